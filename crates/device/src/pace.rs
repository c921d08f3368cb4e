//! How a picture is cut into runs of the kernel: each about as long as a person waits without noticing, by the time that
//! the last one took. So progress shows, a stop is soon heard, no display driver takes the device away from a run that
//! seems to hang, and a small memory suffices.
//!
//! Pure arithmetic; it knows neither devices nor clocks.

use std::ops::Range;

/// How long a run is to take, nanoseconds. Drivers begin to doubt at 2 s.
const TARGET: f64 = 50e6;
/// Samples of the first run, of which nothing is known.
const FIRST: f64 = 4096.0;
/// How many times more samples a run may have than the one before.
const GROWTH: f64 = 16.0;
/// The side of a work-group; tiles are made of whole ones.
const GROUP: u32 = 16;
/// Pixels of the smallest tile.
pub(crate) const LEAST: usize = (GROUP * GROUP) as usize;

/// A tile of the window, and which samples of its pixels.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Run {
    pub(crate) column: u32,
    pub(crate) row: u32,
    pub(crate) columns: u32,
    pub(crate) rows: u32,
    pub(crate) samples: Range<u32>,
}

impl Run {
    /// Pixels of the tile.
    pub(crate) fn pixels(&self) -> usize {
        self.columns as usize * self.rows as usize
    }

    fn work(&self) -> f64 {
        self.pixels() as f64 * f64::from(self.samples.end - self.samples.start)
    }
}

/// The runs of one picture, one after another.
#[derive(Debug)]
pub(crate) struct Pace {
    width: u32,
    height: u32,
    samples: u32,
    /// The most pixels of a tile.
    most: u32,
    /// Samples that the next run may take.
    work: f64,
    last: Option<Run>,
}

impl Pace {
    /// A window, its samples per pixel, and the most pixels that a tile may have: at least [`LEAST`].
    pub(crate) fn new(width: u32, height: u32, samples: u32, most: usize) -> Self {
        Self {
            width,
            height,
            samples: samples.max(1),
            most: u32::try_from(most.max(LEAST)).unwrap_or(u32::MAX),
            work: FIRST,
            last: None,
        }
    }

    /// The next run, or `None` after the last.
    pub(crate) fn next(&mut self) -> Option<Run> {
        let mut run = match self.last.take() {
            None => self.tile(0, 0, None)?,
            Some(last) if last.samples.end < self.samples => last,
            Some(last) if last.column + last.columns < self.width => {
                self.tile(last.column + last.columns, last.row, Some(last.rows))?
            }
            Some(last) => self.tile(0, last.row + last.rows, None)?,
        };
        // A cast from a float ends at the bounds of the integer.
        let several = ((self.work / run.pixels() as f64) as u32).max(1);
        let first = run.samples.end;
        run.samples = first..first.saturating_add(several).min(self.samples);
        self.last = Some(run.clone());
        Some(run)
    }

    /// The run took this long.
    pub(crate) fn took(&mut self, run: &Run, nanoseconds: u64) {
        let ideal = run.work() * TARGET / (nanoseconds.max(1) as f64);
        self.work = ideal.clamp(1.0, run.work() * GROWTH);
    }

    /// The tile at a place, without samples yet: as many whole rows as there is time for, or a part of a strip whose
    /// rows may be given.
    fn tile(&self, column: u32, row: u32, strip: Option<u32>) -> Option<Run> {
        let left = self.height.checked_sub(row).filter(|left| *left > 0)?;
        let pixels = ((self.work / f64::from(self.samples)) as u32).clamp(1, self.most);
        let whole = pixels / self.width;
        let (columns, rows) = match strip {
            None if whole >= left => (self.width, left),
            None if whole >= GROUP => (self.width, whole - whole % GROUP),
            _ => {
                let rows = strip.unwrap_or(GROUP).min(left);
                let columns = (pixels / rows / GROUP * GROUP).max(GROUP);
                (columns.min(self.width - column), rows)
            }
        };
        Some(Run {
            column,
            row,
            columns,
            rows,
            samples: 0..0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{FIRST, GROUP, GROWTH, LEAST, Pace, TARGET};

    /// Every sample of every pixel is in one run, no tile is too large, and from the second run on none takes much
    /// longer than it should where samples all cost the same; returns the number of runs.
    fn check(width: u32, height: u32, samples: u32, most: usize, cost: f64) -> usize {
        let mut pace = Pace::new(width, height, samples, most);
        let (mut runs, mut work) = (0, 0.0);
        let mut at = (0, 0, 0);
        while let Some(run) = pace.next() {
            assert_eq!((run.row, run.column, run.samples.start), at);
            assert!(run.pixels() <= most.max(LEAST) && run.work() > 0.0);
            assert!(run.column + run.columns <= width && run.row + run.rows <= height && run.samples.end <= samples);
            assert!(run.columns == width || run.columns % GROUP == 0 || run.column + run.columns == width);
            let time = run.work() * cost;
            assert!(
                runs == 0 || time <= 1.01 * TARGET.max(LEAST as f64 * cost),
                "{run:?} {time}"
            );
            pace.took(&run, time as u64);
            work += run.work();
            runs += 1;
            at = match (run.samples.end < samples, run.column + run.columns < width) {
                (true, _) => (run.row, run.column, run.samples.end),
                (_, true) => (run.row, run.column + run.columns, 0),
                _ => (run.row + run.rows, 0, 0),
            };
        }
        assert_eq!(at, (height, 0, 0));
        assert_eq!(work, f64::from(width) * f64::from(height) * f64::from(samples));
        runs
    }

    #[test]
    fn a_picture_is_cut_into_runs_that_cover_it() {
        // Two runs to find out the speed, then the rest at once.
        assert!(check(600, 400, 1, 1 << 18, 10.0) <= 4);
        check(1, 1, 1, 256, 1.0);
        check(17, 13, 3, 256, 1e3);
        check(1, 65535, 1, 1 << 18, 50.0);
        check(65535, 1, 1, 1 << 18, 50.0);
        check(65535, 40, 1, 1 << 18, 2000.0);
        check(1000, 100, 64, 1 << 12, 1e3);
        check(40, 40, 4096, 1 << 18, 1e5);
        check(33, 33, 7, 1 << 18, 1e9);
    }

    #[test]
    fn a_run_grows_by_no_more_than_is_known() {
        let mut pace = Pace::new(4096, 4096, 1, 1 << 20);
        let run = pace.next().unwrap();
        assert!(run.work() <= FIRST);
        pace.took(&run, 0);
        assert!(pace.next().unwrap().work() <= FIRST * GROWTH);
    }
}
