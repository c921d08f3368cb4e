//! Leaves as sets of points, each with a bound on what rounding has done to it.

use scenec_scene::{Base, DMat3, DVec3, Scene, Solid, SolidKind, Transform};

/// What every comparison allows for rounding, relative to the sizes of the terms that were added up: 2^-40.
///
/// No figure here takes more than some hundred operations from the numbers of the scene, each off by at most 2^-53 of
/// the sizes of its terms, so the true error is below 2^-46. The rest is distance from what merely touches.
pub(crate) const SLACK: f64 = 1.0 / (1_u64 << 40) as f64;

/// Sizes whose squares and products stay far inside the range of a double.
const SMALLEST: f64 = 1e-100;
const LARGEST: f64 = 1e100;

/// A leaf as a set of points.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Ball(Ball),
    Half(Half),
}

/// The image of the unit ball.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(crate) centre: DVec3,
    /// From the unit ball to the world, but for the centre.
    pub(crate) linear: DMat3,
    /// Back again.
    pub(crate) inverse: DMat3,
    /// The solid lies between this image shrunk and grown about its centre by 1 - `slop` and 1 + `slop`, whichever
    /// of the two matrices is taken for the true one.
    pub(crate) slop: f64,
}

/// All points on the far side of a plane's unit normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Half {
    pub(crate) normal: DVec3,
    /// A point of the plane.
    pub(crate) point: DVec3,
}

impl Shape {
    /// The shape of a solid that is a leaf of ordinary size; nothing is proved of others.
    pub(crate) fn of(scene: &Scene, solid: &Solid) -> Option<Self> {
        match &solid.kind {
            SolidKind::Leaf(leaf) => Self::placed(leaf.base, &scene.transform(leaf)),
            SolidKind::Combine { .. } | SolidKind::Paint { .. } => None,
        }
    }

    /// The shape of a base object that went this way.
    pub(super) fn placed(base: Base, transform: &Transform) -> Option<Self> {
        match base {
            Base::Sphere => Ball::of(transform).map(Self::Ball),
            Base::HalfSpace => Half::of(transform).map(Self::Half),
        }
    }
}

impl Ball {
    /// `None` where the two matrices of the transform disagree by more than 2^-20, or the range of a double is near.
    pub(crate) fn of(transform: &Transform) -> Option<Self> {
        let (linear, inverse) = (transform.linear, transform.inverse);
        let (size, back) = (frobenius(&linear), frobenius(&inverse));
        let usual = |value: f64| (SMALLEST..LARGEST).contains(&value);
        if !usual(size) || !usual(back) || !distance_is_usual(transform.centre) {
            return None;
        }
        // With inverse * linear = I + F the surface where |inverse x| = 1 is the image of points whose length is between
        // 1 / (1 + |F|) and 1 / (1 - |F|). Each element of F is a sum of three products, rounded.
        let off = frobenius(&(inverse * linear - DMat3::IDENTITY));
        let slop = 2.0 * (off + 16.0 * f64::EPSILON * size * back);
        (slop < 1e-6).then_some(Self {
            centre: transform.centre,
            linear,
            inverse,
            slop,
        })
    }

    /// How far it reaches from its centre along a unit vector, at the most.
    pub(crate) fn reach(&self, along: DVec3) -> f64 {
        (1.0 + self.slop) * across(&self.linear, along).length()
    }

    /// Its radius, if it is round to 2^-40.
    pub(crate) fn radius(&self) -> Option<f64> {
        let [x, y, z] = [self.linear.x_axis, self.linear.y_axis, self.linear.z_axis];
        let square = x.length_squared();
        let even = [y.length_squared() - square, z.length_squared() - square];
        let askew = [x.dot(y), y.dot(z), z.dot(x)];
        let off = even
            .into_iter()
            .chain(askew)
            .fold(0.0, |most: f64, off| most.max(off.abs()));
        (off <= square * SLACK).then(|| square.sqrt())
    }
}

impl Half {
    fn of(transform: &Transform) -> Option<Self> {
        // Normals go by the inverse transpose, of which this is the column of the object's y axis.
        let row = transform.inverse.row(1);
        let length = row.length();
        let usual = (SMALLEST..LARGEST).contains(&length) && distance_is_usual(transform.centre);
        usual.then(|| Self {
            normal: row / length,
            point: transform.centre,
        })
    }

    /// How far a point lies outside, along the normal.
    pub(crate) fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.point)
    }
}

/// The transpose of a matrix times a vector.
pub(crate) fn across(matrix: &DMat3, vector: DVec3) -> DVec3 {
    DVec3::new(
        matrix.x_axis.dot(vector),
        matrix.y_axis.dot(vector),
        matrix.z_axis.dot(vector),
    )
}

/// The root of the sum of all squares: at least the largest singular value, at most the root of 3 times it.
pub(crate) fn frobenius(matrix: &DMat3) -> f64 {
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    (x.length_squared() + y.length_squared() + z.length_squared()).sqrt()
}

fn distance_is_usual(point: DVec3) -> bool {
    point.abs().max_element() < LARGEST
}
