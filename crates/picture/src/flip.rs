//! How different two pictures look to somebody who flips between them: the FLIP of Andersson, Nilsson, Akenine-Möller,
//! Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating Images" (2020), for pictures of low
//! dynamic range.
//!
//! Both pictures are blurred as the eye blurs each of its three colour channels, the colours that remain are compared
//! where equal steps look equal, and a difference counts for more where an edge or a point comes or goes with it. It must
//! not know of tracers: a difference is one whoever made it.

mod colour;
mod filter;

use crate::compare::{SizesDiffer, same_size};
use crate::{Picture, TooManyPixels};
use colour::{Opponent, difference};
use filter::{Band, Kernel};

/// Rows that are worked on together: what is held besides the pictures is that many rows and their surroundings.
const BAND: u32 = 32;

/// How different two pictures look.
#[derive(Clone, PartialEq, Debug)]
pub struct Flip {
    /// A number of 0 to 1 for each pixel, row by row.
    pub map: Vec<f32>,
    /// Their mean.
    pub mean: f64,
}

impl Flip {
    /// Pixels in one degree of the visual angle at 0.7 m from a screen 0.7 m and 3840 pixels wide: the distance that the
    /// authors take unless told another.
    pub const PIXELS_PER_DEGREE: f64 = 67.0;
}

/// Compares what a screen shows of two pictures: components are clamped to 0..1 and taken as encoded by the curve of
/// sRGB, which is how a file of integer levels is shown. What is not a number counts as 0. `pixels_per_degree` says
/// how near the screen is; it is taken to be in 1..=1000.
///
/// # Errors
/// If the sizes differ, or there is no memory for the map.
pub fn flip(first: &Picture, second: &Picture, pixels_per_degree: f64) -> Result<Flip, FlipError> {
    same_size(first, second)?;
    let (width, height) = (first.width(), first.height());
    let mut map = Vec::new();
    map.try_reserve_exact(first.pixels().len())
        .map_err(|_| TooManyPixels { width, height })?;
    let lens = Lens::new(pixels_per_degree.clamp(1.0, 1000.0));
    for start in (0..height).step_by(BAND as usize) {
        let rows = start..start.saturating_add(BAND).min(height);
        let [first, second] = [first, second].map(|picture| lens.look(&Band::of(picture, rows.clone(), lens.halo())));
        let pixels = first.colour.iter().zip(&second.colour);
        let features = first.features.iter().zip(&second.features);
        map.extend(pixels.zip(features).map(|((a, b), (c, d))| {
            // The square root of the paper's exponent 1/2, with the length of two unit vectors to normalise.
            let change = [0, 1].map(|index| (c[index] - d[index]).abs());
            let change = (change[0].max(change[1]) * std::f32::consts::FRAC_1_SQRT_2).sqrt();
            difference(*a, *b).powf(1.0 - change.clamp(0.0, 1.0))
        }));
    }
    let sum: f64 = map.iter().copied().map(f64::from).sum();
    let mean = sum / map.len().max(1) as f64;
    Ok(Flip { map, mean })
}

/// Why two pictures could not be compared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FlipError {
    /// They have no pixels in common.
    Sizes(SizesDiffer),
    /// The map does not fit into memory.
    Memory(TooManyPixels),
}

impl std::fmt::Display for FlipError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Sizes(error) => error.fmt(f),
            Self::Memory(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for FlipError {}

impl From<SizesDiffer> for FlipError {
    fn from(error: SizesDiffer) -> Self {
        Self::Sizes(error)
    }
}

impl From<TooManyPixels> for FlipError {
    fn from(error: TooManyPixels) -> Self {
        Self::Memory(error)
    }
}

/// The filters at one distance.
struct Lens {
    /// The paper's table 1: the widths b and the weights a of the eye's contrast sensitivity, by channel.
    luminance: Kernel,
    red_green: Kernel,
    blue_yellow: [Kernel; 2],
    smooth: Kernel,
    edge: Kernel,
    point: Kernel,
}

/// What is seen of a band.
struct Sight {
    /// Linear RGB of 0 to 1, blurred.
    colour: Vec<[f32; 3]>,
    /// How much of an edge and of a point is there.
    features: Vec<[f32; 2]>,
}

impl Lens {
    fn new(pixels_per_degree: f64) -> Self {
        /// The width of the features, in degrees (w of the paper).
        const FEATURE: f64 = 0.082;
        let deviation = 0.5 * FEATURE * pixels_per_degree;
        let [wide, narrow] = Kernel::sensitivities(&[(34.1, 0.04), (13.5, 0.025)], pixels_per_degree);
        let [luminance] = Kernel::sensitivities(&[(1.0, 0.0047)], pixels_per_degree);
        let [red_green] = Kernel::sensitivities(&[(1.0, 0.0053)], pixels_per_degree);
        Self {
            luminance,
            red_green,
            blue_yellow: [wide, narrow],
            smooth: Kernel::smooth(deviation),
            edge: Kernel::edge(deviation),
            point: Kernel::point(deviation),
        }
    }

    /// How many rows above and below a band its filters reach.
    fn halo(&self) -> usize {
        self.luminance.radius().max(self.smooth.radius())
    }

    fn look(&self, band: &Band) -> Sight {
        let [y, cx, cz] = &band.opponent;
        let blur = |plane: &[f32], kernel: &Kernel| band.filter(plane, kernel, kernel);
        let (y_seen, cx_seen) = (blur(y, &self.luminance), blur(cx, &self.red_green));
        let [wide, narrow] = self.blue_yellow.each_ref().map(|kernel| blur(cz, kernel));
        let colour = y_seen.iter().zip(&cx_seen).zip(wide.iter().zip(&narrow));
        let colour = colour.map(|((y, cx), (wide, narrow))| Opponent([*y, *cx, wide + narrow]).to_linear());
        let slopes = |kernel: &Kernel| {
            let across = band.filter(y, kernel, &self.smooth);
            let down = band.filter(y, &self.smooth, kernel);
            // The filters are made for lightness of 0 to 1. An offset of it leaves them as they are.
            let length = |(x, y): (f32, f32)| (x * x + y * y).sqrt() / 116.0;
            across.into_iter().zip(down).map(length)
        };
        Sight {
            colour: colour.collect(),
            features: slopes(&self.edge)
                .zip(slopes(&self.point))
                .map(|(edge, point)| [edge, point])
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Flip, flip};
    use crate::Picture;

    /// A picture of 40 x 30 by a formula of column and row.
    fn picture(colour: impl Fn(u32, u32) -> [f32; 3]) -> Picture {
        let mut picture = Picture::black(40, 30).unwrap();
        for (index, pixel) in (0..).zip(picture.pixels_mut()) {
            *pixel = colour(index % 40, index / 40);
        }
        picture
    }

    fn ramp(x: u32, y: u32) -> [f32; 3] {
        [x as f32 / 39.0, y as f32 / 29.0, 0.5]
    }

    /// The mean of two pictures and the number of the pixel in column 19, row 14.
    fn check(
        name: &str,
        first: impl Fn(u32, u32) -> [f32; 3],
        second: impl Fn(u32, u32) -> [f32; 3],
        degree: f64,
        mean: f64,
        pixel: f32,
    ) {
        let found = flip(&picture(first), &picture(second), degree).unwrap();
        assert!((found.mean - mean).abs() < 2e-5, "{name}: mean {}", found.mean);
        let there = found.map[14 * 40 + 19];
        assert!((there - pixel).abs() < 1e-4, "{name}: pixel {there}");
    }

    #[test]
    fn equal_pictures_do_not_differ_and_green_differs_most_from_blue() {
        check("equal", ramp, ramp, 67.0, 0.0, 0.0);
        check(
            "extremes",
            |_, _| [0.0, 1.0, 0.0],
            |_, _| [0.0, 0.0, 1.0],
            67.0,
            1.0,
            1.0,
        );
        // What a screen can't show makes no difference.
        let beyond = |_, _| [-3.0, f32::NAN, 7.0];
        check("clamped", beyond, |_, _| [0.0, 0.0, 1.0], 67.0, 0.0, 0.0);
    }

    /// The numbers are those of the authors' own program (flip-evaluator 1.7) for the same pictures.
    #[test]
    fn the_authors_program_finds_the_same() {
        let disc = |x0: i32, y0: i32| {
            move |x: u32, y: u32| match (x as i32 - x0).pow(2) + (y as i32 - y0).pow(2) {
                0..64 => [0.9, 0.2, 0.1],
                _ => [0.1, 0.3, 0.6],
            }
        };
        let dark = |x, y| [ramp(x, y)[0] * 0.8, ramp(x, y)[1], 0.5];
        let dot = |x, y| [f32::from(u8::from((x, y) == (19, 14))); 3];
        let line = |x, _| if x == 19 { [1.0; 3] } else { [0.2; 3] };
        let stripes = |a: f32, b: f32| move |x: u32, _: u32| [a, a, b].map(|part| part * (x % 2) as f32);
        check("ramp", ramp, dark, 67.0, 0.253_747_1, 0.229_85);
        check("disc", disc(20, 15), disc(22, 14), 67.0, 0.125_149_4, 0.208_409);
        check("disc from near", disc(20, 15), disc(22, 14), 20.0, 0.095_740_3, 0.0);
        check("dot", |_, _| [0.0; 3], dot, 67.0, 0.011_922, 0.865_048_5);
        check("line", |_, _| [0.2; 3], line, 30.0, 0.063_942_3, 0.985_977_8);
        check(
            "stripes",
            stripes(1.0, 0.0),
            stripes(0.0, 1.0),
            40.0,
            0.976_993_8,
            0.977_955_3,
        );
    }

    #[test]
    fn sizes_must_agree() {
        let (wide, high) = (Picture::black(2, 1).unwrap(), Picture::black(1, 2).unwrap());
        let error = flip(&wide, &high, Flip::PIXELS_PER_DEGREE).unwrap_err();
        assert!(error.to_string().contains("2 x 1 and 1 x 2"), "{error}");
    }
}
