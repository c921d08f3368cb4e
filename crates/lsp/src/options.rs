//! What the program that starts the server decides.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use scenec_text::{Code, Severity};

/// How one file is to be treated; the values of a configuration that lies beside it or above it.
#[derive(Clone)]
pub struct FileOptions {
    /// How grave each code counts; `None` if it is not to be shown.
    pub level: Arc<dyn Fn(Code) -> Option<Severity> + Send + Sync>,
    /// Whether the formatter puts values one below the other.
    pub align: bool,
    /// Why the configuration can't be used, if it can't.
    pub problem: Option<String>,
}

impl Default for FileOptions {
    fn default() -> Self {
        Self {
            level: Arc::new(|code| Some(code.severity())),
            align: false,
            problem: None,
        }
    }
}

/// How the server runs.
pub struct Options {
    /// What holds for a file; asked again each time, so that an edited configuration counts at once.
    pub file: Box<dyn Fn(&Path) -> FileOptions + Send + Sync>,
    /// The name of the files that `file` reads, for the client to watch.
    pub configuration: &'static str,
    /// The scene files below a folder, soon found.
    pub scenes: fn(&Path) -> Vec<PathBuf>,
    /// Whether to tell on standard error what goes on.
    pub log: bool,
    /// The program that draws the preview, and its arguments: one that ends in [`crate::preview::work`].
    pub drawer: (PathBuf, Vec<String>),
}
