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

/// Traces the pixels of a tile of the window, row by row; `spread` tells whether anybody asks how
/// far their samples are apart.
#[inline(always)]
pub(crate) fn trace_tile<R: Lanes, S: Simd>(
    scene: Stage<'_, R, S>,
    tile: &Tile,
    spread: bool,
    pixels: &mut [Pixel<R>],
) -> Stats {
    let mut walker = Walker::new(scene);
    let mut stats = Stats::default();
    let share = R::ONE / R::of(f64::from(scene.frame.samples));
    let places = tile
        .rows
        .clone()
        .flat_map(|row| tile.columns.clone().map(move |column| (column, row)));
    for ((column, row), pixel) in places.zip(pixels) {
        let (column, row) = (scene.frame.window_x + column, scene.frame.window_y + row);
        let mut spent = Spent::new(R::INFINITY);
        let mut sampled = spread.then(Sampled::default);
        let mut sum = [R::ZERO; 3];
        for (k, point) in scene.samples.iter().enumerate() {
            if spent.rays >= scene.frame.ray_budget {
                spent.dropped += scene.reach[scene.frame.raydepth as usize];
                spent.over = true;
                continue;
            }
            spent.rays += 1;
            stats.primary += 1;
            let (colour, first) = walker.walk(ray(&scene.frame, column, row, point), &mut spent);
            sum = fma(colour, R::ONE, sum);
            if let Some(sampled) = &mut sampled {
                sampled.add(in_doubles(colour), 0.0);
            }
            if k == 0 {
                (pixel.leaf, pixel.distance) = first;
            }
        }
        pixel.colour = if scene.samples.len() == 1 {
            sum
        } else {
            scale(sum, share)
        };
        let dropped = (spent.dropped * share).to_f64();
        if let Some(sampled) = &sampled {
            pixel.spread = sampled.spread_with(dropped);
        }
        stats.dropped = stats.dropped.max(dropped);
        stats.over_budget += u64::from(spent.over);
    }
    walker.tally.counted(stats)
}

/// Samples each pixel of the task until it has enough, at one of the stops, or the points or the rays run out.
#[inline(always)]
pub(crate) fn refine_run<R: Lanes, S: Simd>(
    scene: Stage<'_, R, S>,
    task: &Task<'_>,
    first: usize,
    pixels: &mut [Refined],
) -> Stats {
    let mut walker = Walker::new(scene);
    let mut stats = Stats::default();
    let columns = scene.frame.window_width as usize;
    for (number, pixel) in (first..).zip(pixels) {
        let place = task.pixels[number] as usize;
        let column = scene.frame.window_x + (place % columns) as u32;
        let row = scene.frame.window_y + (place / columns) as u32;
        let mut sampled = Sampled::default();
        let (mut rays, mut over) = (0, false);
        for point in SIDES.iter().filter(|_| task.sides) {
            stats.primary += 1;
            let mut spent = Spent::new(R::of(task.spare));
            spent.rays = rays + 1;
            let (colour, _) = walker.walk(ray(&scene.frame, column, row, &point.map(R::of)), &mut spent);
            sampled.see(in_doubles(colour));
            rays = spent.rays;
        }
        for point in &scene.samples {
            if rays >= scene.frame.ray_budget {
                break;
            }
            stats.primary += 1;
            let mut spent = Spent::new(R::of(task.spare));
            spent.rays = rays + 1;
            let (colour, _) = walker.walk(ray(&scene.frame, column, row, point), &mut spent);
            sampled.add(in_doubles(colour), spent.dropped.to_f64());
            (rays, over) = (spent.rays, over || spent.over);
            if sampled.is_stop() && (task.enough)(number, &sampled) {
                break;
            }
        }
        *pixel = Refined::from(&sampled);
        stats.dropped = stats.dropped.max(pixel.spread.dropped.into());
        stats.over_budget += u64::from(over);
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
