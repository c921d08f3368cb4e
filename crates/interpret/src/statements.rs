//! What each statement does: one file for each.

mod broken;
mod combination;
mod light;
mod material;
mod material_set;
mod object;
mod operand;
mod rotate;
mod scale;
mod submit;
mod transform;
mod translate;
mod variable;

use scenec_syntax::{Space, Statement};
use scenec_text::Span;

use crate::state::State;

pub(crate) use broken::broken;
pub(crate) use operand::report_stale;

/// Carries out the statement on `line`.
pub(crate) fn run(state: &mut State<'_>, line: Span, statement: &Statement) {
    if let Some((_, submitted)) = state.submission.done
        && statement.form().info().space == Space::Object
        && !object::is_malformed(state, statement)
    {
        submit::after(state, line, statement, submitted);
        return;
    }
    match statement {
        Statement::Variable { name, value } => variable::run(state, line, *name, *value),
        Statement::Object { name, base } => object::run(state, line, *name, *base),
        Statement::Combination {
            name,
            operator,
            left,
            right,
        } => combination::run(state, line, *name, *operator, [*left, *right]),
        Statement::MaterialSet { name, material } => material_set::run(state, line, *name, *material),
        Statement::Scale { name, by } => scale::run(state, line, *name, by),
        Statement::Rotate { name, axis, angle } => rotate::run(state, line, *name, *axis, *angle),
        Statement::Translate { name, by } => translate::run(state, line, *name, by),
        Statement::Submit { name } => submit::run(state, line, *name),
        Statement::Light { name, values } => light::run(state, line, *name, values),
        Statement::Material { name, values } => material::run(state, line, *name, values),
    }
}
