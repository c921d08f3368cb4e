//! A plan in words, and as an object.

use scenec_picture::Stats;
use scenec_plan::{Features, Tiers};
use serde_json::{Map, Value, json};

use super::Planned;
use crate::commands::render::account::{grouped, kept, rays, table};

/// Bytes of a pixel in memory.
const PIXEL: u64 = 12;

impl Planned {
    fn picture_bytes(&self) -> u64 {
        self.window.pixels() * PIXEL
    }

    /// The line that makes a base object, counted from 1.
    fn line(&self, solid: u32) -> Option<u32> {
        let solid = self.scene.solids.get(solid as usize)?;
        Some(self.source.line_of(solid.span.start) + 1)
    }

    /// What `--device` would name.
    fn device(&self) -> String {
        match self.verdict.device {
            Some(info) => format!("opencl:{}", info.index),
            None => "cpu".to_owned(),
        }
    }
}

/// For people.
pub(super) fn text(planned: &Planned) -> String {
    let settings = &planned.scene.settings;
    let (on, off) = switches(&planned.features);
    let device = match planned.verdict.device {
        Some(info) => format!("{} ({})", info.name, planned.device()),
        None => "the built-in tracer (cpu)".to_owned(),
    };
    let numbers = match &planned.doubles {
        Some(reason) => format!("{}; {reason}", planned.precision),
        None => planned.precision.to_string(),
    };
    table(&[
        (
            "size",
            format!(
                "{} x {}, samples {}, raydepth {}",
                planned.window.width, planned.window.height, settings.samples, settings.raydepth
            ),
        ),
        ("kept", kept(&planned.scene, Some(&planned.plan))),
        ("dropped", dropped(planned)),
        ("tiers", tiers(&planned.summary.tiers, planned.summary.cells)),
        ("features", on),
        ("left out", off),
        ("numbers", numbers),
        (
            "memory",
            format!(
                "{} for the scene, {} for the picture",
                size(planned.summary.bytes),
                size(planned.picture_bytes())
            ),
        ),
        ("rays", format!("about {}", rays(&planned.forecast.stats))),
        (
            "time",
            format!(
                "about {:.0} ms on the built-in tracer, from {} pixels traced",
                planned.forecast.nanoseconds / 1e6,
                grouped(planned.forecast.tried)
            ),
        ),
        ("device", format!("{device}: {}", planned.verdict.why)),
    ])
}

/// For programs.
pub(super) fn object(planned: &Planned) -> Value {
    let settings = &planned.scene.settings;
    let summary = &planned.summary;
    let dropped: Vec<Value> = summary
        .dropped
        .iter()
        .map(|dropped| {
            json!({
                "count": dropped.count,
                "why": dropped.reason.to_string(),
                "first_line": planned.line(dropped.solid),
            })
        })
        .collect();
    let features: Map<String, Value> = planned
        .features
        .list()
        .into_iter()
        .map(|(name, value)| (name.to_lowercase(), value.into()))
        .collect();
    let Stats {
        primary,
        shadow,
        reflected,
        refracted,
        ..
    } = planned.forecast.stats;
    json!({
        "picture": {
            "width": planned.window.width,
            "height": planned.window.height,
            "samples": settings.samples,
            "raydepth": settings.raydepth,
        },
        "base_objects": { "in_file": summary.leaves, "kept": summary.kept },
        "dropped": dropped,
        "islands": {
            "all": summary.islands,
            "single": summary.tiers.single,
            "products": summary.tiers.products,
            "programs": summary.tiers.programs,
            "divided": summary.tiers.divided,
        },
        "cells": summary.cells,
        "shapes": summary.shapes,
        "hierarchy_nodes": summary.nodes,
        "materials": planned.plan.materials.len(),
        "lights": { "in_file": planned.scene.lights.len(), "kept": planned.plan.lights.len() },
        "features": features,
        "precision": planned.precision.to_string(),
        "beyond_f32": planned.doubles,
        "memory": { "scene_bytes": summary.bytes, "picture_bytes": planned.picture_bytes() },
        "forecast": {
            "milliseconds": planned.forecast.nanoseconds / 1e6,
            "pixels_traced": planned.forecast.tried,
            "rays": { "primary": primary, "shadow": shadow, "reflected": reflected, "refracted": refracted },
        },
        "device": { "name": planned.device(), "why": planned.verdict.why },
    })
}

/// What was left out, by reason.
fn dropped(planned: &Planned) -> String {
    let words = planned.summary.dropped.iter().map(|dropped| {
        let place = match (dropped.count, planned.line(dropped.solid)) {
            (1, Some(line)) => format!(" (line {line})"),
            (_, Some(line)) => format!(" (the first on line {line})"),
            (_, None) => String::new(),
        };
        format!("{} {}{place}", grouped(dropped.count as u64), dropped.reason)
    });
    list(words.collect())
}

/// How many islands are evaluated in which way.
fn tiers(tiers: &Tiers, cells: usize) -> String {
    let counts = [
        (tiers.single, "single"),
        (tiers.products, "products"),
        (tiers.programs, "programs"),
        (tiers.divided, "divided"),
        (cells, "cells"),
    ];
    let some = counts.into_iter().filter(|(count, _)| *count > 0);
    list(
        some.map(|(count, word)| format!("{} {word}", grouped(count as u64)))
            .collect(),
    )
}

fn list(words: Vec<String>) -> String {
    if words.is_empty() {
        return "nothing".to_owned();
    }
    words.join(", ")
}

/// The features that are on, with the number where there is more to say, and those that are off.
fn switches(features: &Features) -> (String, String) {
    let (on, off): (Vec<_>, Vec<_>) = features.list().into_iter().partition(|(_, value)| *value != 0);
    let word = |(name, value): (&str, u32)| match value {
        0 | 1 => name.to_lowercase(),
        _ => format!("{} {value}", name.to_lowercase()),
    };
    let words = |these: Vec<_>| list(these.into_iter().map(word).collect());
    (words(on), words(off))
}

/// Bytes in the unit that fits.
fn size(bytes: u64) -> String {
    match bytes {
        0..=9_999 => format!("{bytes} bytes"),
        10_000..=9_999_999 => format!("{:.0} kB", bytes as f64 / 1e3),
        10_000_000..=9_999_999_999 => format!("{:.0} MB", bytes as f64 / 1e6),
        _ => format!("{:.1} GB", bytes as f64 / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::size;

    fn check(bytes: u64, expect: &str) {
        assert_eq!(size(bytes), expect);
    }

    #[test]
    fn sizes_are_told_in_units_that_fit() {
        check(0, "0 bytes");
        check(9_999, "9999 bytes");
        check(2_880_000, "2880 kB");
        check(123_456_789, "123 MB");
        check(51_538_821_120, "51.5 GB");
    }
}
