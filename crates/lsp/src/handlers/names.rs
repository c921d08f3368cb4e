//! Where a name stands, where it was made, and giving it another.

use scenec_ide::RenameError;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::lsp_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, GotoDefinitionParams, GotoDefinitionResponse,
    Location, LocationLink, PrepareRenameResponse, ReferenceParams, RenameParams, TextDocumentPositionParams,
    WorkspaceEdit,
};

use crate::server::{Server, refused};

/// # Errors
/// As [`Server::at`].
pub(crate) async fn highlights(
    server: &Server,
    params: DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>> {
    let at = server.at(params.text_document_position_params, |view, offset| {
        let found = scenec_ide::highlights(&view.document, offset).into_iter();
        let found = found.map(|place| DocumentHighlight {
            range: view.range(place.span),
            kind: Some(if place.write {
                DocumentHighlightKind::WRITE
            } else {
                DocumentHighlightKind::READ
            }),
        });
        Some(found.collect())
    });
    at.await
}

/// # Errors
/// As [`Server::at`].
pub(crate) async fn definition(
    server: &Server,
    params: GotoDefinitionParams,
) -> Result<Option<GotoDefinitionResponse>> {
    let at = server.at(params.text_document_position_params, |view, offset| {
        let found = scenec_ide::definition(&view.document, offset)?;
        if !view.abilities.links {
            return Some(view.location(found.name).into());
        }
        let link = LocationLink {
            origin_selection_range: Some(view.range(found.origin)),
            target_uri: view.url.clone(),
            target_range: view.range(found.line),
            target_selection_range: view.range(found.name),
        };
        Some(vec![link].into())
    });
    at.await
}

/// # Errors
/// As [`Server::at`].
pub(crate) async fn references(server: &Server, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
    let declarations = params.context.include_declaration;
    let at = server.at(params.text_document_position, move |view, offset| {
        let found = scenec_ide::references(&view.document, offset, declarations).into_iter();
        Some(found.map(|span| view.location(span)).collect())
    });
    at.await
}

/// # Errors
/// As [`Server::at`], and why the name can't be changed.
pub(crate) async fn prepare_rename(
    server: &Server,
    params: TextDocumentPositionParams,
) -> Result<Option<PrepareRenameResponse>> {
    let at = server.at(params, |view, offset| {
        let found = scenec_ide::prepare_rename(&view.document, offset);
        Some(found.map(|name| PrepareRenameResponse::RangeWithPlaceholder {
            range: view.range(name.span),
            placeholder: name.placeholder,
        }))
    });
    at.await?.transpose().map_err(why)
}

/// # Errors
/// As [`Server::at`], and why the name can't be changed, or not to this.
pub(crate) async fn rename(server: &Server, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
    let name = params.new_name;
    let at = server.at(params.text_document_position, move |view, offset| {
        let found = scenec_ide::rename(&view.document, offset, &name);
        Some(found.map(|edits| view.workspace_edit(&edits)))
    });
    at.await?.transpose().map_err(why)
}

fn why(error: RenameError) -> Error {
    refused(&error)
}
