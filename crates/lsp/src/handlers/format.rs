//! The canonical style: of a document, of some of its lines, of the one that was just finished.

use scenec_ide::FormatStyle;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    DocumentFormattingParams, DocumentOnTypeFormattingParams, DocumentRangeFormattingParams, TextEdit,
};

use crate::server::{Server, refused};
use crate::view::View;

/// # Errors
/// As [`Server::on_exactly`], and where a line stands in the way.
pub(crate) async fn document(server: &Server, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
    let on = server.on_exactly(&params.text_document.uri, |view| {
        let edits = scenec_ide::format(&view.document, style(view));
        let edits = edits.map_err(|why| view.position(why.span.start).line + 1);
        edits.map(|edits| view.edits(&edits))
    });
    on.await?
        .transpose()
        .map_err(|line| refused(&format!("line {line} fits no statement, so nothing is formatted")))
}

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn lines(server: &Server, params: DocumentRangeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
    let range = params.range;
    // A selection of whole lines ends before the first letter of the next one.
    let behind = u32::from(range.end.character == 0 && range.end.line > range.start.line);
    let on = server.on_exactly(&params.text_document.uri, move |view| {
        let edits = scenec_ide::format_lines(&view.document, range.start.line, range.end.line - behind, style(view));
        view.edits(&edits)
    });
    on.await
}

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn finished_line(
    server: &Server,
    params: DocumentOnTypeFormattingParams,
) -> Result<Option<Vec<TextEdit>>> {
    let place = params.text_document_position;
    // The cursor stands on the line after the one that was finished.
    let Some(line) = place.position.line.checked_sub(1) else {
        return Ok(None);
    };
    let on = server.on_exactly(&place.text_document.uri, move |view| {
        let edits = scenec_ide::format_line(&view.document, line, style(view));
        view.edits(&edits)
    });
    on.await
}

/// The editor's setting counts, then the file's configuration.
fn style(view: &View) -> FormatStyle {
    FormatStyle {
        align: view.settings.align.unwrap_or_else(|| view.file_options().align),
    }
}
