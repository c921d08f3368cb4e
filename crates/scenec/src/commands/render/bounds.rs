//! How wrong the picture may be: the tolerance that is asked for, the map of bounds, and what is said of both.

use std::path::{Path, PathBuf};

use clap::Args;
use scenec_measure::{Bound, Doubt, Tolerance};
use scenec_picture::{Depth, Picture, Window, heat};

use super::account::grouped;
use super::machine::Promise;
use super::target::Target;
use crate::failure::Failure;
use crate::values;

/// The most pixels of which is told how far their samples are apart: a hundred bytes for each.
pub(super) const MOST_PIXELS: u64 = 1 << 23;

/// Arguments about how wrong the picture may be.
#[derive(Args, Debug)]
#[command(next_help_heading = "Bounds")]
pub(super) struct BoundOptions {
    /// Sample until no colour component may be off by more than this: `1/255`, `0.004` or `0.4%`
    ///
    /// Each pixel takes as many samples, and drops as many faint branches of its paths, as its bound allows; those of the
    /// file, --samples and --cutoff do not count. What branches may add is proven, what roundings and more samples may
    /// change is estimated. Where a pixel can't be brought below, the picture is written all the same, a
    /// warning says how many there are and why, and the exit code is 4. Unless --device says otherwise, the built-in tracer does it.
    #[arg(long, value_name = "T", value_parser = values::tolerance, conflicts_with_all = ["samples", "cutoff"])]
    pub(super) tolerance: Option<f64>,
    /// The most samples that one pixel may take for --tolerance
    #[arg(long, value_name = "N", requires = "tolerance", default_value_t = Tolerance::MOST_SAMPLES,
        value_parser = clap::value_parser!(u32).range(16..=i64::from(Tolerance::MOST_SAMPLES)))]
    pub(super) most_samples: u32,
    /// Write how wrong each pixel may be as a picture too: numbers in floating-point formats, colours in others
    ///
    /// In colours, black is up to 1/65536, blue about 1/4096, red about 1/256, yellow about 1/16 and white from 1 on; green
    /// is where there is no bound.
    #[arg(long, value_name = "FILE")]
    error_map: Option<PathBuf>,
}

impl BoundOptions {
    /// The place of the map, if it is wanted.
    pub(super) fn map(&self, input: &Path, picture: &Target) -> Result<Option<Target>, Failure> {
        let map = self
            .error_map
            .as_deref()
            .map(|path| Target::beside(path, input, picture));
        map.transpose()
    }

    /// Whether the tracer is to tell how far samples are apart: for the map, and where it is no burden for whoever asks.
    pub(super) fn spread(&self, window: &Window, asked: bool) -> bool {
        self.error_map.is_some() || (asked && window.pixels() <= MOST_PIXELS)
    }

    /// Refuses a map that would take too much memory.
    pub(super) fn check(&self, window: &Window) -> Result<(), Failure> {
        if self.error_map.is_some() && self.tolerance.is_none() && window.pixels() > MOST_PIXELS {
            return Err(Failure::Unusable(format!(
                "an error map without --tolerance is made of at most {} pixels; --size and --crop make it smaller",
                grouped(MOST_PIXELS)
            )));
        }
        Ok(())
    }

    /// The option that is about the bound of each pixel, if there is one; such a picture is held as a whole.
    pub(super) fn bounded_by(&self) -> Option<&'static str> {
        let map = self.error_map.as_ref().map(|_| "--error-map");
        self.tolerance.map(|_| "--tolerance").or(map)
    }
}

/// The map as a picture for a target.
pub(super) fn map(doubts: &[Doubt], width: u32, height: u32, target: &Target) -> Result<Picture, Failure> {
    let mut map = Picture::black(width, height).map_err(Failure::unusable)?;
    let raw = target.depth() == Depth::Float;
    for (pixel, doubt) in map.pixels_mut().iter_mut().zip(doubts) {
        let bound = doubt.bound() as f32;
        *pixel = [if raw { bound.min(f32::MAX) } else { bound }; 3];
    }
    if raw {
        return Ok(map);
    }
    let black = Picture::black(width, height).map_err(Failure::unusable)?;
    heat(&black, &map).map_err(Failure::unusable)
}

/// The parts of a bound, in words.
pub(super) fn words(bound: &Bound) -> String {
    format!(
        "at most {:.3e} of any colour component: truncation {:.3e} (proven), rounding {:.3e} and sampling {:.3e} (estimated)",
        bound.max, bound.truncation, bound.rounding, bound.sampling
    )
}

/// What was spent on a tolerance.
pub(super) fn spent(promise: &Promise) -> String {
    let (mut sum, mut most) = (0_u64, 0);
    for samples in &promise.samples {
        (sum, most) = (sum + u64::from(*samples), most.max(*samples));
    }
    let mean = sum as f64 / promise.samples.len().max(1) as f64;
    format!("{mean:.1} samples per pixel, {} at most", grouped(most.into()))
}

/// Why pixels are not within the tolerance, each counted once; `None` if all are.
pub(super) fn shortfall(promise: &Promise, doubts: &[Doubt]) -> Option<String> {
    let tolerance = promise.tolerance;
    let mut reasons = [
        ("what was left out for the ray budget may add too much", 0_u64),
        ("roundings may change too much", 0),
        ("more samples than allowed would be needed", 0),
    ];
    for doubt in doubts.iter().filter(|doubt| doubt.bound() > tolerance) {
        let [truncation, rounding] = [doubt.truncation, doubt.rounding].map(f64::from);
        let reason = if truncation > tolerance {
            0
        } else if truncation + rounding > tolerance {
            1
        } else {
            2
        };
        reasons[reason].1 += 1;
    }
    let missed: u64 = reasons.iter().map(|(_, count)| count).sum();
    let why = reasons.iter().filter(|(_, count)| *count > 0);
    let why: Vec<_> = why
        .map(|(reason, count)| format!("of {} {reason}", grouped(*count)))
        .collect();
    (missed > 0).then(|| {
        format!(
            "{} of {} pixels may be off by more than {tolerance:.3e}, up to {:.3e}: {}",
            grouped(missed),
            grouped(doubts.len() as u64),
            Bound::of(doubts).max,
            why.join(", ")
        )
    })
}
