//! The open documents, their order of edits, and what is known about each.
//!
//! Edits take effect at once and cost next to nothing. What a text means is worked out only when somebody asks, off the
//! threads that talk to the client, always for the newest text: a burst of edits leaves no queue of work behind it.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use scenec_ide::Document;
use scenec_text::SourceFile;
use tokio::sync::watch;
use tower_lsp::lsp_types::{SemanticToken, TextDocumentContentChangeEvent, Url};

use crate::abilities::Encoding;
use crate::text::Text;

/// All open documents.
#[derive(Default)]
pub(crate) struct Documents {
    open: Mutex<HashMap<Url, Arc<Open>>>,
    revisions: AtomicU64,
}

/// One open document.
pub(crate) struct Open {
    state: Mutex<State>,
    /// The newest analysis.
    analysed: watch::Sender<Option<Arc<Analysed>>>,
    /// Counts the states of the text; for those who have to hear of an edit.
    revision: watch::Sender<u64>,
    /// The tokens that the client was sent last, and the name that they were given.
    pub(crate) tokens: Mutex<Option<(String, Vec<SemanticToken>)>>,
}

struct State {
    name: String,
    text: Text,
    version: i32,
    revision: u64,
    /// The newest state that somebody waits for.
    wanted: u64,
    /// Whether a thread is at work on the document.
    busy: bool,
}

/// What is known about one state of a document.
pub(crate) struct Analysed {
    /// The analysis; `None` if it failed, which no text should bring about.
    pub(crate) document: Option<Arc<Document>>,
    /// The client's number for the state.
    pub(crate) version: i32,
    /// Our own number, never used twice.
    pub(crate) revision: u64,
}

/// The answer to somebody who asked about a document.
pub(crate) struct Answer {
    /// What is known, of the state that was asked about or a newer one.
    pub(crate) analysed: Arc<Analysed>,
    /// Whether it is the very state that was asked about.
    pub(crate) exact: bool,
}

impl Documents {
    /// Takes up a document; one that is open already starts anew.
    pub(crate) fn open(&self, url: Url, version: i32, text: &str) {
        let revision = self.next_revision();
        let state = State {
            name: url.to_string(),
            text: Text::new(text),
            version,
            revision,
            wanted: 0,
            busy: false,
        };
        let open = Arc::new(Open {
            state: Mutex::new(state),
            analysed: watch::Sender::new(None),
            revision: watch::Sender::new(revision),
            tokens: Mutex::new(None),
        });
        lock(&self.open).insert(url, open);
    }

    /// Takes edits over, in order. Tells whether the document is open.
    pub(crate) fn change(
        &self,
        url: &Url,
        version: i32,
        changes: &[TextDocumentContentChangeEvent],
        encoding: Encoding,
    ) -> bool {
        let Some(open) = self.get(url) else {
            return false;
        };
        let revision = self.next_revision();
        let mut state = lock(&open.state);
        for change in changes {
            state.text.change(change, encoding);
        }
        state.version = version;
        state.revision = revision;
        drop(state);
        open.revision.send_replace(revision);
        true
    }

    /// Forgets a document. Tells whether it was open.
    pub(crate) fn close(&self, url: &Url) -> bool {
        lock(&self.open).remove(url).is_some()
    }

    /// A document, if it is open.
    pub(crate) fn get(&self, url: &Url) -> Option<Arc<Open>> {
        lock(&self.open).get(url).cloned()
    }

    /// The names of all open documents, in order.
    pub(crate) fn urls(&self) -> Vec<Url> {
        let mut urls: Vec<Url> = lock(&self.open).keys().cloned().collect();
        urls.sort();
        urls
    }

    fn next_revision(&self) -> u64 {
        self.revisions.fetch_add(1, Ordering::Relaxed) + 1
    }
}

impl Open {
    /// What is known about the text as it stands when this is first polled; waits until that is worked out. `None` if the
    /// document went away meanwhile.
    pub(crate) async fn analysed(self: Arc<Self>) -> Option<Answer> {
        let wanted = self.want();
        let mut newest = self.analysed.subscribe();
        let enough = |newest: &Option<Arc<Analysed>>| newest.as_ref().is_some_and(|one| one.revision >= wanted);
        let analysed = newest.wait_for(enough).await.ok()?.clone()?;
        let exact = analysed.revision == wanted;
        Some(Answer { analysed, exact })
    }

    /// Hears of every edit.
    pub(crate) fn edits(&self) -> watch::Receiver<u64> {
        self.revision.subscribe()
    }

    /// Sees to it that the present state is worked out, and gives its number.
    fn want(self: &Arc<Self>) -> u64 {
        let mut state = lock(&self.state);
        state.wanted = state.revision;
        let known = self
            .analysed
            .borrow()
            .as_ref()
            .is_some_and(|one| one.revision == state.revision);
        if !known && !state.busy {
            state.busy = true;
            let open = Arc::clone(self);
            tokio::task::spawn_blocking(move || open.work());
        }
        state.revision
    }

    /// Works out the newest text until nobody waits for a newer one.
    fn work(&self) {
        loop {
            let state = lock(&self.state);
            let (name, text) = (state.name.clone(), state.text.clone());
            let (version, revision) = (state.version, state.revision);
            drop(state);
            let before = self.analysed.borrow().as_ref().and_then(|one| one.document.clone());
            let analysed = Analysed {
                document: analyse(name, &text, before.as_deref()),
                version,
                revision,
            };
            self.analysed.send_replace(Some(Arc::new(analysed)));
            let mut state = lock(&self.state);
            if state.wanted <= revision {
                state.busy = false;
                return;
            }
        }
    }
}

fn analyse(name: String, text: &Text, before: Option<&Document>) -> Option<Arc<Document>> {
    let analyse = || {
        let source = SourceFile::new(name, text.whole()).ok()?;
        Some(Arc::new(match before {
            Some(before) => Document::after(before, source),
            None => Document::new(source),
        }))
    };
    catch_unwind(AssertUnwindSafe(analyse)).ok().flatten()
}

/// Locks a mutex; what a panicking thread left behind is still a state that edits mend.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
