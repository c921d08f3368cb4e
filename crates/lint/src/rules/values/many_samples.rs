//! Pictures of a great many sample points.

use scenec_scene::setting;
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A picture of more than ten thousand million sample points: pixels times `samples`.
    ///
    /// Each sample point is a ray of its own, with all its reflections, refractions and shadows, so such a picture
    /// takes minutes on a fast machine and hours on a slow one. Beyond 64 samples a pixel the eye sees no difference.
    ///
    /// ## Example
    ///
    /// ```scene
    /// width := 3000
    /// height := 2000
    /// samples := 4096
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// width := 3000
    /// height := 2000
    /// samples := 64
    /// !ball := sphere
    /// !ball <=
    /// ```
    ManySamples, check
}

/// The most sample points of a picture that pass without a remark.
const MOST: u64 = 10_000_000_000;

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some(settings) = context.settings() else {
        return;
    };
    let points = u64::from(settings.width) * u64::from(settings.height) * u64::from(settings.samples);
    let samples = setting("samples").and_then(|row| context.setting(row));
    if let (true, Some((_, samples))) = (points > MOST, samples) {
        findings.push(
            Diagnostic::new(
                Code::ManySamples,
                format!("the picture has {:.1e} sample points", points as f64),
                samples,
                format!("for each of {} x {} pixels", settings.width, settings.height),
            )
            .help("up to 1e10 pass without a remark; 64 samples a pixel are smooth to the eye"),
        );
    }
}
