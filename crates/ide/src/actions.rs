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
        Code::MissingSettings => create::settings(document).into_iter().collect(),
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

#[cfg(test)]
mod tests {
    use scenec_text::apply;

    use super::{ActionKind, actions, fix_all};
    use crate::marked::marked;
    use crate::tests::document;

    /// The text after the action of this title; empty if there is none.
    fn check(text: &str, title: &str, expect: &str) {
        let (document, offset) = marked(text);
        let found = actions(&document, scenec_text::Span::at(offset));
        let action = found.iter().find(|action| action.title == title);
        let after = action.map_or_else(String::new, |action| apply(document.text(), &action.edits));
        assert_eq!(
            after,
            expect,
            "{text}: {:?}",
            found.iter().map(|action| &action.title).collect::<Vec<_>>()
        );
    }

    #[test]
    fn what_is_missing_is_created() {
        check(
            "!a := sphere\r\n!a ?= r$0ed\r\n",
            "create the material `?red`",
            "!a := sphere\r\n?red := 0.1 0.7 0.2 0 0 1 16 0.8 0.8 0.8\r\n!a ?= red\r\n",
        );
        check("!u := $0a | a", "create the object `!a`", "!a := sphere\n!u := a | a");
        check(
            "*l := 1 2 $0q 1 1 1",
            "create the variable `q`",
            "q := 1\n*l := 1 2 q 1 1 1",
        );
        check("*l := 1 2 $0width 1 1 1", "create the variable `width`", "");
    }

    #[test]
    fn transforms_go_to_the_base_objects_where_that_is_the_same() {
        let title = "transform the 2 base objects before they are combined instead";
        check(
            "!a := sphere\n!b := hp\n!u := a - b\n!u ?= m\n!u$0 += 1 2 3 / up\n!u <=",
            title,
            "!a := sphere\n!b := hp\n!a += 1 2 3\n!b += 1 2 3\n!u := a - b\n!u ?= m\n/ up\n!u <=",
        );
        check(
            "!a := sphere\n!u := a | a\n!b := hp\n!u := u | b\n!u #x=$0 1",
            title,
            "!a := sphere\n!a #x= 1\n!u := a | a\n!b := hp\n!b #x= 1\n!u := u | b",
        );
        check(
            "!a := sphere\n!b := hp\n!u := a | b\n!u +=$0 1 2 3\n!v := a | u",
            title,
            "",
        );
        check(
            "!a := sphere\n!b := hp\n!u := a | b\n!v := u | u\n!u +=$0 1 2 3",
            title,
            "",
        );
        check("!a := sphere\n!b := hp\n!u := a | b\nq := 1\n!u +=$0 q 2 3", title, "");
        check(
            "!a := sphere\n!b := hp\n!u := a | b\n!u #x= 1\n!u +=$0 1 2 3",
            title,
            "",
        );
    }

    #[test]
    fn late_statements_go_before_the_submission() {
        let title = "move the statement before the submission";
        check(
            "!a := sphere\n!a <=\n!a$0 += 1 2 3 / c",
            title,
            "!a := sphere\n!a += 1 2 3 / c\n!a <=",
        );
        check("!a := sphere\n!a <=\nq := 1\n!a$0 += 1 2 q", title, "");
        check("!a := sphere\n!u := a | a\n!u <=\n!u$0 += 1 2 3", title, "");
        check("!a := sphere\n!a <=\n!a$0 <=", title, "");
    }

    #[test]
    fn a_finding_can_be_allowed() {
        let here = "allow W009 on this line";
        check("a := 1\nq$0 := 1", here, "a := 1\nq := 1  / scenec: allow W009");
        check("q$0 := 1 / mine", here, "q := 1 / scenec: allow W009 mine");
        check("q$0 := 1 /mine", here, "q := 1 / scenec: allow W009 mine");
        check(
            "q$0 := 1 / scenec: allow W001, W002 why",
            here,
            "q := 1 / scenec: allow W001, W002, W009 why",
        );
        let file = "allow W009 in this file";
        check("\u{FEFF}q$0 := 1", file, "\u{FEFF}/ scenec: allow W009\nq := 1");
        check(
            "/ scenec: allow W001\nq$0 := 1",
            file,
            "/ scenec: allow W001, W009\nq := 1",
        );
        check("!a$0 := 1", "allow E005 on this line", "");
    }

    #[test]
    fn words_that_may_have_been_meant_are_written() {
        check("!a := $0shpere", "write `sphere`", "!a := sphere");
        check("widht$0 := 1", "write `width`", "width := 1");
        check(
            "a := 1\nb := a  / scenec: allow W09$0",
            "write `W009`",
            "a := 1\nb := a  / scenec: allow W009",
        );
    }

    #[test]
    fn missing_settings_come_behind_the_others() {
        let (document, offset) = marked("/ c\nwidth := 5\n!a := sphere\n!a <=$0");
        let found = actions(&document, scenec_text::Span::at(offset));
        let action = found
            .iter()
            .find(|action| action.title == "add the 14 missing settings")
            .unwrap();
        let after = apply(document.text(), &action.edits);
        assert!(
            after.starts_with("/ c\nwidth := 5\nheight := 400\nlookat_x := 0\n"),
            "{after}"
        );
        assert!(crate::tests::document(&after).scene().is_some(), "{after}");
    }

    #[test]
    fn all_safe_repairs_are_one_change() {
        let text = "a := 1\r\na := 2\r\nq := 3\r\n!s := sphere\r\n!s += a 0 0\r\n!s <=\r\n!s <=\r\n";
        let document = document(text);
        let found = actions(&document, scenec_text::Span::at(0));
        assert!(
            found
                .iter()
                .any(|action| action.kind == ActionKind::FixAll && action.edits.is_empty())
        );
        assert_eq!(
            apply(text, &fix_all(&document)),
            "a := 2\r\n!s := sphere\r\n!s += a 0 0\r\n!s <=\r\n"
        );
    }
}
