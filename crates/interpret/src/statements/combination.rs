//! `!z := x | y`

use scenec_scene::{Op, SolidKind};
use scenec_syntax::Operator;
use scenec_text::Span;

use super::operand;
use crate::Role;
use crate::names::Gap;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, operator: Operator, operands: [Span; 2]) {
    let id = state.objects.mention(name, Role::Define, &mut state.symbols);
    let [left, right] = operands.map(|operand| state.object(operand, Role::Use));
    if left.is_err() && operands[0].of(state.text) == operands[1].of(state.text) && right == Err(Gap::Unknown) {
        // `a | a` misses one name, not two.
        state.unknown.pop();
    }
    let take = |state: &mut State<'_>, found: Result<usize, Gap>| {
        found.and_then(|id| operand::take(state, id, line).ok_or(Gap::Poisoned))
    };
    match (take(state, left), take(state, right)) {
        (Ok(left), Ok(right)) => {
            let op = match operator {
                Operator::Union => Op::Union,
                Operator::Intersection => Op::Intersection,
                Operator::Subtraction => Op::Subtraction,
            };
            let solid = state.push_solid(SolidKind::Combine { op, left, right }, line);
            operand::bind(state, id, solid, line);
        }
        (left, right) => match left.err().max(right.err()) {
            Some(Gap::Poisoned) => operand::poison(state, id),
            _ => state.objects.ignore(id, line),
        },
    }
}
