//! The table for programs.

use std::fmt::Write;

use crate::run::{Report, Row};

/// One column: its name and how a row fills it.
type Column = (&'static str, fn(&Report, &Row) -> String);

/// Times are in seconds, colours in units of a component.
const COLUMNS: &[Column] = &[
    ("family", |_, row| quoted(&row.family)),
    ("knob", |_, row| quoted(&row.knob)),
    ("tracer", |_, row| quoted(&row.tracer)),
    ("precision", |_, row| row.setting.precision.to_string()),
    ("width", |report, _| report.truth.width.to_string()),
    ("height", |report, _| report.truth.height.to_string()),
    ("samples", |_, row| row.setting.samples.to_string()),
    ("raydepth", |_, row| row.setting.raydepth.to_string()),
    ("cutoff", |_, row| row.setting.cutoff.to_string()),
    ("rays_primary", |_, row| row.stats.primary.to_string()),
    ("rays_shadow", |_, row| row.stats.shadow.to_string()),
    ("rays_reflected", |_, row| row.stats.reflected.to_string()),
    ("rays_refracted", |_, row| row.stats.refracted.to_string()),
    ("over_budget", |_, row| row.stats.over_budget.to_string()),
    ("kernel_cold", |_, row| row.kernel.cold.to_string()),
    ("kernel_median", |_, row| row.kernel.median.to_string()),
    ("kernel_min", |_, row| row.kernel.min.to_string()),
    ("kernel_mad", |_, row| row.kernel.mad.to_string()),
    ("process_cold", |_, row| row.process.cold.to_string()),
    ("process_median", |_, row| row.process.median.to_string()),
    ("process_min", |_, row| row.process.min.to_string()),
    ("process_mad", |_, row| row.process.mad.to_string()),
    ("drift", |report, _| report.drift.to_string()),
    ("rmse", |_, row| row.figures.rmse.to_string()),
    ("max", |_, row| row.figures.max_abs.to_string()),
    ("p99", |_, row| row.figures.p99_abs.to_string()),
    ("share", |_, row| row.figures.off_share.to_string()),
    ("flip", |_, row| row.flip.to_string()),
    ("non_finite", |_, row| row.figures.non_finite.to_string()),
    ("bound_truncation", |_, row| row.bound.truncation.to_string()),
    ("bound_rounding", |_, row| row.bound.rounding.to_string()),
    ("bound_sampling", |_, row| row.bound.sampling.to_string()),
    ("bound_max", |_, row| row.bound.max.to_string()),
    ("bound_rms", |_, row| row.bound.rms.to_string()),
    ("reference_samples", |report, _| report.truth.samples.to_string()),
    ("reference_max", |report, _| report.truth.own_max.to_string()),
    ("reference_rms", |report, _| report.truth.own_rms.to_string()),
    ("limited", |_, row| row.limited.to_string()),
    ("front", |_, row| row.front.to_string()),
    ("defect", |report, row| report.is_defect(row).to_string()),
    ("unpromised", |report, row| report.is_unpromised(row).to_string()),
];

/// One line for each row of each named report, below a line of names (RFC 4180, with bare line feeds).
#[must_use]
pub fn csv(reports: &[(String, Report)]) -> String {
    let names: Vec<_> = COLUMNS.iter().map(|(name, _)| *name).collect();
    let mut text = format!("scene,{}\n", names.join(","));
    for (name, report) in reports {
        for row in &report.rows {
            let cells: Vec<_> = COLUMNS.iter().map(|(_, cell)| cell(report, row)).collect();
            // Writing to a string can't fail.
            writeln!(text, "{},{}", quoted(name), cells.join(",")).unwrap_or_default();
        }
    }
    text
}

/// In quotes where a comma or a line end would be mistaken for more than text.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn only_what_must_be_is_quoted() {
        for (text, expect) in [
            ("cpu f32", "cpu f32"),
            ("cpu f32 x16, depth", "\"cpu f32 x16, depth\""),
            ("a \"b\"", "\"a \"\"b\"\"\""),
        ] {
            assert_eq!(quoted(text), expect);
        }
    }
}
