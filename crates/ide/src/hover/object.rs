//! Objects: where they are, what they are made of, and whether they are in the picture.

use std::fmt::Write;

use scenec_interpret::{DefinitionId, Occurrence, Role};
use scenec_scene::{Axis, DEFAULT_MATERIAL, StepKind};
use scenec_syntax::Statement;
use scenec_text::{Code, Span};

use super::material::summary;
use crate::Document;
use crate::extent::Extent;
use crate::solid::{Made, Shape, Standing};
use crate::words::{angle, code, degrees, figure, triple};

/// The most lines of one kind that are listed.
const MOST: usize = 8;

/// An object by its name, as it stands at the end of its line; where the line makes it, as it stands in the end.
pub(super) fn said(document: &Document, name: Span, id: Option<DefinitionId>, place: Option<&Occurrence>) -> String {
    let title = format!("**object** {}", code(&format!("!{}", document.words(name))));
    let before = match place.map(|place| place.role) {
        Some(Role::Edit) => document
            .source()
            .line_span(document.source().line_of(name.start))
            .map_or(name.end, |line| line.end),
        Some(Role::Define) => u32::MAX,
        Some(Role::Use) | None => name.start,
    };
    let standing = id.and_then(|id| Some((id, Standing::of(document, id, before)?)));
    let Some((id, standing)) = standing else {
        let why = match place.map(|place| place.role) {
            Some(Role::Define) => "This statement makes no object.",
            _ => "Nothing makes an object of this name before this line.",
        };
        return format!("{title}\n\n{why}");
    };
    let mut text = title;
    let _ = write!(text, ": {}", made(document, id, &standing));
    steps(document, &standing, &mut text);
    whereabouts(document, id, &standing, &mut text);
    material(document, id, &standing, &mut text);
    let _ = write!(text, "\n\n{}", picture(document, id));
    findings(document, id, &mut text);
    text
}

fn made(document: &Document, id: DefinitionId, standing: &Standing<'_>) -> String {
    let line = document.definition_of(id).map(|found| found.line).unwrap_or_default();
    let number = document.line_number(line.start);
    match standing.made {
        Made::Base(base) => {
            let row = scenec_scene::Base::ALL.iter().find(|(known, _)| *known == base);
            format!("`{}`, made on line {number}", row.map_or("", |(_, word)| word))
        }
        Made::Combination => {
            let leaves = match document.facts().leaves(id) {
                u64::MAX => "more base objects than can be counted".to_owned(),
                leaves => format!("{leaves} base objects"),
            };
            format!("{} on line {number}, of {leaves}", code(document.words(line)))
        }
    }
}

/// The transforms as they were written.
fn steps(document: &Document, standing: &Standing<'_>, text: &mut String) {
    if standing.steps.is_empty() {
        return;
    }
    text.push('\n');
    let skipped = standing.steps.len().saturating_sub(MOST);
    if skipped > 0 {
        let _ = write!(text, "\n- {skipped} transforms before these");
    }
    for (line, step) in standing.steps.iter().skip(skipped) {
        let number = document.line_number(line.start);
        let _ = write!(text, "\n- {} (line {number})", step_words(step));
    }
}

fn step_words(step: &StepKind) -> String {
    match step {
        StepKind::Scale(by) if by.x == by.y && by.y == by.z => format!("scaled by {}", figure(by.x)),
        StepKind::Scale(by) => format!("scaled by {}", triple(*by)),
        StepKind::Translate(by) => format!("moved by {}", triple(*by)),
        StepKind::Rotate(axis, radians) => {
            let axis = match axis {
                Axis::X => "x",
                Axis::Y => "y",
                Axis::Z => "z",
            };
            let (short, degrees) = (angle(*radians), degrees(*radians));
            if short == degrees {
                format!("turned about {axis} by {degrees}")
            } else {
                format!("turned about {axis} by {short} ({degrees})")
            }
        }
    }
}

/// Where it is, and the box around it.
fn whereabouts(document: &Document, id: DefinitionId, standing: &Standing<'_>, text: &mut String) {
    let extent = || Extent::of(document, id, standing).and_then(Extent::words);
    match standing.shape() {
        Some(Shape::Ball { centre, .. }) => {
            let _ = write!(text, "\n\nCentre {}; {}.", triple(centre), extent().unwrap_or_default());
        }
        Some(Shape::Half { point, normal }) => {
            let _ = write!(text, "\n\nPlane through {}, facing {}.", triple(point), triple(normal));
        }
        None => {
            if let Some(extent) = extent() {
                let _ = write!(text, "\n\nWithin {extent}.");
            }
        }
    }
}

fn material(document: &Document, id: DefinitionId, standing: &Standing<'_>, text: &mut String) {
    if let Some((line, paint)) = standing.paint {
        let name = code(&format!("?{}", document.name_of(paint)));
        let number = document.line_number(line.start);
        let _ = write!(text, "\n\nMaterial {name} (line {number}).");
        if let Some(material) = document.material(paint) {
            let _ = write!(text, " {}", summary(&material));
        }
    } else if standing.made != Made::Combination {
        let _ = write!(text, "\n\nDefault material. {}", summary(&DEFAULT_MATERIAL));
    }
    let hidden = document.facts().taken(id).filter(|taken| !taken.bare);
    if let Some(painted) = hidden.and_then(|taken| taken.painted) {
        let number = document.line_number(painted.start);
        let _ = write!(
            text,
            "\n\nIn the picture {} on line {number} replaces it.",
            code(document.words(painted))
        );
    }
}

/// Whether it is in the submitted object, and if not, why.
fn picture(document: &Document, id: DefinitionId) -> String {
    let facts = document.facts();
    let Some(submission) = facts.submission() else {
        return "Not in the picture: nothing is submitted.".to_owned();
    };
    if let Some(taken) = facts.taken(id) {
        let number = document.line_number(taken.last.start);
        if taken.last == submission.line {
            return format!("In the picture: submitted on line {number}.");
        }
        let end = document.line_number(submission.line.start);
        let by = code(document.words(taken.last));
        return format!("In the picture: taken by {by} on line {number}, submitted on line {end}.");
    }
    let takers = facts
        .uses(document, id)
        .filter_map(|place| document.statement_at(place.span.start));
    match takers.last() {
        Some((Statement::Combination { .. }, line)) if !facts.is_late(line) => {
            let number = document.line_number(line.start);
            format!(
                "Not in the picture: {} on line {number} takes it, and is not submitted.",
                code(document.words(line))
            )
        }
        _ => "Not in the picture: nothing that is submitted takes it.".to_owned(),
    }
}

/// The statements about it that do nothing or less than they seem to.
fn findings(document: &Document, id: DefinitionId, text: &mut String) {
    let made = document.definition_of(id).map(|found| found.line);
    let edits = document.facts().edits(document, id);
    let edited = edits.filter_map(|edit| Some(document.statement_at(edit.span.start)?.1));
    let all = made
        .into_iter()
        .chain(edited)
        .flat_map(|line| document.findings_on(line));
    for (listed, finding) in all.filter(|finding| drops(finding.code)).take(MOST).enumerate() {
        let lead = if listed == 0 { "\n" } else { "" };
        let number = document.line_number(finding.span().start);
        let _ = write!(
            text,
            "{lead}\n- line {number}: {} ({})",
            crate::words::plain(&finding.message),
            finding.code.id()
        );
    }
}

/// Whether a finding tells of a statement that is dropped.
const fn drops(code: Code) -> bool {
    matches!(
        code,
        Code::UnknownObject
            | Code::UnknownMaterial
            | Code::UnknownVariable
            | Code::AfterSubmission
            | Code::MaterialRedefined
            | Code::OperandEdited
            | Code::OverwrittenUnused
            | Code::UnusedObject
            | Code::MaterialReplaced
            | Code::TransformedCombination
            | Code::ZeroScale
            | Code::TransformOverflow
            | Code::CoveredSolid
            | Code::IdleSubtraction
            | Code::EmptySubtraction
            | Code::EmptyIntersection
            | Code::IdleIntersection
    )
}
