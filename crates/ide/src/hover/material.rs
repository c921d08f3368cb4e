//! Materials: all ten values, the colour, and what it looks like.

use std::fmt::Write;

use scenec_interpret::{DefinitionId, Occurrence, Role};
use scenec_scene::{MATERIAL_FIELDS, Material};
use scenec_text::Span;

use super::Said;
use crate::Document;
use crate::words::{bytes, code, figure, hex, look};

/// A material by its name.
pub(super) fn said(document: &Document, name: Span, id: Option<DefinitionId>, place: Option<&Occurrence>) -> Said {
    let title = format!("**material** {}", code(&format!("?{}", document.words(name))));
    let Some((id, material)) = id.and_then(|id| Some((id, document.material(id)?))) else {
        let why = match place.map(|place| place.role) {
            Some(Role::Define) => "This statement defines nothing.",
            _ => "Nothing defines a material of this name before this line.",
        };
        return format!("{title}\n\n{why}").into();
    };
    let mut markdown = format!("{title}\n\n{}", table(&material));
    let line = material.span.unwrap_or_default();
    let uses = match document.facts().use_count(id) {
        0 => "No object takes it.".to_owned(),
        1 => "1 statement takes it.".to_owned(),
        uses => format!("{uses} statements take it."),
    };
    let _ = write!(
        markdown,
        "\n\nDefined on line {}. {uses}",
        document.line_number(line.start)
    );
    Said {
        markdown,
        ball: Some(material),
    }
}

/// The ten values, and what they come to.
pub(super) fn table(material: &Material) -> String {
    let mut text = String::from("| | | |\n|:---------|------:|:---|\n");
    for (field, value) in MATERIAL_FIELDS.iter().zip(material.values()) {
        let name = format!("`{}`", field.name);
        let _ = writeln!(text, "| {name:<10} | {:>6} | {} |", figure(value), field.meaning);
    }
    let _ = write!(text, "\n{}", summary(material));
    text
}

/// What it looks like, and how much light it gives back.
pub(super) fn summary(material: &Material) -> String {
    let [r, g, b] = bytes(material.colour.to_array());
    let clamped = if material.colour.to_array().iter().all(|part| (0.0..=1.0).contains(part)) {
        ""
    } else {
        ", brought between 0 and 1"
    };
    format!(
        "Looks: {}. Colour `{}`, rgb({r}, {g}, {b}){clamped}.\n\n{}, {}.",
        look(material),
        hex(material.colour),
        share("Ambient + diffuse", material.ambient + material.diffuse),
        share("reflection + refraction", material.reflect + material.refract),
    )
}

fn share(what: &str, sum: f64) -> String {
    let warning = if sum > 1.0 + 1e-9 {
        " (more light than falls on it)"
    } else {
        ""
    };
    format!("{what} = {}{warning}", figure(sum))
}
