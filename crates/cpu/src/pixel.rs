//! From a pixel to its rays and back to one colour.

use fearless_simd::{Simd, SimdBase};
use scenec_picture::{NOTHING, Refined, SIDES, Sampled, Spread, Stats, Task};
use scenec_plan::{Real, in_doubles};

use crate::bands::Tile;
use crate::lanes::{LANES, Lanes, bits, load, select3, splat, splat3, store3};
use crate::path::{Paths, Room, Sample, Walker};
use crate::ray::Rays;
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

    /// Its pixels, neighbours together: of a tile's, four in each of two rows are eight.
    fn order(&self) -> Vec<u32> {
        let Self::Tile { tile, .. } = self else {
            return (0..).take(self.count()).collect();
        };
        let (width, height) = (tile.columns.len() as u32, tile.rows.len() as u32);
        let mut order = Vec::with_capacity(self.count());
        for top in (0..height).step_by(2) {
            for column in 0..width {
                order.extend((top..height.min(top + 2)).map(|row| row * width + column));
            }
        }
        order
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
pub(crate) fn trace<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, mut work: Work<'_, R>, room: &mut Room<R>) -> Stats {
    let mut stats = Stats::default();
    let sides = SIDES.map(|point| point.map(R::of));
    let (sides, spare) = match &work {
        Work::Tile { .. } => (&[][..], R::INFINITY),
        Work::Run { task, .. } => (if task.sides { &sides[..] } else { &[] }, R::of(task.spare)),
    };
    let mut walker = Walker::new(stage, room, work.count(), spare);
    let mut sums = Sums::new(&work, stage.samples.len());
    let mut open = work.order();
    let mut asked = Vec::with_capacity(open.len());
    for (place, point) in sides.iter().chain(&stage.samples).enumerate() {
        asked.clear();
        for number in &open {
            let sample = &mut walker.samples()[*number as usize];
            sample.colour = [R::ZERO; 3];
            if place < sides.len() || sample.spent.rays < stage.frame.ray_budget {
                sample.spent.rays += 1;
                asked.push(*number);
            } else if let Work::Tile { .. } = work {
                sample.spent.dropped += stage.reach[stage.frame.raydepth as usize];
                sample.spent.over = true;
            }
        }
        stats.primary += asked.len() as u64;
        for numbers in asked.chunks(LANES) {
            let paths = from_eye(stage, &work, numbers, *point);
            walker.step(&paths);
        }
        walker.follow();
        sums.add(&work, place < sides.len(), spare, &mut asked, walker.samples());
        if let Work::Run { .. } = work {
            std::mem::swap(&mut open, &mut asked);
        }
        if open.is_empty() {
            break;
        }
    }
    for (number, sample) in walker.samples().iter().enumerate() {
        let dropped = sums.finish(&mut work, number, sample);
        stats.dropped = stats.dropped.max(dropped);
        stats.over_budget += u64::from(sample.spent.over);
    }
    walker.counted(stats)
}

/// What the samples of each pixel add up to.
struct Sums<R> {
    colours: Vec<Vector<R>>,
    /// Only where somebody asks how far they are apart.
    sampled: Vec<Sampled>,
    share: R,
}

impl<R: Lanes> Sums<R> {
    fn new(work: &Work<'_, R>, samples: usize) -> Self {
        let wanted = match work {
            Work::Tile { spread, .. } => *spread && samples > 1,
            Work::Run { .. } => true,
        };
        Self {
            colours: vec![[R::ZERO; 3]; work.count()],
            sampled: vec![Sampled::default(); if wanted { work.count() } else { 0 }],
            share: R::ONE / R::of(samples as f64),
        }
    }

    /// Adds a sample of each of these pixels, or a look at one of their sides; those that have enough are taken out.
    fn add(&mut self, work: &Work<'_, R>, side: bool, spare: R, numbers: &mut Vec<u32>, samples: &mut [Sample<R>]) {
        numbers.retain(|number| {
            let number = *number as usize;
            let sample = &mut samples[number];
            self.colours[number] = fma(sample.colour, R::ONE, self.colours[number]);
            let Some(sampled) = self.sampled.get_mut(number) else {
                return true;
            };
            let colour = in_doubles(sample.colour);
            let Work::Run { task, first, .. } = work else {
                sampled.add(colour, 0.0);
                return true;
            };
            let dropped = sample.spent.dropped.to_f64();
            (sample.spent.dropped, sample.spent.spare) = (R::ZERO, spare);
            if side {
                sampled.see(colour);
                return true;
            }
            sampled.add(colour, dropped);
            !(sampled.is_stop() && (task.enough)(first + number, sampled))
        });
    }

    /// Puts a pixel where it belongs; the most that its dropped branches could have added.
    fn finish(&self, work: &mut Work<'_, R>, number: usize, sample: &Sample<R>) -> f64 {
        let sampled = self.sampled.get(number);
        match work {
            Work::Tile { pixels, spread, .. } => {
                let dropped = (sample.spent.dropped * self.share).to_f64();
                let (leaf, distance) = sample.first.unwrap_or((NOTHING, R::INFINITY));
                let sum = self.colours[number];
                pixels[number] = Pixel {
                    colour: if self.share == R::ONE {
                        sum
                    } else {
                        scale(sum, self.share)
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
                pixels[number] = sampled.map_or_else(Refined::default, Refined::from);
                pixels[number].spread.dropped.into()
            }
        }
    }
}

/// The rays from the eye through a point of some pixels, measured from the pixels' centres. The whole part of a position is an
/// integer that is exact in single precision.
#[inline(always)]
fn from_eye<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, work: &Work<'_, R>, numbers: &[u32], point: [R; 2]) -> Paths<R> {
    let (simd, frame) = (stage.simd, &stage.frame);
    let mut whole = [[R::ZERO; LANES]; 2];
    let mut sample = [0; LANES];
    for (lane, number) in numbers.iter().enumerate() {
        let (column, row) = work.place(*number as usize, frame.window_width);
        let (column, row) = (frame.window_x + column, frame.window_y + row);
        whole[0][lane] = R::of(2.0 * f64::from(column) + 1.0 - f64::from(frame.width));
        whole[1][lane] = R::of(2.0 * f64::from(row) + 1.0 - f64::from(frame.height));
        sample[lane] = *number;
    }
    let two = splat::<R, S>(simd, R::TWO);
    let offset = [two * splat::<R, S>(simd, point[0]), two * splat::<R, S>(simd, point[1])];
    let x = (load::<R, S>(simd, &whole[0]) + offset[0]) / splat::<R, S>(simd, R::of(frame.width.into()));
    let y = (load::<R, S>(simd, &whole[1]) + offset[1]) / splat::<R, S>(simd, R::of(frame.height.into()));
    let (right, up) = (splat3(simd, frame.right), splat3(simd, frame.up));
    let direction = normalize(fma(up, -y, fma(right, x, splat3(simd, frame.forward))));
    // An eye that is on no surface has the normal 0, and all rays go to its side.
    let normal = splat3(simd, frame.eye_normal);
    let behind = bits(dot(normal, direction).simd_lt(splat::<R, S>(simd, R::ZERO)));
    let local = if frame.eye_flat != 0 {
        select3::<R, S>(simd, behind, neg(normal), normal)
    } else {
        splat3(simd, frame.eye_local)
    };
    let side = |behind: u32| {
        if frame.eye_inside >> behind & 1 == 1 {
            u32::MAX
        } else {
            0
        }
    };
    let mut paths = Paths {
        sample,
        bounces: [frame.raydepth; LANES],
        lanes: (1 << numbers.len()) - 1,
        ..Paths::NONE
    };
    paths.rays = Rays {
        origin: store3(splat3::<R, S>(simd, frame.eye)),
        direction: store3(direction),
        local: store3(local),
        class: [frame.eye_class; LANES],
        into: behind,
        inside: behind & side(1) | !behind & side(0),
        ..Rays::EMPTY
    };
    paths
}
