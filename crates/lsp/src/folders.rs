//! The folders that the client has open, and the scenes in them of which it has told nothing.
//!
//! Files are read when they are asked for, and forgotten again: nobody has to hear of what changes on the disk.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use scenec_ide::Document;
use scenec_text::SourceFile;
use tower_lsp::lsp_types::{InitializeParams, Url, WorkspaceFoldersChangeEvent};

use crate::documents::lock;
use crate::options::Options;

/// All files together that are read for one question have at most so many bytes: more would keep it waiting for long.
const MOST_BYTES: u64 = 8 << 20;
/// And there are at most so many of them.
const MOST_FILES: usize = 1000;

/// The folders that are open, by their paths.
#[derive(Debug, Default)]
pub(crate) struct Folders(Mutex<Vec<PathBuf>>);

impl Folders {
    /// Takes over those of a greeting; older clients have one at most.
    pub(crate) fn meet(&self, greeting: &InitializeParams) {
        let named = greeting.workspace_folders.iter().flatten().map(|folder| &folder.uri);
        let mut folders: Vec<PathBuf> = named.filter_map(path).collect();
        if folders.is_empty() {
            #[allow(deprecated, reason = "what older clients have in its place")]
            folders.extend(greeting.root_uri.as_ref().and_then(path));
        }
        *lock(&self.0) = folders;
    }

    /// Some were opened or closed.
    pub(crate) fn change(&self, event: &WorkspaceFoldersChangeEvent) {
        let mut folders = lock(&self.0);
        let gone: Vec<PathBuf> = event.removed.iter().filter_map(|folder| path(&folder.uri)).collect();
        folders.retain(|folder| !gone.contains(folder));
        folders.extend(event.added.iter().filter_map(|folder| path(&folder.uri)));
    }

    /// Reads the scenes in the folders but for those that are open, as far as that is soon done. What can't be read is
    /// left out.
    pub(crate) fn closed(&self, options: &Options, open: &[Url]) -> Vec<(Url, Document)> {
        let folders = lock(&self.0).clone();
        let mut seen: HashSet<PathBuf> = open.iter().filter_map(path).collect();
        let mut left = MOST_BYTES;
        let mut found = Vec::new();
        for file in folders.iter().flat_map(|folder| (options.scenes)(folder)) {
            if found.len() == MOST_FILES || !seen.insert(file.clone()) {
                continue;
            }
            let length = fs::metadata(&file).map_or(u64::MAX, |about| about.len());
            if length <= left
                && let Some(document) = read(&file)
            {
                left -= length;
                found.push(document);
            }
        }
        found
    }
}

fn path(url: &Url) -> Option<PathBuf> {
    url.to_file_path().ok()
}

fn read(file: &Path) -> Option<(Url, Document)> {
    let text = fs::read_to_string(file).ok()?;
    let url = Url::from_file_path(file).ok()?;
    let source = SourceFile::new(url.to_string(), text).ok()?;
    Some((url, Document::new(source)))
}
