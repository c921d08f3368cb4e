//! Writing a camera into the text.

use scenec_interpret::Role;
use scenec_syntax::{Space, Statement};
use scenec_text::{Edit, Span};

use crate::Document;
use crate::insert::{line_end, new_line_after, new_settings};

/// A camera to write down.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CameraChange {
    /// Where it stands, world units.
    pub eye: [f64; 3],
    /// Where it looks, world units.
    pub lookat: [f64; 3],
    /// Which way is up, where that changed.
    pub up: Option<[f64; 3]>,
    /// Horizontal field of view in radians, where that changed.
    pub fov: Option<f64>,
}

const EYE: [&str; 3] = ["eyepos_x", "eyepos_y", "eyepos_z"];
const LOOKAT: [&str; 3] = ["lookat_x", "lookat_y", "lookat_z"];
const UP: [&str; 3] = ["up_x", "up_y", "up_z"];

/// The edits after which the file has this camera and is the same otherwise. Values are replaced where they stand; one
/// that something else reads is set again behind that; one that is missing comes behind the last setting. None if a
/// number is not finite.
#[must_use]
pub fn camera_edits(document: &Document, change: &CameraChange) -> Vec<Edit> {
    let mut wanted: Vec<(&str, f64)> = EYE.into_iter().zip(change.eye).collect();
    wanted.extend(LOOKAT.into_iter().zip(change.lookat));
    wanted.extend(change.up.into_iter().flat_map(|up| UP.into_iter().zip(up)));
    wanted.extend(change.fov.map(|fov| ("fov", fov)));
    if wanted.iter().any(|(_, value)| !value.is_finite()) {
        return Vec::new();
    }
    let mut edits = Vec::new();
    // Lines to add, by the line that they go behind; without one, behind the last setting.
    let mut added: Vec<(Option<Span>, String)> = Vec::new();
    for (name, value) in wanted {
        match place_of(document, name) {
            Some(place) if place.value == Some(value) => {}
            Some(Place { behind: None, span, .. }) => edits.push(Edit {
                span,
                text: number(value),
            }),
            Some(Place { behind, .. }) => added.push((behind, assignment(name, value))),
            None => added.push((None, assignment(name, value))),
        }
    }
    edits.extend(additions(document, added));
    edits.sort_by_key(|edit| edit.span.start);
    edits
}

/// One edit for each line that something goes behind.
fn additions(document: &Document, mut added: Vec<(Option<Span>, String)>) -> Vec<Edit> {
    added.sort_by_key(|(line, _)| *line);
    let end = line_end(document);
    let groups = added.chunk_by(|a, b| a.0 == b.0);
    groups
        .filter_map(|group| {
            let lines: Vec<&str> = group.iter().map(|(_, line)| line.as_str()).collect();
            let text = lines.join(end);
            Some(match group.first()?.0 {
                Some(line) => new_line_after(document, line, &text),
                None => new_settings(document, &text),
            })
        })
        .collect()
}

fn assignment(name: &str, value: f64) -> String {
    format!("{name} := {}", number(value))
}

/// The shortest way to write a number that reads as the same one.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-5..1e15).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Where a setting gets its value.
struct Place {
    /// The value as written.
    span: Span,
    /// What it is now, where that is known.
    value: Option<f64>,
    /// The last statement that reads it, if any does.
    behind: Option<Span>,
}

/// The last statement that sets `name`; a line that fits no statement is none.
fn place_of(document: &Document, name: &str) -> Option<Place> {
    let symbol = document.symbol(Space::Variable, name)?;
    let mut last = None;
    let mut read = None;
    for place in document.interpretation().symbols.places(symbol) {
        if place.role != Role::Define {
            read = Some(place.span);
        } else if let Some((Statement::Variable { value, .. }, _)) = document.statement_at(place.span.start) {
            (last, read) = (Some((value.span, place.definition)), None);
        }
    }
    let (span, definition) = last?;
    Some(Place {
        span,
        value: definition.and_then(|id| document.facts().value(id)),
        behind: read.and_then(|read| Some(document.line_at(read.start)?.span)),
    })
}

#[cfg(test)]
mod tests {
    use scenec_text::apply;

    use super::{CameraChange, camera_edits};
    use crate::tests::document;

    fn check(text: &str, expect: &str) {
        let change = CameraChange {
            eye: [1.5, 0.0, -2e-9],
            lookat: [0.1 + 0.2, 7.0, 1e20],
            up: None,
            fov: Some(1.0),
        };
        let edits = camera_edits(&document(text), &change);
        assert_eq!(apply(text, &edits), expect, "{text}");
        let broken = CameraChange {
            fov: Some(f64::NAN),
            ..change
        };
        assert_eq!(camera_edits(&document(text), &broken), []);
    }

    #[test]
    fn values_change_where_they_stand() {
        check(
            "eyepos_x := 4.0 / left\r\nd := 3\r\neyepos_y := -d\r\neyepos_z := 1\r\nlookat_x := pi\r\nlookat_y := 7.0\r\nlookat_z := 0\r\nfov := 2\r\n",
            "eyepos_x := 1.5 / left\r\nd := 3\r\neyepos_y := 0\r\neyepos_z := -2e-9\r\nlookat_x := 0.30000000000000004\r\nlookat_y := 7.0\r\nlookat_z := 1e20\r\nfov := 1\r\n",
        );
    }

    #[test]
    fn what_is_missing_comes_behind_the_settings_and_what_is_read_stays() {
        check(
            "/ c\neyepos_x := 1\neyepos_y := 0\neyepos_z := -2e-9\nlookat_x := 0.30000000000000004\nlookat_y := 7\n!s := sphere\n!s += eyepos_x 0 0",
            "/ c\neyepos_x := 1\neyepos_y := 0\neyepos_z := -2e-9\nlookat_x := 0.30000000000000004\nlookat_y := 7\nlookat_z := 1e20\nfov := 1\n!s := sphere\n!s += eyepos_x 0 0\neyepos_x := 1.5",
        );
    }
}
