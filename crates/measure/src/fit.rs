//! How large a picture a bench can bear in the time that it has, by what its first small pictures take.

use std::time::Instant;

use scenec_device::{DeviceInfo, Precision};
use scenec_picture::{Layers, Limits, Request, TraceError, Tracer, Watch, Window};
use scenec_reference::Reference;
use scenec_scene::Scene;

use crate::effort::Effort;
use crate::hidden::Hidden;
use crate::ladder::{Rung, ladder};
use crate::setting::{Machine, Setting};
use crate::trial::trial;
use crate::truth::work;

/// No picture is made smaller than this many pixels: fewer show nothing.
const LEAST: f64 = 24.0 * 16.0;

/// What a sample of the reference costs is found on so many times fewer columns and rows.
const COARSE: u32 = 2;

impl Effort {
    /// A scene of a size that this effort can bear: as small as its pixels say, and halved as often as it takes to be done in
    /// its time, by what each machine takes for its first picture and the reference for a coarse one.
    ///
    /// # Errors
    /// Those of the tracers on this processor; what a device can't do is found out later.
    pub fn fitted(&self, scene: Scene, device: Option<&DeviceInfo>, watch: &Watch) -> Result<Scene, TraceError> {
        let scene = self.shrunk(scene);
        let Some(seconds) = self.seconds else {
            return Ok(scene);
        };
        let pixels = f64::from(scene.settings.width) * f64::from(scene.settings.height);
        let cost = self.cost(&scene, pixels, device, watch)?;
        let mut left = pixels;
        while left * cost > seconds && left / 2.0 >= LEAST {
            left /= 2.0;
        }
        let smaller = Self {
            pixels: left as u64,
            ..*self
        };
        Ok(smaller.shrunk(scene))
    }

    /// The seconds that a bench takes for each pixel of a scene.
    fn cost(&self, scene: &Scene, pixels: f64, device: Option<&DeviceInfo>, watch: &Watch) -> Result<f64, TraceError> {
        let mut known: Vec<(Machine, Precision, f64)> = Vec::new();
        let mut sum = reference(scene, watch)? * work(1, self.reference_samples) as f64;
        for Rung { setting, .. } in ladder(scene, self, device) {
            let strict = setting.strict();
            let found = known
                .iter()
                .find(|(machine, precision, _)| *machine == strict.machine && *precision == strict.precision);
            let sample = match found {
                Some((_, _, sample)) => *sample,
                None => {
                    let sample = self.sample(scene, &strict, watch)? / pixels;
                    known.push((strict.machine, strict.precision, sample));
                    sample
                }
            };
            sum += sample * f64::from(setting.samples) * self.pictures() as f64;
            // The points at which surfaces are looked for, about as dear as samples without light.
            if setting.machine == Machine::Cpu && setting.precision == Precision::F64 && setting.samples == 1 {
                sum += sample * Hidden::work() as f64;
            }
        }
        Ok(sum)
    }

    /// The seconds for a sample of each pixel; nothing for a device that fails.
    fn sample(&self, scene: &Scene, setting: &Setting, watch: &Watch) -> Result<f64, TraceError> {
        let samples = self.samples.get(1).copied().unwrap_or(1);
        match trial(scene, &setting.with_samples(samples), watch) {
            Ok(trial) => Ok(trial.seconds / f64::from(samples)),
            Err(TraceError::Failed(_)) if setting.machine != Machine::Cpu => Ok(0.0),
            Err(error) => Err(error),
        }
    }
}

/// The seconds for a sample of the slow tracer.
fn reference(scene: &Scene, watch: &Watch) -> Result<f64, TraceError> {
    let mut coarse = scene.clone();
    let settings = &mut coarse.settings;
    settings.samples = 1;
    settings.width = (settings.width / COARSE).max(1);
    settings.height = (settings.height / COARSE).max(1);
    let window = Window::whole(settings.width, settings.height);
    let mut tracer = Reference::new(&coarse);
    let begin = Instant::now();
    tracer.trace(&Request {
        window,
        limits: Limits::NO_CUTOFF,
        layers: Layers::default(),
        watch,
    })?;
    Ok(begin.elapsed().as_secs_f64() / window.pixels() as f64)
}
