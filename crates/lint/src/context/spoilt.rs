//! What the errors of a file may have to do with, so that one cause gets one report.

use std::collections::HashSet;

use scenec_interpret::DefinitionId;
use scenec_scene::Base;
use scenec_syntax::{Content, Form, Space, Statement};
use scenec_text::Span;

use super::Context;

/// What can't be relied upon in a file with errors.
pub(super) struct Spoilt<'a> {
    /// The names on lines that fit no statement.
    words: HashSet<&'a str>,
    /// Whether such a line may have used an object or a material without its name being there.
    objects: bool,
    materials: bool,
    /// The base object of each transform, if no error can have changed what came before.
    moved: Vec<Option<Base>>,
}

impl<'a> Spoilt<'a> {
    /// One pass over the lines and one over the statements.
    pub(super) fn of(context: &Context<'a>) -> Self {
        let holes = !context.source.holes().is_empty();
        let mut spoilt = Self {
            words: HashSet::new(),
            objects: holes,
            materials: holes,
            moved: Vec::new(),
        };
        let text = context.text();
        for line in context.lines() {
            match &line.content {
                Content::Broken(broken) => {
                    let names = broken.mentions.iter().chain(&broken.name);
                    spoilt.words.extend(names.map(|name| name.of(text)));
                    spoilt.objects |= matches!(
                        broken.form,
                        None | Some(Form::Object | Form::Combination | Form::Submit)
                    );
                    spoilt.materials |= matches!(broken.form, None | Some(Form::MaterialSet));
                }
                // A base object that there is not may have been meant for one to be copied.
                Content::Statement(Statement::Object { base, .. }) => {
                    let word = base.of(text);
                    if Base::ALL.iter().all(|(_, known)| *known != word) {
                        spoilt.words.insert(word);
                    }
                }
                Content::Statement(_) | Content::Comment => {}
            }
        }
        spoilt.objects |= !submits(context);
        spoilt.moved = if holes { Vec::new() } else { spoilt.bases(context) };
        spoilt
    }

    pub(super) fn may_use(&self, space: Space, name: &str) -> bool {
        let whole = match space {
            Space::Object => self.objects,
            Space::Material => self.materials,
            Space::Variable | Space::Light => true,
        };
        whole || self.words.contains(name)
    }

    pub(super) fn moved(&self, step: usize) -> Option<Base> {
        self.moved.get(step).copied().flatten()
    }

    /// The base objects of the transforms, which come in the order of their statements. A transform that came to nothing
    /// may have been a mistake, and what it was to be changes those after it.
    fn bases(&self, context: &Context<'a>) -> Vec<Option<Base>> {
        let steps = context.steps();
        let mut written = steps.iter().map(|step| step.span).peekable();
        let mut unsure: HashSet<DefinitionId> = HashSet::new();
        let mut moved = Vec::with_capacity(steps.len());
        for (span, statement) in context.statements() {
            let (Statement::Scale { name, .. } | Statement::Rotate { name, .. } | Statement::Translate { name, .. }) =
                statement
            else {
                continue;
            };
            let object = context.places_on(span).next().and_then(|place| place.definition);
            if written.next_if_eq(&span).is_none() {
                unsure.extend(object);
                continue;
            }
            let sure = |id: &DefinitionId| !unsure.contains(id) && !self.words.contains(name.of(context.text()));
            moved.push(object.filter(sure).and_then(|id| base(context, id)));
        }
        moved
    }
}

/// Whether the file submits an object that there is.
fn submits(context: &Context<'_>) -> bool {
    let submits = |(span, statement): (Span, Statement)| {
        let object = || context.places_on(span).next().and_then(|place| place.definition);
        matches!(statement, Statement::Submit { .. }) && object().is_some()
    };
    context.statements().any(submits)
}

fn base(context: &Context<'_>, object: DefinitionId) -> Option<Base> {
    let made = context.statement_at(context.definition(object)?.line)?;
    let Statement::Object { base, .. } = made else {
        return None;
    };
    let word = base.of(context.text());
    Base::ALL
        .iter()
        .find(|(_, known)| *known == word)
        .map(|(base, _)| *base)
}
