//! `!x *= a b c`

use scenec_scene::{DVec3, StepKind};
use scenec_syntax::{Value, quote};
use scenec_text::{Code, Diagnostic, Span};

use super::transform;
use crate::Role;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, by: &[Value; 3]) {
    let object = state.object(name, Role::Edit);
    let factors = state.numbers(by);
    if let Ok(factors) = factors
        && let Some((_, value)) = factors.iter().zip(by).find(|(factor, _)| **factor == 0.0)
    {
        if object.is_ok() {
            let name = quote(&format!("!{}", name.of(state.text)));
            state.report(
                Diagnostic::new(
                    Code::ZeroScale,
                    format!("a scale by 0 makes {name} vanish"),
                    value.span,
                    "is 0",
                )
                .help("1 leaves a direction as it is, -1 mirrors it"),
            );
        }
        return;
    }
    let kind = factors.map(|factors| StepKind::Scale(DVec3::from_array(factors)));
    transform::apply(state, line, object, kind);
}
