//! `--watch`: doing something again whenever a file has changed.
//!
//! Files are looked at every so often. That works on every file system, over networks and for files that editors replace.

use std::collections::BTreeSet;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::config;
use crate::exit::Exit;
use crate::files::FileOptions;
use crate::interrupt;
use crate::jobs::remark;
use crate::report::plural;

/// How long between two looks at the watch for Ctrl-C, and how many of those make a look at the files.
const TICK: Duration = Duration::from_millis(50);
const TICKS: u32 = 5;

/// When a file was written and how long it is; `None` where there is none.
type Stamp = Option<(SystemTime, u64)>;

/// Calls `again` now and after every change, until Ctrl-C or until it breaks off.
pub(crate) fn watch(files: &FileOptions, mut again: impl FnMut() -> ControlFlow<Exit>) -> Exit {
    let watch = interrupt::watch();
    let mut seen = None;
    while !watch.stopped() {
        let now = stamps(files);
        if seen.as_ref() != Some(&now) {
            // What changes from here on is seen at the next look.
            if let ControlFlow::Break(exit) = again() {
                return exit;
            }
            let scenes = now
                .iter()
                .filter(|(path, _)| path.file_name() != Some(config::NAME.as_ref()));
            remark(&format!("watching {}; Ctrl-C ends", plural(scenes.count(), "file")));
            seen = Some(now);
        }
        for _ in 0..TICKS {
            if watch.stopped() {
                break;
            }
            thread::sleep(TICK);
        }
    }
    Exit::Interrupted
}

/// The files, and the places where a configuration for them may stand.
fn stamps(files: &FileOptions) -> Vec<(PathBuf, Stamp)> {
    let paths: Vec<_> = files.find().files.into_iter().map(|input| input.path).collect();
    let folder = |path: &PathBuf| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        fs::canonicalize(folder.unwrap_or(Path::new("."))).ok()
    };
    let folders: BTreeSet<PathBuf> = paths.iter().filter_map(folder).collect();
    let above: BTreeSet<&Path> = folders.iter().flat_map(|folder| folder.ancestors()).collect();
    let configs = above.into_iter().map(|folder| folder.join(config::NAME));
    let configs = configs.filter(|path| path.exists()).collect::<Vec<_>>();
    let stamp = |path: PathBuf| {
        let stamp = fs::metadata(&path).and_then(|there| Ok((there.modified()?, there.len())));
        (path, stamp.ok())
    };
    paths.into_iter().chain(configs).map(stamp).collect()
}
