//! One state of one document as a handler sees it: the features' byte offsets on one side, the client's lines and columns
//! on the other.

use std::cell::Cell;
use std::sync::Arc;

use scenec_ide::Document;
use scenec_text::{Edit, Span};
use tower_lsp::lsp_types::{
    DocumentChanges, Location, OneOf, OptionalVersionedTextDocumentIdentifier, Position, Range, TextDocumentEdit,
    TextEdit, Url, WorkspaceEdit,
};

use crate::abilities::Abilities;
use crate::convert::{self, Known};
use crate::options::{FileOptions, Options};
use crate::pages::Pages;
use crate::settings::Settings;

/// A document and what a handler needs beside it.
pub(crate) struct View {
    pub(crate) url: Url,
    pub(crate) document: Arc<Document>,
    /// The client's number for this state.
    pub(crate) version: i32,
    /// Our own number for it.
    pub(crate) revision: u64,
    pub(crate) abilities: Abilities,
    pub(crate) settings: Arc<Settings>,
    pub(crate) options: Arc<Options>,
    pub(crate) pages: Arc<Pages>,
    /// Where the last conversion ended: most places are asked for in order.
    pub(crate) known: Cell<Known>,
}

impl View {
    /// The client's name for an offset.
    pub(crate) fn position(&self, offset: u32) -> Position {
        let (position, known) = convert::position(&self.document, self.abilities.encoding, offset, self.known.get());
        self.known.set(known);
        position
    }

    /// The client's name for a span.
    pub(crate) fn range(&self, span: Span) -> Range {
        let start = self.position(span.start);
        Range::new(start, self.position(span.end))
    }

    /// How many columns a span takes that lies on one line.
    pub(crate) fn width(&self, span: Span) -> u32 {
        let encoding = self.abilities.encoding;
        span.of(self.document.text())
            .chars()
            .map(|one| encoding.width(one))
            .sum()
    }

    /// A span in this document.
    pub(crate) fn location(&self, span: Span) -> Location {
        Location::new(self.url.clone(), self.range(span))
    }

    /// The offset of the client's place.
    pub(crate) fn offset(&self, position: Position) -> u32 {
        convert::offset(&self.document, self.abilities.encoding, position)
    }

    /// The span of the client's range.
    pub(crate) fn span(&self, range: Range) -> Span {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        Span::new(start.min(end), end.max(start))
    }

    /// Edits as the client wants them.
    pub(crate) fn edits(&self, edits: &[Edit]) -> Vec<TextEdit> {
        let edit = |edit: &Edit| TextEdit::new(self.range(edit.span), edit.text.clone());
        edits.iter().map(edit).collect()
    }

    /// Edits of this very state of the document.
    pub(crate) fn workspace_edit(&self, edits: &[Edit]) -> WorkspaceEdit {
        let edits = self.edits(edits);
        if !self.abilities.versioned_edits {
            return WorkspaceEdit::new([(self.url.clone(), edits)].into());
        }
        let text_document = OptionalVersionedTextDocumentIdentifier::new(self.url.clone(), self.version);
        let edits = edits.into_iter().map(OneOf::Left).collect();
        let edit = TextDocumentEdit { text_document, edits };
        WorkspaceEdit {
            document_changes: Some(DocumentChanges::Edits(vec![edit])),
            ..WorkspaceEdit::default()
        }
    }

    /// What the configuration says of this file.
    pub(crate) fn file_options(&self) -> FileOptions {
        let path = self.url.to_file_path();
        path.map(|path| (self.options.file)(&path)).unwrap_or_default()
    }
}
