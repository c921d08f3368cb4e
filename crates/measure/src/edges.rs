//! What a number of sample points may miss of a straight edge across a pixel: tables for each number that pixels stop at.

/// How the samples of a pixel were taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Taken {
    /// By a plain render: at the first points of its plan.
    Plainly,
    /// To a tolerance: at scrambled points, after a look at those on the sides, which are in the pixel's range.
    ToTolerance,
}

/// What a number of sample points may miss.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Missed {
    /// The largest part of a pixel that a straight edge can cut off without a point in it.
    pub(crate) empty: f64,
    /// The share of a pixel by which the points count a straight edge wrong: the root of the mean square over all edges.
    pub(crate) typical: f64,
}

impl Missed {
    /// By as many points, or by the next smaller number that is listed.
    pub(crate) fn by(taken: Taken, count: u32) -> Option<Self> {
        let rows = match taken {
            Taken::Plainly => PLAIN,
            Taken::ToTolerance => SCRAMBLED,
        };
        let place = rows.partition_point(|row| row.0 <= count);
        let (_, empty, typical) = *rows.get(place.checked_sub(1)?)?;
        Some(Self { empty, typical })
    }
}

/// The most samples that there is a row for.
pub(crate) const MOST_SAMPLES: u32 = 1 << 18;

/// Numbers of points, and the two figures of [`Missed`].
type Rows = &'static [(u32, f64, f64)];

/// Of a plan's points.
const PLAIN: Rows = &[
    (16, 1.87e-1, 7.74e-2),
    (24, 1.46e-1, 5.72e-2),
    (32, 1.05e-1, 5.14e-2),
    (48, 9.75e-2, 3.75e-2),
    (64, 3.84e-2, 2.27e-2),
    (96, 1.92e-2, 1.23e-2),
    (128, 1.92e-2, 1.33e-2),
    (192, 1.92e-2, 7.29e-3),
    (256, 1.18e-2, 5.91e-3),
    (384, 1.18e-2, 4.39e-3),
    (512, 6.15e-3, 3.15e-3),
    (768, 3.13e-3, 2.45e-3),
    (1024, 1.61e-3, 2.01e-3),
    (1536, 1.52e-3, 1.47e-3),
    (2048, 9.57e-4, 1.08e-3),
    (3072, 8.69e-4, 8.58e-4),
    (4096, 8.69e-4, 7.28e-4),
    (6144, 3.27e-4, 5.02e-4),
    (8192, 1.93e-4, 3.73e-4),
    (12288, 1.46e-4, 2.84e-4),
    (16384, 1.18e-4, 2.26e-4),
    (24576, 9.71e-5, 1.54e-4),
    (32768, 7.71e-5, 1.23e-4),
    (49152, 3.11e-5, 9.61e-5),
    (65536, 2.71e-5, 7.41e-5),
    (98304, 1.81e-5, 4.71e-5),
    (131_072, 1.81e-5, 3.91e-5),
    (196_608, 1.51e-5, 3.61e-5),
    (262_144, 1.51e-5, 3.21e-5),
];

/// Of scrambled points.
const SCRAMBLED: Rows = &[
    (16, 9.18e-2, 3.48e-2),
    (24, 7.42e-2, 3.07e-2),
    (32, 4.39e-2, 2.30e-2),
    (48, 3.33e-2, 1.84e-2),
    (64, 2.27e-2, 1.50e-2),
    (96, 1.67e-2, 1.11e-2),
    (128, 1.03e-2, 7.98e-3),
    (192, 9.52e-3, 6.84e-3),
    (256, 5.41e-3, 4.82e-3),
    (384, 5.41e-3, 4.07e-3),
    (512, 2.26e-3, 3.17e-3),
    (768, 2.26e-3, 2.50e-3),
    (1024, 1.34e-3, 1.81e-3),
    (1536, 7.21e-4, 1.49e-3),
    (2048, 6.08e-4, 1.11e-3),
    (3072, 6.08e-4, 8.56e-4),
    (4096, 3.17e-4, 6.47e-4),
    (6144, 3.17e-4, 5.13e-4),
    (8192, 1.78e-4, 3.86e-4),
    (12288, 1.78e-4, 3.05e-4),
    (16384, 5.50e-5, 2.26e-4),
    (24576, 5.06e-5, 1.84e-4),
    (32768, 5.06e-5, 1.39e-4),
    (49152, 4.14e-5, 1.08e-4),
    (65536, 1.65e-5, 8.03e-5),
    (98304, 1.65e-5, 6.54e-5),
    (131_072, 1.14e-5, 4.91e-5),
    (196_608, 1.06e-5, 3.80e-5),
    (262_144, 6.16e-6, 2.87e-5),
];

#[cfg(test)]
mod tests {
    use scenec_plan::sample_points;

    use super::{MOST_SAMPLES, PLAIN, Rows, SCRAMBLED};
    use crate::discrepancy::{empty, typical};
    use crate::points::{SCRAMBLE, scrambled_points};

    fn check(rows: Rows, points: &[[f64; 2]]) {
        assert_eq!(rows.last().map(|row| row.0), Some(MOST_SAMPLES));
        for (count, empty_part, typical_share) in rows.iter().take_while(|row| row.0 as usize <= points.len()) {
            let first = &points[..*count as usize];
            for (found, listed) in [(empty(first), empty_part), (typical(first), typical_share)] {
                assert!(found <= *listed && *listed <= 1.01 * found, "{count}: {found} {listed}");
            }
        }
    }

    #[test]
    fn the_tables_are_what_the_points_give() {
        check(PLAIN, &sample_points(4096));
        check(SCRAMBLED, &scrambled_points(4096, SCRAMBLE));
    }
}
