//! Three numbers.

use scenec_plan::Real;

pub(crate) type Vector<R> = [R; 3];

#[inline(always)]
pub(crate) fn add<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(crate) fn sub<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
pub(crate) fn scale<R: Real>(a: Vector<R>, by: R) -> Vector<R> {
    [a[0] * by, a[1] * by, a[2] * by]
}

/// a * by + b, each component rounded once.
#[inline(always)]
pub(crate) fn fma<R: Real>(a: Vector<R>, by: R, b: Vector<R>) -> Vector<R> {
    [a[0].fma(by, b[0]), a[1].fma(by, b[1]), a[2].fma(by, b[2])]
}

#[inline(always)]
pub(crate) fn dot<R: Real>(a: Vector<R>, b: Vector<R>) -> R {
    a[0].fma(b[0], a[1].fma(b[1], a[2] * b[2]))
}

/// The vector of length 1 in this direction; the caller knows that its square neither overflows nor vanishes.
#[inline(always)]
pub(crate) fn normalize<R: Real>(a: Vector<R>) -> Vector<R> {
    scale(a, R::ONE / dot(a, a).sqrt())
}

/// Rows times vector.
#[inline(always)]
pub(crate) fn rows<R: Real>(m: &[R; 9], v: Vector<R>) -> Vector<R> {
    [
        dot([m[0], m[1], m[2]], v),
        dot([m[3], m[4], m[5]], v),
        dot([m[6], m[7], m[8]], v),
    ]
}

/// Columns times vector: the transpose of the rows.
#[inline(always)]
pub(crate) fn columns<R: Real>(m: &[R; 9], v: Vector<R>) -> Vector<R> {
    [
        dot([m[0], m[3], m[6]], v),
        dot([m[1], m[4], m[7]], v),
        dot([m[2], m[5], m[8]], v),
    ]
}

#[inline(always)]
pub(crate) fn neg<R: Real>(a: Vector<R>) -> Vector<R> {
    [-a[0], -a[1], -a[2]]
}
