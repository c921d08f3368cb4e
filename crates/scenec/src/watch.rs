//! `--watch`: doing something again whenever a file has changed.
//!
//! Files are looked at every so often. That works on every file system, over networks and for files that editors replace.

use std::collections::BTreeSet;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::config::{self, ConfigOptions};
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
pub(crate) fn watch(files: &FileOptions, config: &ConfigOptions, mut again: impl FnMut() -> ControlFlow<Exit>) -> Exit {
    let watch = interrupt::watch();
    let mut seen = None;
    while !watch.stopped() {
        let now = stamps(files, config);
        if seen.as_ref() != Some(&now) {
            // What changes from here on is seen at the next look.
            if let ControlFlow::Break(exit) = again() {
                return exit;
            }
            remark(&format!("watching {}; Ctrl-C ends", plural(now.scenes.len(), "file")));
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

/// What the files are like now, and the configurations that hold for them or would.
#[derive(PartialEq, Eq)]
struct Stamps {
    scenes: Vec<(PathBuf, Stamp)>,
    configs: Vec<(PathBuf, Stamp)>,
}

fn stamps(files: &FileOptions, config: &ConfigOptions) -> Stamps {
    let paths: Vec<_> = files.find().files.into_iter().map(|input| input.path).collect();
    let configs = match &config.config {
        Some(only) => vec![only.clone()],
        None if config.isolated => Vec::new(),
        None => places(&paths),
    };
    let stamp = |path: PathBuf| {
        let stamp = fs::metadata(&path).and_then(|there| Ok((there.modified()?, there.len())));
        (path, stamp.ok())
    };
    Stamps {
        scenes: paths.into_iter().map(stamp).collect(),
        configs: configs.into_iter().map(stamp).collect(),
    }
}

/// The places where a configuration of these files may stand.
fn places(paths: &[PathBuf]) -> Vec<PathBuf> {
    let folder = |path: &PathBuf| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        fs::canonicalize(folder.unwrap_or(Path::new("."))).ok()
    };
    let folders: BTreeSet<PathBuf> = paths.iter().filter_map(folder).collect();
    let above: BTreeSet<&Path> = folders.iter().flat_map(|folder| folder.ancestors()).collect();
    above.into_iter().map(|folder| folder.join(config::NAME)).collect()
}
