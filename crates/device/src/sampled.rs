//! What a device says of the samples of a pixel, as the picture's room has it.

use scenec_picture::Sampled;
use scenec_plan::{Real, packed_structs};

/// The same sums.
pub(crate) fn in_picture<R: Real>(sums: &packed_structs::Sampled<R>) -> Sampled {
    let colours = sums.red.iter().zip(&sums.green).zip(&sums.blue);
    let mut blocks = [[0.0; 3]; Sampled::BLOCKS];
    for (block, ((red, green), blue)) in blocks.iter_mut().zip(colours) {
        *block = [red, green, blue].map(|sum| sum.to_f64());
    }
    Sampled {
        count: sums.count,
        blocks,
        whole: sums.whole as usize,
        size: sums.size,
        filled: sums.filled,
        low: sums.low.map(R::to_f64),
        high: sums.high.map(R::to_f64),
        dropped: sums.dropped.to_f64(),
    }
}
