//! Making what a file lacks.

use scenec_scene::{Base, DEFAULT_MATERIAL, setting};
use scenec_syntax::Space;
use scenec_text::{Code, Diagnostic};

use super::Offer;
use crate::Document;
use crate::camera::number;
use crate::insert::{line_end, new_line_before, new_settings};

/// The settings that are missing, with the values that the finding proposes.
pub(super) fn settings(document: &Document) -> Option<Offer> {
    let lines = document.proposed_settings();
    let title = match lines.as_slice() {
        [] => return None,
        [_] => "add the missing setting".to_owned(),
        lines => format!("add the {} missing settings", lines.len()),
    };
    let edit = new_settings(document, &lines.join(line_end(document)));
    Some((title, vec![edit]))
}

/// Something of the name that is missing, on a line before the statement that uses it.
pub(super) fn named(document: &Document, finding: &Diagnostic) -> Option<Offer> {
    let name = finding.span().of(document.text());
    let (space, value) = match finding.code {
        Code::UnknownObject => (Space::Object, Base::ALL.first()?.1.to_owned()),
        Code::UnknownMaterial => (Space::Material, default_material()),
        // A setting has a place of its own.
        Code::UnknownVariable if setting(name).is_none() => (Space::Variable, "1".to_owned()),
        _ => return None,
    };
    let sigil = space.sigil();
    let edit = new_line_before(document, finding.span(), &format!("{sigil}{name} := {value}"));
    let title = format!("create the {} `{sigil}{name}`", space.noun());
    Some((title, vec![edit]))
}

/// The values of the material that objects have without one.
fn default_material() -> String {
    DEFAULT_MATERIAL.values().map(number).join(" ")
}
