//! `scene/pick`: from a place in the picture to the statement that made the object there.

use scenec_ide::statement_of;
use scenec_scene::SolidId;
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::lsp_types::{Range, TextDocumentIdentifier, Url};

use crate::pictures::Subject;
use crate::preview::{CameraWish, News, Task};
use crate::server::{Server, refused};
use crate::view::View;

/// Where, from 0 at the upper left to 1 at the lower right.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Params {
    text_document: TextDocumentIdentifier,
    x: f64,
    y: f64,
    camera: Option<CameraWish>,
}

/// The statement.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Picked {
    uri: Url,
    name: String,
    range: Range,
    selection_range: Range,
}

impl Server {
    /// Answers `scene/pick`.
    pub(crate) async fn scene_pick(&self, params: Params) -> Result<Option<Picked>> {
        let Params { x, y, camera, .. } = params;
        let url = params.text_document.uri;
        let Some(subject) = self
            .on(&url, move |view| Subject::of(view, None, camera))
            .await?
            .flatten()
        else {
            return Ok(None);
        };
        let version = subject.version;
        match subject.ask(self, Task::Pick { x, y }).await {
            Some((News::Picked { solid: Some(solid) }, _)) => {
                let found = self.on(&url, move |view| (view.version == version).then(|| picked(view, solid)));
                found
                    .await?
                    .unwrap_or_default()
                    .ok_or_else(|| Error::new(ErrorCode::ContentModified))
            }
            Some((News::Failed { message }, _)) => Err(refused(&message)),
            _ => Ok(None),
        }
    }
}

fn picked(view: &View, solid: u32) -> Option<Picked> {
    let target = statement_of(&view.document, SolidId(solid))?;
    Some(Picked {
        uri: view.url.clone(),
        name: target.name.of(view.document.text()).to_owned(),
        range: view.range(target.line),
        selection_range: view.range(target.name),
    })
}
