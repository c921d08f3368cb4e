//! What the user sets in the editor, and files of configuration that change.

use tower_lsp::lsp_types::{ConfigurationItem, DidChangeConfigurationParams};

use crate::server::Server;
use crate::settings::Settings;

/// The client tells of settings, or that there are others to be asked for.
pub(crate) fn changed(server: &Server, params: &DidChangeConfigurationParams) {
    match Settings::read(&params.settings) {
        Some(settings) => take(server, settings),
        None => ask(server),
    }
}

/// Asks the client for its settings, if it can be asked.
pub(crate) fn ask(server: &Server) {
    if !server.abilities().configuration {
        return;
    }
    let server = server.clone();
    // A question to the client must never be waited for where a message of it is at work.
    tokio::spawn(async move {
        let item = ConfigurationItem {
            scope_uri: None,
            section: Some("scenec".to_owned()),
        };
        let answer = server.client.configuration(vec![item]).await;
        let settings = answer.ok().and_then(|values| Settings::read(values.first()?));
        if let Some(settings) = settings {
            take(&server, settings);
        }
    });
}

fn take(server: &Server, settings: Settings) {
    if server.set(settings) {
        server.pictures.preview.forgive();
        refresh(server);
    }
}

/// Has everything shown anew that may look different now.
pub(crate) fn refresh(server: &Server) {
    let abilities = server.abilities();
    if !abilities.pulls {
        for url in server.documents.urls() {
            server.publisher.ask(url);
        }
    }
    let client = server.client.clone();
    tokio::spawn(async move {
        // A client that refuses shows what it had.
        if abilities.refreshes_findings {
            client.workspace_diagnostic_refresh().await.unwrap_or_default();
        }
        if abilities.refreshes_hints {
            client.inlay_hint_refresh().await.unwrap_or_default();
        }
        if abilities.refreshes_lenses {
            client.code_lens_refresh().await.unwrap_or_default();
        }
    });
}
