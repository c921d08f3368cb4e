//! What a picture will take, found out by tracing a coarse one first.
//!
//! A guess from the plan alone would have to know how many rays meet what; a coarse picture knows. It costs at most one
//! part in 64 of the whole. Where not even the most that the plan allows is long, there is no need to try.

use std::time::Instant;

use scenec_cpu::{Cpu, Number};
use scenec_picture::{Layers, Request, Stats, TraceError, Tracer, Window};
use scenec_plan::{Features, Plan};

/// Columns and rows are divided by this, at least.
const DIVISOR: u32 = 8;
/// Pixels beyond this tell nothing new.
const ENOUGH: f64 = 8192.0;

/// What takes less than this, nanoseconds, is timed twice.
const SHORT: u64 = 5_000_000;
/// More base objects than this are not simple.
const SIMPLE: usize = 32;
/// What a ray costs, and a base object that it may meet, nanoseconds: as measured, and rounded up.
const RAY: f64 = 40.0;
const MEETING: f64 = 12.0;

/// What the built-in tracer would take for the whole picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forecast {
    /// Nanoseconds.
    pub(crate) nanoseconds: f64,
    /// Rays by kind.
    pub(crate) stats: Stats,
    /// How many pixels were traced to find out.
    pub(crate) tried: u64,
}

/// Traces a coarse picture of what the request asks for; afterwards the tracer is as it was.
///
/// # Errors
/// Those of the tracer.
pub(crate) fn forecast<R: Number>(
    cpu: &mut Cpu<R>,
    plan: &Plan,
    request: &Request<'_>,
) -> Result<Forecast, TraceError> {
    let (view, window) = (&plan.view, request.window);
    let divisor = divisor(window.pixels());
    let part = |length: u32| (length / divisor).max(1);
    let coarse = Window {
        x: window.x / divisor,
        y: window.y / divisor,
        width: part(window.width),
        height: part(window.height),
    };
    let (columns, rows) = (
        part(view.width).max(coarse.x + coarse.width),
        part(view.height).max(coarse.y + coarse.height),
    );
    cpu.divide(columns, rows, view.samples.get(..1).unwrap_or_default());
    let request = Request {
        window: coarse,
        layers: Layers::default(),
        ..*request
    };
    let traced = timed(cpu, &request).and_then(|(stats, time)| match time {
        // So short a time is mostly that of waking threads and of caches that are cold.
        SHORT.. => Ok((stats, time)),
        _ => timed(cpu, &request).map(|(_, again)| (stats, time.min(again))),
    });
    cpu.divide(view.width, view.height, &view.samples);
    let (stats, time) = traced?;
    let times = window.pixels() as f64 * view.samples.len() as f64 / coarse.pixels() as f64;
    Ok(Forecast {
        nanoseconds: time as f64 * times,
        stats: scaled(&stats, times),
        tried: coarse.pixels(),
    })
}

/// What it took, and the nanoseconds.
fn timed<R: Number>(cpu: &mut Cpu<R>, request: &Request<'_>) -> Result<(Stats, u64), TraceError> {
    let begin = Instant::now();
    let stats = cpu.trace(request)?.stats;
    Ok((stats, begin.elapsed().as_nanos().try_into().unwrap_or(u64::MAX)))
}

/// The most nanoseconds that the built-in tracer can take for a plan, if it is a simple one: each path bounces as often as
/// it may, each hit sees every light, and each ray meets every base object.
pub(crate) fn most(plan: &Plan, request: &Request<'_>, threads: usize) -> Option<f64> {
    let features = Features::of(plan);
    let leaves = plan.members.len().max(plan.leaves.len());
    if leaves > SIMPLE || features.programs || features.cells || features.branching {
        return None;
    }
    let bounces = if features.reflections { plan.view.raydepth } else { 0 };
    let rays = (1.0 + f64::from(bounces)) * (1.0 + plan.lights.len() as f64);
    let ray = RAY + MEETING * leaves as f64;
    let samples = request.window.pixels() as f64 * plan.view.samples.len() as f64;
    Some(samples * rays * ray / threads.max(1) as f64)
}

fn divisor(pixels: u64) -> u32 {
    // A picture has at most 2^32 pixels, so the root is small.
    DIVISOR.max((pixels as f64 / ENOUGH).sqrt() as u32)
}

fn scaled(stats: &Stats, times: f64) -> Stats {
    let many = |count: u64| (count as f64 * times).round() as u64;
    Stats {
        primary: many(stats.primary),
        shadow: many(stats.shadow),
        reflected: many(stats.reflected),
        refracted: many(stats.refracted),
        ..Stats::default()
    }
}

#[cfg(test)]
mod tests {
    use super::divisor;

    fn check(pixels: u64, expect: u32) {
        assert_eq!(divisor(pixels), expect, "{pixels}");
    }

    #[test]
    fn the_coarse_picture_is_a_small_part_and_never_a_large_one() {
        check(1, 8);
        check(600 * 400, 8);
        check(3840 * 2160, 31);
        check(65535 * 65535, 724);
    }
}
