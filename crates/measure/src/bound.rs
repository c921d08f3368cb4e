//! How wrong a picture may be: what is proven, and what is estimated.

use scenec_picture::{Exact, TraceError, Watch};
use scenec_plan::{Plan, PlanError, plan};
use scenec_scene::{Scene, View, view};

use crate::discrepancy::of_edges;
use crate::doubt::{Doubt, SHADING};
use crate::hidden::{Hidden, Lights};
use crate::setting::Setting;
use crate::trial::{Trial, trial};

/// How far rays are turned to see what roundings may do, in roundings of a number near 1. A pixel's ray is known to
/// about four of them; this is 64 times as far, so that a small picture has enough pixels that show it.
const TURN: f64 = 4.0 * 64.0;

/// A bound on a picture's distance from the picture of the same scene at any number of samples with nothing dropped.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Bound {
    /// Proven: what dropped branches, and paths that ended before the scene's ray depth, may add to any component.
    pub truncation: f64,
    /// Estimated: what roundings change, in the worst pixel.
    pub rounding: f64,
    /// Estimated: what more samples would change, in the worst pixel.
    pub sampling: f64,
    /// All three together in the worst pixel.
    pub max: f64,
    /// All three together: the root of the mean square over all components.
    pub rms: f64,
}

impl Bound {
    /// Of a picture whose pixels may be so wrong.
    #[must_use]
    pub fn of(doubts: &[Doubt]) -> Self {
        let most = |part: fn(&Doubt) -> f64| doubts.iter().map(part).fold(0.0, f64::max);
        let squares: f64 = doubts.iter().map(|doubt| doubt.bound() * doubt.bound()).sum();
        Self {
            truncation: most(|doubt| doubt.truncation.into()),
            rounding: most(|doubt| doubt.rounding.into()),
            sampling: most(|doubt| doubt.sampling.into()),
            max: most(Doubt::bound),
            rms: (squares / doubts.len().max(1) as f64).sqrt(),
        }
    }
}

/// The bound of a picture that was traced with a setting: takes two more pictures.
///
/// Sampling is estimated in two ways, and the larger counts. An embedded pair: twice what the second half of the samples
/// changed, where the first sample alone is paired with the next. And an edge: twice what the points of a pixel may be
/// wrong about a straight edge, times the contrast around the pixel; for a pair may miss an edge, and its neighbours
/// don't. In the mean square, where no pixel counts alone, the pair suffices. Surfaces that show between all samples of a
/// pixel and of its neighbours are in neither: what they may bring is added.
///
/// Rounding is estimated by what becomes of the picture when every ray is turned a little: the worst pixel as it is, for
/// a ray that takes another way brings all that it can bring; of the mean square a 16th, for the number of such pixels is
/// 64 times smaller where the angle is, and the root of it is doubled.
///
/// # Errors
/// Those of the tracers.
pub(crate) fn bound(
    scene: &Scene,
    setting: &Setting,
    traced: &Trial,
    hidden: &Hidden,
    watch: &Watch,
) -> Result<Bound, TraceError> {
    let other = match setting.samples {
        1 => 2,
        samples => samples / 2,
    };
    let pair = trial(scene, &setting.with_samples(other), watch)?;
    let turned = trial(&turned(scene, TURN * setting.roundoff()), setting, watch)?;
    let failed = |error: PlanError| TraceError::Failed(error.to_string());
    let plan_here = plan(&setting.scene(scene)).map_err(failed)?;
    let lights = Lights::of(&plan_here);
    let samples = setting.samples.max(other);
    let beyond = shallow(&plan(scene).map_err(failed)?, setting);
    let none = Vec::new();
    let [all, pair, turned] = [traced, &pair, &turned].map(|trial| trial.frame.exact.as_ref().unwrap_or(&none));
    Ok(Parts {
        all,
        pair,
        turned,
        width: scene.settings.width.max(1) as usize,
        edge: of_edges(&plan_here.view.samples),
        hidden: &|index, colour| hidden.bring(index, samples, colour, &lights),
        truncation: traced.frame.stats.dropped + beyond,
        // The picture itself is of singles.
        rounding: SHADING * setting.roundoff() + f64::from(f32::EPSILON) / 2.0,
    }
    .sum())
}

struct Parts<'a> {
    all: &'a Exact,
    pair: &'a Exact,
    turned: &'a Exact,
    /// Columns.
    width: usize,
    /// The share of a contrast that the sample points may be wrong about.
    edge: f64,
    /// What surfaces between the samples may add to a pixel of a colour.
    hidden: &'a dyn Fn(usize, [f64; 3]) -> [f64; 3],
    truncation: f64,
    /// Relative to a component.
    rounding: f64,
}

impl Parts<'_> {
    fn sum(&self) -> Bound {
        let mut bound = Bound {
            truncation: self.truncation,
            ..Bound::default()
        };
        let mut squares = 0.0;
        let others = self.pair.iter().zip(self.turned);
        for (index, (pixel, (pair, turned))) in self.all.iter().zip(others).enumerate() {
            let (contrast, hidden) = (self.contrast(index), (self.hidden)(index, *pixel));
            for component in [0, 1, 2] {
                let value = pixel[component];
                let change = 2.0 * (value - pair[component]).abs();
                let sampling = change.max(2.0 * self.edge * contrast[component]) + hidden[component];
                let (own, flips) = (self.rounding * value.abs(), (value - turned[component]).abs());
                bound.sampling = bound.sampling.max(sampling);
                bound.rounding = bound.rounding.max(own + flips);
                bound.max = bound.max.max(self.truncation + sampling + own + flips);
                squares += (self.truncation + change + hidden[component] + own).powi(2) + flips * flips / 16.0;
            }
        }
        bound.rms = (squares / self.all.as_flattened().len().max(1) as f64).sqrt();
        bound
    }

    /// From the least to the most of each component, of a pixel and the eight around it, in the picture and its pair.
    fn contrast(&self, index: usize) -> [f64; 3] {
        let (column, row) = (index % self.width, index / self.width);
        let columns = column.saturating_sub(1)..self.width.min(column + 2);
        let mut range = [(f64::INFINITY, f64::NEG_INFINITY); 3];
        for row in row.saturating_sub(1)..row + 2 {
            let line = row * self.width;
            for picture in [self.all, self.pair] {
                let around = picture
                    .get(line + columns.start..line + columns.end)
                    .unwrap_or_default();
                for pixel in around {
                    for ((low, high), value) in range.iter_mut().zip(pixel) {
                        (*low, *high) = (low.min(*value), high.max(*value));
                    }
                }
            }
        }
        range.map(|(low, high)| (high - low).max(0.0))
    }
}

/// The scene with its eye turned by an angle, in radians, towards its upper right.
fn turned(scene: &Scene, angle: f64) -> Scene {
    let mut scene = scene.clone();
    if let View::Clear(camera) | View::AlongUp(camera) = view(&scene.settings) {
        let far = (scene.settings.lookat - scene.settings.eyepos).length();
        let aside = (camera.right.normalize() + camera.up.normalize()).normalize();
        scene.settings.lookat += aside * (far * angle);
    }
    scene
}

/// The most that paths bring which go on beyond the setting's ray depth.
///
/// Each surface hands on at most p times what further rays bring, so what begins beyond depth d counts with p^(d+1) at
/// most; and a ray with so many fewer bounces to go brings no more than the plan says.
fn shallow(whole: &Plan, setting: &Setting) -> f64 {
    let Some(beyond) = whole.view.raydepth.checked_sub(setting.raydepth + 1) else {
        return 0.0;
    };
    let handed_on = whole.materials.iter().fold(0.0_f64, |most, material| {
        most.max(material.reflect.abs() + material.refract.abs())
    });
    let brings = whole.reach.get(beyond as usize).copied().unwrap_or(f64::INFINITY);
    let weight = handed_on.powf(f64::from(setting.raydepth) + 1.0);
    if weight > 0.0 { weight * brings } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::Parts;

    fn check(edge: f64, hidden: f64, sampling: f64, max: f64) {
        let bound = Parts {
            all: &vec![[1.0, 2.0, 0.0], [1.0, 2.5, 0.0]],
            pair: &vec![[1.5, 2.0, 0.0], [1.0, 2.5, 0.0]],
            turned: &vec![[1.0, 1.0, 0.0], [1.0, 2.5, 0.0]],
            width: 2,
            edge,
            hidden: &|index, _| if index == 0 { [hidden, 0.0, 0.0] } else { [0.0; 3] },
            truncation: 0.25,
            rounding: 0.125,
        }
        .sum();
        assert_eq!((bound.truncation, bound.rounding), (0.25, 1.25));
        assert_eq!((bound.sampling, bound.max), (sampling, max));
        let squares: f64 = [1.375 + hidden, 0.5, 0.25, 0.375, 0.5625, 0.25]
            .iter()
            .map(|part: &f64| part * part)
            .sum();
        assert!((bound.rms - ((squares + 1.0 / 16.0) / 6.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn the_parts_add_up_pixel_by_pixel() {
        check(0.0, 0.0, 1.0, 1.5);
        // The contrast of both green components is a half.
        check(0.5, 0.0, 1.0, 2.0);
        check(2.0, 0.0, 2.0, 3.5);
        check(0.0, 0.5, 1.5, 1.875);
    }
}
