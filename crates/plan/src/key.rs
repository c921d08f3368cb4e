//! By what nearly equal surfaces are found: their numbers, rounded.

use scenec_scene::{DMat3, DVec3};

use crate::shape::{Form, Shape, ShapeKind, largest};

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

impl Key {
    /// That of a shape; shapes with the same one are the same.
    pub(crate) fn of(shape: &Shape) -> Self {
        Self::on(Grid::SAME, shape)
    }

    /// The cell in which a surface lies when its numbers are rounded to `steps` of its size, on a grid shifted by a part
    /// of a step. A ball is an ellipsoid here, and a half-space its complement.
    pub(crate) fn cell(shape: &Shape, steps: f64, shift: f64) -> Self {
        let grid = Grid { steps, shift };
        match shape.form {
            Form::Ball { radius } => Self {
                kind: ShapeKind::Ellipsoid,
                turned: false,
                numbers: with_gram(shape.centre, radius, &DMat3::IDENTITY, grid),
            },
            _ => Self {
                turned: false,
                ..Self::on(grid, shape)
            },
        }
    }

    /// That of a half-space on the other side of the plane.
    pub(crate) const fn of_complement(self) -> Self {
        Self {
            turned: !self.turned,
            ..self
        }
    }

    fn on(grid: Grid, shape: &Shape) -> Self {
        let (turned, numbers) = match &shape.form {
            Form::HalfSpace { normal } => half_space(*normal, shape.centre, grid),
            Form::Ball { radius } => (false, ball(shape.centre, *radius, grid)),
            Form::Ellipsoid(axes) => (false, ellipsoid(shape.centre, &axes.linear, grid)),
        };
        Self {
            kind: shape.kind(),
            turned,
            numbers,
        }
    }
}

/// Whether the plane is named after its other side, and the numbers of its key.
fn half_space(normal: DVec3, foot: DVec3, grid: Grid) -> (bool, [i64; 12]) {
    let turned = normal
        .to_array()
        .into_iter()
        .find(|x| x.abs() > 0.5)
        .is_some_and(|x| x < 0.0);
    let normal = if turned { -normal } else { normal };
    let distance = normal.dot(foot);
    let [x, y, z] = normal.to_array().map(|x| grid.step(x, 1.0));
    // The distance has a grid of its own; which one is part of the key.
    let size = near_power(distance);
    let numbers = [x, y, z, grid.step(distance, size), power(size), 0, 0, 0, 0, 0, 0, 0];
    (turned, numbers)
}

fn ball(centre: DVec3, radius: f64, grid: Grid) -> [i64; 12] {
    let size = near_power(centre.abs().max_element() + radius);
    let [x, y, z] = centre.to_array().map(|x| grid.step(x, size));
    [x, y, z, grid.step(radius, size), power(size), 0, 0, 0, 0, 0, 0, 0]
}

/// The matrix by its Gram matrix, since a rotation of the unit sphere changes nothing.
fn ellipsoid(centre: DVec3, linear: &DMat3, grid: Grid) -> [i64; 12] {
    let largest = largest(linear);
    let l = *linear * (1.0 / largest);
    with_gram(centre, largest, &(l * l.transpose()), grid)
}

/// An ellipsoid by its largest number and the Gram matrix of all that it has, as parts of that; a ball's is the identity.
fn with_gram(centre: DVec3, largest: f64, gram: &DMat3, grid: Grid) -> [i64; 12] {
    let (size, own) = (near_power(centre.abs().max_element() + largest), near_power(largest));
    let [x, y, z] = centre.to_array().map(|x| grid.step(x, size));
    let [a, b, c] = gram.x_axis.to_array().map(|x| grid.step(x, 1.0));
    let [_, d, e] = gram.y_axis.to_array().map(|x| grid.step(x, 1.0));
    let f = grid.step(gram.z_axis.z, 1.0);
    [
        x,
        y,
        z,
        power(size),
        grid.step(largest, own),
        power(own),
        a,
        b,
        c,
        d,
        e,
        f,
    ]
}

/// A power of two near `size`. The bounds between two of them lie at odd multiples of the root of 2, where no number that
/// a person writes lies.
fn near_power(size: f64) -> f64 {
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
