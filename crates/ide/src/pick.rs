//! Between the text and the solids of the scene: what the cursor is on, and what a pixel shows.

use scenec_interpret::Role;
use scenec_scene::{Scene, SolidId, SolidKind};
use scenec_syntax::{Space, Statement};
use scenec_text::Span;

use crate::Document;
use crate::names::{Named, name_at};
use crate::navigate::{Target, target};

/// The solid that the statement at `offset` makes, edits or submits, or the one that an operand under the cursor stands
/// for: the one in the picture, where an object was edited after it had been taken. `None` where there is no scene.
#[must_use]
pub fn object_at(document: &Document, offset: u32) -> Option<SolidId> {
    let scene = document.scene()?;
    let (statement, line) = document.statement_at(offset)?;
    if statement.form().info().space != Space::Object {
        return None;
    }
    let shown = Shown::of(scene);
    if let Some(operand) = operand_at(document, statement, line, offset, &shown) {
        return Some(operand);
    }
    if let Some(made) = shown.made_by(line) {
        return Some(made);
    }
    let subject = document.occurrence(statement.name())?;
    let made = document.definition_of(subject.definition?)?.line;
    if matches!(statement, Statement::Submit { .. }) {
        return Some(scene.root);
    }
    shown.moved_by(line).or_else(|| shown.made_by(made))
}

/// The statement that made a solid.
#[must_use]
pub fn statement_of(document: &Document, solid: SolidId) -> Option<Target> {
    let line = document.scene()?.solids.get(solid.index())?.span;
    target(document, line, line)
}

/// The operand under the cursor, as the combination took it.
fn operand_at(
    document: &Document,
    statement: &Statement,
    line: Span,
    offset: u32,
    shown: &Shown<'_>,
) -> Option<SolidId> {
    let Statement::Combination {
        left: left_name,
        right: right_name,
        ..
    } = statement
    else {
        return None;
    };
    let name: Named = name_at(document, offset).filter(|name| name.role == Role::Use)?;
    let combination = shown.made_by(line)?;
    let SolidKind::Combine { left, right, .. } = shown.scene.solids.get(combination.index())?.kind else {
        return None;
    };
    if name.span == *left_name {
        Some(left)
    } else {
        (name.span == *right_name).then_some(right)
    }
}

/// A scene and which of its solids are part of the submitted one.
struct Shown<'a> {
    scene: &'a Scene,
    reached: Vec<bool>,
}

impl<'a> Shown<'a> {
    /// Operands stand before the combinations that take them, so one backward pass does.
    fn of(scene: &'a Scene) -> Self {
        let mut reached = vec![false; scene.solids.len()];
        let reach = |reached: &mut Vec<bool>, id: SolidId| {
            if let Some(place) = reached.get_mut(id.index()) {
                *place = true;
            }
        };
        reach(&mut reached, scene.root);
        for (index, solid) in scene.solids.iter().enumerate().rev() {
            if reached.get(index) != Some(&true) {
                continue;
            }
            match &solid.kind {
                SolidKind::Combine { left, right, .. } => {
                    reach(&mut reached, *left);
                    reach(&mut reached, *right);
                }
                SolidKind::Paint { inside, .. } => reach(&mut reached, *inside),
                SolidKind::Leaf(_) => {}
            }
        }
        Self { scene, reached }
    }

    /// The best of the solids that `fits`: one of the picture before others, the last of those.
    fn best(&self, fits: impl Fn(&scenec_scene::Solid) -> bool) -> Option<SolidId> {
        let solids = self.scene.solids.iter().zip(&self.reached).zip(0..);
        let fitting = solids.filter(|((solid, _), _)| fits(solid));
        let best = fitting.max_by_key(|((_, reached), index)| (**reached, *index));
        best.map(|(_, index)| SolidId(index))
    }

    /// The solid that a statement made.
    fn made_by(&self, line: Span) -> Option<SolidId> {
        self.best(|solid| solid.span == line)
    }

    /// The leaf that a transform moved.
    fn moved_by(&self, line: Span) -> Option<SolidId> {
        let steps = &self.scene.steps;
        let step = steps.iter().position(|step| step.span == line)?;
        // Which steps come after this one on the same object: each names one before it.
        let mut after = vec![false; steps.len()];
        for (index, other) in steps.iter().enumerate().skip(step) {
            let follows = other.previous.and_then(|before| after.get(before.index()).copied());
            if let Some(place) = after.get_mut(index) {
                *place = index == step || follows == Some(true);
            }
        }
        self.best(|solid| match &solid.kind {
            SolidKind::Leaf(leaf) => {
                let last = leaf.steps.and_then(|last| after.get(last.index()).copied());
                last == Some(true)
            }
            _ => false,
        })
    }
}

#[cfg(test)]
mod tests {
    use scenec_scene::SETTINGS;

    use super::{object_at, statement_of};
    use crate::marked::marked;

    /// The statement that made the solid at the cursor, or nothing.
    fn check(text: &str, expect: &str) {
        let required = SETTINGS.iter().filter(|row| row.default.is_none());
        let settings: String = required
            .map(|row| format!("{} := {}\n", row.name, row.name.len()))
            .collect();
        let (document, offset) = marked(&format!("{text}\neyepos_x := 1\n{settings}eyepos_x := 2"));
        let solid = object_at(&document, offset);
        let made = solid.and_then(|solid| statement_of(&document, solid));
        assert_eq!(made.map_or("", |made| made.line.of(document.text())), expect, "{text}");
    }

    #[test]
    fn the_cursor_finds_the_solid_of_its_statement() {
        let rest = "\n!b := hp\n!u := a | b\n!u <=";
        check(&format!("!a := sphere\n!a +=$0 1 2 3{rest}"), "!a := sphere");
        check(&format!("$0!a := sphere{rest}"), "!a := sphere");
        check("!a := sphere\n!b := hp\n!u := a | $0b\n!u <=", "!b := hp");
        check("!a := sphere\n!b := hp\n!u $0:= a | b\n!u <=", "!u := a | b");
        check("!a := sphere\n!b := hp\n!u := a | b\n!$0u <=", "!u := a | b");
        check("!a := sphere\n!a <=\n$0*l := 1 2 3 4 5 6", "");
        check("!a := sphere\n!a <=\n$0oops", "");
    }
}
