//! `scene/render`: pictures of a scene, coarse ones first, until the last one or until something newer comes up.

use scenec_text::Severity;
use serde::{Deserialize, Serialize};
use tokio::sync::watch;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::notification::Notification;
use tower_lsp::lsp_types::{Range, TextDocumentIdentifier, Url};

use crate::pictures::{SceneStatus, Size, Status, Subject, base64};
use crate::preview::{CameraUsed, CameraWish, News, Pass, Quality, Task};
use crate::server::Server;
use crate::view::View;

/// What is wanted.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Params {
    text_document: TextDocumentIdentifier,
    /// The client's number, which every frame repeats.
    id: i64,
    size: Option<Size>,
    camera: Option<CameraWish>,
    quality: Quality,
    /// Whether an edit lets it go on, with the text as it is now.
    #[serde(default)]
    despite_edits: bool,
}

/// How it ended.
#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
enum Outcome {
    Done,
    Cancelled,
    Broken,
    Failed,
}

/// The answer, after the last frame.
#[derive(Debug, Serialize)]
pub(crate) struct Answer {
    outcome: Outcome,
    version: Option<i32>,
    width: Option<u32>,
    height: Option<u32>,
    device: Option<String>,
    milliseconds: Option<f64>,
    camera: Option<CameraUsed>,
    error: Option<Failure>,
}

#[derive(Debug, Serialize)]
struct Failure {
    message: String,
    code: Option<&'static str>,
    range: Option<Range>,
}

/// `scene/frame`
#[derive(Debug, Serialize, Deserialize)]
struct Frame {
    uri: Url,
    id: i64,
    version: i32,
    pass: u32,
    #[serde(rename = "final")]
    last: bool,
    width: u32,
    height: u32,
    png: String,
    device: String,
    milliseconds: f64,
}

enum SceneFrame {}

impl Notification for SceneFrame {
    type Params = Frame;
    const METHOD: &'static str = "scene/frame";
}

impl Server {
    /// Answers `scene/render`.
    pub(crate) async fn scene_render(&self, params: Params) -> Result<Answer> {
        let url = params.text_document.uri.clone();
        // All this happens before a later message is read: it is the present text that is drawn, and a later request
        // for the same document finds this one's turn to take.
        let mut turn = self.pictures.turn(&url);
        let Some(mut edits) = self.documents.get(&url).map(|open| open.edits()) else {
            return Ok(Answer::failed(None, "the document is not open".to_owned()));
        };
        let despite_edits = params.despite_edits;
        let over = async {
            tokio::select! {
                () = turn.over() => {}
                () = outdated(&mut edits, despite_edits) => {}
            }
        };
        tokio::select! {
            biased;
            () = over => Ok(Answer::new(Outcome::Cancelled, None)),
            answer = draw(self, params) => answer,
        }
    }
}

/// Ends with the document, or with its next edit unless that is to be passed over.
async fn outdated(edits: &mut watch::Receiver<u64>, despite_edits: bool) {
    while edits.changed().await.is_ok() && despite_edits {}
}

async fn draw(server: &Server, params: Params) -> Result<Answer> {
    let url = params.text_document.uri;
    let (size, camera) = (params.size, params.camera);
    let subject = move |view: &View| {
        let subject = Subject::of(view, size, camera);
        subject
            .map(|subject| (subject, view.settings.device.clone()))
            .ok_or_else(|| Box::new(broken(view)))
    };
    let (subject, device) = match server.on(&url, subject).await? {
        Some(Ok(found)) => found,
        Some(Err(broken)) => return Ok(*broken),
        None => return Ok(Answer::new(Outcome::Cancelled, None)),
    };
    let version = subject.version;
    let quality = params.quality;
    let mut asked = server
        .pictures
        .preview
        .ask(subject.look, Task::Draw { quality, device }, subject.text);
    let mut shown = None;
    while let Some((news, payload)) = asked.next().await {
        match news {
            News::Pass(pass) => {
                let frame = frame(&url, params.id, version, &pass, base64(payload).await?);
                shown = Some(pass);
                server.client.send_notification::<SceneFrame>(frame).await;
            }
            News::Drawn { camera, remark } => {
                // The library writes answers and notifications from two queues. This returns only once its queue has
                // let go of what was sent before, so that the answer can't overtake the last frame.
                let status = Status::drawn(shown.as_ref(), remark);
                server.client.send_notification::<SceneStatus>(status).await;
                return Ok(Answer::done(version, shown, camera));
            }
            News::Failed { message } => return Ok(Answer::failed(Some(version), message)),
            News::Cancelled => return Ok(Answer::new(Outcome::Cancelled, Some(version))),
            News::Picked { .. } | News::Outlined { .. } => break,
        }
    }
    Ok(Answer::failed(Some(version), "nothing draws".to_owned()))
}

fn frame(url: &Url, id: i64, version: i32, pass: &Pass, png: String) -> Frame {
    Frame {
        uri: url.clone(),
        id,
        version,
        pass: pass.pass,
        last: pass.last,
        width: pass.width,
        height: pass.height,
        png,
        device: pass.device.clone(),
        milliseconds: pass.milliseconds,
    }
}

/// That a text is no scene, with its first error.
fn broken(view: &View) -> Answer {
    let first = view
        .document
        .diagnostics()
        .iter()
        .find(|found| found.severity() == Severity::Error);
    let error = match first {
        Some(found) => Failure {
            message: found.message.clone(),
            code: Some(found.code.id()),
            range: Some(view.range(found.span())),
        },
        None => Failure {
            message: "the text is no scene".to_owned(),
            code: None,
            range: None,
        },
    };
    Answer {
        error: Some(error),
        ..Answer::new(Outcome::Broken, Some(view.version))
    }
}

impl Answer {
    const fn new(outcome: Outcome, version: Option<i32>) -> Self {
        Self {
            outcome,
            version,
            width: None,
            height: None,
            device: None,
            milliseconds: None,
            camera: None,
            error: None,
        }
    }

    fn done(version: i32, last: Option<Pass>, camera: CameraUsed) -> Self {
        let answer = Self {
            camera: Some(camera),
            ..Self::new(Outcome::Done, Some(version))
        };
        match last {
            Some(pass) => Self {
                width: Some(pass.width),
                height: Some(pass.height),
                device: Some(pass.device),
                milliseconds: Some(pass.milliseconds),
                ..answer
            },
            None => answer,
        }
    }

    fn failed(version: Option<i32>, message: String) -> Self {
        Self {
            error: Some(Failure {
                message,
                code: None,
                range: None,
            }),
            ..Self::new(Outcome::Failed, version)
        }
    }
}
