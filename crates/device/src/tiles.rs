//! What comes back from a device, tile by tile, and the frame that it makes.

use scenec_picture::{Exact, Frame, NOTHING, Picture, Request, Spread, Stats, TraceError};
use scenec_plan::packed_structs::{Outcome, Sampled};
use scenec_plan::{Real, in_doubles, in_singles};

use crate::buffer::Buffer;
use crate::calls::Plain;
use crate::error::DeviceError;
use crate::pace::Run;
use crate::sampled::in_picture;
use crate::session::Session;

/// What a tile's pixels come to, in the device's memory.
pub(crate) struct Room<R> {
    pub(crate) outcomes: Buffer<Outcome<R>>,
    /// Of one pixel, if the program does not sum them up.
    pub(crate) sums: Buffer<Sampled<R>>,
}

/// What a program tells of pixels besides their colours.
#[derive(Clone, Copy)]
pub(crate) struct Told {
    pub(crate) distances: bool,
    pub(crate) spread: bool,
    /// Whether samples are summed up in blocks.
    pub(crate) sums: bool,
    /// World units per plan unit.
    pub(crate) unit: f64,
}

/// A frame that is being put together.
pub(crate) struct Tiles<R> {
    width: usize,
    unit: f64,
    /// The tile that was read and has not been entered.
    run: Option<Run>,
    outcomes: Vec<Outcome<R>>,
    sums: Vec<Sampled<R>>,
    picture: Picture,
    ids: Option<Vec<u32>>,
    exact: Option<Exact>,
    distances: Option<Vec<f64>>,
    spread: Option<Vec<Spread>>,
    stats: Stats,
}

impl<R: Real + Plain> Tiles<R> {
    /// With nothing in it yet; of tiles with at most so many pixels.
    ///
    /// # Errors
    /// There is no memory for the picture.
    pub(crate) fn new(request: &Request<'_>, told: Told, most: usize) -> Result<Self, TraceError> {
        let picture = Picture::black(request.window.width, request.window.height)?;
        let (layers, count) = (request.layers, picture.pixels().len());
        let spread = layers.spread && told.spread;
        Ok(Self {
            width: request.window.width as usize,
            unit: told.unit,
            run: None,
            outcomes: vec![Outcome::default(); most],
            sums: vec![Sampled::default(); if spread && told.sums { most } else { 0 }],
            picture,
            ids: layers.ids.then(|| vec![NOTHING; count]),
            exact: layers.exact.then(|| vec![[0.0; 3]; count]),
            distances: (layers.distances && told.distances).then(|| vec![f64::INFINITY; count]),
            spread: spread.then(|| vec![Spread::default(); count]),
            stats: Stats::default(),
        })
    }

    /// Reads a tile, after the one before was entered.
    pub(crate) fn read(&mut self, session: &Session, room: &Room<R>, run: Run) -> Result<(), DeviceError> {
        session.read(&room.outcomes, 0, &mut self.outcomes[..run.pixels()])?;
        if !self.sums.is_empty() {
            session.read(&room.sums, 0, &mut self.sums[..run.pixels()])?;
        }
        self.run = Some(run);
        Ok(())
    }

    /// Enters the tile that was read last, if it has not been; how many pixels that are.
    pub(crate) fn enter(&mut self) -> u64 {
        let Some(run) = self.run.take() else { return 0 };
        let columns = run.columns as usize;
        for row in 0..run.rows as usize {
            let at = (run.row as usize + row) * self.width + run.column as usize;
            for column in 0..columns {
                self.pixel(at + column, row * columns + column);
            }
        }
        run.pixels() as u64
    }

    /// Enters one pixel, by its places in the frame and in the tile.
    fn pixel(&mut self, at: usize, in_tile: usize) {
        let outcome = &self.outcomes[in_tile];
        self.picture.pixels_mut()[at] = in_singles(outcome.colour);
        if let Some(ids) = &mut self.ids {
            ids[at] = outcome.solid;
        }
        if let Some(exact) = &mut self.exact {
            exact[at] = in_doubles(outcome.colour);
        }
        if let Some(distances) = &mut self.distances {
            distances[at] = outcome.distance.to_f64() * self.unit;
        }
        if let Some(spread) = &mut self.spread {
            let dropped = outcome.dropped.to_f64();
            spread[at] = match self.sums.get(in_tile) {
                Some(sums) => in_picture(sums).spread_with(dropped),
                None => Spread::of_one(in_doubles(outcome.colour), dropped),
            };
        }
        self.stats = self.stats.merge(pixel_stats(outcome));
    }

    /// The whole, which took so many nanoseconds of the device.
    pub(crate) fn finish(self, kernel_ns: u64) -> Frame {
        Frame {
            picture: self.picture,
            ids: self.ids,
            exact: self.exact,
            paths: None,
            spread: self.spread,
            distances: self.distances,
            stats: Stats {
                kernel_ns: Some(kernel_ns),
                ..self.stats
            },
        }
    }
}

pub(crate) fn pixel_stats<R: Real>(outcome: &Outcome<R>) -> Stats {
    Stats {
        primary: outcome.primary.into(),
        shadow: outcome.shadow.into(),
        reflected: outcome.reflected.into(),
        refracted: outcome.refracted.into(),
        dropped: outcome.dropped.to_f64(),
        over_budget: outcome.over.into(),
        kernel_ns: None,
    }
}
