//! `scenec plan`

mod account;

use std::io::{self, Write};
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use scenec_cpu::{Cpu, Number};
use scenec_device::{Precision, Verdict, source as kernels};
use scenec_picture::{Layers, Request, Window};
use scenec_plan::{Features, Plan, Summary, plan};
use scenec_scene::Scene;
use scenec_text::SourceFile;

use super::render::{choice, view};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::forecast::{Forecast, forecast};
use crate::{interrupt, report, scenes};

/// Say what a render would keep of a scene, leave out, need and take, and what would compute it
///
/// The arguments are those of `scenec render`. Some pixels are traced to find out how long the whole picture would take.
/// Findings about the file go to standard error.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct PlanOptions {
    /// The scene file; `-` reads standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// How the plan is written
    #[arg(long, value_enum, default_value_t = Format::Text, value_name = "FORMAT")]
    output_format: Format,
    /// Print the OpenCL source that the scene needs, and nothing else
    #[arg(long, conflicts_with = "output_format")]
    emit_kernel: bool,
    #[command(flatten)]
    view: view::ViewOptions,
    #[command(flatten)]
    machine: choice::MachineOptions,
    #[command(flatten)]
    voice: report::Voice,
}

/// How a plan is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// An object
    Json,
}

const AFTER_HELP: &str = "\
Examples:
  scenec plan dice.scene
  scenec plan dice.scene --size 3840x2160 --samples 16 --output-format json
  scenec plan dice.scene --device opencl
  scenec plan dice.scene --emit-kernel > dice.cl

Exit codes:
  0    the plan is printed
  1    the scene file has errors
  2    the arguments or the file can't be used
  3    there is no such device
  130  stopped by Ctrl-C";

/// What there is to tell.
struct Planned {
    source: SourceFile,
    scene: Scene,
    plan: Plan,
    window: Window,
    precision: Precision,
    /// Why singles don't do.
    doubles: Option<String>,
    features: Features,
    summary: Summary,
    forecast: Forecast,
    verdict: Verdict,
}

impl PlanOptions {
    pub(crate) fn run(&self) -> Exit {
        let told = self.told().and_then(|text| {
            let mut out = io::stdout().lock();
            let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
            written.map_err(|error| Failure::Unusable(format!("cannot write <stdout>: {error}")))
        });
        match told {
            Ok(()) => Exit::Clean,
            Err(failure) => {
                // With standard error gone there is nobody left to tell.
                failure.tell(&mut io::stderr().lock()).unwrap_or_default();
                failure.exit()
            }
        }
    }

    fn told(&self) -> Result<String, Failure> {
        let (source, scene) = scenes::open(&self.file, self.voice.quiet, &self.voice.style, |_| ())?;
        let scene = self.view.scene(scene);
        let plan = plan(&scene).map_err(|error| Failure::Unusable(format!("the scene can't be traced: {error}")))?;
        let precision = self.machine.precision(&plan, |_| ());
        if self.emit_kernel {
            return Ok(kernels(precision, &self.machine.features(&plan)));
        }
        let planned = match precision {
            Precision::F32 => self.planned::<f32>((source, scene), plan, precision),
            Precision::F64 => self.planned::<f64>((source, scene), plan, precision),
        }?;
        Ok(match self.output_format {
            Format::Text => account::text(&planned),
            Format::Json => format!("{:#}\n", account::object(&planned)),
        })
    }

    fn planned<R: Number>(
        &self,
        (source, scene): (SourceFile, Scene),
        plan: Plan,
        precision: Precision,
    ) -> Result<Planned, Failure> {
        let window = self.view.window(scene.settings.width, scene.settings.height)?;
        let mut cpu = Cpu::<R>::new(&plan, self.machine.threads())?;
        let forecast = forecast(
            &mut cpu,
            &plan,
            &Request {
                window,
                limits: self.view.limits(),
                layers: Layers::default(),
                watch: interrupt::watch(),
            },
        )?;
        let verdict = self.machine.choose(&plan, precision, forecast.nanoseconds)?;
        let precision = match verdict.device {
            Some(info) => self.machine.precision_on(info, precision, |_| ()),
            None => precision,
        };
        Ok(Planned {
            window,
            precision,
            doubles: plan.beyond_single().map(|reason| reason.to_string()),
            features: match verdict.device {
                Some(info) => self.machine.features_on(info, &plan, precision, forecast.nanoseconds),
                None => self.machine.features(&plan),
            },
            summary: plan.summary(),
            forecast,
            verdict,
            source,
            scene,
            plan,
        })
    }
}
