//! `scene/outline`: a line around the object at the cursor, to be laid over the picture.

use scenec_ide::{object_at, statement_of};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::TextDocumentPositionParams;

use crate::pictures::{Size, Subject, base64};
use crate::preview::{CameraWish, News, Task};
use crate::server::{Server, refused};

/// The cursor, and how the scene is looked at.
#[derive(Debug, Deserialize)]
pub(crate) struct Params {
    #[serde(flatten)]
    place: TextDocumentPositionParams,
    size: Option<Size>,
    camera: Option<CameraWish>,
}

/// A picture that is clear but for the line.
#[derive(Debug, Serialize)]
pub(crate) struct Outline {
    name: String,
    width: u32,
    height: u32,
    png: String,
}

impl Server {
    /// Answers `scene/outline`.
    pub(crate) async fn scene_outline(&self, params: Params) -> Result<Option<Outline>> {
        let Params { place, size, camera } = params;
        let found = self.at(place, move |view, offset| {
            let solid = object_at(&view.document, offset)?;
            let statement = statement_of(&view.document, solid);
            let name = statement.map(|target| target.name.of(view.document.text()).to_owned());
            Some((name.unwrap_or_default(), solid.0, Subject::of(view, size, camera)?))
        });
        let Some((name, solid, subject)) = found.await? else {
            return Ok(None);
        };
        match subject.ask(self, Task::Outline { solid }).await {
            Some((News::Outlined { width, height }, png)) if !png.is_empty() => Ok(Some(Outline {
                name,
                width,
                height,
                png: base64(png).await?,
            })),
            Some((News::Failed { message }, _)) => Err(refused(&message)),
            _ => Ok(None),
        }
    }
}
