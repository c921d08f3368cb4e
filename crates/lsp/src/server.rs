//! The server's state, and how work on a document is done: off the threads that talk to the client, panics contained.

use std::cell::Cell;
use std::collections::HashSet;
use std::fmt::Display;
use std::sync::{Arc, Mutex, OnceLock};

use scenec_ide::Document;
use tokio::sync::watch;
use tower_lsp::Client;
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::lsp_types::{MessageType, TextDocumentPositionParams, Url};

use crate::abilities::Abilities;
use crate::convert::Known;
use crate::documents::{Documents, lock};
use crate::folders::Folders;
use crate::log::Log;
use crate::options::Options;
use crate::pages::Pages;
use crate::pictures::Pictures;
use crate::publisher::Publisher;
use crate::settings::Settings;
use crate::view::View;

/// The state that all requests share; a copy of it is another handle.
#[derive(Clone)]
pub(crate) struct Server {
    pub(crate) client: Client,
    pub(crate) documents: Arc<Documents>,
    pub(crate) options: Arc<Options>,
    pub(crate) publisher: Arc<Publisher>,
    pub(crate) log: Log,
    pub(crate) pictures: Arc<Pictures>,
    pages: Arc<Pages>,
    pub(crate) folders: Arc<Folders>,
    settings: Arc<Mutex<Arc<Settings>>>,
    abilities: Arc<OnceLock<Abilities>>,
    told: Arc<Mutex<HashSet<String>>>,
    /// Where the number of the client's process goes.
    process: Arc<watch::Sender<Option<u32>>>,
}

impl Server {
    /// A server that knows nothing of its client yet.
    pub(crate) fn new(client: Client, options: Options, process: watch::Sender<Option<u32>>) -> Self {
        Self {
            pictures: Arc::new(Pictures::new(&client, &options)),
            pages: Arc::new(Pages::of_user()),
            folders: Arc::default(),
            client,
            process: Arc::new(process),
            log: Log { on: options.log },
            options: Arc::new(options),
            documents: Arc::default(),
            publisher: Arc::default(),
            settings: Arc::default(),
            abilities: Arc::default(),
            told: Arc::default(),
        }
    }

    /// What the client can do.
    pub(crate) fn abilities(&self) -> Abilities {
        self.abilities.get().copied().unwrap_or_default()
    }

    /// Remembers what the client can do; the first word counts.
    pub(crate) fn meet(&self, abilities: Abilities, process: Option<u32>) {
        // The protocol library lets no second greeting through.
        self.abilities.get_or_init(|| abilities);
        self.process.send_replace(process);
    }

    /// The settings in force.
    pub(crate) fn settings(&self) -> Arc<Settings> {
        lock(&self.settings).clone()
    }

    /// Takes settings over. Tells whether they are other ones.
    pub(crate) fn set(&self, settings: Settings) -> bool {
        let mut present = lock(&self.settings);
        let other = **present != settings;
        *present = Arc::new(settings);
        other
    }

    /// Does some work on the newest state of a document, off the threads that talk to the client. `None` if the document
    /// is not open.
    ///
    /// # Errors
    /// If the work panics.
    pub(crate) async fn on<T: Send + 'static>(
        &self,
        url: &Url,
        work: impl FnOnce(&View) -> T + Send + 'static,
    ) -> Result<Option<T>> {
        self.view(url, false, work).await
    }

    /// Does some work on the very state of a document that a request speaks of.
    ///
    /// # Errors
    /// If the document was edited before it could be read, or the work panics.
    pub(crate) async fn on_exactly<T: Send + 'static>(
        &self,
        url: &Url,
        work: impl FnOnce(&View) -> T + Send + 'static,
    ) -> Result<Option<T>> {
        self.view(url, true, work).await
    }

    /// Does some work at a place in a document.
    ///
    /// # Errors
    /// As [`Server::on_exactly`].
    pub(crate) async fn at<T: Send + 'static>(
        &self,
        place: TextDocumentPositionParams,
        work: impl FnOnce(&View, u32) -> Option<T> + Send + 'static,
    ) -> Result<Option<T>> {
        let position = place.position;
        let at = move |view: &View| work(view, view.offset(position));
        Ok(self.on_exactly(&place.text_document.uri, at).await?.flatten())
    }

    async fn view<T: Send + 'static>(
        &self,
        url: &Url,
        exactly: bool,
        work: impl FnOnce(&View) -> T + Send + 'static,
    ) -> Result<Option<T>> {
        // Up to the first wait this runs before any later message is read: what is asked for is the present state.
        let Some(open) = self.documents.get(url) else {
            self.log.say(format_args!("{url} is not open"));
            return Ok(None);
        };
        let Some(answer) = open.analysed().await else {
            return Ok(None);
        };
        if exactly && !answer.exact {
            return Err(Error::new(ErrorCode::ContentModified));
        }
        let document = answer.analysed.document.clone().ok_or_else(failed)?;
        let view = View {
            version: answer.analysed.version,
            revision: answer.analysed.revision,
            ..self.view_of(url.clone(), document)
        };
        aside(move || work(&view)).await.map(Some)
    }

    /// A document that the client has told nothing of, as a handler sees it.
    pub(crate) fn view_of(&self, url: Url, document: Arc<Document>) -> View {
        View {
            url,
            document,
            version: 0,
            revision: 0,
            abilities: self.abilities(),
            settings: self.settings(),
            options: Arc::clone(&self.options),
            pages: Arc::clone(&self.pages),
            known: Cell::new(Known::default()),
        }
    }

    /// Shows a message, unless it was shown before.
    pub(crate) fn tell_once(&self, message: Option<String>) {
        let Some(message) = message else {
            return;
        };
        if lock(&self.told).insert(message.clone()) {
            self.tell(message);
        }
    }

    /// Shows a message.
    fn tell(&self, message: impl Display + Send + 'static) {
        let client = self.client.clone();
        tokio::spawn(async move { client.show_message(MessageType::WARNING, message).await });
    }
}

/// Does some work on a thread of its own. A panic in it is an error of this request alone.
///
/// # Errors
/// If the work panics.
pub(crate) async fn aside<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Result<T> {
    tokio::task::spawn_blocking(work).await.map_err(|_| failed())
}

/// An answer that says why there is none.
pub(crate) fn refused(why: &impl Display) -> Error {
    /// "RequestFailed", which the library has no name for.
    const REQUEST_FAILED: i64 = -32803;
    let mut error = Error::new(ErrorCode::ServerError(REQUEST_FAILED));
    error.message = why.to_string().into();
    error
}

/// What is said of a request that panicked.
pub(crate) fn failed() -> Error {
    let mut error = Error::internal_error();
    error.message = "the server failed at this request".into();
    error
}

#[cfg(test)]
mod tests {
    use super::aside;

    #[tokio::test]
    async fn a_panic_is_an_error_of_one_request() {
        let failed = aside(|| std::hint::black_box(Vec::<u8>::new())[0]).await;
        assert_eq!(failed.unwrap_err().message, "the server failed at this request");
        assert_eq!(aside(|| 5).await, Ok(5));
    }
}
