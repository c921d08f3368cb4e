//! Filters of rows and columns. All of them are products of one along the rows and one along the columns.

use std::f64::consts::PI;
use std::ops::Range;

use super::colour::Opponent;
use crate::Picture;

/// A filter along one direction: an odd number of weights, the middle one for the place itself.
#[derive(Clone, Debug)]
pub(super) struct Kernel(Vec<f32>);

impl Kernel {
    /// The filters of one channel of the eye, whose results add up: each of (weight a, width b) is a Gaussian
    /// a sqrt(pi/b) exp(-pi² d²/b) of the distance d in degrees, and all together leave an even colour as it is.
    pub(super) fn sensitivities<const N: usize>(parts: &[(f64, f64); N], pixels_per_degree: f64) -> [Self; N] {
        /// The widest of all channels: all reach equally far.
        const WIDEST: f64 = 0.04;
        let radius = 3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree;
        let shapes = parts.map(|(a, b)| {
            let bell = weights(radius, |x| (-(PI * x / pixels_per_degree).powi(2) / b).exp());
            let sum: f64 = bell.iter().sum();
            // Along rows and along columns: each part counts with the square of its sum.
            (bell, a * (PI / b).sqrt(), sum)
        });
        let whole: f64 = shapes.iter().map(|(_, weight, sum)| weight * sum * sum).sum();
        shapes.map(|(bell, weight, _)| Self::of(&bell, (weight / whole).sqrt()))
    }

    /// A Gaussian of this deviation in pixels, of sum 1.
    pub(super) fn smooth(deviation: f64) -> Self {
        let bell = weights(3.0 * deviation, |x| gauss(x, deviation));
        let sum: f64 = bell.iter().sum();
        Self::of(&bell, 1.0 / sum)
    }

    /// Its slope: finds edges.
    pub(super) fn edge(deviation: f64) -> Self {
        Self::balanced(&weights(3.0 * deviation, |x| -x * gauss(x, deviation)))
    }

    /// Its curvature: finds points and lines.
    pub(super) fn point(deviation: f64) -> Self {
        let curve = |x: f64| ((x / deviation).powi(2) - 1.0) * gauss(x, deviation);
        Self::balanced(&weights(3.0 * deviation, curve))
    }

    /// The positive weights sum up to 1, the negative ones to -1.
    fn balanced(weights: &[f64]) -> Self {
        let sum = |sign: f64| {
            weights
                .iter()
                .map(|w| (w * sign).max(0.0))
                .sum::<f64>()
                .max(f64::MIN_POSITIVE)
        };
        let (positive, negative) = (sum(1.0), sum(-1.0));
        let scaled = weights
            .iter()
            .map(|w| if *w < 0.0 { w / negative } else { w / positive });
        Self(scaled.map(|w| w as f32).collect())
    }

    fn of(weights: &[f64], factor: f64) -> Self {
        Self(weights.iter().map(|w| (w * factor) as f32).collect())
    }

    /// How far it reaches, in pixels.
    pub(super) fn radius(&self) -> usize {
        self.0.len() / 2
    }
}

fn gauss(x: f64, deviation: f64) -> f64 {
    (-0.5 * (x / deviation).powi(2)).exp()
}

fn weights(radius: f64, weight: impl Fn(f64) -> f64) -> Vec<f64> {
    let radius = radius.ceil() as i32;
    (-radius..=radius).map(|x| weight(f64::from(x))).collect()
}

/// Some rows of a picture with those around them; beyond its edges the picture goes on as it ends.
pub(super) struct Band {
    /// The channels, row by row.
    pub(super) opponent: [Vec<f32>; 3],
    width: usize,
    halo: usize,
}

impl Band {
    pub(super) fn of(picture: &Picture, rows: Range<u32>, halo: usize) -> Self {
        let last = picture.height().saturating_sub(1);
        let reach = halo as u32;
        let mut opponent = [const { Vec::new() }; 3];
        for row in 0..rows.end - rows.start + 2 * reach {
            let row = (rows.start + row).saturating_sub(reach).min(last);
            for pixel in picture.row(row) {
                for (plane, value) in opponent.iter_mut().zip(Opponent::of_shown(*pixel).0) {
                    plane.push(value);
                }
            }
        }
        Self {
            opponent,
            width: picture.width() as usize,
            halo,
        }
    }

    /// One of its channels through a filter along the rows and one along the columns; without the rows around.
    pub(super) fn filter(&self, plane: &[f32], across: &Kernel, down: &Kernel) -> Vec<f32> {
        let mut filtered = Vec::with_capacity(plane.len());
        let mut padded = Vec::new();
        for row in plane.chunks_exact(self.width) {
            self.pad(row, across.radius(), &mut padded);
            filtered.extend(padded.windows(across.0.len()).map(|part| weigh(part, &across.0)));
        }
        let rows: Vec<&[f32]> = filtered.chunks_exact(self.width).collect();
        let skipped = self.halo - down.radius();
        let inner = &rows[skipped..rows.len() - skipped];
        let mut out = Vec::with_capacity(plane.len());
        for part in inner.windows(down.0.len()) {
            let start = out.len();
            out.resize(start + self.width, 0.0);
            for (row, weight) in part.iter().zip(&down.0) {
                for (sum, value) in out[start..].iter_mut().zip(*row) {
                    *sum += weight * value;
                }
            }
        }
        out
    }

    fn pad(&self, row: &[f32], by: usize, padded: &mut Vec<f32>) {
        let ends = row.first().zip(row.last());
        let (first, last) = ends.map_or((0.0, 0.0), |(first, last)| (*first, *last));
        padded.clear();
        padded.resize(by, first);
        padded.extend_from_slice(row);
        padded.resize(self.width + 2 * by, last);
    }
}

fn weigh(values: &[f32], weights: &[f32]) -> f32 {
    values.iter().zip(weights).map(|(value, weight)| value * weight).sum()
}
