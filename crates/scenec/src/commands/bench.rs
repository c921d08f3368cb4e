//! `scenec bench`

mod cache;
mod outputs;
mod process;
mod stability;
mod tolerance;

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use scenec_device::{DeviceInfo, discover, is_opencl, select};
use scenec_measure::{Bench, Effort, Report};
use scenec_picture::Watch;
use scenec_scene::Scene;

use crate::exit::Exit;
use crate::failure::Failure;
use crate::report::{self, Style, plural};
use crate::{interrupt, progress, scenes, values};
use outputs::Outputs;
use process::Renders;

/// Measure error against run time
///
/// Each scene is rendered at a ladder of settings: samples, precisions, cut-offs and ray depths, on the built-in tracer
/// and on an OpenCL device. Each picture is held against a reference of many samples that the slow tracer makes in
/// double precision, and against the bound that it gives on its own error. Pictures are small unless --size is given:
/// what counts is the cost of a ray and the size of an error, and the reference is slow.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct BenchOptions {
    /// The scene files
    #[arg(value_name = "SCENE", required_unless_present = "stability")]
    scenes: Vec<PathBuf>,
    /// The folder to write report.csv, report.md and the diagrams wp.svg and wp.png into
    #[arg(short, long, value_name = "DIR", required_unless_present_any = ["stability", "tolerance"])]
    output: Option<PathBuf>,
    /// Run the stability suite instead, awkward scenes with known answers, and print its table
    ///
    /// Each case is traced by every tracer that there is, in each precision that a render of it would take, and held
    /// against a closed form, another scene that must look the same, or the slow tracer.
    #[arg(long, conflicts_with_all = ["scenes", "output", "quick", "full", "size", "cache", "heat"])]
    stability: bool,
    /// Ask POV-Ray too, which has to be installed, and add what it makes of each case to the table
    ///
    /// It is given each scene with every surface in a flat colour. What counts is the share of pixels, those on an edge left
    /// out, where it shows another surface than the slow tracer.
    #[arg(long, requires = "stability")]
    povray: bool,
    /// Print a row for each case and not for each of its members
    ///
    /// Of ten thousand random trees some two hundred are traced then.
    #[arg(long, requires = "stability")]
    brief: bool,
    /// Print instead what a render to this tolerance costs beside the same samples for every pixel
    ///
    /// Each scene is rendered with --tolerance, and held against the same scene to an eighth of it with other sample
    /// points. The table says how many samples everywhere would be as good by their bound, and by their error.
    #[arg(long, value_name = "T", value_parser = values::tolerance,
        conflicts_with_all = ["stability", "output", "device", "cache", "heat"])]
    tolerance: Option<f64>,
    /// Take about a minute, with fewer pixels, samples and repetitions; of a scene that is slow, with fewer pixels still
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Take the time for figures that are to be kept; this is the default
    #[arg(long)]
    full: bool,
    /// Columns and rows, instead of the file's made smaller
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    size: Option<(u32, u32)>,
    /// The OpenCL device to try too: `none`, `opencl`, `opencl:INDEX` or `opencl:NAME`; the best there is unless given
    #[arg(long, value_name = "DEVICE", value_parser = device)]
    device: Option<String>,
    /// Where references are kept from one run to the next; the user's cache folder unless given
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,
    /// Write a picture of the differences from the reference for each row as well
    #[arg(long)]
    heat: bool,
    #[command(flatten)]
    style: Style,
}

const AFTER_HELP: &str = "\
Examples:
  scenec bench seed.scene -o bench --quick
  scenec bench scenes/glass.scene scenes/mirrors.scene -o bench --size 120x80 --device none
  scenec bench --stability > stability.md
  scenec bench --stability --povray --brief --device none > stability.md
  scenec bench one.scene other.scene --tolerance 1/255 --size 48x32

Exit codes:
  0    everything is written, and no picture is more wrong than its bound
  1    a picture is more wrong than its bound or a case of the suite fails, or a scene file has errors
  2    the arguments, a file or the folder can't be used
  3    the device that was asked for is not there
  130  stopped by Ctrl-C; nothing is written then";

fn device(text: &str) -> Result<String, String> {
    if text == "none" || is_opencl(text) {
        return Ok(text.to_owned());
    }
    Err("a device is none, opencl, opencl:INDEX or opencl:NAME".to_owned())
}

impl BenchOptions {
    pub(crate) fn run(&self) -> Exit {
        match self.bench() {
            Ok(exit) => exit,
            Err(failure) => {
                // With standard error gone there is nobody left to tell.
                failure.tell(&mut io::stderr().lock()).unwrap_or_default();
                failure.exit()
            }
        }
    }

    fn bench(&self) -> Result<Exit, Failure> {
        if let Some(tolerance) = self.tolerance {
            let scene = |path: &PathBuf| {
                let (_, scene) = scenes::open(path, true, &self.style, |_| ())?;
                Ok((name(path), self.sized(scene)))
            };
            let scenes: Result<Vec<_>, Failure> = self.scenes.iter().map(scene).collect();
            return tolerance::run(&scenes?, tolerance);
        }
        // Without the suite the arguments have to name a folder.
        let Some(output) = self.output.as_ref().filter(|_| !self.stability) else {
            return stability::run(self.device()?, self.povray, self.brief);
        };
        interrupt::watch();
        let outputs = Outputs::at(output)?;
        let device = self.device()?;
        let mut scenes = Vec::new();
        for path in &self.scenes {
            if path.as_os_str() == "-" {
                return Err(Failure::unusable(
                    "a bench needs files: it renders them again and again",
                ));
            }
            scenes.push((path, scenes::open(path, true, &self.style, |_| ())?.1));
        }
        let mut reports = Vec::new();
        for (path, scene) in scenes {
            let scene = match self.size {
                Some(_) => self.sized(scene),
                None => self.effort().fitted(scene, device, interrupt::watch())?,
            };
            let report = self.one(path, &scene, device)?;
            tell(path, &report);
            reports.push((path.display().to_string(), report));
        }
        let names = outputs.write(&reports, self.heat)?;
        remark(&format!("wrote {}", names.join(", ")));
        let defects: usize = reports.iter().map(|(_, report)| report.defects().count()).sum();
        Ok(if defects > 0 { Exit::Errors } else { Exit::Clean })
    }

    const fn effort(&self) -> Effort {
        if self.quick { Effort::QUICK } else { Effort::FULL }
    }

    fn sized(&self, mut scene: Scene) -> Scene {
        let Some((width, height)) = self.size else {
            return self.effort().shrunk(scene);
        };
        (scene.settings.width, scene.settings.height) = (width, height);
        scene
    }

    /// The one that was asked for, or else the best there is, if there is one.
    fn device(&self) -> Result<Option<&'static DeviceInfo>, Failure> {
        match self.device.as_deref() {
            None => Ok(select("opencl", discover()).ok()),
            Some("none") => Ok(None),
            Some(request) => Ok(Some(select(request, discover())?)),
        }
    }

    fn one(&self, path: &Path, scene: &Scene, device: Option<&'static DeviceInfo>) -> Result<Report, Failure> {
        let watch = interrupt::watch();
        let counter = Watch::new();
        let bench = Bench {
            scene,
            effort: self.effort(),
            device,
            shelf: self.cache.clone().or_else(cache::folder),
            salt: cache::salt(),
            watch,
            counter: &counter,
        };
        let size = (scene.settings.width, scene.settings.height);
        let mut renders = Renders::of(path, size, watch)?;
        let work = || bench.run(&mut |setting, start| renders.run(setting, start));
        Ok(progress::counted(&counter, bench.work(), "samples", work)?)
    }
}

/// What a scene is called by its file.
fn name(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    stem.to_string_lossy().into_owned()
}

/// What is found in a few lines, as soon as it is.
fn tell(path: &Path, report: &Report) {
    let name = path.display();
    remark(&format!(
        "{name}: {} x {}, {}, reference of {} samples{}, its own error about {:.1e}, drift of this machine {:.0} %",
        report.truth.width,
        report.truth.height,
        plural(report.rows.len(), "row"),
        report.truth.samples,
        if report.truth.kept { " (kept)" } else { "" },
        report.truth.own_rms,
        report.drift * 100.0
    ));
    for note in &report.notes {
        remark(&format!("{name}: not tried: {note}"));
    }
    for row in report.defects() {
        remark(&format!(
            "{name}: defect: {}, {}: off by {:.3e}, though its bound is {:.3e}",
            row.family, row.knob, row.figures.max_abs, row.bound.max
        ));
    }
}

fn remark(message: &str) {
    report::remark(&mut io::stderr().lock(), message).unwrap_or_default();
}
