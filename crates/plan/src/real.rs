//! The number that a tracer computes in: f32 or f64, one source for both.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A binary floating-point number with a fused multiply-add.
pub trait Real:
    Copy
    + PartialOrd
    + Debug
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// Half the distance from 1 to the next number: the unit roundoff u.
    const ROUNDOFF: Self;
    /// What the language's command line calls it.
    const NAME: &'static str;

    /// The nearest such number.
    fn of(value: f64) -> Self;
    /// The same number as a single: exact.
    fn of_f32(value: f32) -> Self;
    /// The same number as a double.
    fn to_f64(self) -> f64;
    /// The nearest single.
    fn to_f32(self) -> f32;
    /// self * b + c, rounded once.
    #[must_use]
    fn fma(self, b: Self, c: Self) -> Self;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// The larger; a NaN yields to a number.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// The smaller; a NaN yields to a number.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// e to this power.
    #[must_use]
    fn exp(self) -> Self;
    /// The natural logarithm of 1 plus this, exact near 0.
    #[must_use]
    fn ln_1p(self) -> Self;
}

/// A colour as pictures hold it: what lies beyond the range of a single ends at its bounds.
#[must_use]
pub fn in_singles<R: Real>(colour: [R; 3]) -> [f32; 3] {
    colour.map(|part| part.to_f32().clamp(f32::MIN, f32::MAX))
}

/// A colour in doubles: what lies beyond their range ends at its bounds as well.
#[must_use]
pub fn in_doubles<R: Real>(colour: [R; 3]) -> [f64; 3] {
    colour.map(|part| part.to_f64().clamp(f64::MIN, f64::MAX))
}

macro_rules! real {
    ($type:ident, $name:literal) => {
        impl Real for $type {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const INFINITY: Self = $type::INFINITY;
            const ROUNDOFF: Self = $type::EPSILON / 2.0;
            const NAME: &'static str = $name;

            #[inline(always)]
            fn of(value: f64) -> Self {
                value as Self
            }
            #[inline(always)]
            fn of_f32(value: f32) -> Self {
                Self::from(value)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn to_f32(self) -> f32 {
                self as f32
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                self.mul_add(b, c)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $type::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $type::abs(self)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                $type::max(self, other)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                $type::min(self, other)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                $type::exp(self)
            }
            #[inline(always)]
            fn ln_1p(self) -> Self {
                $type::ln_1p(self)
            }
        }
    };
}

real!(f32, "f32");
real!(f64, "f64");
