//! The suite's result as one table in Markdown.

use std::fmt::Write;

use super::Verdict;
use super::judge::Outcome;

/// A row for each verdict, and a closing line; with a column for POV-Ray if it was asked.
#[must_use]
pub fn table(verdicts: &[Verdict]) -> String {
    let beside = verdicts.iter().any(|verdict| verdict.povray.is_some());
    let mut out = String::from("| case | member | condition | error f32 | allowed | error f64 | allowed | verdict |");
    out += if beside { " POV-Ray |\n" } else { "\n" };
    out += "|---|---|---|---|---|---|---|---|";
    out += if beside { "---|\n" } else { "\n" };
    for verdict in verdicts {
        let opinion = if beside { opinion(verdict) } else { String::new() };
        let _ = writeln!(out, "{}{opinion}", row(verdict));
    }
    let held = verdicts.iter().filter(|verdict| verdict.holds()).count();
    let _ = writeln!(out, "\n{held} of {} hold.", verdicts.len());
    out
}

fn row(verdict: &Verdict) -> String {
    let condition = verdict
        .condition
        .map_or_else(String::new, |value| format!("{value:.0e}"));
    let (single, allowed_single) = cells(verdict.single.as_ref());
    let (double, allowed_double) = cells(verdict.double.as_ref());
    let allowed_single = match (&verdict.beyond_single, &verdict.wider) {
        (Some(why), _) => why.clone(),
        (None, Some(why)) => format!("f64 taken: {why}"),
        (None, None) => allowed_single,
    };
    let words = if verdict.holds() { "holds" } else { "**FAILS**" };
    format!(
        "| {}: {} | {} | {condition} | {single} | {allowed_single} | {double} | {allowed_double} | {words} |",
        verdict.case, verdict.title, verdict.run
    )
}

fn opinion(verdict: &Verdict) -> String {
    match &verdict.povray {
        None => " |".to_owned(),
        Some(Ok(0.0)) => " the same |".to_owned(),
        Some(Ok(share)) => format!(" {:.1} % other |", share * 100.0),
        Some(Err(reason)) => format!(" {reason} |"),
    }
}

fn cells(outcome: Option<&Outcome>) -> (String, String) {
    let number = |x: f64| if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}") };
    outcome.map_or_else(Default::default, |it| (number(it.error), number(it.threshold)))
}
