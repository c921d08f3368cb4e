//! What can be folded away, and what grows around the cursor.

use scenec_ide::FoldKind;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{FoldingRange, FoldingRangeKind, FoldingRangeParams, SelectionRange, SelectionRangeParams};

use crate::server::Server;
use crate::view::View;

/// # Errors
/// As [`Server::on`].
pub(crate) async fn folds(server: &Server, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
    let on = server.on(&params.text_document.uri, |view| {
        let found = scenec_ide::folds(&view.document).into_iter();
        let found = found.map(|fold| FoldingRange {
            start_line: fold.first_line,
            end_line: fold.last_line,
            kind: Some(match fold.kind {
                FoldKind::Comment => FoldingRangeKind::Comment,
                FoldKind::Statements => FoldingRangeKind::Region,
            }),
            ..FoldingRange::default()
        });
        found.collect()
    });
    on.await
}

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn selections(server: &Server, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
    let on = server.on_exactly(&params.text_document.uri, move |view| {
        let places = params.positions.into_iter();
        places.map(|place| selection(view, view.offset(place))).collect()
    });
    on.await
}

fn selection(view: &View, offset: u32) -> SelectionRange {
    let spans = scenec_ide::selections(&view.document, offset);
    let outside_in = spans.into_iter().rev().fold(None, |parent, span| {
        let range = view.range(span);
        let parent: Option<SelectionRange> = parent;
        Some(SelectionRange {
            range,
            parent: parent.map(Box::new),
        })
    });
    outside_in.unwrap_or_else(|| {
        let place = view.position(offset);
        SelectionRange {
            range: tower_lsp::lsp_types::Range::new(place, place),
            parent: None,
        }
    })
}
