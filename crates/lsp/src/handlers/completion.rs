//! What may be written here.

use std::borrow::Cow;

use scenec_ide::{Completion, CompletionKind};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    CompletionItem, CompletionItemKind, CompletionParams, CompletionResponse, CompletionTextEdit, InsertTextFormat,
    TextEdit,
};

use crate::markup::documentation;
use crate::server::Server;
use crate::view::View;

/// # Errors
/// As [`Server::at`].
pub(crate) async fn completion(server: &Server, params: CompletionParams) -> Result<Option<CompletionResponse>> {
    let at = server.at(params.text_document_position, |view, offset| {
        let found = scenec_ide::completions(&view.document, offset);
        let items = found.into_iter().map(|one| item(view, one)).collect();
        Some(CompletionResponse::Array(items))
    });
    at.await
}

fn item(view: &View, found: Completion) -> CompletionItem {
    let abilities = view.abilities;
    let snippet = found.snippet && abilities.snippets;
    let text = match found.snippet && !snippet {
        true => flat(&found.insert).into_owned(),
        false => found.insert,
    };
    CompletionItem {
        kind: Some(kind(found.kind)),
        detail: Some(found.detail).filter(|detail| !detail.is_empty()),
        documentation: documentation(&found.documentation, abilities.markdown_completion),
        sort_text: Some(format!("{:06}", found.order)),
        insert_text_format: snippet.then_some(InsertTextFormat::SNIPPET),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(view.range(found.replace), text))),
        filter_text: (found.filter != found.label).then_some(found.filter),
        label: found.label,
        ..CompletionItem::default()
    }
}

const fn kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Statement => CompletionItemKind::SNIPPET,
        CompletionKind::Operator => CompletionItemKind::OPERATOR,
        CompletionKind::Base => CompletionItemKind::CLASS,
        CompletionKind::Object => CompletionItemKind::STRUCT,
        CompletionKind::Material => CompletionItemKind::COLOR,
        CompletionKind::Light => CompletionItemKind::EVENT,
        CompletionKind::Variable => CompletionItemKind::VARIABLE,
        CompletionKind::Setting => CompletionItemKind::PROPERTY,
        CompletionKind::Constant => CompletionItemKind::CONSTANT,
    }
}

/// A snippet as plain text: every place to fill in holds what it proposes.
fn flat(snippet: &str) -> Cow<'_, str> {
    if !snippet.contains(['$', '\\']) {
        return Cow::Borrowed(snippet);
    }
    let mut text = String::new();
    let mut rest = snippet.chars().peekable();
    while let Some(one) = rest.next() {
        match one {
            '\\' => text.extend(rest.next()),
            '$' if rest.next_if_eq(&'{').is_some() => {
                // The number of the place, up to what is proposed for it; the closing brace is passed over below.
                while rest.next_if(char::is_ascii_digit).is_some() {}
                rest.next_if_eq(&':');
            }
            '$' => while rest.next_if(char::is_ascii_digit).is_some() {},
            '}' => {}
            _ => text.push(one),
        }
    }
    Cow::Owned(text)
}

#[cfg(test)]
mod tests {
    use super::flat;

    #[test]
    fn a_snippet_becomes_what_it_proposes() {
        assert_eq!(flat("plain"), "plain");
        assert_eq!(flat("!${1:name} := ${2:sphere}$0"), "!name := sphere");
        assert_eq!(flat("a\\$b \\} ${3}c$1 $12d"), "a$b } c d");
    }
}
