//! `scene/panic`: a handler that panics, to see in the real process what that costs. Only programs that are built with
//! debug assertions know it; a released one answers that there is no such method.

use serde::Deserialize;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::TextDocumentIdentifier;

use crate::server::Server;

/// Where to panic.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Params {
    /// In the work on this document; in the handler itself if absent.
    text_document: Option<TextDocumentIdentifier>,
}

#[expect(clippy::panic, reason = "that is what it is for")]
fn panic() -> Option<()> {
    panic!("as was asked for")
}

impl Server {
    /// Panics, at once or on the thread that works on a document.
    pub(crate) async fn scene_panic(&self, params: Params) -> Result<Option<()>> {
        match params.text_document {
            Some(document) => Ok(self.on(&document.uri, |_| panic()).await?.flatten()),
            None => Ok(panic()),
        }
    }

    /// Panics where nobody waits for an answer.
    pub(crate) async fn scene_panic_unasked(&self) {
        panic();
    }
}
