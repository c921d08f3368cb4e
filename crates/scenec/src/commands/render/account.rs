//! What a render took, for those who ask with `--stats`.

use std::fmt::Write;
use std::time::Duration;

use scenec_measure::Bound;
use scenec_picture::{Stats, Window};
use scenec_plan::{Features, Plan};
use scenec_scene::{Scene, SolidKind};

use super::clock::Clock;
use super::machine::Traced;

/// The account of a render, some lines of text.
pub(super) fn account(scene: &Scene, traced: &Traced, window: &Window, clock: &Clock) -> String {
    let mut rows = vec![
        ("size", size(scene, traced, window)),
        ("device", traced.name.clone()),
        ("kept", kept(scene, traced.plan.as_ref())),
        ("rays", rays(&traced.frame.stats)),
        ("dropped", dropped(&traced.frame.stats)),
        ("bound", bound(traced)),
    ];
    if let Some(features) = &traced.features {
        rows.push(("features", self::features(features)));
    }
    rows.push(("time", times(traced.frame.stats.kernel_ns, clock)));
    table(&rows)
}

/// Rows of a word and what is to be said under it.
pub(crate) fn table(rows: &[(&str, String)]) -> String {
    let mut text = String::new();
    for (name, words) in rows {
        // Writing to a string can't fail.
        writeln!(text, "{name:<9} {words}").unwrap_or_default();
    }
    text
}

fn size(scene: &Scene, traced: &Traced, window: &Window) -> String {
    let settings = &scene.settings;
    let whole = (settings.width, settings.height);
    let part = if whole == (window.width, window.height) {
        String::new()
    } else {
        format!(" of {} x {}", whole.0, whole.1)
    };
    let samples = match &traced.promise {
        Some(promise) => super::bounds::spent(promise),
        None => format!("samples {}", settings.samples),
    };
    format!(
        "{} x {}{part}, {samples}, raydepth {}",
        window.width, window.height, settings.raydepth
    )
}

/// How much of a scene is traced.
pub(crate) fn kept(scene: &Scene, plan: Option<&Plan>) -> String {
    let leaves = scene
        .solids
        .iter()
        .filter(|solid| matches!(solid.kind, SolidKind::Leaf(_)));
    let (leaves, lights) = (leaves.count(), scene.lights.len());
    match plan {
        Some(plan) => format!(
            "{} of {leaves} base objects in {} islands, {} of {lights} lights, {} hierarchy nodes",
            plan.leaves.len(),
            plan.islands.len(),
            plan.lights.len(),
            plan.nodes.len()
        ),
        None => format!("all of {leaves} base objects and {lights} lights: the reference tracer plans nothing"),
    }
}

/// How many rays of which kind.
pub(crate) fn rays(stats: &Stats) -> String {
    format!(
        "{} in all: {} from the eye, {} to lights, {} reflected, {} refracted",
        grouped(stats.rays()),
        grouped(stats.primary),
        grouped(stats.shadow),
        grouped(stats.reflected),
        grouped(stats.refracted)
    )
}

fn dropped(stats: &Stats) -> String {
    format!(
        "at most {:.3e} of any colour component; {} pixels met their ray budget",
        stats.dropped,
        grouped(stats.over_budget)
    )
}

/// How wrong the picture may be, so far as is known.
fn bound(traced: &Traced) -> String {
    match &traced.doubts {
        Some(doubts) => super::bounds::words(&Bound::of(doubts)),
        None => format!(
            "truncation at most {:.3e} (proven); the rest is estimated of up to {} pixels",
            traced.frame.stats.dropped,
            grouped(super::bounds::MOST_PIXELS)
        ),
    }
}

/// Those that are on; a number where there is more to say than that.
fn features(features: &Features) -> String {
    let on = features.list().into_iter().filter(|(_, value)| *value != 0);
    let word = |(name, value): (&str, u32)| match value {
        1 => name.to_lowercase(),
        _ => format!("{} {value}", name.to_lowercase()),
    };
    on.map(word).collect::<Vec<_>>().join(", ")
}

fn times(kernel_ns: Option<u64>, clock: &Clock) -> String {
    let mut words: Vec<_> = clock
        .stages()
        .iter()
        .map(|(stage, time)| format!("{stage} {}", milliseconds(*time)))
        .collect();
    words.push(format!("total {}", milliseconds(clock.total())));
    if let Some(nanoseconds) = kernel_ns {
        words.push(format!("kernel {}", milliseconds(Duration::from_nanos(nanoseconds))));
    }
    words.join(", ")
}

fn milliseconds(time: Duration) -> String {
    format!("{:.2} ms", time.as_secs_f64() * 1e3)
}

/// A number with its thousands apart.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::with_capacity(digits.len() * 2);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;

    fn check(number: u64, expect: &str) {
        assert_eq!(grouped(number), expect);
    }

    #[test]
    fn thousands_stand_apart() {
        check(0, "0");
        check(999, "999");
        check(1000, "1,000");
        check(65_536, "65,536");
        check(1_234_567, "1,234,567");
    }
}
