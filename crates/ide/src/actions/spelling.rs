//! The word that may have been meant, where the finding itself has no repair.

use scenec_scene::Base;
use scenec_text::{Code, Diagnostic, Edit, Severity, closest};

use super::Offer;
use crate::Document;

/// To write the nearest base object, or the nearest code that can be allowed.
pub(super) fn offer(document: &Document, finding: &Diagnostic) -> Option<Offer> {
    if finding.fix.is_some() {
        return None;
    }
    let word = finding.span().of(document.text());
    let near = match finding.code {
        Code::UnknownBase => closest(word, Base::ALL.iter().map(|(_, word)| *word)),
        Code::UselessAllow => {
            let known = Code::ALL.iter().filter(|code| code.severity() != Severity::Error);
            closest(word, known.map(|code| code.id()))
        }
        _ => None,
    }?;
    let edit = Edit {
        span: finding.span(),
        text: near.to_owned(),
    };
    Some((format!("write `{near}`"), vec![edit]))
}
