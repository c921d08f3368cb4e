//! Findings for clients that don't ask for them: one task sends them all, so that none overtakes a newer one.

use std::collections::BTreeSet;
use std::sync::Mutex;

use tokio::sync::Notify;
use tower_lsp::lsp_types::Url;

use crate::documents::lock;
use crate::handlers::diagnostics::findings;
use crate::server::Server;

/// The documents whose findings have to be sent anew.
#[derive(Default)]
pub(crate) struct Publisher {
    due: Mutex<BTreeSet<Url>>,
    wake: Notify,
}

impl Publisher {
    /// Asks for a document's findings; however often before they are sent, they are sent once.
    pub(crate) fn ask(&self, url: Url) {
        lock(&self.due).insert(url);
        self.wake.notify_one();
    }

    /// Sends what is due, for ever.
    pub(crate) async fn run(server: Server) {
        loop {
            server.publisher.wake.notified().await;
            let due = std::mem::take(&mut *lock(&server.publisher.due));
            for url in due {
                publish(&server, url).await;
            }
        }
    }
}

async fn publish(server: &Server, url: Url) {
    let Some(open) = server.documents.get(&url) else {
        // What was sent for a document stays until it is taken back.
        server.client.publish_diagnostics(url, Vec::new(), None).await;
        return;
    };
    let found = server.on(&url, |view| (findings(view), view.version)).await;
    let Ok(Some(((findings, problem), version))) = found else {
        return;
    };
    server.tell_once(problem);
    let newest = server
        .documents
        .get(&url)
        .is_some_and(|now| std::sync::Arc::ptr_eq(&now, &open));
    if newest {
        server.client.publish_diagnostics(url, findings, Some(version)).await;
    }
}
