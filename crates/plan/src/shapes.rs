//! The distinct surfaces of a scene.
//!
//! Copies of a ball that differ in their rotation, and half-spaces whose planes coincide, are found and get the very same
//! numbers. A tracer then computes the very same distances for them, so that coincident surfaces cancel exactly and a ray
//! that starts on one of them starts on all.

use scenec_scene::{Base, DMat3, DVec3, Transform};

use crate::register::Register;

/// What a surface is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ShapeKind {
    /// A sphere that stayed one.
    Ball,
    /// Any other image of the unit sphere.
    Ellipsoid,
    /// A half-space.
    HalfSpace,
}

/// A surface in numbers.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Shape {
    /// What it is.
    pub kind: ShapeKind,
    /// Equal for shapes with the same surface; a half-space and its complement share theirs.
    pub class: u32,
    /// The centre; of a half-space, the foot of the perpendicular from the plan's origin.
    pub centre: DVec3,
    /// World to object, without the translation. Of a ball, 1/radius times the identity; of a half-space, only the first
    /// row counts: the outward unit normal.
    pub inverse: DMat3,
    /// Object to world, without the translation; unused for a half-space.
    pub linear: DMat3,
}

impl Shape {
    /// Whether the solid behind the surface holds a point in the shape's own coordinates; the surface counts as inside.
    #[must_use]
    pub fn holds(&self, point: DVec3) -> bool {
        let local = point - self.centre;
        match self.kind {
            ShapeKind::HalfSpace => self.normal().dot(local) <= 0.0,
            _ => (self.inverse * local).length_squared() <= 1.0,
        }
    }

    /// Where on its own unit sphere the surface has a point, if it is on the surface to within 2^-48 of the sizes that its
    /// test subtracts: 32 roundings, which leaves room for those of the transform. A point that is nearer than that can't
    /// be told from one on the surface.
    #[must_use]
    pub(crate) fn touched_by(&self, point: DVec3) -> Option<DVec3> {
        let near = (-48.0_f64).exp2();
        let sizes = point.abs().max_element() + self.centre.abs().max_element();
        let offset = point - self.centre;
        if self.kind == ShapeKind::HalfSpace {
            return (self.normal().dot(offset).abs() <= near * sizes).then_some(DVec3::ZERO);
        }
        let local = self.inverse * offset;
        let largest = self
            .inverse
            .to_cols_array()
            .into_iter()
            .fold(0.0_f64, |most, x| most.max(x.abs()));
        ((local.length() - 1.0).abs() <= near * (1.0 + largest * sizes)).then(|| local.normalize())
    }

    /// The outward unit normal of a half-space.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.inverse.row(0)
    }

    /// A bound from below on the shortest half axis of a ball or ellipsoid.
    #[must_use]
    pub fn least_radius(&self) -> f64 {
        let squares: f64 = self.inverse.to_cols_array().into_iter().map(|x| x * x).sum();
        squares.sqrt().recip()
    }

    /// The cell in which the surface lies when its numbers are rounded to `steps` of its size, on a grid shifted by a part
    /// of a step. A ball is an ellipsoid here, and a half-space its complement.
    pub(crate) fn cell(&self, steps: f64, shift: f64) -> Key {
        let kind = match self.kind {
            ShapeKind::HalfSpace => ShapeKind::HalfSpace,
            _ => ShapeKind::Ellipsoid,
        };
        let key = key(&Self { kind, ..*self }, Grid { steps, shift });
        Key { turned: false, ..key }
    }

    /// The shape after a translation by `-origin` and a scale.
    #[must_use]
    pub(crate) fn relative(&self, origin: DVec3, scale: f64) -> Self {
        let centre = (self.centre - origin) * scale;
        match self.kind {
            ShapeKind::HalfSpace => {
                let normal = self.normal();
                Self {
                    centre: normal * normal.dot(centre),
                    ..*self
                }
            }
            _ => Self {
                centre,
                inverse: self.inverse * (1.0 / scale),
                linear: self.linear * scale,
                ..*self
            },
        }
    }
}

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

/// A shape rounded to a grid of about 2^-40 of its own size: coarse enough for copies that were computed in another
/// order, whose numbers differ by a few 2^-53, and far finer than single precision can tell apart.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    kind: ShapeKind,
    turned: bool,
    numbers: [i64; 12],
}

/// What a shape's numbers are rounded to.
#[derive(Clone, Copy)]
struct Grid {
    /// Steps in the size of what is rounded.
    steps: f64,
    /// By what part of a step the grid is shifted.
    shift: f64,
}

impl Grid {
    /// Where copies that were computed in another order meet.
    const SAME: Self = Self {
        steps: (1_u64 << 40) as f64,
        shift: 0.0,
    };

    fn step(self, value: f64, size: f64) -> i64 {
        // At most about 2^42 in size, so this addition rounds to a whole number, and the bits tell which.
        const ROUND: f64 = 1.5 * (1_u64 << 52) as f64;
        (value / size * self.steps + self.shift + ROUND).to_bits() as i64
    }
}

impl Shapes {
    /// The number of the shape of a base object that went this way.
    pub(crate) fn intern(&mut self, base: Base, transform: &Transform) -> u32 {
        let shape = canonical(base, transform);
        let key = key(&shape, Grid::SAME);
        if let Some(known) = self.find(&key) {
            return known;
        }
        let twin = (shape.kind == ShapeKind::HalfSpace).then(|| {
            let turned = !key.turned;
            self.find(&Key { turned, ..key })
        });
        let (shape, turned) = match twin.flatten().map(|twin| self.list[twin as usize]) {
            Some(twin) => {
                let inverse = twin.inverse * -1.0;
                (Shape { inverse, ..twin }, true)
            }
            None => {
                self.classes += 1;
                let class = self.classes - 1;
                (Shape { class, ..shape }, false)
            }
        };
        let number = self.list.len() as u32;
        self.list.push(shape);
        self.turned.push(turned);
        self.known.file(&key, number);
        number
    }

    /// The number of the shape with a key. A half-space that took the numbers of one on the other side of its plane has
    /// the key that those numbers give.
    fn find(&self, key: &Key) -> Option<u32> {
        self.known
            .find(key, |number| self::key(&self.list[number as usize], Grid::SAME))
    }
}

fn canonical(base: Base, transform: &Transform) -> Shape {
    let shape = Shape {
        kind: ShapeKind::Ellipsoid,
        class: 0,
        centre: transform.centre,
        inverse: transform.inverse,
        linear: transform.linear,
    };
    match base {
        Base::HalfSpace => {
            let normal = unit(transform.inverse.row(1));
            let inverse = DMat3::from_cols(normal, DVec3::ZERO, DVec3::ZERO).transpose();
            Shape {
                kind: ShapeKind::HalfSpace,
                inverse,
                linear: DMat3::ZERO,
                ..shape
            }
        }
        Base::Sphere => match radius(&transform.linear) {
            Some(radius) => Shape {
                kind: ShapeKind::Ball,
                inverse: DMat3::from_diagonal(DVec3::splat(1.0 / radius)),
                linear: DMat3::from_diagonal(DVec3::splat(radius)),
                ..shape
            },
            None => shape,
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
    let largest = linear
        .to_cols_array()
        .into_iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    // Scaled, so that the products neither overflow nor vanish.
    let l = *linear * (1.0 / largest);
    let gram = l * l.transpose();
    let square = (gram.x_axis.x + gram.y_axis.y + gram.z_axis.z) / 3.0;
    let rest = gram - DMat3::from_diagonal(DVec3::splat(square));
    let tolerance = square * (-40.0_f64).exp2();
    let round = rest.to_cols_array().into_iter().all(|x| x.abs() <= tolerance);
    round.then(|| square.sqrt() * largest)
}

fn key(shape: &Shape, grid_of: Grid) -> Key {
    let step = |value, size| grid_of.step(value, size);
    let (turned, numbers) = match shape.kind {
        ShapeKind::HalfSpace => {
            let normal = shape.normal();
            let turned = normal
                .to_array()
                .into_iter()
                .find(|x| x.abs() > 0.5)
                .is_some_and(|x| x < 0.0);
            let normal = if turned { -normal } else { normal };
            let distance = normal.dot(shape.centre);
            let [x, y, z] = normal.to_array();
            // The distance has a grid of its own; which one is part of the key.
            let size = grid(distance);
            (
                turned,
                [
                    step(x, 1.0),
                    step(y, 1.0),
                    step(z, 1.0),
                    step(distance, size),
                    power(size),
                    0,
                    0,
                    0,
                    0,
                    0,
                    0,
                    0,
                ],
            )
        }
        ShapeKind::Ball => {
            let radius = shape.linear.x_axis.x;
            let size = grid(shape.centre.abs().max_element() + radius);
            let [x, y, z] = shape.centre.to_array().map(|x| step(x, size));
            (false, [x, y, z, step(radius, size), power(size), 0, 0, 0, 0, 0, 0, 0])
        }
        ShapeKind::Ellipsoid => {
            let largest = shape
                .linear
                .to_cols_array()
                .into_iter()
                .fold(0.0_f64, |most, x| most.max(x.abs()));
            let size = grid(shape.centre.abs().max_element() + largest);
            let [x, y, z] = shape.centre.to_array().map(|x| step(x, size));
            let l = shape.linear * (1.0 / largest);
            let gram = l * l.transpose();
            let [a, b, c] = gram.x_axis.to_array().map(|x| step(x, 1.0));
            let [_, d, e] = gram.y_axis.to_array().map(|x| step(x, 1.0));
            (
                false,
                [
                    x,
                    y,
                    z,
                    power(size),
                    step(largest, grid(largest)),
                    power(grid(largest)),
                    a,
                    b,
                    c,
                    d,
                    e,
                    step(gram.z_axis.z, 1.0),
                ],
            )
        }
    };
    Key {
        kind: shape.kind,
        turned,
        numbers,
    }
}

/// A power of two near `size`. The bounds between two of them lie at odd multiples of the root of 2, where no number that
/// a person writes lies.
fn grid(size: f64) -> f64 {
    if size == 0.0 {
        return 1.0;
    }
    // The exponent alone is the power of two below; the smallest numbers have none of their own.
    let power = (size.abs() * std::f64::consts::SQRT_2).to_bits() & f64::INFINITY.to_bits();
    f64::from_bits(power).max(f64::MIN_POSITIVE)
}

/// Which power of two a grid is: without it, a shape and another one twice as large and twice as far would be one.
const fn power(grid: f64) -> i64 {
    (grid.to_bits() >> 52) as i64
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
            .map(|(base, transform)| shapes.intern(*base, transform))
            .collect();
        numbers.iter().map(|number| shapes.list[*number as usize]).collect()
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
        assert_eq!(shapes[0].kind, ShapeKind::Ball);
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
        assert_eq!(shapes[2].kind, ShapeKind::Ellipsoid);
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
