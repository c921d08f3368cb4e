//! One binary, fast everywhere: the tracer is compiled several times, and the copy that this processor runs best is taken.

use fearless_simd::{Level, Simd};
use scenec_picture::Stats;

use crate::lanes::Lanes;
use crate::path::Room;
use crate::pixel::{self, Work};
use crate::stage::{Prepared, Stage};

/// Runs something that is written over a stage with the widest vectors that there are. Where a processor has no fused
/// multiply-add it is a call: slow, and the same bits.
macro_rules! widest {
    ($scene:expr, $stage:ident => $work:expr) => {{
        let (scene, level) = ($scene, Level::new());
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = level.as_avx512() {
            let $stage = Stage { scene, simd };
            return simd.vectorize(#[inline(always)] || $work);
        }
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = level.as_avx2() {
            let $stage = Stage { scene, simd };
            return simd.vectorize(#[inline(always)] || $work);
        }
        // Every other processor of this kind has the vectors of its first ones; the general way would compile the copies
        // above once more.
        #[cfg(target_arch = "x86_64")]
        return level.as_sse2().map_or_else(Stats::default, |simd| {
            let $stage = Stage { scene, simd };
            simd.vectorize(#[inline(always)] || $work)
        });
        #[cfg(not(target_arch = "x86_64"))]
        fearless_simd::dispatch!(level, simd => {
            let $stage = Stage { scene, simd };
            $work
        })
    }};
}

/// A number that pictures are traced in: f32 or f64, and no other.
#[allow(private_bounds, reason = "how it is traced is nobody's business but this room's")]
pub trait Number: Traced {}

impl Number for f32 {}
impl Number for f64 {}

/// A number with tracers of its own. Implemented for each by hand, so that they are compiled here once and not wherever
/// somebody asks for a picture.
pub(crate) trait Traced: Lanes {
    /// Traces some of the window's pixels.
    fn trace(scene: &Prepared<Self>, work: Work<'_, Self>, room: &mut Room<Self>) -> Stats;
}

macro_rules! traced {
    ($number:ty) => {
        impl Traced for $number {
            fn trace(scene: &Prepared<Self>, work: Work<'_, Self>, room: &mut Room<Self>) -> Stats {
                widest!(scene, stage => pixel::trace(stage, work, room))
            }
        }
    };
}

traced!(f32);
traced!(f64);
