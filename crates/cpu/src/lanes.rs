//! Eight numbers at once, in the tracer's precision and in the words of whatever processor there is.
//!
//! What is done to them is written out, here and where they are used, without closures: `map` and its kind are compiled
//! for any processor, and where one of them is not made part of its caller, each operation in it is a call.

use fearless_simd::{Simd, SimdBase, SimdFloat, SimdFloatElement, SimdMask, f32x8, f64x8};
pub(crate) use scenec_plan::LANES;
use scenec_plan::Real;

/// A number that comes in eights.
pub(crate) trait Lanes: Real + SimdFloatElement {
    /// Eight of them.
    type Eight<S: Simd>: SimdFloat<S, Element = Self, Array = [Self; LANES]>;

    /// The same numbers as eight singles.
    fn of_singles<S: Simd>(simd: S, values: &[f32; LANES]) -> Self::Eight<S>;
}

impl Lanes for f32 {
    type Eight<S: Simd> = f32x8<S>;

    #[inline(always)]
    fn of_singles<S: Simd>(simd: S, values: &[f32; LANES]) -> Self::Eight<S> {
        f32x8::load_array_ref(simd, values)
    }
}

impl Lanes for f64 {
    type Eight<S: Simd> = f64x8<S>;

    #[inline(always)]
    fn of_singles<S: Simd>(simd: S, values: &[f32; LANES]) -> Self::Eight<S> {
        let [a, b, c, d, e, f, g, h] = *values;
        let wide = [
            Self::from(a),
            Self::from(b),
            Self::from(c),
            Self::from(d),
            Self::from(e),
            Self::from(f),
            Self::from(g),
            Self::from(h),
        ];
        f64x8::load_array(simd, wide)
    }
}

/// Three numbers, eight times.
pub(crate) type Vector8<R, S> = [<R as Lanes>::Eight<S>; 3];

#[inline(always)]
pub(crate) fn load<R: Lanes, S: Simd>(simd: S, values: &[R; LANES]) -> R::Eight<S> {
    R::Eight::<S>::load_array_ref(simd, values)
}

#[inline(always)]
pub(crate) fn splat<R: Lanes, S: Simd>(simd: S, value: R) -> R::Eight<S> {
    R::Eight::<S>::splat(simd, value)
}

#[inline(always)]
pub(crate) fn splat3<R: Lanes, S: Simd>(simd: S, v: [R; 3]) -> Vector8<R, S> {
    [
        splat::<R, S>(simd, v[0]),
        splat::<R, S>(simd, v[1]),
        splat::<R, S>(simd, v[2]),
    ]
}

/// Three vectors, each times the same.
#[inline(always)]
pub(crate) fn scale<S: Simd, V: SimdFloat<S>>(a: [V; 3], by: V) -> [V; 3] {
    [a[0] * by, a[1] * by, a[2] * by]
}

/// The same operations in the same order as [`crate::vector::dot`], so the same bits.
#[inline(always)]
pub(crate) fn dot<S: Simd, V: SimdFloat<S>>(a: [V; 3], b: [V; 3]) -> V {
    a[0].mul_add_precise(b[0], a[1].mul_add_precise(b[1], a[2] * b[2]))
}

/// As [`crate::vector::fma`].
#[inline(always)]
pub(crate) fn fma<S: Simd, V: SimdFloat<S>>(a: [V; 3], by: V, b: [V; 3]) -> [V; 3] {
    [
        a[0].mul_add_precise(by, b[0]),
        a[1].mul_add_precise(by, b[1]),
        a[2].mul_add_precise(by, b[2]),
    ]
}

/// The lanes in which something holds, one bit each.
#[inline(always)]
pub(crate) fn bits<S: Simd, M: SimdMask<S>>(mask: M) -> u32 {
    mask.to_bitmask() as u32
}

/// The numbers of the lanes that are set, lowest first.
pub(crate) struct Set(pub(crate) u32);

impl Iterator for Set {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros() as usize % LANES;
        self.0 &= self.0 - 1;
        Some(lane)
    }
}
