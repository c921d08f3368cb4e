//! Words between the values.

use scenec_ide::InlayKind;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, InlayHintTooltip};

use crate::markup::markup;
use crate::server::Server;
use crate::settings::Hints;
use crate::view::View;

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn hints(server: &Server, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
    let on = server.on_exactly(&params.text_document.uri, move |view| {
        let found = scenec_ide::inlay_hints(&view.document, view.span(params.range));
        let shown = found.into_iter().filter(|hint| wanted(view.settings.hints, hint.kind));
        shown.map(|one| hint(view, one)).collect()
    });
    on.await
}

const fn wanted(hints: Hints, kind: InlayKind) -> bool {
    match kind {
        InlayKind::Parameter => hints.fields,
        InlayKind::Angle => hints.angles,
        InlayKind::Position => hints.positions,
    }
}

fn hint(view: &View, found: scenec_ide::InlayHint) -> InlayHint {
    let before = found.kind == InlayKind::Parameter;
    // Tooltips have no ability of their own; a client that shows Markdown shows it everywhere.
    let tooltip = markup(&found.tooltip, view.abilities.markdown_hover);
    InlayHint {
        position: view.position(found.offset),
        label: InlayHintLabel::String(found.label),
        kind: before.then_some(InlayHintKind::PARAMETER),
        text_edits: None,
        tooltip: (!found.tooltip.is_empty()).then_some(InlayHintTooltip::MarkupContent(tooltip)),
        padding_left: Some(!before),
        padding_right: Some(before),
        data: None,
    }
}
