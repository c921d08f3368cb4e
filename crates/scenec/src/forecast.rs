//! What a picture will take, found out by tracing some of it first.
//!
//! A guess from the plan alone would have to know how many rays meet what; pixels that were traced know. They are tiles of
//! neighbours, all over the picture: rays that are close together meet the same parts of a scene, and what one of them takes
//! from memory is there for the next. It costs at most one part in 64 of the whole, but for a picture of a few pixels. Where
//! not even the most that the plan allows is long, there is no need to try.

use std::time::Instant;

use scenec_cpu::{Cpu, Number};
use scenec_picture::{Refiner, Request, Stats, Task, TraceError, Window};
use scenec_plan::{Features, Plan};

/// They are traced so often, and the shortest time counts: after the first, threads are awake, and a tile finds in the caches
/// what a neighbour would have left there.
const TIMES: u32 = 2;
/// One pixel in so many is traced each time.
const SHARE: u64 = 64 * TIMES as u64;
/// Pixels beyond this tell nothing new.
const ENOUGH: u64 = 8192;
/// Columns and rows of a tile, as the tracer itself divides a picture.
const TILE: [u32; 2] = [16, 8];
/// Where so many tiles would be too much, they are smaller.
const SPREAD: u64 = 16;

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

/// Traces some pixels of what the request asks for; afterwards the tracer is as it was.
///
/// # Errors
/// Those of the tracer.
pub(crate) fn forecast<R: Number>(
    cpu: &mut Cpu<R>,
    plan: &Plan,
    request: &Request<'_>,
) -> Result<Forecast, TraceError> {
    let (view, window) = (&plan.view, request.window);
    let pixels = tiles(window);
    cpu.divide(view.width, view.height, view.samples.get(..1).unwrap_or_default());
    let runs: Result<Vec<_>, _> = (0..TIMES).map(|_| timed(cpu, &pixels, request)).collect();
    cpu.divide(view.width, view.height, &view.samples);
    let runs = runs?;
    let time = runs.iter().map(|(_, time)| *time).min().unwrap_or_default();
    let stats = runs.first().map(|(stats, _)| *stats).unwrap_or_default();
    let times = window.pixels() as f64 * view.samples.len() as f64 / pixels.len() as f64;
    Ok(Forecast {
        nanoseconds: time as f64 * times,
        stats: scaled(&stats, times),
        tried: pixels.len() as u64,
    })
}

/// What it took, and the nanoseconds.
fn timed<R: Number>(cpu: &mut Cpu<R>, pixels: &[u32], request: &Request<'_>) -> Result<(Stats, u64), TraceError> {
    let task = Task {
        pixels,
        enough: &|_, _| true,
        sides: false,
        spare: f64::INFINITY,
    };
    let begin = Instant::now();
    let (_, stats) = cpu.refine(request.window, request.limits, &task, request.watch)?;
    Ok((stats, begin.elapsed().as_nanos().try_into().unwrap_or(u64::MAX)))
}

/// Pixels of a window, counted row by row: of tiles that stand on a grid, the neighbours of each together.
fn tiles(window: Window) -> Vec<u32> {
    let (width, height) = (window.width, window.height);
    let wanted = (window.pixels() / SHARE).clamp(1, ENOUGH);
    let [mut across, mut down] = TILE;
    while down > 2 && SPREAD * u64::from(across * down) > wanted {
        (across, down) = (across / 2, down / 2);
    }
    let (across, down) = (across.min(width).max(1), down.min(height).max(1));
    let count = (wanted / u64::from(across * down)).max(1) as f64;
    let columns = (count * f64::from(width) / f64::from(height.max(1))).sqrt().round();
    let columns = (columns.min(count) as u32).clamp(1, (width / across).max(1));
    let rows = ((count / f64::from(columns)) as u32).clamp(1, (height / down).max(1));
    let mut pixels = Vec::new();
    for top in starts(height, rows, down) {
        for left in starts(width, columns, across) {
            // Two rows at a time, as eight rays that go together come from.
            for row in (0..down).step_by(2) {
                for column in left..left + across {
                    let pair = top + row..top + down.min(row + 2);
                    pixels.extend(pair.map(|row| row * width + column));
                }
            }
        }
    }
    pixels
}

/// Where so many parts of a length begin that are in the middle of equal ones of it.
fn starts(length: u32, parts: u32, part: u32) -> impl Iterator<Item = u32> {
    let middle = move |i| (2 * u64::from(i) + 1) * u64::from(length) / (2 * u64::from(parts));
    (0..parts).map(move |i| middle(i) as u32 - part / 2)
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
    use std::collections::HashSet;

    use scenec_picture::Window;

    use super::tiles;

    /// How many pixels are traced, of which none is outside or named twice, and all quarters of a large picture have some.
    fn check(width: u32, height: u32, expect: usize) {
        let pixels = tiles(Window::whole(width, height));
        assert_eq!(pixels.len(), expect, "{width} x {height}");
        let places: HashSet<_> = pixels.iter().map(|pixel| (pixel % width, pixel / width)).collect();
        assert_eq!(places.len(), expect, "{width} x {height}");
        assert!(places.iter().all(|(_, row)| *row < height), "{width} x {height}");
        let quarters: HashSet<_> = places.iter().map(|(x, y)| (x * 2 / width, y * 2 / height)).collect();
        assert!(width.min(height) < 64 || quarters.len() == 4, "{width} x {height}");
    }

    #[test]
    fn the_tiles_are_a_small_part_and_never_a_large_one() {
        check(1, 1, 1);
        check(3, 1, 3);
        check(64, 48, 16);
        check(600, 400, 1728);
        check(1280, 720, 6400);
        check(3840, 2160, 7040);
        check(7, 65535, 3528);
        check(65535, 3, 1512);
        check(65535, 65535, 8192);
    }
}
