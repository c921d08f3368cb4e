//! From a pixel to its rays and back to one colour.

use fearless_simd::Simd;
use scenec_picture::{NOTHING, Refined, SIDES, Sampled, Spread, Stats, Task};
use scenec_plan::packed_structs::Frame;
use scenec_plan::{Real, in_doubles};

use crate::bands::Tile;
use crate::lanes::Lanes;
use crate::path::{Spent, Walker};
use crate::ray::{End, Ray};
use crate::stage::Stage;
use crate::vector::{Vector, dot, fma, neg, normalize, scale};

/// A traced pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pixel<R> {
    /// The mean of its samples.
    pub(crate) colour: Vector<R>,
    /// The leaf that its first sample hits, or [`NOTHING`].
    pub(crate) leaf: u32,
    /// How far away that is, plan units.
    pub(crate) distance: R,
    /// How far its samples are apart.
    pub(crate) spread: Spread,
}

impl<R: Real> Default for Pixel<R> {
    fn default() -> Self {
        Self {
            colour: [R::ZERO; 3],
            leaf: NOTHING,
            distance: R::INFINITY,
            spread: Spread::default(),
        }
    }
}

/// What is asked of some pixels of the window.
pub(crate) enum Work<'a, R> {
    /// All samples of a tile's, row by row.
    Tile {
        tile: &'a Tile,
        /// Whether anybody asks how far their samples are apart.
        spread: bool,
        pixels: &'a mut [Pixel<R>],
    },
    /// As many samples of each, from the task's `first` on, as it takes: until there are enough, at one of the stops, or the
    /// points or the rays run out.
    Run {
        task: &'a Task<'a>,
        first: usize,
        pixels: &'a mut [Refined],
    },
}

impl<R: Real> Work<'_, R> {
    const fn count(&self) -> usize {
        match self {
            Self::Tile { pixels, .. } => pixels.len(),
            Self::Run { pixels, .. } => pixels.len(),
        }
    }

    /// The column and row of a pixel in the window.
    #[inline(always)]
    fn place(&self, number: usize, columns: u32) -> (u32, u32) {
        match self {
            Self::Tile { tile, .. } => {
                let (number, columns) = (number as u32, tile.columns.len() as u32);
                (
                    tile.columns.start + number % columns,
                    tile.rows.start + number / columns,
                )
            }
            Self::Run { task, first, .. } => {
                let place = task.pixels[first + number];
                (place % columns, place / columns)
            }
        }
    }
}

/// Does the work.
// One function for either kind of work, since the tracer becomes a part of it: another one would hold another copy.
#[inline(always)]
pub(crate) fn trace<R: Lanes, S: Simd>(scene: Stage<'_, R, S>, mut work: Work<'_, R>) -> Stats {
    let mut walker = Walker::new(scene);
    let mut stats = Stats::default();
    let share = R::ONE / R::of(f64::from(scene.frame.samples));
    let spare = match &work {
        Work::Tile { .. } => R::INFINITY,
        Work::Run { task, .. } => R::of(task.spare),
    };
    let samples_matter = match &work {
        Work::Tile { spread, .. } => *spread && scene.samples.len() > 1,
        Work::Run { .. } => true,
    };
    let sides = SIDES.map(|point| point.map(R::of));
    let sides = match &work {
        Work::Run { task, .. } if task.sides => &sides[..],
        _ => &[],
    };
    for number in 0..work.count() {
        let (column, row) = work.place(number, scene.frame.window_width);
        let (column, row) = (scene.frame.window_x + column, scene.frame.window_y + row);
        let mut spent = Spent::new(spare);
        let mut sampled = samples_matter.then(Sampled::default);
        let mut sum = [R::ZERO; 3];
        let mut seen = None;
        for (place, point) in sides.iter().chain(&scene.samples).enumerate() {
            let side = place < sides.len();
            if !side && spent.rays >= scene.frame.ray_budget {
                if let Work::Run { .. } = work {
                    break;
                }
                spent.dropped += scene.reach[scene.frame.raydepth as usize];
                spent.over = true;
                continue;
            }
            spent.rays += 1;
            stats.primary += 1;
            let (colour, hit) = walker.walk(ray(&scene.frame, column, row, point), &mut spent);
            sum = fma(colour, R::ONE, sum);
            seen = seen.or(Some(hit));
            match (&mut sampled, &work) {
                (None, _) => {}
                (Some(sampled), Work::Tile { .. }) => sampled.add(in_doubles(colour), 0.0),
                (Some(sampled), Work::Run { task, first, .. }) => {
                    let dropped = spent.dropped.to_f64();
                    (spent.dropped, spent.spare) = (R::ZERO, spare);
                    if side {
                        sampled.see(in_doubles(colour));
                        continue;
                    }
                    sampled.add(in_doubles(colour), dropped);
                    if sampled.is_stop() && (task.enough)(first + number, sampled) {
                        break;
                    }
                }
            }
        }
        let dropped = match &mut work {
            Work::Tile { pixels, spread, .. } => {
                let dropped = (spent.dropped * share).to_f64();
                let (leaf, distance) = seen.unwrap_or((NOTHING, R::INFINITY));
                pixels[number] = Pixel {
                    colour: if scene.samples.len() == 1 {
                        sum
                    } else {
                        scale(sum, share)
                    },
                    leaf,
                    distance,
                    spread: match sampled {
                        Some(sampled) => sampled.spread_with(dropped),
                        None if *spread => Spread::of_one(in_doubles(sum), dropped),
                        None => Spread::default(),
                    },
                };
                dropped
            }
            Work::Run { pixels, .. } => {
                pixels[number] = sampled.as_ref().map_or_else(Refined::default, Refined::from);
                pixels[number].spread.dropped.into()
            }
        };
        stats.dropped = stats.dropped.max(dropped);
        stats.over_budget += u64::from(spent.over);
    }
    walker.tally.counted(stats)
}

/// The ray from the eye through a point of a pixel, measured from the pixel's centre. The whole part of the position is
/// an integer that is exact in single precision.
#[inline(always)]
fn ray<R: Real>(frame: &Frame<R>, column: u32, row: u32, point: &[R; 2]) -> Ray<R> {
    let place = |index: u32, count: u32, offset: R| {
        let whole = R::of(2.0 * f64::from(index) + 1.0 - f64::from(count));
        (whole + R::TWO * offset) / R::of(f64::from(count))
    };
    let x = place(column, frame.width, point[0]);
    let y = -place(row, frame.height, point[1]);
    let direction = normalize(fma(frame.up, y, fma(frame.right, x, frame.forward)));
    // An eye that is on no surface has the normal 0, and all rays go to its side.
    let behind = dot(frame.eye_normal, direction) < R::ZERO;
    let side = if behind {
        neg(frame.eye_normal)
    } else {
        frame.eye_normal
    };
    Ray {
        origin: frame.eye,
        direction,
        local: if frame.eye_flat != 0 { side } else { frame.eye_local },
        class: frame.eye_class,
        into: behind,
        inside: frame.eye_inside >> u32::from(behind) & 1 == 1,
        end: End::NONE,
    }
}
