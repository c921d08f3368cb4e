//! `scenec render`

pub(crate) mod account;
mod bounds;
pub(crate) mod choice;
mod clock;
mod machine;
mod target;
pub(crate) mod view;

use std::io;
use std::path::PathBuf;

use clap::Args;
use scenec_picture::{Layers, Request, Window};
use scenec_scene::Scene;

use crate::exit::Exit;
use crate::failure::Failure;
use crate::{interrupt, report, scenes};
use account::{account, grouped};
use clock::Clock;
use machine::{Attempt, Traced};
use target::Deliver;

/// Trace a scene file into a picture
///
/// The file is checked first: with errors in it nothing is rendered. The picture appears under its name only when it is
/// complete; whatever stood there before stays on any failure. Reports go to standard error.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Render {
    /// The scene file; `-` reads standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[command(flatten)]
    target: target::TargetOptions,
    #[command(flatten)]
    view: view::ViewOptions,
    #[command(flatten)]
    machine: choice::MachineOptions,
    #[command(flatten)]
    bounds: bounds::BoundOptions,
    #[command(flatten)]
    talk: TalkOptions,
}

/// Arguments about what is said.
#[derive(Args, Debug)]
#[command(next_help_heading = "Reports")]
struct TalkOptions {
    /// Tell what the render took
    #[arg(long)]
    stats: bool,
    #[command(flatten)]
    voice: report::Voice,
}

const AFTER_HELP: &str = "\
Examples:
  scenec render seed.scene -o seed.png
  scenec render seed.scene -o large.png --size 3840x2160 --samples 16
  scenec render seed.scene -o exact.png --tolerance 1/255 --error-map wrong.exr
  scenec render seed.scene -o part.exr --crop 200,100,64,64 --device reference
  generate | scenec render - -o - --format png --quiet | display

Exit codes:
  0    the picture is written
  1    the scene file has errors
  2    the arguments, the file or the place to write can't be used, or the picture is too large
  3    the device failed, or there is none
  4    the picture is written, but some of it may be off by more than --tolerance
  130  stopped by Ctrl-C; a second Ctrl-C does not wait for the tracer";

impl Render {
    pub(crate) fn run(&self) -> Exit {
        match self.render() {
            Ok(exit) => exit,
            Err(failure) => {
                // With standard error gone there is nobody left to tell, here and below.
                failure.tell(&mut io::stderr().lock()).unwrap_or_default();
                failure.exit()
            }
        }
    }

    fn render(&self) -> Result<Exit, Failure> {
        let mut clock = Clock::start();
        if let Some(option) = self.bounds.bounded_by() {
            self.machine.must_keep_rules(option)?;
        }
        let target = self.target.target(&self.file)?;
        let map = self.bounds.map(&self.file, &target)?;
        let (_, scene) = scenes::open(&self.file, self.talk.voice.quiet, &self.talk.voice.style, |stage| {
            clock.lap(stage)
        })?;
        let scene = self.view.scene(scene);
        let window = self.view.window(scene.settings.width, scene.settings.height)?;
        self.bounds.check(&window)?;
        for target in [Some(&target), map.as_ref()].into_iter().flatten() {
            target.check(&window)?;
        }

        let watch = interrupt::watch();
        let bands = self.bounds.bounded_by().is_none() && target.wants_bands(&window)?;
        let traced = if bands {
            let trace = |deliver: Deliver<'_>| self.trace(&scene, window, &mut clock, Some(deliver));
            target.stream(&window, watch, trace)?
        } else {
            self.trace(&scene, window, &mut clock, None)?
        };
        if !self.talk.voice.quiet {
            self.doubts(&traced);
        }
        if !bands {
            target.write(&traced.frame.picture, watch)?;
        }
        if let (Some(map), Some(doubts)) = (&map, &traced.doubts) {
            map.write(&bounds::map(doubts, window.width, window.height, map)?, watch)?;
        }
        clock.lap("encode");
        self.conclude(&scene, &traced, &window, &target.name(), &clock);
        Ok(verdict(&traced))
    }

    fn trace<'a>(
        &'a self,
        scene: &Scene,
        window: Window,
        clock: &'a mut Clock,
        deliver: Option<Deliver<'a>>,
    ) -> Result<Traced, Failure> {
        let mut limits = self.view.limits();
        if self.bounds.tolerance.is_some() {
            limits.ray_budget = self.view.generous_budget();
        }
        let mut attempt = Attempt {
            options: &self.machine,
            request: Request {
                window,
                limits,
                layers: Layers {
                    spread: deliver.is_none()
                        && self.machine.keeps_rules()
                        && self.bounds.spread(&window, self.talk.stats),
                    ..Layers::default()
                },
                watch: interrupt::watch(),
            },
            clock,
            deliver,
            delivered: machine::Delivered::default(),
            progress: !self.talk.voice.quiet,
            warn: if self.talk.voice.quiet { |_| () } else { warn },
        };
        match self.bounds.tolerance {
            Some(tolerance) => attempt.promised(scene, tolerance, self.bounds.most_samples),
            None => attempt.trace(scene),
        }
    }

    /// Says what may be wrong with a picture.
    fn doubts(&self, traced: &Traced) {
        let stats = &traced.frame.stats;
        if stats.over_budget > 0 && traced.promise.is_none() {
            warn(&format!(
                "{} met the ray budget of {}, and what was left out may add up to {:.2e} of a colour component; \
                 --ray-budget sets it",
                pixels(stats.over_budget),
                grouped(self.view.limits().ray_budget.into()),
                stats.dropped
            ));
        }
        if traced.strange > 0 {
            warn(&format!("{} came out as no finite number", pixels(traced.strange)));
        }
    }

    fn conclude(&self, scene: &Scene, traced: &Traced, window: &Window, target: &str, clock: &Clock) {
        let out = &mut io::stderr().lock();
        if self.talk.stats {
            report::remark(out, account(scene, traced, window, clock).trim_end()).unwrap_or_default();
        }
        if !self.talk.voice.quiet {
            let line = format!(
                "wrote {target}: {} x {}, {}, {:.0} ms",
                window.width,
                window.height,
                traced.name,
                clock.total().as_secs_f64() * 1e3
            );
            let line = match &traced.promise {
                Some(promise) => format!("{line}, {}", bounds::spent(promise)),
                None => line,
            };
            report::remark(out, &line).unwrap_or_default();
        }
    }
}

/// Whether the picture is what was asked for. If not, that is said to those as well who want to hear of nothing else.
fn verdict(traced: &Traced) -> Exit {
    let (Some(promise), Some(doubts)) = (&traced.promise, &traced.doubts) else {
        return Exit::Clean;
    };
    match bounds::shortfall(promise, doubts) {
        Some(words) => {
            warn(&words);
            Exit::Missed
        }
        None => Exit::Clean,
    }
}

fn warn(message: &str) {
    report::remark(&mut io::stderr().lock(), &format!("warning: {message}")).unwrap_or_default();
}

fn pixels(count: u64) -> String {
    match count {
        1 => "1 pixel".to_owned(),
        _ => format!("{} pixels", grouped(count)),
    }
}
