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
    /// The share of a pixel by which the points may count a straight edge wrong while blocks of them agree: several times the root of the
    /// mean square over all edges.
    pub(crate) edge: f64,
}

impl Missed {
    /// By as many points, or by the next smaller number that is listed.
    pub(crate) fn by(taken: Taken, count: u32) -> Option<Self> {
        let (rows, times) = match taken {
            Taken::Plainly => (PLAIN, PLAINLY),
            Taken::ToTolerance => (SCRAMBLED, TO_TOLERANCE),
        };
        let place = rows.partition_point(|row| row.0 <= count);
        let (_, empty, typical) = *rows.get(place.checked_sub(1)?)?;
        let (_, times) = times.iter().rev().find(|(first, _)| *first <= count)?;
        Some(Self {
            empty,
            edge: times * typical,
        })
    }
}

/// From which number of points on how many times the typical share counts.
type Times = &'static [(u32, f64)];

/// Of a plan's points.
const PLAINLY: Times = &[(0, 4.5)];

/// Of scrambled points: never less than for others, and random edges were off by more than that though their blocks agreed, as much
/// as that: 1,200,000 were tried, most of them up to 16,384 points.
const TO_TOLERANCE: Times = &[
    (0, 4.5),
    (224, 4.9),
    (256, 4.5),
    (480, 4.7),
    (512, 4.5),
    (960, 4.6),
    (1024, 4.5),
    (2048, 4.8),
    (2304, 4.7),
    (4096, 5.4),
    (7168, 5.8),
    (7680, 5.4),
    (32768, 7.1),
];

/// The most samples that there is a row for.
pub(crate) const MOST_SAMPLES: u32 = 1 << 18;

/// Numbers of points, the first figure of [`Missed`], and the typical share that an edge is counted wrong.
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
    (18, 9.18e-2, 3.62e-2),
    (20, 7.42e-2, 3.17e-2),
    (22, 7.42e-2, 3.70e-2),
    (24, 7.42e-2, 3.07e-2),
    (26, 7.42e-2, 3.13e-2),
    (28, 6.64e-2, 2.68e-2),
    (30, 4.39e-2, 2.43e-2),
    (32, 4.39e-2, 2.30e-2),
    (36, 3.33e-2, 2.46e-2),
    (40, 3.33e-2, 2.09e-2),
    (44, 3.33e-2, 2.09e-2),
    (48, 3.33e-2, 1.84e-2),
    (52, 3.28e-2, 1.68e-2),
    (56, 3.28e-2, 1.77e-2),
    (60, 3.28e-2, 1.72e-2),
    (64, 2.27e-2, 1.50e-2),
    (72, 2.27e-2, 1.41e-2),
    (80, 2.27e-2, 1.29e-2),
    (88, 2.27e-2, 1.24e-2),
    (96, 1.67e-2, 1.11e-2),
    (104, 1.67e-2, 1.10e-2),
    (112, 1.60e-2, 9.69e-3),
    (120, 1.03e-2, 9.30e-3),
    (128, 1.03e-2, 7.98e-3),
    (144, 1.03e-2, 8.06e-3),
    (160, 1.03e-2, 7.86e-3),
    (176, 1.03e-2, 7.38e-3),
    (192, 9.52e-3, 6.84e-3),
    (208, 9.52e-3, 6.45e-3),
    (224, 8.25e-3, 5.91e-3),
    (240, 8.25e-3, 5.41e-3),
    (256, 5.41e-3, 4.82e-3),
    (288, 5.41e-3, 5.05e-3),
    (320, 5.41e-3, 4.79e-3),
    (352, 5.41e-3, 4.53e-3),
    (384, 5.41e-3, 4.07e-3),
    (416, 5.41e-3, 4.07e-3),
    (448, 5.41e-3, 3.82e-3),
    (480, 2.26e-3, 3.56e-3),
    (512, 2.26e-3, 3.17e-3),
    (576, 2.26e-3, 3.18e-3),
    (640, 2.26e-3, 2.91e-3),
    (704, 2.26e-3, 2.77e-3),
    (768, 2.26e-3, 2.50e-3),
    (832, 2.26e-3, 2.42e-3),
    (896, 1.73e-3, 2.21e-3),
    (960, 1.73e-3, 2.06e-3),
    (1024, 1.34e-3, 1.81e-3),
    (1152, 1.34e-3, 1.85e-3),
    (1280, 1.34e-3, 1.74e-3),
    (1408, 7.21e-4, 1.66e-3),
    (1536, 7.21e-4, 1.49e-3),
    (1664, 7.21e-4, 1.44e-3),
    (1792, 6.72e-4, 1.31e-3),
    (1920, 6.72e-4, 1.25e-3),
    (2048, 6.08e-4, 1.11e-3),
    (2304, 6.08e-4, 1.13e-3),
    (2560, 6.08e-4, 1.03e-3),
    (2816, 6.08e-4, 9.51e-4),
    (3072, 6.08e-4, 8.56e-4),
    (3328, 6.08e-4, 8.35e-4),
    (3584, 6.08e-4, 7.86e-4),
    (3840, 6.08e-4, 7.43e-4),
    (4096, 3.17e-4, 6.47e-4),
    (4608, 3.17e-4, 6.55e-4),
    (5120, 3.17e-4, 5.95e-4),
    (5632, 3.17e-4, 5.78e-4),
    (6144, 3.17e-4, 5.13e-4),
    (6656, 3.17e-4, 5.05e-4),
    (7168, 2.22e-4, 4.59e-4),
    (7680, 1.78e-4, 4.40e-4),
    (8192, 1.78e-4, 3.86e-4),
    (9216, 1.78e-4, 3.87e-4),
    (10240, 1.78e-4, 3.64e-4),
    (11264, 1.78e-4, 3.42e-4),
    (12288, 1.78e-4, 3.05e-4),
    (13312, 1.11e-4, 2.97e-4),
    (14336, 1.11e-4, 2.73e-4),
    (15360, 5.50e-5, 2.56e-4),
    (16384, 5.50e-5, 2.26e-4),
    (18432, 5.50e-5, 2.29e-4),
    (20480, 5.50e-5, 2.14e-4),
    (22528, 5.06e-5, 2.05e-4),
    (24576, 5.06e-5, 1.84e-4),
    (26624, 5.06e-5, 1.81e-4),
    (28672, 5.06e-5, 1.66e-4),
    (30720, 5.06e-5, 1.57e-4),
    (32768, 5.06e-5, 1.39e-4),
    (36864, 5.06e-5, 1.38e-4),
    (40960, 4.14e-5, 1.28e-4),
    (45056, 4.14e-5, 1.21e-4),
    (49152, 4.14e-5, 1.08e-4),
    (53248, 4.14e-5, 1.05e-4),
    (57344, 1.65e-5, 9.66e-5),
    (61440, 1.65e-5, 9.12e-5),
    (65536, 1.65e-5, 8.03e-5),
    (73728, 1.65e-5, 8.15e-5),
    (81920, 1.65e-5, 7.52e-5),
    (90112, 1.65e-5, 7.26e-5),
    (98304, 1.65e-5, 6.54e-5),
    (106_496, 1.65e-5, 6.38e-5),
    (114_688, 1.65e-5, 5.84e-5),
    (122_880, 1.65e-5, 5.52e-5),
    (131_072, 1.14e-5, 4.91e-5),
    (147_456, 1.14e-5, 4.88e-5),
    (163_840, 1.14e-5, 4.53e-5),
    (180_224, 1.06e-5, 4.26e-5),
    (196_608, 1.06e-5, 3.80e-5),
    (212_992, 6.16e-6, 3.71e-5),
    (229_376, 6.16e-6, 3.46e-5),
    (245_760, 6.16e-6, 3.24e-5),
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
