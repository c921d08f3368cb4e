//! Findings for clients that don't ask for them: one task sends them all, so that none overtakes a newer one.

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};

use tokio::sync::Notify;
use tower_lsp::lsp_types::{Diagnostic, Url};

use crate::documents::{Open, lock};
use crate::handlers::diagnostics::{findings, findings_at_once};
use crate::server::Server;
use crate::view::View;

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

/// Sends the findings of a document: of a large one those that are known at once, and then, unless it is edited meanwhile, all of
/// them, if they are others.
async fn publish(server: &Server, url: Url) {
    let Some(open) = server.documents.get(&url) else {
        // What was sent for a document stays until it is taken back.
        server.client.publish_diagnostics(url, Vec::new(), None).await;
        return;
    };
    let mut edits = open.edits();
    let sent = match server.on(&url, known_at_once).await {
        Ok(Some(Some(known))) => Some(known),
        Ok(Some(None)) => None,
        Ok(None) | Err(_) => return,
    };
    if let Some(known) = &sent {
        send(server, &url, &open, known).await;
    }
    let all = server.on(&url, |view| Known::new(view, findings(view)));
    let all = tokio::select! {
        all = all => all,
        // Somebody has asked for the findings of the edited text.
        _ = edits.changed(), if sent.is_some() => return,
    };
    if let Ok(Some(all)) = all
        && sent.as_ref() != Some(&all)
    {
        send(server, &url, &open, &all).await;
    }
}

/// What is known of one state of a document.
#[derive(PartialEq)]
struct Known {
    version: i32,
    findings: Vec<Diagnostic>,
    /// What is wrong with the configuration.
    problem: Option<String>,
}

impl Known {
    fn new(view: &View, (findings, problem): (Vec<Diagnostic>, Option<String>)) -> Self {
        let version = view.version;
        Self {
            version,
            findings,
            problem,
        }
    }
}

fn known_at_once(view: &View) -> Option<Known> {
    findings_at_once(view).map(|found| Known::new(view, found))
}

/// Sends findings, unless the document was closed or opened anew meanwhile.
async fn send(server: &Server, url: &Url, open: &Arc<Open>, known: &Known) {
    server.tell_once(known.problem.clone());
    let newest = server.documents.get(url).is_some_and(|now| Arc::ptr_eq(&now, open));
    if newest {
        let findings = known.findings.clone();
        server
            .client
            .publish_diagnostics(url.clone(), findings, Some(known.version))
            .await;
    }
}
