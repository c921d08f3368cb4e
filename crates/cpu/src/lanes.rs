//! Eight numbers at once, in the tracer's precision and in the words of whatever processor there is.
//!
//! What is done to them is written out, here and where they are used, without closures: `map` and its kind are compiled
//! for any processor, and where one of them is not made part of its caller, each operation in it is a call.

use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdFloatElement, SimdMask, f32x8, f64x8};
pub(crate) use scenec_plan::LANES;
use scenec_plan::Real;

use crate::vector::{Arithmetic, Vector};

/// A number that comes in eights.
pub(crate) trait Lanes: Real + SimdFloatElement + Arithmetic {
    /// Eight of them.
    type Eight<S: Simd>: SimdFloat<S, Element = Self, Array = [Self; LANES]> + Arithmetic;

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
pub(crate) type Vector8<R, S> = Vector<<R as Lanes>::Eight<S>>;

/// The same in memory.
pub(crate) type Triple<R> = [[R; LANES]; 3];

#[inline(always)]
pub(crate) fn load<R: Lanes, S: Simd>(simd: S, values: &[R; LANES]) -> R::Eight<S> {
    R::Eight::<S>::load_array_ref(simd, values)
}

#[inline(always)]
pub(crate) fn load3<R: Lanes, S: Simd>(simd: S, values: &Triple<R>) -> Vector8<R, S> {
    [
        load::<R, S>(simd, &values[0]),
        load::<R, S>(simd, &values[1]),
        load::<R, S>(simd, &values[2]),
    ]
}

#[inline(always)]
pub(crate) fn store3<R: Lanes, S: Simd>(v: Vector8<R, S>) -> Triple<R> {
    [v[0].to_array(), v[1].to_array(), v[2].to_array()]
}

/// One lane of it.
#[inline(always)]
pub(crate) const fn lane3<R: Copy>(values: &Triple<R>, lane: usize) -> Vector<R> {
    [values[0][lane], values[1][lane], values[2][lane]]
}

/// Changes one lane of it.
#[inline(always)]
pub(crate) const fn set3<R: Copy>(values: &mut Triple<R>, lane: usize, v: Vector<R>) {
    values[0][lane] = v[0];
    values[1][lane] = v[1];
    values[2][lane] = v[2];
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

/// In the lanes that are set the first, in the others the second.
#[inline(always)]
pub(crate) fn select<R: Lanes, S: Simd>(simd: S, lanes: u32, a: R::Eight<S>, b: R::Eight<S>) -> R::Eight<S> {
    <R::Eight<S> as SimdBase<S>>::Mask::from_bitmask(simd, lanes.into()).select(a, b)
}

#[inline(always)]
pub(crate) fn select3<R: Lanes, S: Simd>(simd: S, lanes: u32, a: Vector8<R, S>, b: Vector8<R, S>) -> Vector8<R, S> {
    [
        select::<R, S>(simd, lanes, a[0], b[0]),
        select::<R, S>(simd, lanes, a[1], b[1]),
        select::<R, S>(simd, lanes, a[2], b[2]),
    ]
}

/// The lanes in which something holds, one bit each.
#[inline(always)]
pub(crate) fn bits<S: Simd, M: SimdMask<S>>(mask: M) -> u32 {
    mask.to_bitmask() as u32
}

/// The numbers of the lanes that are set, lowest first.
#[derive(Clone, Copy)]
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

/// Eight sets, one to a byte: bit i of set j becomes bit j of set i.
///
/// Blocks of 1, 2 and 4 bits change places across the diagonal (Warren, Hacker's Delight, 2nd ed. 2012, 7-3).
#[inline(always)]
pub(crate) const fn turned(mut sets: u64) -> u64 {
    let change = (sets ^ (sets >> 7)) & 0x00aa_00aa_00aa_00aa;
    sets ^= change ^ (change << 7);
    let change = (sets ^ (sets >> 14)) & 0x0000_cccc_0000_cccc;
    sets ^= change ^ (change << 14);
    let change = (sets ^ (sets >> 28)) & 0x0000_0000_f0f0_f0f0;
    sets ^ change ^ (change << 28)
}

#[cfg(test)]
mod tests {
    use super::turned;

    #[test]
    fn sets_are_turned() {
        for i in 0..8 {
            for j in 0..8 {
                assert_eq!(turned(1 << (8 * j + i)), 1 << (8 * i + j), "{i} of {j}");
            }
        }
    }
}
