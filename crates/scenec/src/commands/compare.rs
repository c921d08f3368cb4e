//! `scenec compare`

mod account;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use scenec_cpu::Cpu;
use scenec_picture::{
    Encoding, Figures, Flip, Format, Layers, Limits, Picture, Request, Tracer, Window, compare, flip, heat, load, save,
};
use scenec_plan::plan;

use crate::exit::Exit;
use crate::failure::Failure;
use crate::report::Style;
use crate::{interrupt, progress, scenes, values};
use account::{Account, Form};

/// Tell how far two pictures are apart
///
/// Each of the two is a picture, if its extension is one of a known format, or a scene file, which is rendered by the
/// built-in tracer first. The figures are of colour components as they stand in the file: 0 to 1 where it holds levels.
/// Pixels with a number that is not finite are counted and left out of the figures.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Compare {
    /// A picture or a scene file; `-` reads a scene from standard input
    #[arg(value_name = "A")]
    first: PathBuf,
    /// A picture or a scene file of the same size
    #[arg(value_name = "B")]
    second: PathBuf,
    /// Write a picture of the differences: black up to 1/65536, blue about 1/4096, red about 1/256, yellow about 1/16,
    /// white from 1 on; green where a number is not finite
    #[arg(long, value_name = "FILE")]
    heat: Option<PathBuf>,
    /// How the figures are written
    #[arg(long, value_enum, default_value_t = Form::Text, value_name = "FORM")]
    output_format: Form,
    /// End with code 1 if the figure is above this, or if a pixel is not finite: a number, or a fraction such as 1/255
    #[arg(long, value_name = "X", value_parser = values::limit, allow_negative_numbers = true)]
    fail_above: Option<f64>,
    /// The figure that --fail-above is about
    #[arg(long, value_enum, default_value_t = Figure::Max, value_name = "FIGURE", requires = "fail_above")]
    figure: Figure,
    /// How near the screen is for FLIP, in pixels of one degree of the visual angle: 1 to 1000
    #[arg(long, value_name = "N", default_value_t = Flip::PIXELS_PER_DEGREE, value_parser = pixels_per_degree)]
    pixels_per_degree: f64,
    #[command(flatten)]
    style: Style,
}

const AFTER_HELP: &str = "\
Examples:
  scenec compare before.png after.png
  scenec compare before.pfm seed.scene --heat heat.png
  scenec compare one.scene other.scene --fail-above 1/255
  scenec compare one.png other.png --figure flip --fail-above 0.05 --output-format json

Exit codes:
  0    the figures are written, and none is above --fail-above
  1    a figure is above --fail-above, or a scene file has errors
  2    the arguments or a file can't be used, or the sizes differ
  130  stopped by Ctrl-C";

/// A figure to judge by.
#[derive(clap::ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Figure {
    /// The largest difference of any component
    Max,
    /// The root of the mean square of the components' differences
    Rmse,
    /// 99 in 100 pixels are off by no more than this
    P99,
    /// The share of pixels, 0 to 1, that are off by more than 1/255
    Share,
    /// The mean of FLIP, 0 to 1: how different they look
    Flip,
}

impl Figure {
    fn of(self, figures: &Figures, flip: f64) -> f64 {
        match self {
            Self::Max => figures.max_abs,
            Self::Rmse => figures.rmse,
            Self::P99 => figures.p99_abs,
            Self::Share => figures.off_share,
            Self::Flip => flip,
        }
    }
}

fn pixels_per_degree(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number| (1.0..=1000.0).contains(number));
    number.ok_or_else(|| "there are 1 to 1000 pixels in a degree".to_owned())
}

impl Compare {
    pub(crate) fn run(&self) -> Exit {
        match self.compare() {
            Ok(exit) => exit,
            Err(failure) => {
                // With standard error gone there is nobody left to tell.
                failure.tell(&mut io::stderr().lock()).unwrap_or_default();
                failure.exit()
            }
        }
    }

    fn compare(&self) -> Result<Exit, Failure> {
        if self.first == self.second && self.first.as_os_str() == "-" {
            return Err(Failure::unusable("standard input holds one scene, not two"));
        }
        let heat_format = self.heat.as_deref().map(|path| {
            Format::from_path(path).ok_or_else(|| {
                Failure::Unusable(format!(
                    "the extension of {} is not one of a known format",
                    path.display()
                ))
            })
        });
        let heat_format = heat_format.transpose()?;
        let (first, second) = (self.picture(&self.first)?, self.picture(&self.second)?);
        let figures = compare(&first, &second).map_err(Failure::unusable)?;
        let flip = flip(&first, &second, self.pixels_per_degree).map_err(Failure::unusable)?;
        if let (Some(path), Some(format)) = (&self.heat, heat_format) {
            let map = heat(&first, &second).map_err(Failure::unusable)?;
            interrupt::while_writing(|| save(&map, path, &Encoding::of(format))).map_err(Failure::unusable)?;
        }
        let over = self.fail_above.filter(|limit| {
            // What is not finite is in no figure, and nobody may take it for small.
            figures.non_finite > 0 || self.figure.of(&figures, flip.mean) > *limit
        });
        let account = Account {
            names: [&self.first, &self.second].map(|path| path.display().to_string()),
            size: (first.width(), first.height()),
            figures,
            flip: flip.mean,
            pixels_per_degree: self.pixels_per_degree,
            over: over.map(|limit| (self.figure, limit)),
        };
        let mut out = io::stdout().lock();
        account
            .write(self.output_format, &mut out)
            .and_then(|()| out.flush())
            .map_err(|error| Failure::Unusable(format!("cannot write <stdout>: {error}")))?;
        Ok(if over.is_some() { Exit::Errors } else { Exit::Clean })
    }

    /// The picture in a file, or that of the scene in it.
    fn picture(&self, path: &Path) -> Result<Picture, Failure> {
        if Format::from_path(path).is_some() {
            return load(path).map_err(|error| Failure::Unusable(format!("cannot read {}: {error}", path.display())));
        }
        let (_, scene) = scenes::open(path, true, &self.style, |_| ())?;
        let plan = plan(&scene).map_err(|error| Failure::Unusable(format!("the scene can't be traced: {error}")))?;
        let window = Window::whole(scene.settings.width, scene.settings.height);
        let watch = interrupt::watch();
        let request = Request {
            window,
            limits: Limits::DEFAULT,
            layers: Layers::default(),
            watch,
        };
        let mut tracer = Cpu::<f32>::new(&plan, 0)?;
        let frame = progress::shown(watch, window.pixels(), true, || tracer.trace(&request))?;
        Ok(frame.picture)
    }
}
