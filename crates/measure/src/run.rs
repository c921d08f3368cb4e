//! A scene through the ladder: first how wrong each picture is, then how long each takes.

use std::path::PathBuf;

use scenec_device::DeviceInfo;
use scenec_picture::{Figures, Flip, Picture, Stats, TraceError, Watch, compare_exact, flip};
use scenec_scene::Scene;

use crate::bound::{Bound, bound};
use crate::effort::Effort;
use crate::hidden::Hidden;
use crate::ladder::{Rung, ladder};
use crate::pareto::front;
use crate::setting::Setting;
use crate::timing::{Times, calibration, drift};
use crate::trial::{Trial, trial};
use crate::truth::{Shelf, Truth, work};

/// Runs a whole process that renders a scene with a setting, and says how many seconds it took; of a setting that promises
/// nothing it does not wait for ever.
pub type Process<'a> = dyn FnMut(&Setting, Start) -> Result<f64, TraceError> + 'a;

/// What a process finds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Start {
    /// Nothing that an earlier run compiled.
    Cold,
    /// What earlier runs left.
    Warm,
}

/// A bench of one scene.
pub struct Bench<'a> {
    /// What is traced, at this size.
    pub scene: &'a Scene,
    /// How much is tried.
    pub effort: Effort,
    /// The device that is tried besides the processor.
    pub device: Option<&'a DeviceInfo>,
    /// Where references are kept from one run to the next.
    pub shelf: Option<PathBuf>,
    /// Changes when the program does: references of another program are not taken.
    pub salt: Vec<u8>,
    /// Who says stop.
    pub watch: &'a Watch,
    /// Hears how far the work is, up to [`Bench::work`].
    pub counter: &'a Watch,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Report {
    /// What all pictures are held against.
    pub truth: Truth,
    /// A row for each setting that could be tried.
    pub rows: Vec<Row>,
    /// Settings that could not be tried, and why.
    pub notes: Vec<String>,
    /// How far the slowest run of a fixed piece of work, done between the others, is from the quickest: 0.1 is a tenth.
    pub drift: f64,
}

/// One setting.
#[derive(Clone, Debug)]
pub struct Row {
    /// What stays the same along a curve: "cpu f32".
    pub family: String,
    /// What changes along it: "samples 16".
    pub knob: String,
    /// What was asked for.
    pub setting: Setting,
    /// Who computed.
    pub tracer: String,
    /// Tracing alone.
    pub kernel: Times,
    /// Whole processes, from start to end.
    pub process: Times,
    /// Rays, and what was dropped.
    pub stats: Stats,
    /// How wrong it is.
    pub figures: Figures,
    /// How wrong it looks: the mean of FLIP.
    pub flip: f64,
    /// How wrong it may be.
    pub bound: Bound,
    /// Whether it promises something, and no other row that does is both quicker and less wrong.
    pub front: bool,
    /// Whether the reference is not good enough to tell: its own error is more than a third of the row's.
    pub limited: bool,
    /// The picture.
    pub picture: Picture,
}

impl Report {
    /// Whether a row is more wrong than it says it may be, what the reference may be wrong left aside. Of a row that
    /// promises nothing that is no defect.
    #[must_use]
    pub fn is_defect(&self, row: &Row) -> bool {
        row.setting.machine.promises() && self.is_beyond(row)
    }

    /// Whether a row that promises nothing is more wrong than it would be allowed to be if it did.
    #[must_use]
    pub fn is_unpromised(&self, row: &Row) -> bool {
        !row.setting.machine.promises() && self.is_beyond(row)
    }

    fn is_beyond(&self, row: &Row) -> bool {
        let strange = row.figures.non_finite > 0;
        strange || row.figures.max_abs > row.bound.max + self.truth.own_max
    }

    /// The rows that are.
    pub fn defects(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| self.is_defect(row))
    }
}

impl Bench<'_> {
    /// How far the counter goes.
    #[must_use]
    pub fn work(&self) -> u64 {
        let rungs = ladder(self.scene, &self.effort, self.device);
        let settings: u64 = rungs.iter().map(|rung| self.pictures(&rung.setting)).sum();
        let before = work(self.pixels(), self.effort.reference_samples) + self.pixels() * Hidden::work();
        before + settings * self.effort.pictures()
    }

    fn pixels(&self) -> u64 {
        u64::from(self.scene.settings.width) * u64::from(self.scene.settings.height)
    }

    fn pictures(&self, setting: &Setting) -> u64 {
        self.pixels() * u64::from(setting.samples)
    }

    /// Does it all.
    ///
    /// # Errors
    /// `Cancelled` if somebody says stop; what a device can't do is a note instead.
    pub fn run(&self, process: &mut Process<'_>) -> Result<Report, TraceError> {
        let shelf = Shelf {
            folder: self.shelf.clone(),
            salt: self.salt.clone(),
        };
        let truth = Truth::of(
            self.scene,
            self.effort.reference_samples,
            &shelf,
            self.watch,
            self.counter,
        )?;
        let hidden = Hidden::of(self.scene, self.watch, self.counter)?;
        let mut notes = Vec::new();
        let mut tried = Vec::new();
        let mut hopeless = String::new();
        for rung in ladder(self.scene, &self.effort, self.device) {
            if rung.family == hopeless {
                continue;
            }
            match self.try_out(&rung, &hidden, process) {
                Ok((picture, bound)) => tried.push((rung, picture, bound)),
                Err(TraceError::Failed(reason)) => {
                    notes.push(format!("{}, {}: {reason}", rung.family, rung.knob));
                    if !rung.setting.machine.promises() {
                        hopeless = rung.family;
                    }
                }
                Err(error) => return Err(error),
            }
        }
        let rungs: Vec<_> = tried.iter().map(|(rung, _, _)| rung).collect();
        let (times, drift) = self.time(&rungs, process)?;
        let mut report = Report {
            rows: Vec::new(),
            notes,
            drift,
            truth,
        };
        for ((rung, traced, bound), (kernel, process)) in tried.into_iter().zip(times) {
            let row = row(rung, traced, bound, kernel, process, &report.truth)?;
            report.rows.push(row);
        }
        let promised = || report.rows.iter().filter(|row| row.setting.machine.promises());
        let points: Vec<_> = promised().map(|row| (row.kernel.median, row.figures.rmse)).collect();
        let promised = report.rows.iter_mut().filter(|row| row.setting.machine.promises());
        for (row, front) in promised.zip(front(&points)) {
            row.front = front;
        }
        Ok(report)
    }

    /// The picture of a rung, and its bound; of one that promises nothing, the bound of what it stands beside.
    fn try_out(&self, rung: &Rung, hidden: &Hidden, process: &mut Process<'_>) -> Result<(Trial, Bound), TraceError> {
        let (setting, strict) = (&rung.setting, rung.setting.strict());
        let (traced, bound) = if strict == *setting {
            let traced = trial(self.scene, setting, self.watch)?;
            let bound = bound(self.scene, setting, &traced, hidden, self.watch)?;
            (traced, bound)
        } else {
            // What promises nothing may not even end, and a process can be stopped.
            process(setting, Start::Cold)?;
            let sober = trial(self.scene, &strict, self.watch)?;
            let bound = bound(self.scene, &strict, &sober, hidden, self.watch)?;
            (trial(self.scene, setting, self.watch)?, bound)
        };
        self.counter.advance(3 * self.pictures(&rung.setting));
        Ok((traced, bound))
    }

    /// Kernel and process times of each rung: in rounds, so that a slow minute slows all of them.
    fn time(&self, rungs: &[&Rung], process: &mut Process<'_>) -> Result<(Vec<(Times, Times)>, f64), TraceError> {
        let mut steady = vec![calibration()];
        let mut runs = vec![(Vec::new(), Vec::new()); rungs.len()];
        for round in 0..self.effort.rounds() {
            let start = if round == 0 { Start::Cold } else { Start::Warm };
            for (rung, (kernels, processes)) in rungs.iter().zip(&mut runs) {
                kernels.push(trial(self.scene, &rung.setting, self.watch)?.seconds);
                processes.push(process(&rung.setting, start)?);
                self.counter.advance(2 * self.pictures(&rung.setting));
            }
            steady.push(calibration());
        }
        let times = |runs: &[f64]| match runs {
            [cold, warm @ ..] => Times::of(*cold, warm),
            [] => None,
        };
        let none = || TraceError::Failed("nothing was timed".to_owned());
        let all = runs
            .iter()
            .map(|(kernels, processes)| Some((times(kernels)?, times(processes)?)));
        Ok((all.collect::<Option<_>>().ok_or_else(none)?, drift(&steady)))
    }
}

fn row(
    rung: Rung,
    traced: Trial,
    bound: Bound,
    kernel: Times,
    process: Times,
    truth: &Truth,
) -> Result<Row, TraceError> {
    let picture = traced.frame.picture;
    let figures = compare_exact(&picture, &truth.exact);
    let seen = flip(&truth.picture()?, &picture, Flip::PIXELS_PER_DEGREE);
    Ok(Row {
        family: rung.family,
        knob: rung.knob,
        setting: rung.setting,
        tracer: traced.name,
        kernel,
        process,
        stats: traced.frame.stats,
        flip: seen.map_err(|error| TraceError::Failed(error.to_string()))?.mean,
        bound,
        front: false,
        limited: figures.rmse < 3.0 * truth.own_rms,
        figures,
        picture,
    })
}
