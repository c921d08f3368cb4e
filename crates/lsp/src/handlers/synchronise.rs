//! Opening, editing and closing. Nothing here waits: edits are taken over before the next message is read.

use std::panic::{AssertUnwindSafe, catch_unwind};

use tower_lsp::lsp_types::{DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, Url};

use crate::server::Server;

/// A document was opened, or opened again.
pub(crate) fn open(server: &Server, params: DidOpenTextDocumentParams) {
    let document = params.text_document;
    contained(server, || {
        server
            .documents
            .open(document.uri.clone(), document.version, &document.text);
    });
    edited(server, document.uri);
}

/// A document was edited.
pub(crate) fn change(server: &Server, params: &DidChangeTextDocumentParams) {
    let document = &params.text_document;
    let encoding = server.abilities().encoding;
    contained(server, || {
        let changes = &params.content_changes;
        if !server
            .documents
            .change(&document.uri, document.version, changes, encoding)
        {
            server
                .log
                .say(format_args!("an edit of {}, which is not open", document.uri));
        }
    });
    edited(server, document.uri.clone());
}

/// A document was closed.
pub(crate) fn close(server: &Server, params: DidCloseTextDocumentParams) {
    let url = params.text_document.uri;
    if server.documents.close(&url) {
        edited(server, url);
    }
}

fn edited(server: &Server, url: Url) {
    if !server.abilities().pulls {
        server.publisher.ask(url);
    }
}

/// A notification has no answer that could tell of a panic, and must not end the server.
fn contained(server: &Server, work: impl FnOnce()) {
    if catch_unwind(AssertUnwindSafe(work)).is_err() {
        server.log.say("a notification failed");
    }
}
