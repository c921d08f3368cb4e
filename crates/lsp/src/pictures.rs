//! What the requests about pictures share: the process that draws, whose turn it is for a document, and the words to the
//! client about how the process fares.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use serde::{Deserialize, Serialize};
use tokio::sync::{mpsc, oneshot};
use tower_lsp::Client;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::Url;
use tower_lsp::lsp_types::notification::Notification;

use crate::documents::lock;
use crate::log::Log;
use crate::options::Options;
use crate::preview::{CameraWish, Limits, Look, News, Pass, Preview, Report, State, Task};
use crate::server::{Server, aside};
use crate::settings::Csg;
use crate::view::View;

/// The process that draws, and the pictures on their way.
pub(crate) struct Pictures {
    pub(crate) preview: Preview,
    turns: Mutex<HashMap<Url, (u64, oneshot::Sender<()>)>>,
    counter: AtomicU64,
}

/// The right to draw a document, until somebody else takes it.
pub(crate) struct Turn {
    pictures: Arc<Pictures>,
    url: Url,
    number: u64,
    over: oneshot::Receiver<()>,
}

/// A size in pixels.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(crate) struct Size {
    width: u32,
    height: u32,
}

/// A scene to be looked at, apart from its document.
pub(crate) struct Subject {
    pub(crate) text: Arc<str>,
    pub(crate) look: Look,
    pub(crate) version: i32,
}

impl Pictures {
    /// For one client. The process is not started before there is something to draw.
    pub(crate) fn new(client: &Client, options: &Options) -> Self {
        let (program, arguments) = options.drawer.clone();
        let (sender, reports) = mpsc::unbounded_channel();
        tokio::spawn(tell(client.clone(), reports));
        let log = Log { on: options.log };
        let report = move |report| match report {
            Report::Line(line) => log.say(format_args!("drawing: {line}")),
            Report::Status { state, message } => {
                let status = Status::of(state, message);
                // A server at its end tells nothing any more.
                sender.send(status).unwrap_or_default();
            }
        };
        Self {
            preview: Preview::new(program, arguments, Limits::DEFAULT, report),
            turns: Mutex::default(),
            counter: AtomicU64::new(0),
        }
    }

    /// Takes the turn for a document from whoever has it.
    pub(crate) fn turn(self: &Arc<Self>, url: &Url) -> Turn {
        let number = self.counter.fetch_add(1, Ordering::Relaxed);
        let (sender, over) = oneshot::channel();
        lock(&self.turns).insert(url.clone(), (number, sender));
        Turn {
            pictures: Arc::clone(self),
            url: url.clone(),
            number,
            over,
        }
    }
}

impl Turn {
    /// Ends when somebody else has the turn.
    pub(crate) async fn over(&mut self) {
        // The other end is never used, only dropped.
        (&mut self.over).await.unwrap_or_default();
    }
}

impl Drop for Turn {
    fn drop(&mut self) {
        let mut turns = lock(&self.pictures.turns);
        if turns.get(&self.url).is_some_and(|(number, _)| *number == self.number) {
            turns.remove(&self.url);
        }
    }
}

impl Subject {
    /// What a view shows, if it is a scene.
    pub(crate) fn of(view: &View, size: Option<Size>, camera: Option<CameraWish>) -> Option<Self> {
        view.document.scene()?;
        Some(Self {
            text: Arc::from(view.document.text()),
            look: Look {
                name: view.url.to_string(),
                size: size.map(|size| (size.width, size.height)),
                camera,
                ignore_operators: view.settings.csg == Csg::Ignore,
            },
            version: view.version,
        })
    }

    /// Asks one thing, and waits for how it ends.
    pub(crate) async fn ask(self, server: &Server, task: Task) -> Option<(News, Vec<u8>)> {
        let mut asked = server.pictures.preview.ask(self.look, task, self.text);
        let mut last = None;
        while let Some(news) = asked.next().await {
            last = Some(news);
        }
        last
    }
}

/// Bytes as text, off the threads that talk to the client.
///
/// # Errors
/// As [`aside`].
pub(crate) async fn base64(bytes: Vec<u8>) -> Result<String> {
    use base64::Engine;
    aside(move || base64::engine::general_purpose::STANDARD.encode(bytes)).await
}

/// `scene/status`
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Status {
    state: State,
    device: Option<String>,
    milliseconds: Option<f64>,
    message: Option<String>,
}

impl Status {
    fn of(state: State, message: Option<String>) -> Self {
        Self {
            state,
            device: None,
            milliseconds: None,
            message,
        }
    }

    /// After a picture.
    pub(crate) fn drawn(last: Option<&Pass>, message: Option<String>) -> Self {
        Self {
            device: last.map(|pass| pass.device.clone()),
            milliseconds: last.map(|pass| pass.milliseconds),
            ..Self::of(State::Ready, message)
        }
    }
}

pub(crate) enum SceneStatus {}

impl Notification for SceneStatus {
    type Params = Status;
    const METHOD: &'static str = "scene/status";
}

async fn tell(client: Client, mut reports: mpsc::UnboundedReceiver<Status>) {
    while let Some(status) = reports.recv().await {
        client.send_notification::<SceneStatus>(status).await;
    }
}
