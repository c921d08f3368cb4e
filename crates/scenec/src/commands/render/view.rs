//! What is looked at: the settings that the command line puts in the place of the file's, and the part that is traced.

use clap::{Args, ValueEnum};
use scenec_measure::Tolerance;
use scenec_picture::{Limits, Window};
use scenec_scene::Scene;

use crate::failure::Failure;
use crate::values;

/// Arguments that take the place of what the file says.
#[derive(Args, Debug)]
#[command(next_help_heading = "Picture")]
pub(crate) struct ViewOptions {
    /// Columns and rows in place of the file's `width` and `height`
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    size: Option<(u32, u32)>,
    /// Sample points per pixel in place of the file's `samples`: 1 to 4096
    #[arg(long, value_name = "N", value_parser = values::samples, allow_negative_numbers = true)]
    samples: Option<u32>,
    /// The most reflections and refractions of one path in place of the file's `raydepth`: 0 to 1024
    #[arg(long, value_name = "N", value_parser = values::raydepth, allow_negative_numbers = true)]
    raydepth: Option<u32>,
    /// What becomes of the operators | & and -
    #[arg(long, value_enum, default_value_t = Csg::Tree, value_name = "HOW")]
    csg: Csg,
    /// Trace and write only this part, in pixels from the upper left corner; its pixels are those of the whole picture
    #[arg(long, value_name = "X,Y,W,H", value_parser = values::window)]
    crop: Option<Window>,
    /// Drop a branch of a path when the most it could still add to its sample is below this; 0 never drops one
    #[arg(long, value_name = "X", default_value = "1/4096", value_parser = values::cutoff, allow_negative_numbers = true)]
    cutoff: f64,
    /// The most rays, those towards lights aside, that one pixel may use: 65536 unless given, and 16777216 with --tolerance
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    ray_budget: Option<u32>,
}

/// What becomes of the operators.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
enum Csg {
    /// They combine solids, as the language says
    Tree,
    /// Every base object inside the submitted one shows, as in the original program
    Ignore,
}

impl ViewOptions {
    /// The scene as it is to be traced.
    pub(crate) fn scene(&self, mut scene: Scene) -> Scene {
        if let Some((width, height)) = self.size {
            (scene.settings.width, scene.settings.height) = (width, height);
        }
        if let Some(samples) = self.samples {
            scene.settings.samples = samples;
        }
        if let Some(raydepth) = self.raydepth {
            scene.settings.raydepth = raydepth;
        }
        match self.csg {
            Csg::Tree => scene,
            Csg::Ignore => scene.ignoring_operators(),
        }
    }

    /// Which part of a picture of this size is to be traced: one inside it.
    pub(crate) fn window(&self, width: u32, height: u32) -> Result<Window, Failure> {
        let window = self.crop.unwrap_or(Window::whole(width, height));
        let inside = |start: u32, length: u32, size: u32| start.checked_add(length).is_some_and(|end| end <= size);
        if !inside(window.x, window.width, width) || !inside(window.y, window.height, height) {
            let Window {
                x,
                y,
                width: w,
                height: h,
            } = window;
            return Err(Failure::Unusable(format!(
                "the crop {x},{y},{w},{h} reaches beyond the picture, which has {width} x {height} pixels"
            )));
        }
        Ok(window)
    }

    /// Where paths end early.
    pub(crate) fn limits(&self) -> Limits {
        Limits {
            cutoff: self.cutoff,
            ray_budget: self.ray_budget.unwrap_or(Limits::DEFAULT.ray_budget),
        }
    }

    /// The most rays of a pixel that is to be within a tolerance.
    pub(super) fn generous_budget(&self) -> u32 {
        self.ray_budget.unwrap_or(Tolerance::RAY_BUDGET)
    }
}
