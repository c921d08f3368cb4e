//! The suite's result as one table in Markdown.

use std::fmt::Write;

use super::Verdict;
use super::verdict::Outcome;

/// A row for each verdict, and a closing line; with a column for POV-Ray if it was asked.
#[must_use]
pub fn table(verdicts: &[Verdict]) -> String {
    let head = [
        "| case | member | condition | error f32 | allowed | error f64 | allowed | verdict |",
        "|---|---|---|---|---|---|---|---|",
    ];
    let rows = verdicts.iter().map(|verdict| (row(verdict), opinion(verdict)));
    whole(head, rows, verdicts)
}

/// A row for each case, all of its members together, and a closing line: the largest part of what is allowed that an error takes
/// up, and how many members a render would take doubles for.
#[must_use]
pub fn summary(verdicts: &[Verdict]) -> String {
    let head = [
        "| case | members | of them f64 | verdict | f32, of what is allowed | f64 |",
        "|---|---:|---:|---|---:|---:|",
    ];
    let cases = verdicts.chunk_by(|a, b| a.case == b.case);
    whole(
        head,
        cases.map(|members| (case_row(members), opinions(members))),
        verdicts,
    )
}

/// The head of a table, its rows, each with what POV-Ray makes of it if that was asked, and how many verdicts hold.
fn whole(head: [&str; 2], rows: impl Iterator<Item = (String, String)>, verdicts: &[Verdict]) -> String {
    let beside = verdicts.iter().any(|verdict| verdict.povray.is_some());
    let lines = head.into_iter().zip([" POV-Ray |", "---|"]);
    let lines = lines.map(|(line, more)| (line.to_owned(), more.to_owned())).chain(rows);
    let mut out = String::new();
    for (line, more) in lines {
        let _ = writeln!(out, "{line}{}", if beside { more.as_str() } else { "" });
    }
    let held = verdicts.iter().filter(|verdict| verdict.holds()).count();
    let _ = writeln!(out, "\n{held} of {} hold.", verdicts.len());
    out
}

fn case_row(members: &[Verdict]) -> String {
    let Some(first) = members.first() else {
        return String::new();
    };
    let single = members
        .iter()
        .filter(|member| member.beyond_single.is_none() && member.wider.is_none());
    let double = members.iter().filter_map(|member| member.double.as_ref());
    let wider = members.iter().filter(|member| member.wider.is_some()).count();
    let mut words = verdict_words(members.iter().all(Verdict::holds)).to_owned();
    let idle: Vec<_> = members.iter().filter_map(|member| member.not_run).collect();
    for alike in idle.chunk_by(|a, b| a == b) {
        let _ = write!(words, "; {} not run: {}", alike.len(), alike[0]);
    }
    format!(
        "| {}: {} | {} | {wider} | {words} | {} | {} |",
        first.case,
        first.title,
        members.len(),
        part(single.filter_map(|member| member.single.as_ref())),
        part(double)
    )
}

const fn verdict_words(holds: bool) -> &'static str {
    if holds { "holds" } else { "**FAILS**" }
}

/// The largest part of what is allowed.
fn part<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> String {
    let part = |outcome: &Outcome| match outcome.error {
        0.0 => 0.0,
        error => error / outcome.threshold,
    };
    let most = outcomes.map(part).max_by(f64::total_cmp);
    most.map_or_else(String::new, |most| {
        if most == 0.0 {
            "0".to_owned()
        } else {
            format!("{most:.1e}")
        }
    })
}

/// What POV-Ray makes of the members.
fn opinions(members: &[Verdict]) -> String {
    let opinions = || members.iter().filter_map(|member| member.povray.as_ref());
    let seen = opinions().filter_map(|opinion| opinion.as_ref().ok());
    let (mut seen, mut same, mut worst) = (seen.copied().peekable(), 0, 0.0_f64);
    let mut words = Vec::new();
    if seen.peek().is_some() {
        let mut count = 0;
        for share in seen {
            (count, same, worst) = (count + 1, same + usize::from(share == 0.0), worst.max(share));
        }
        words.push(match count - same {
            0 => "the same".to_owned(),
            other => format!("{other} of {count} other, up to {:.1} %", worst * 100.0),
        });
    }
    let mut reasons: Vec<_> = opinions().filter_map(|opinion| opinion.as_ref().err()).collect();
    reasons.sort();
    words.extend(
        reasons
            .chunk_by(|a, b| a == b)
            .map(|alike| format!("{} {}", alike.len(), alike[0])),
    );
    format!(" {} |", words.join("; "))
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
    let mut words = verdict_words(verdict.holds()).to_owned();
    if let Some(reason) = verdict.not_run {
        let _ = write!(words, "; not run: {reason}");
    }
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
