//! Three numbers, or three times eight of them: the same operations in the same order, so the same bits.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, f32x8, f64x8};

/// What a formula needs of a number, be it one or eight at once.
pub(crate) trait Arithmetic:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// self * by + more, rounded once.
    fn fused(self, by: Self, more: Self) -> Self;
    /// Square root.
    fn root(self) -> Self;
    /// 1 / self.
    fn inverse(self) -> Self;
    /// Without its sign.
    fn size(self) -> Self;
    /// 1.
    fn one(self) -> Self;
}

macro_rules! one {
    ($number:ty) => {
        impl Arithmetic for $number {
            #[inline(always)]
            fn fused(self, by: Self, more: Self) -> Self {
                self.mul_add(by, more)
            }
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn inverse(self) -> Self {
                1.0 / self
            }
            #[inline(always)]
            fn size(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn one(self) -> Self {
                1.0
            }
        }
    };
}

macro_rules! eight {
    ($eight:ident, $emulated:ident) => {
        // Many instructions, so that it is no part of every place that asks for one.
        #[inline(never)]
        fn $emulated<S: Simd>(a: $eight<S>, by: $eight<S>, more: $eight<S>) -> $eight<S> {
            a.mul_add_precise(by, more)
        }

        impl<S: Simd> Arithmetic for $eight<S> {
            #[inline(always)]
            fn fused(self, by: Self, more: Self) -> Self {
                if has_fused(self.simd.level()) {
                    self.mul_add_precise(by, more)
                } else {
                    $emulated(self, by, more)
                }
            }
            #[inline(always)]
            fn root(self) -> Self {
                SimdFloat::sqrt(self)
            }
            #[inline(always)]
            fn inverse(self) -> Self {
                self.one() / self
            }
            #[inline(always)]
            fn size(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn one(self) -> Self {
                Self::splat(self.simd, 1.0)
            }
        }
    };
}

one!(f32);
one!(f64);
eight!(f32x8, emulated_f32);
eight!(f64x8, emulated_f64);

/// Whether a multiplication and an addition rounded once are one instruction. The compiler knows.
#[inline(always)]
#[cfg(target_arch = "x86_64")]
const fn has_fused(level: Level) -> bool {
    !matches!(level, Level::Sse2(_) | Level::Sse4_2(_))
}

#[inline(always)]
#[cfg(not(target_arch = "x86_64"))]
const fn has_fused(_: Level) -> bool {
    cfg!(target_arch = "aarch64")
}

pub(crate) type Vector<A> = [A; 3];

#[inline(always)]
pub(crate) fn add<A: Arithmetic>(a: Vector<A>, b: Vector<A>) -> Vector<A> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(crate) fn sub<A: Arithmetic>(a: Vector<A>, b: Vector<A>) -> Vector<A> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
pub(crate) fn scale<A: Arithmetic>(a: Vector<A>, by: A) -> Vector<A> {
    [a[0] * by, a[1] * by, a[2] * by]
}

/// a * by + b, each component rounded once.
#[inline(always)]
pub(crate) fn fma<A: Arithmetic>(a: Vector<A>, by: A, b: Vector<A>) -> Vector<A> {
    [a[0].fused(by, b[0]), a[1].fused(by, b[1]), a[2].fused(by, b[2])]
}

#[inline(always)]
pub(crate) fn dot<A: Arithmetic>(a: Vector<A>, b: Vector<A>) -> A {
    a[0].fused(b[0], a[1].fused(b[1], a[2] * b[2]))
}

/// The vector of length 1 in this direction; the caller knows that its square neither overflows nor vanishes.
#[inline(always)]
pub(crate) fn normalize<A: Arithmetic>(a: Vector<A>) -> Vector<A> {
    scale(a, dot(a, a).root().inverse())
}

/// The direction that a mirror sends a ray; renormalised, so that long paths do not drift.
#[inline(always)]
pub(crate) fn reflect<A: Arithmetic>(direction: Vector<A>, normal: Vector<A>) -> Vector<A> {
    let towards = dot(direction, normal);
    normalize(fma(normal, -(towards + towards), direction))
}

/// Rows times vector.
#[inline(always)]
pub(crate) fn rows<A: Arithmetic>(m: &[A; 9], v: Vector<A>) -> Vector<A> {
    [
        dot([m[0], m[1], m[2]], v),
        dot([m[3], m[4], m[5]], v),
        dot([m[6], m[7], m[8]], v),
    ]
}

/// Columns times vector: the transpose of the rows.
#[inline(always)]
pub(crate) fn columns<A: Arithmetic>(m: &[A; 9], v: Vector<A>) -> Vector<A> {
    [
        dot([m[0], m[3], m[6]], v),
        dot([m[1], m[4], m[7]], v),
        dot([m[2], m[5], m[8]], v),
    ]
}

#[inline(always)]
pub(crate) fn neg<A: Arithmetic>(a: Vector<A>) -> Vector<A> {
    [-a[0], -a[1], -a[2]]
}
