//! Remarks above statements: to render what is submitted, and how often something is used.

use scenec_ide::LensKind;
use serde_json::{Value, json};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{CodeLens, CodeLensParams, Command, Location};

use crate::server::Server;
use crate::view::View;

/// Opens the preview of a document; takes its address.
const PREVIEW: &str = "scenec.preview";
/// Shows places; takes the document's address, a place in it and a list of places.
const SHOW_PLACES: &str = "scenec.showReferences";

/// # Errors
/// As [`Server::on`].
pub(crate) async fn lenses(server: &Server, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
    let on = server.on(&params.text_document.uri, |view| {
        if !view.settings.lens {
            return Vec::new();
        }
        let found = scenec_ide::lenses(&view.document).into_iter();
        found.filter_map(|lens| one(view, lens)).collect()
    });
    on.await
}

fn one(view: &View, lens: scenec_ide::Lens) -> Option<CodeLens> {
    let range = view.range(lens.span);
    let command = match lens.what {
        // The protocol has no picture: without a client that knows the command there is nothing to offer.
        LensKind::Preview if !view.abilities.commands => return None,
        LensKind::Preview => command("preview", PREVIEW, vec![json!(view.url)]),
        LensKind::Uses { places } => {
            let title = match places.len() {
                0 => "no uses".to_owned(),
                1 => "1 use".to_owned(),
                many => format!("{many} uses"),
            };
            if !view.abilities.commands || places.is_empty() {
                command(&title, "", Vec::new())
            } else {
                let places: Vec<Location> = places.iter().map(|place| view.location(*place)).collect();
                command(
                    &title,
                    SHOW_PLACES,
                    vec![json!(view.url), json!(range.start), json!(places)],
                )
            }
        }
    };
    Some(CodeLens {
        range,
        command: Some(command),
        data: None,
    })
}

fn command(title: &str, name: &str, arguments: Vec<Value>) -> Command {
    Command {
        title: title.to_owned(),
        command: name.to_owned(),
        arguments: Some(arguments).filter(|arguments| !arguments.is_empty()),
    }
}
