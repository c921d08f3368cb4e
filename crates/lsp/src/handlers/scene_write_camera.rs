//! `scene/writeCamera`: the edits that make a camera of the preview the file's own.

use scenec_ide::{CameraChange, camera_edits};
use serde::Deserialize;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{TextDocumentIdentifier, WorkspaceEdit};

use crate::preview::CameraWish;
use crate::server::Server;

/// The camera.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Params {
    text_document: TextDocumentIdentifier,
    camera: CameraWish,
}

impl Server {
    /// Answers `scene/writeCamera`.
    pub(crate) async fn scene_write_camera(&self, params: Params) -> Result<Option<WorkspaceEdit>> {
        let CameraWish { eye, lookat, up, fov } = params.camera;
        let change = CameraChange { eye, lookat, up, fov };
        let edits = self.on_exactly(&params.text_document.uri, move |view| {
            let edits = camera_edits(&view.document, &change);
            (!edits.is_empty()).then(|| view.workspace_edit(&edits))
        });
        Ok(edits.await?.flatten())
    }
}
