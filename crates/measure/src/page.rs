//! The report for people, in Markdown.

use std::fmt::Write;

use crate::run::{Report, Row};

const HEAD: &str = "\
| | kernel ms | process ms, cold | warm | Mrays/s | RMSE | max | p99 | off by > 1/255 | FLIP | bound | of it proven | bound / max | |\n\
|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n";

const LEGEND: &str = "\
Kernel times are the median of the warm runs ± the median distance from it, process times those of whole processes that
write a file. RMSE, max and p99 are distances from the reference, of colour components. The bound is on the worst
component of the worst pixel: what was cut off (proven), and roundings and missing samples (estimated). On the *front* is
what no other row beats in both kernel time and RMSE. *Reference-limited* rows are so close that the reference's own
error shows in them. A *DEFECT* is more wrong than its bound and the reference's own error together. Of *fast-math*, which
is there for comparison, nothing is promised: where it is so wrong, that is only said, and it is on no front.\n";

/// The page of these named reports; `diagram` is the file of each one's diagram.
#[must_use]
pub fn page(reports: &[(String, Report)], diagram: impl Fn(usize) -> String) -> String {
    let mut text = format!("# Error against run time\n\n{LEGEND}");
    for (index, (name, report)) in reports.iter().enumerate() {
        // Writing to a string can't fail, here and below.
        section(&mut text, name, report, &diagram(index)).unwrap_or_default();
    }
    text
}

fn section(text: &mut String, name: &str, report: &Report, diagram: &str) -> std::fmt::Result {
    let truth = &report.truth;
    writeln!(text, "\n## {}\n\n![work and precision]({diagram})\n", escaped(name))?;
    writeln!(
        text,
        "{} x {} pixels. The reference has {} samples a pixel{}; its own error is about {:.1e} (root mean square), \
         {:.1e} in the worst pixel. A fixed piece of work between the runs varied by {:.0} %: differences in time below \
         that say nothing.\n",
        truth.width,
        truth.height,
        truth.samples,
        if truth.kept {
            " and was kept from an earlier run"
        } else {
            ""
        },
        truth.own_rms,
        truth.own_max,
        report.drift * 100.0
    )?;
    text.push_str(HEAD);
    let mut family = "";
    for row in &report.rows {
        if row.family != family {
            family = &row.family;
            writeln!(text, "| **{}** | | | | | | | | | | | | | |", escaped(family))?;
        }
        line(text, report, row)?;
    }
    for note in &report.notes {
        writeln!(text, "\nNot tried: {}.", escaped(note))?;
    }
    Ok(())
}

fn line(text: &mut String, report: &Report, row: &Row) -> std::fmt::Result {
    let (figures, bound) = (&row.figures, &row.bound);
    let ms = |seconds: f64| format!("{:.2}", seconds * 1e3);
    let words = [
        (report.is_defect(row), "**DEFECT**"),
        (report.is_unpromised(row), "not promised"),
        (row.front, "front"),
        (row.limited, "reference-limited"),
    ];
    let words: Vec<_> = words
        .iter()
        .filter(|(holds, _)| *holds)
        .map(|(_, word)| *word)
        .collect();
    let cells = [
        escaped(&row.knob),
        format!("{} ± {}", ms(row.kernel.median), ms(row.kernel.mad)),
        ms(row.process.cold),
        ms(row.process.median),
        format!("{:.2}", row.stats.rays() as f64 / row.kernel.median.max(1e-12) * 1e-6),
        format!("{:.2e}", figures.rmse),
        format!("{:.2e}", figures.max_abs),
        format!("{:.2e}", figures.p99_abs),
        format!("{:.2} %", figures.off_share * 100.0),
        format!("{:.2e}", row.flip),
        format!("{:.2e}", bound.max),
        format!("{:.2e}", bound.truncation),
        ratio(bound.max, figures.max_abs),
        words.join(", "),
    ];
    writeln!(text, "| {} |", cells.join(" | "))
}

/// How many times the error the bound is.
fn ratio(bound: f64, error: f64) -> String {
    if error > 0.0 {
        format!("{:.1}", bound / error)
    } else {
        "-".to_owned()
    }
}

/// What Markdown's tables would take for their own.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\")
        .replace('|', "\\|")
        .replace(['\n', '\r'], " ")
}
