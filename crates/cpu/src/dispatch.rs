//! One binary, fast everywhere: the tracer is compiled twice, and the copy that this processor can run is taken.

use std::ops::Range;

use scenec_picture::Stats;
use scenec_plan::{Packed, Real};

use crate::pixel::{self, Pixel};
use crate::refine::{Refined, Task};

/// Traces a run of the window's pixels, counted row by row.
pub(crate) fn trace_run<R: Real>(
    scene: &Packed<R>,
    range: Range<usize>,
    spread: bool,
    pixels: &mut [Pixel<R>],
) -> Stats {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        #[allow(unsafe_code)]
        // SAFETY: the function's only demand is that the processor has these features, which was just asked.
        return unsafe { trace_run_fma(scene, range, spread, pixels) };
    }
    // Without the instruction a fused multiply-add is a call: slow, and the same bits.
    pixel::trace_run(scene, range, spread, pixels)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn trace_run_fma<R: Real>(scene: &Packed<R>, range: Range<usize>, spread: bool, pixels: &mut [Pixel<R>]) -> Stats {
    pixel::trace_run(scene, range, spread, pixels)
}

/// Samples some of the window's pixels until each has enough.
pub(crate) fn refine_run<R: Real>(scene: &Packed<R>, task: &Task<'_>, first: usize, pixels: &mut [Refined]) -> Stats {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        #[allow(unsafe_code)]
        // SAFETY: the function's only demand is that the processor has these features, which was just asked.
        return unsafe { refine_run_fma(scene, task, first, pixels) };
    }
    pixel::refine_run(scene, task, first, pixels)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn refine_run_fma<R: Real>(scene: &Packed<R>, task: &Task<'_>, first: usize, pixels: &mut [Refined]) -> Stats {
    pixel::refine_run(scene, task, first, pixels)
}
