//! The distinct surfaces of a scene.
//!
//! Copies of a ball that differ in their rotation, and half-spaces whose planes coincide, are found and get the very same
//! numbers. A tracer then computes the very same distances for them, so that coincident surfaces cancel exactly and a ray
//! that starts on one of them starts on all.

use scenec_scene::{Base, DMat3, DVec3, Transform};

use crate::key::Key;
use crate::register::Register;
use crate::shape::{Axes, Form, Shape, ShapeKind, largest};

/// Finds equal surfaces while leaves are gathered.
#[derive(Default)]
pub(crate) struct Shapes {
    /// The distinct shapes, world units.
    pub(crate) list: Vec<Shape>,
    /// Of each, whether it is the half-space on the other side of the plane that its class is named after.
    pub(crate) turned: Vec<bool>,
    known: Register,
    classes: u32,
}

/// A shape and half of what its key hashes to.
pub(crate) struct Sought {
    shape: Shape,
    half: u32,
}

impl Shapes {
    /// None, with room for so many.
    pub(crate) fn with_room(room: usize) -> Self {
        Self {
            list: Vec::with_capacity(room),
            turned: Vec::with_capacity(room),
            known: Register::with_room(room),
            classes: 0,
        }
    }

    /// What is looked for, of a base object that went this way.
    pub(crate) fn sought(&self, base: Base, transform: &Transform) -> Sought {
        let shape = canonical(base, transform);
        let half = self.known.half(&Key::of(&shape));
        Sought { shape, half }
    }

    /// See [`Register::expect`].
    pub(crate) fn expect(&self, sought: &Sought) {
        self.known.expect(sought.half);
    }

    /// The number of a shape.
    pub(crate) fn intern(&mut self, Sought { shape, half }: Sought) -> u32 {
        if let Some(known) = self.find(half, || Key::of(&shape)) {
            return known;
        }
        let twin = match shape.kind() {
            ShapeKind::HalfSpace => {
                let key = Key::of(&shape).of_complement();
                self.find(self.known.half(&key), || key)
            }
            _ => None,
        };
        let (shape, turned) = match twin.map(|twin| &self.list[twin as usize]) {
            Some(twin) => {
                let normal = -twin.normal();
                let form = Form::HalfSpace { normal };
                (Shape { form, ..*twin }, true)
            }
            None => {
                let class = self.classes;
                self.classes += 1;
                (Shape { class, ..shape }, false)
            }
        };
        let number = self.list.len() as u32;
        self.list.push(shape);
        self.turned.push(turned);
        self.known.file(half, number);
        number
    }

    /// The number of the shape with a key. A half-space that took the numbers of one on the other side of its plane has
    /// the key that those numbers give.
    fn find(&self, half: u32, key: impl Fn() -> Key) -> Option<u32> {
        self.known
            .find(half, |number| Key::of(&self.list[number as usize]) == key())
    }
}

fn canonical(base: Base, transform: &Transform) -> Shape {
    let ellipsoid = || {
        Form::Ellipsoid(Box::new(Axes {
            inverse: transform.inverse,
            linear: transform.linear,
        }))
    };
    Shape {
        class: 0,
        centre: transform.centre,
        form: match base {
            Base::HalfSpace => Form::HalfSpace {
                normal: unit(transform.inverse.row(1)),
            },
            Base::Sphere => radius(&transform.linear).map_or_else(ellipsoid, |radius| Form::Ball { radius }),
        },
    }
}

/// The radius of the unit ball's image, if that is a ball to within 2^-40.
fn radius(linear: &DMat3) -> Option<f64> {
    // A plain scale keeps its radius to the last bit.
    let plain = linear.x_axis.x.abs();
    if *linear == DMat3::from_diagonal(linear.diagonal()) && linear.diagonal().abs() == DVec3::splat(plain) {
        return Some(plain);
    }
    let largest = largest(linear);
    // Scaled, so that the products neither overflow nor vanish.
    let l = *linear * (1.0 / largest);
    let gram = l * l.transpose();
    let square = (gram.x_axis.x + gram.y_axis.y + gram.z_axis.z) / 3.0;
    let rest = gram - DMat3::from_diagonal(DVec3::splat(square));
    let tolerance = square * (-40.0_f64).exp2();
    let round = rest.to_cols_array().into_iter().all(|x| x.abs() <= tolerance);
    round.then(|| square.sqrt() * largest)
}

fn unit(v: DVec3) -> DVec3 {
    (v / v.abs().max_element()).normalize()
}

#[cfg(test)]
mod tests {
    use scenec_scene::{Axis, Base, DVec3, Transform};

    use super::{Shape, ShapeKind, Shapes};

    fn intern(leaves: &[(Base, Transform)]) -> Vec<Shape> {
        let mut shapes = Shapes::default();
        let numbers: Vec<_> = leaves
            .iter()
            .map(|(base, transform)| shapes.intern(shapes.sought(*base, transform)))
            .collect();
        numbers
            .iter()
            .map(|number| shapes.list[*number as usize].clone())
            .collect()
    }

    #[test]
    fn a_rotated_ball_is_the_same_ball() {
        let place = DVec3::new(0.1, 0.2, -0.7);
        let ball = Transform::IDENTITY.scaled(DVec3::splat(1.3)).translated(place);
        let turned = Transform::IDENTITY
            .rotated(Axis::X, 0.3)
            .scaled(DVec3::splat(-1.3))
            .rotated(Axis::Z, 2.0)
            .translated(place);
        let shapes = intern(&[(Base::Sphere, ball), (Base::Sphere, turned)]);
        assert_eq!(shapes[0].kind(), ShapeKind::Ball);
        assert_eq!(shapes[0], shapes[1]);
    }

    #[test]
    fn a_half_space_and_its_complement_share_a_class() {
        let slanted = Transform::IDENTITY
            .rotated(Axis::X, 0.4)
            .translated(DVec3::new(0.0, 1.0, 0.3));
        let turned = Transform::IDENTITY
            .rotated(Axis::X, 0.4 + std::f64::consts::PI)
            .translated(DVec3::new(5.0, 1.0, 0.3));
        let shapes = intern(&[(Base::HalfSpace, slanted), (Base::HalfSpace, turned)]);
        assert_eq!(shapes[0].class, shapes[1].class);
        assert_eq!(shapes[0].normal(), -shapes[1].normal());
    }

    #[test]
    fn different_surfaces_stay_apart() {
        let id = Transform::IDENTITY;
        let shapes = intern(&[
            (Base::Sphere, id),
            (Base::Sphere, id.translated(DVec3::X * 1e-7)),
            (Base::Sphere, id.scaled(DVec3::new(1.0, 1.0, 1.0 + 1e-7))),
            (Base::HalfSpace, id),
            (Base::HalfSpace, id.translated(DVec3::Y * 1e-9)),
        ]);
        let mut classes: Vec<_> = shapes.iter().map(|shape| shape.class).collect();
        classes.dedup();
        assert_eq!(classes.len(), 5, "{classes:?}");
        assert_eq!(shapes[2].kind(), ShapeKind::Ellipsoid);
    }

    #[test]
    fn what_is_twice_as_large_or_far_is_another_surface() {
        let egg = Transform::IDENTITY.scaled(DVec3::new(1.0, 1.0, 2.5));
        let near = egg.translated(DVec3::Z * -2.5);
        let twice = DVec3::splat(2.0);
        for (base, first, second) in [
            (Base::Sphere, near, egg.translated(DVec3::Z * -5.0)),
            (Base::Sphere, near, near.scaled(twice)),
            (Base::Sphere, egg, egg.scaled(twice)),
            (Base::Sphere, Transform::IDENTITY, Transform::IDENTITY.scaled(twice)),
            (
                Base::HalfSpace,
                Transform::IDENTITY.translated(DVec3::Y),
                Transform::IDENTITY.translated(DVec3::Y * 2.0),
            ),
        ] {
            let shapes = intern(&[(base, first), (base, second)]);
            assert_ne!(shapes[0].class, shapes[1].class, "{first:?} {second:?}");
        }
    }
}
