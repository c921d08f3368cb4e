//! What a document makes, as a tree or a list, and what all make that are open or lie in the client's folders.

use std::sync::Arc;

use scenec_ide::{FoundSymbol, OutlineItem, OutlineKind};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, SymbolInformation, SymbolKind, WorkspaceSymbolParams,
};

use crate::server::{Server, aside};
use crate::view::View;

/// The most that are sent of files that are not open.
const MOST: usize = 1000;

/// # Errors
/// As [`Server::on`].
pub(crate) async fn outline(server: &Server, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
    let on = server.on(&params.text_document.uri, |view| {
        let items = scenec_ide::outline(&view.document);
        if view.abilities.hierarchy {
            return DocumentSymbolResponse::Nested(items.into_iter().map(|item| nested(view, item)).collect());
        }
        let mut list = Vec::new();
        for item in &items {
            flatten(view, item, None, &mut list);
        }
        DocumentSymbolResponse::Flat(list)
    });
    on.await
}

/// # Errors
/// As [`Server::on`].
pub(crate) async fn everywhere(
    server: &Server,
    params: WorkspaceSymbolParams,
) -> Result<Option<Vec<SymbolInformation>>> {
    let mut all = Vec::new();
    let open = server.documents.urls();
    for url in &open {
        let query = params.query.clone();
        let found = server.on(url, move |view| matching(view, &query)).await?;
        all.extend(found.unwrap_or_default());
    }
    let asked = server.clone();
    let in_folders = aside(move || {
        let closed = asked.folders.closed(&asked.options, &open).into_iter();
        let views = closed.map(|(url, document)| asked.view_of(url, Arc::new(document)));
        let found = views.flat_map(|view| matching(&view, &params.query));
        found.take(MOST).collect::<Vec<_>>()
    });
    all.extend(in_folders.await?);
    Ok(Some(all))
}

fn matching(view: &View, query: &str) -> Vec<SymbolInformation> {
    let found = scenec_ide::symbols(&view.document, query).into_iter();
    found.map(|symbol| everywhere_one(view, symbol)).collect()
}

/// The tree is a few levels deep at most, whatever the scene.
#[allow(deprecated, reason = "a field that can't be left out")]
fn nested(view: &View, item: OutlineItem) -> DocumentSymbol {
    let range = view.range(item.line);
    let selection_range = view.range(item.name_span);
    let children: Vec<DocumentSymbol> = item.children.into_iter().map(|child| nested(view, child)).collect();
    DocumentSymbol {
        name: item.name,
        detail: Some(item.detail).filter(|detail| !detail.is_empty()),
        kind: kind(item.kind),
        tags: None,
        deprecated: None,
        range,
        selection_range,
        children: (!children.is_empty()).then_some(children),
    }
}

fn flatten(view: &View, item: &OutlineItem, container: Option<&str>, list: &mut Vec<SymbolInformation>) {
    list.push(symbol(view, &item.name, kind(item.kind), item.line, container));
    for child in &item.children {
        flatten(view, child, Some(&item.name), list);
    }
}

fn everywhere_one(view: &View, found: FoundSymbol) -> SymbolInformation {
    let kind = match found.name.chars().next() {
        Some('!') => SymbolKind::OBJECT,
        Some('?') => kind(OutlineKind::Material),
        Some('*') => kind(OutlineKind::Light),
        _ if found.setting => kind(OutlineKind::Setting),
        _ => kind(OutlineKind::Variable),
    };
    symbol(view, &found.name, kind, found.name_span, None)
}

#[allow(deprecated, reason = "a field that can't be left out")]
fn symbol(
    view: &View,
    name: &str,
    kind: SymbolKind,
    span: scenec_text::Span,
    container: Option<&str>,
) -> SymbolInformation {
    SymbolInformation {
        name: name.to_owned(),
        kind,
        tags: None,
        deprecated: None,
        location: view.location(span),
        container_name: container.map(str::to_owned),
    }
}

const fn kind(kind: OutlineKind) -> SymbolKind {
    match kind {
        OutlineKind::Base => SymbolKind::OBJECT,
        OutlineKind::Combination => SymbolKind::CLASS,
        OutlineKind::Material => SymbolKind::ENUM_MEMBER,
        OutlineKind::Light => SymbolKind::EVENT,
        OutlineKind::Setting => SymbolKind::PROPERTY,
        OutlineKind::Variable => SymbolKind::VARIABLE,
        OutlineKind::More => SymbolKind::NULL,
    }
}
