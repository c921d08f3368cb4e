//! Findings for people: drawn with the lines that they are about.
//!
//! Owns colour, width and what may reach a terminal. It must not know how a finding came about.

mod colour;
mod excerpt;
mod sanitise;

use std::io::{self, Write};
use std::ops::Range;

use ariadne::{Color, Config, IndexType, Label, Report, ReportKind, Source};
use scenec_text::{Severity, SourceFile};

use crate::finding::Shown;
pub(crate) use colour::ColourChoice;
use excerpt::Excerpt;
pub(crate) use sanitise::sanitise;

/// How findings are shown: arguments that every subcommand with findings has.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct Style {
    /// When to colour the reports
    #[arg(long = "color", value_enum, default_value_t = ColourChoice::Auto, value_name = "WHEN")]
    pub(crate) colour: ColourChoice,
    /// The most findings to show of one file, errors before warnings
    #[arg(long, default_value_t = 100, value_name = "N")]
    pub(crate) max_diagnostics: usize,
}

/// The same, where a subcommand also tells how it went.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct Voice {
    /// Say nothing but errors and what was asked for
    #[arg(short, long)]
    pub(crate) quiet: bool,
    #[command(flatten)]
    pub(crate) style: Style,
}

/// How many findings of each kind there are.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) errors: usize,
    pub(crate) warnings: usize,
    pub(crate) hints: usize,
}

impl Tally {
    pub(crate) fn of(findings: &[impl Shown]) -> Self {
        let count = |severity| findings.iter().filter(|finding| finding.severity() == severity).count();
        Self {
            errors: count(Severity::Error),
            warnings: count(Severity::Warning),
            hints: count(Severity::Hint),
        }
    }

    /// The two together.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            errors: self.errors + other.errors,
            warnings: self.warnings + other.warnings,
            hints: self.hints + other.hints,
        }
    }

    /// The counts in words; `None` if there is nothing to count.
    pub(crate) fn words(self) -> Option<String> {
        let count = |number: usize, noun: &str| (number > 0).then(|| plural(number, noun));
        let counts = [
            count(self.errors, "error"),
            count(self.warnings, "warning"),
            count(self.hints, "hint"),
        ];
        let counts: Vec<_> = counts.into_iter().flatten().collect();
        (!counts.is_empty()).then(|| counts.join(", "))
    }
}

/// A number of things.
pub(crate) fn plural(number: usize, noun: &str) -> String {
    let s = if number == 1 { "" } else { "s" };
    format!("{number} {noun}{s}")
}

/// Writes the findings of one file to standard error's `out`, in the order given, as many as the style allows.
///
/// # Errors
/// Those of `out`, a closed pipe among them.
pub(crate) fn print(
    out: &mut impl Write,
    source: &SourceFile,
    findings: &[impl Shown],
    style: &Style,
) -> io::Result<()> {
    draw(
        out,
        source,
        findings,
        style.colour.decide(&io::stderr()),
        style.max_diagnostics,
    )
}

/// Writes the findings of one file, in the order given, at most so many.
///
/// # Errors
/// Those of `out`, a closed pipe among them.
pub(crate) fn draw(
    out: &mut (impl Write + ?Sized),
    source: &SourceFile,
    findings: &[impl Shown],
    colour: bool,
    most: usize,
) -> io::Result<()> {
    let printer = Printer {
        source,
        name: sanitise(source.name()),
        colour,
    };
    let (chosen, hidden) = choose(findings, most);
    for finding in chosen {
        printer.one(out, finding)?;
    }
    not_shown(out, hidden)
}

/// The findings to show where at most so many are, errors before the others, and how many that leaves out.
pub(crate) fn choose<S: Shown>(findings: &[S], most: usize) -> (Vec<&S>, usize) {
    let mut errors_left = most;
    let mut others_left = most.saturating_sub(Tally::of(findings).errors);
    let chosen = findings.iter().filter(|finding| {
        let left = match finding.severity() {
            Severity::Error => &mut errors_left,
            Severity::Warning | Severity::Hint => &mut others_left,
        };
        let chosen = *left > 0;
        *left = left.saturating_sub(1);
        chosen
    });
    (chosen.collect(), findings.len().saturating_sub(most))
}

/// Says how many findings were left out, if any were.
///
/// # Errors
/// Those of `out`.
pub(crate) fn not_shown(out: &mut (impl Write + ?Sized), hidden: usize) -> io::Result<()> {
    match hidden {
        0 => Ok(()),
        _ => writeln!(out, "{hidden} more not shown; --max-diagnostics sets how many are"),
    }
}

/// Writes one line that says how a file fared.
///
/// # Errors
/// Those of `out`.
pub(crate) fn summary(out: &mut (impl Write + ?Sized), source: &SourceFile, tally: Tally) -> io::Result<()> {
    let name = sanitise(source.name());
    match tally.words() {
        Some(counts) => writeln!(out, "{counts} in {name}"),
        None => writeln!(out, "{name}: no problems"),
    }
}

/// Writes why the command can't be carried out.
///
/// # Errors
/// Those of `out`.
pub(crate) fn failure(out: &mut impl Write, message: &str) -> io::Result<()> {
    writeln!(out, "error: {}", sanitise(message))
}

/// Writes lines that are no finding.
///
/// # Errors
/// Those of `out`.
pub(crate) fn remark(out: &mut impl Write, message: &str) -> io::Result<()> {
    writeln!(out, "{}", sanitise(message))
}

struct Printer<'a> {
    source: &'a SourceFile,
    name: String,
    colour: bool,
}

impl Printer<'_> {
    fn one(&self, out: &mut (impl Write + ?Sized), shown: &impl Shown) -> io::Result<()> {
        let excerpt = Excerpt::of(self.source, shown.diagnostic());
        let mut drawn = Vec::new();
        let report = self.draw(shown, &excerpt.places);
        report.write((self.name.clone(), Source::from(&excerpt.text)), &mut drawn)?;
        writeln!(
            out,
            "{}",
            excerpt.numbered(&String::from_utf8_lossy(&drawn), &self.name)
        )
    }

    /// A finding whose labels lie at these places.
    fn draw(&self, shown: &impl Shown, places: &[Range<usize>]) -> Report<'static, (String, Range<usize>)> {
        let finding = shown.diagnostic();
        let (kind, colour) = match shown.severity() {
            Severity::Error => (ReportKind::Error, Color::Red),
            Severity::Warning => (ReportKind::Warning, Color::Yellow),
            Severity::Hint => (ReportKind::Advice, Color::Cyan),
        };
        let place = |index: usize| places.get(index).cloned().unwrap_or_default();
        let config = Config::default()
            .with_color(self.colour)
            .with_index_type(IndexType::Byte);
        let mut report = Report::build(kind, (self.name.clone(), place(0)))
            .with_config(config)
            .with_code(finding.code.id())
            .with_message(sanitise(&finding.message));
        for (index, label) in finding.labels.iter().enumerate() {
            let line = self.source.line_of(label.span.start);
            report = report.with_label(
                Label::new((self.name.clone(), place(index)))
                    .with_message(sanitise(&label.message))
                    .with_color(if index == 0 { colour } else { Color::Blue })
                    // Labels out of the order of their lines would be drawn as if they were of several files.
                    .with_order(i32::try_from(line).unwrap_or(i32::MAX)),
            );
        }
        if let Some(help) = &finding.help {
            report = report.with_help(sanitise(help));
        }
        report.finish()
    }
}

/// The last boundary between characters at or before an offset.
fn snap(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
