//! `?x := ambref diffref specref rflec rfrac rfracind shiny r g b`

use scenec_scene::{Material, MaterialId};
use scenec_syntax::{Space, Value, quote};
use scenec_text::{Code, Diagnostic, Span};

use crate::Role;
use crate::bindings::Paint;
use crate::names::{Binding, Gap};
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, values: &[Value; 10]) {
    let id = state.paints.mention(name, Role::Define, &mut state.symbols);
    let numbers = state.numbers(values);
    let entry = &mut state.paints.entries[id];
    let numbers = match numbers {
        Ok(numbers) => numbers,
        Err(Gap::Unknown) => {
            state.paints.ignore(id, line);
            return;
        }
        Err(Gap::Poisoned) => {
            entry.binding = Binding::Poisoned;
            return;
        }
    };
    let number = MaterialId(u32::try_from(state.materials.len()).unwrap_or(u32::MAX));
    let material = Material::from_values(numbers, line);
    state.materials.push(material);
    let taken = entry.bound().and_then(|paint| paint.taken);
    let paint = Paint {
        id: number,
        line,
        used: false,
        taken,
    };
    let name = entry.name.of(state.text);
    if let Some(before) = entry.bind(line, paint, &mut state.symbols)
        && !before.used
    {
        state.overwritten(Space::Material, name, before.line, line);
    }
    check(state, name, &material, values);
}

fn check(state: &mut State<'_>, name: &str, material: &Material, values: &[Value; 10]) {
    let [_, _, _, _, _, index, shiny, ..] = values;
    let name = quote(&format!("?{name}"));
    if material.shiny < 0.0 {
        state.report(
            Diagnostic::new(
                Code::NegativeShininess,
                format!("the shininess of {name} is negative"),
                shiny.span,
                format!("is {}", material.shiny),
            )
            .help("the exponent of the highlight is 0 or more; the larger, the smaller the highlight"),
        );
    }
    if material.refract > 0.0 && material.index <= 0.0 {
        let effect = if material.index == 0.0 {
            "all light is reflected on entry"
        } else {
            "light leaves on the other side of the normal"
        };
        state.report(
            Diagnostic::new(
                Code::StrangeIndex,
                format!("{name} refracts with the index {}: {effect}", material.index),
                index.span,
                "not the index of any glass",
            )
            .help("air has the index 1, water 1.33, glass about 1.5"),
        );
    }
}
