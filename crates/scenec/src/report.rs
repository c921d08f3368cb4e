//! Findings for people: drawn with the lines that they are about.
//!
//! Owns colour, width and what may reach a terminal. It must not know how a finding came about.

mod colour;
mod excerpt;
mod sanitise;

use std::io::{self, Write};
use std::ops::Range;

use ariadne::{Color, Config, IndexType, Label, Report, ReportKind, Source};
use scenec_text::{Diagnostic, Severity, SourceFile, Span};

pub(crate) use colour::ColourChoice;
use excerpt::Excerpt;
use sanitise::sanitise;

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

/// How many findings of each kind there are.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) errors: usize,
    pub(crate) warnings: usize,
}

impl Tally {
    pub(crate) fn of(diagnostics: &[Diagnostic]) -> Self {
        let count = |severity| {
            diagnostics
                .iter()
                .filter(|finding| finding.severity() == severity)
                .count()
        };
        Self {
            errors: count(Severity::Error),
            warnings: count(Severity::Warning),
        }
    }
}

/// Writes the findings of one file, in the order given, as many as the style allows.
///
/// # Errors
/// Those of `out`, a closed pipe among them.
pub(crate) fn print(
    out: &mut impl Write,
    source: &SourceFile,
    diagnostics: &[Diagnostic],
    style: &Style,
) -> io::Result<()> {
    let printer = Printer {
        source,
        name: sanitise(source.name()),
        whole: None,
        colour: style.colour.decide(),
    };
    printer.print(out, diagnostics, style.max_diagnostics)
}

/// Writes one line that says how a file fared.
///
/// # Errors
/// Those of `out`.
pub(crate) fn summary(out: &mut impl Write, source: &SourceFile, tally: Tally) -> io::Result<()> {
    let name = sanitise(source.name());
    let count = |number: usize, noun: &str| match number {
        0 => None,
        1 => Some(format!("1 {noun}")),
        _ => Some(format!("{number} {noun}s")),
    };
    let counts: Vec<_> = [count(tally.errors, "error"), count(tally.warnings, "warning")]
        .into_iter()
        .flatten()
        .collect();
    if counts.is_empty() {
        writeln!(out, "{name}: no problems")
    } else {
        writeln!(out, "{} in {name}", counts.join(", "))
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
    /// The whole file as it may reach a terminal, made when the first finding needs it and kept for the others.
    whole: Option<Source<String>>,
    colour: bool,
}

impl Printer<'_> {
    fn print(mut self, out: &mut impl Write, diagnostics: &[Diagnostic], most: usize) -> io::Result<()> {
        let errors = diagnostics
            .iter()
            .filter(|finding| finding.severity() == Severity::Error)
            .count();
        let mut warnings_left = most.saturating_sub(errors);
        let mut errors_left = most;
        for finding in diagnostics {
            let left = match finding.severity() {
                Severity::Error => &mut errors_left,
                Severity::Warning | Severity::Hint => &mut warnings_left,
            };
            if *left > 0 {
                *left -= 1;
                self.one(out, finding)?;
            }
        }
        let hidden = diagnostics.len().saturating_sub(most);
        if hidden > 0 {
            writeln!(out, "{hidden} more not shown; --max-diagnostics sets how many are")?;
        }
        Ok(())
    }

    fn one(&mut self, out: &mut impl Write, finding: &Diagnostic) -> io::Result<()> {
        if let Some(excerpt) = Excerpt::of(self.source, finding) {
            let mut drawn = Vec::new();
            let place = |_: Span, index: usize| excerpt.places.get(index).cloned().unwrap_or_default();
            let report = self.draw(finding, place);
            report.write((self.name.clone(), Source::from(excerpt.text)), &mut drawn)?;
            // The drawing counts columns from the start of the excerpt; the file counts them from the start of the line.
            let drawn = String::from_utf8_lossy(&drawn);
            let (first, rest) = drawn.split_once('\n').unwrap_or((&drawn, ""));
            let shown = format!("{}:{}:{}", self.name, excerpt.line, excerpt.shown_column);
            let true_place = format!("{}:{}:{}", self.name, excerpt.line, excerpt.column);
            return writeln!(out, "{first}\n{}", rest.replacen(&shown, &true_place, 1));
        }
        let start = first_byte(self.source);
        let whole = self.whole.take().unwrap_or_else(|| {
            // The space gives an empty last line something to point at.
            Source::from(sanitise(self.source.text().get(start..).unwrap_or_default()) + " ")
        });
        let place = |span: Span, _: usize| {
            let snap = |offset: u32| snap(self.source.text(), offset as usize).max(start) - start;
            snap(span.start)..snap(span.end).max(snap(span.start))
        };
        let report = self.draw(finding, place);
        report.write((self.name.clone(), &whole), &mut *out)?;
        self.whole = Some(whole);
        writeln!(out)
    }

    fn draw(
        &self,
        finding: &Diagnostic,
        place: impl Fn(Span, usize) -> Range<usize>,
    ) -> Report<'static, (String, Range<usize>)> {
        let (kind, colour) = match finding.severity() {
            Severity::Error => (ReportKind::Error, Color::Red),
            Severity::Warning => (ReportKind::Warning, Color::Yellow),
            Severity::Hint => (ReportKind::Advice, Color::Cyan),
        };
        let config = Config::default()
            .with_color(self.colour)
            .with_index_type(IndexType::Byte);
        let mut report = Report::build(kind, (self.name.clone(), place(finding.span(), 0)))
            .with_config(config)
            .with_code(finding.code.id())
            .with_message(sanitise(&finding.message));
        for (index, label) in finding.labels.iter().enumerate() {
            let line = self.source.position(label.span.start).line;
            report = report.with_label(
                Label::new((self.name.clone(), place(label.span, index)))
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

/// The length of a byte-order mark, if there is one.
fn first_byte(source: &SourceFile) -> usize {
    if source.text().starts_with('\u{FEFF}') {
        '\u{FEFF}'.len_utf8()
    } else {
        0
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
