//! What can be done about a place: repairs of what was found there, and changes that keep the file's meaning.

mod allow;
mod create;
mod fix_all;
mod spelling;
mod submission;
mod transform;

use scenec_text::{Code, Diagnostic, Edit, Span};

use crate::Document;

pub use fix_all::fix_all;

/// What sort of change it is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ActionKind {
    /// It makes a finding go away.
    QuickFix,
    /// It says the same in another way.
    Refactor,
    /// All safe repairs of the file at once. Its edits are left empty, since they take several goes over the text:
    /// [`fix_all`] gives them.
    FixAll,
}

/// A change to offer.
#[derive(Clone, PartialEq, Debug)]
pub struct Action {
    /// What it does, as a command.
    pub title: String,
    /// What sort of change it is.
    pub kind: ActionKind,
    /// The edits; they don't overlap, and come in the order of the text.
    pub edits: Vec<Edit>,
    /// The findings that it makes go away, as indices into [`Document::diagnostics`].
    pub fixes: Vec<usize>,
    /// Whether it is certain to be wanted.
    pub preferred: bool,
}

/// What a finding calls for: a title and edits, in any order.
type Offer = (String, Vec<Edit>);

/// Everything that can be done about the findings that touch `span`.
#[must_use]
pub fn actions(document: &Document, span: Span) -> Vec<Action> {
    let numbered = document.diagnostics().iter().enumerate();
    let touched: Vec<(usize, &Diagnostic)> = numbered.filter(|(_, finding)| touches(finding.span(), span)).collect();
    let mut actions = Vec::new();
    for (index, finding) in &touched {
        let fix = finding.fix.iter();
        actions.extend(fix.map(|fix| quick_fix(*index, (fix.title.clone(), fix.edits.clone()), fix.safe)));
        let offers = offers(document, finding);
        actions.extend(offers.into_iter().map(|offer| quick_fix(*index, offer, false)));
    }
    if touched.iter().any(|(_, finding)| is_safe(finding)) {
        let all = document.diagnostics().iter().enumerate();
        actions.push(Action {
            title: "make all safe repairs".to_owned(),
            kind: ActionKind::FixAll,
            edits: Vec::new(),
            fixes: all
                .filter(|(_, finding)| is_safe(finding))
                .map(|(index, _)| index)
                .collect(),
            preferred: false,
        });
    }
    for (index, finding) in &touched {
        let offers = allow::offers(document, finding);
        actions.extend(offers.into_iter().map(|offer| quick_fix(*index, offer, false)));
    }
    actions
}

/// What there is to do about a finding beyond its own repair.
fn offers(document: &Document, finding: &Diagnostic) -> Vec<Offer> {
    match finding.code {
        Code::MissingSettings => create::settings(document, finding).into_iter().collect(),
        Code::UnknownObject | Code::UnknownMaterial | Code::UnknownVariable => {
            create::named(document, finding).into_iter().collect()
        }
        Code::TransformedCombination => transform::to_the_base_objects(document, finding).into_iter().collect(),
        Code::AfterSubmission => submission::before(document, finding).into_iter().collect(),
        Code::UnknownBase | Code::UselessAllow => spelling::offer(document, finding).into_iter().collect(),
        _ => Vec::new(),
    }
}

fn quick_fix(index: usize, (title, mut edits): Offer, preferred: bool) -> Action {
    edits.sort_by_key(|edit| edit.span);
    Action {
        title,
        kind: ActionKind::QuickFix,
        edits,
        fixes: vec![index],
        preferred,
    }
}

fn is_safe(finding: &Diagnostic) -> bool {
    finding.fix.as_ref().is_some_and(|fix| fix.safe)
}

const fn touches(one: Span, other: Span) -> bool {
    one.start <= other.end && other.start <= one.end
}
