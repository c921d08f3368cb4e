//! What can be done about findings: repairs one by one, and all the safe ones at once.

use scenec_ide::{Action, ActionKind};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, Diagnostic};

use crate::handlers::diagnostics::finding;
use crate::options::FileOptions;
use crate::server::Server;
use crate::view::View;

/// The kind under which an editor asks for all safe repairs, such as before it saves.
const FIX_ALL: CodeActionKind = CodeActionKind::new("source.fixAll.scenec");

/// The kinds of actions that there are.
pub(crate) fn kinds() -> Vec<CodeActionKind> {
    vec![CodeActionKind::QUICKFIX, CodeActionKind::REFACTOR, FIX_ALL]
}

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn actions(server: &Server, params: CodeActionParams) -> Result<Option<Vec<CodeActionOrCommand>>> {
    let on = server.on_exactly(&params.text_document.uri, move |view| {
        // Without this the protocol has commands only, and there are none here.
        if !view.abilities.actions {
            return Vec::new();
        }
        let only = params.context.only;
        let file = view.file_options();
        let span = view.span(params.range);
        let mut found: Vec<CodeAction> = scenec_ide::actions(&view.document, span)
            .into_iter()
            .filter_map(|action| one(view, &file, action))
            .filter(|action| only.as_ref().is_none_or(|only| asked(only, action.kind.as_ref())))
            .collect();
        // Only who asks for it gets it under this kind: it changes the whole file, wherever the cursor is.
        if only.is_some_and(|only| asked(&only, Some(&FIX_ALL))) {
            found.extend(all(view));
        }
        found.into_iter().map(CodeActionOrCommand::CodeAction).collect()
    });
    on.await
}

/// Whether a kind, or one that it is part of, is among those that were asked for.
fn asked(only: &[CodeActionKind], kind: Option<&CodeActionKind>) -> bool {
    let part = |kind: &CodeActionKind, whole: &CodeActionKind| {
        let rest = kind.as_str().strip_prefix(whole.as_str());
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.') || whole.as_str().is_empty())
    };
    kind.is_some_and(|kind| only.iter().any(|whole| part(kind, whole)))
}

/// An action as the client wants it; `None` if it is about findings that are not shown.
fn one(view: &View, file: &FileOptions, action: Action) -> Option<CodeAction> {
    let found = action
        .fixes
        .iter()
        .filter_map(|index| view.document.diagnostics().get(*index));
    let shown: Vec<Diagnostic> = found
        .filter_map(|found| Some(finding(view, found, (file.level)(found.code)?)))
        .collect();
    if shown.is_empty() && !action.fixes.is_empty() {
        return None;
    }
    let edits = match action.kind {
        ActionKind::FixAll => scenec_ide::fix_all(&view.document),
        ActionKind::QuickFix | ActionKind::Refactor => action.edits,
    };
    Some(CodeAction {
        title: action.title,
        kind: Some(match action.kind {
            ActionKind::Refactor => CodeActionKind::REFACTOR,
            ActionKind::QuickFix | ActionKind::FixAll => CodeActionKind::QUICKFIX,
        }),
        diagnostics: Some(shown).filter(|shown| !shown.is_empty()),
        edit: Some(view.workspace_edit(&edits)),
        is_preferred: action.preferred.then_some(true),
        ..CodeAction::default()
    })
}

fn all(view: &View) -> Option<CodeAction> {
    let edits = scenec_ide::fix_all(&view.document);
    (!edits.is_empty()).then(|| CodeAction {
        title: "make all safe repairs".to_owned(),
        kind: Some(FIX_ALL),
        edit: Some(view.workspace_edit(&edits)),
        ..CodeAction::default()
    })
}

#[cfg(test)]
mod tests {
    use tower_lsp::lsp_types::CodeActionKind;

    use super::{FIX_ALL, asked};

    fn check(only: &[&'static str], kind: &CodeActionKind, expect: bool) {
        let kinds: Vec<_> = only.iter().map(|kind| CodeActionKind::new(kind)).collect();
        assert_eq!(asked(&kinds, Some(kind)), expect, "{only:?} {kind:?}");
    }

    #[test]
    fn a_kind_holds_its_parts() {
        check(&["source.fixAll"], &FIX_ALL, true);
        check(&["source"], &FIX_ALL, true);
        check(&["source.fixAll.scenec"], &FIX_ALL, true);
        check(&["source.fixAll.scene"], &FIX_ALL, false);
        check(&["source.organizeImports", "quickfix"], &FIX_ALL, false);
        check(&[""], &FIX_ALL, true);
        check(&[], &FIX_ALL, false);
        check(&["quickfix"], &CodeActionKind::QUICKFIX, true);
        check(&["refactor.extract"], &CodeActionKind::REFACTOR, false);
    }
}
