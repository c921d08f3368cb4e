//! Where what was costly to make is kept between runs, for as long as it is there: nothing may depend on it.
//!
//! This owns the folder and the files in it. It knows keys and bytes, and neither programs nor devices.

mod hash;

use std::env;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, SystemTime};

pub(crate) use hash::Hash;

/// Moves the folder; `off` goes without one.
const VARIABLE: &str = "SCENEC_CACHE_DIR";
/// All entries together have at most so many bytes.
const BOUND: u64 = 64 << 20;
/// The first bytes of an entry, with the version of what follows.
const MARK: &[u8; 16] = b"scenec cache 01\n";
/// The mark, then the key, the length and the hash of the bytes.
const HEAD: usize = MARK.len() + 16 + 8 + 16;
/// The names of entries end so.
const SUFFIX: &str = "entry";
/// What a process that was ended in the midst of writing left behind is swept away after this.
const ABANDONED: Duration = Duration::from_secs(3600);

/// This user's folder for what can be made again: `SCENEC_CACHE_DIR`, or `scenec` in that of the XDG rules or what the
/// system has in its place. `None` where there is no such place, or none is wanted.
#[must_use]
pub fn cache_folder() -> Option<PathBuf> {
    folder(|name| env::var_os(name).map(PathBuf::from))
}

fn folder(variable: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
    match variable(VARIABLE) {
        Some(off) if off.as_os_str() == "off" => return None,
        Some(path) if !path.as_os_str().is_empty() => return Some(path),
        _ => {}
    }
    let of = |name: &str| variable(name).filter(|path| path.is_absolute());
    let caches = of("XDG_CACHE_HOME")
        .or_else(|| of("LOCALAPPDATA"))
        .or_else(|| of("HOME").map(|home| home.join(".cache")))?;
    Some(caches.join("scenec"))
}

/// Entries in a folder. All that can go wrong with them means that they are not there.
#[derive(Clone, Debug)]
pub(crate) struct Cache {
    folder: Option<PathBuf>,
    bound: u64,
}

impl Cache {
    /// The one of this user, for entries of one kind.
    pub(crate) fn of_user(kind: &str) -> Self {
        Self {
            folder: cache_folder().map(|folder| folder.join(kind)),
            bound: BOUND,
        }
    }

    /// Whether anything is ever kept.
    pub(crate) const fn is_on(&self) -> bool {
        self.folder.is_some()
    }

    /// The bytes that were put under this key.
    pub(crate) fn get(&self, key: Hash) -> Option<Vec<u8>> {
        let path = self.path(key)?;
        let bytes = unpack(key, fs::read(&path).ok()?)?;
        // The entry that was used last is the last to go. Where that can't be written down, it goes sooner.
        File::options()
            .write(true)
            .open(path)
            .and_then(|file| file.set_modified(SystemTime::now()))
            .unwrap_or_default();
        Some(bytes)
    }

    /// Whether there is such an entry, whole or not.
    pub(crate) fn has(&self, key: Hash) -> bool {
        self.path(key).is_some_and(|path| path.exists())
    }

    /// Puts bytes under a key, and throws out what was not used for longest until all is within the bound. Whoever reads
    /// meanwhile finds the entry whole or not at all.
    pub(crate) fn put(&self, key: Hash, bytes: &[u8]) {
        if bytes.len() as u64 > self.bound / 4 {
            return;
        }
        if let (Some(folder), Some(path)) = (&self.folder, self.path(key)) {
            // A folder that can't be written to is as good as none.
            write(folder, &path, key, bytes)
                .and_then(|()| sweep(folder, self.bound))
                .unwrap_or_default();
        }
    }

    /// Forgets an entry that turned out to be of no use.
    pub(crate) fn forget(&self, key: Hash) {
        if let Some(path) = self.path(key) {
            fs::remove_file(path).unwrap_or_default();
        }
    }

    fn path(&self, key: Hash) -> Option<PathBuf> {
        let folder = self.folder.as_ref()?;
        Some(folder.join(format!("{:032x}.{SUFFIX}", key.value())))
    }
}

fn write(folder: &Path, path: &Path, key: Hash, bytes: &[u8]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let mut head = Vec::with_capacity(HEAD);
    head.extend_from_slice(MARK);
    head.extend_from_slice(&key.value().to_le_bytes());
    head.extend_from_slice(&(bytes.len() as u64).to_le_bytes());
    head.extend_from_slice(&Hash::of(&[bytes]).value().to_le_bytes());
    // Under its own name when it is whole. Nobody waits for the disk: what a power cut leaves of it fails its checksum.
    static TURN: AtomicU32 = AtomicU32::new(0);
    let turn = TURN.fetch_add(1, Ordering::Relaxed);
    let part = path.with_extension(format!("{}-{turn}.part", process::id()));
    let mut out = File::create(&part)?;
    out.write_all(&head)
        .and_then(|()| out.write_all(bytes))
        .and_then(|()| fs::rename(&part, path))
        .or_else(|error| fs::remove_file(&part).and(Err(error)))
}

/// The bytes of an entry, if all of them are there and unharmed: drivers have been seen to end the process over half a
/// program.
fn unpack(key: Hash, mut entry: Vec<u8>) -> Option<Vec<u8>> {
    let (head, bytes) = entry.split_at_checked(HEAD)?;
    let mut expect = MARK.to_vec();
    expect.extend_from_slice(&key.value().to_le_bytes());
    expect.extend_from_slice(&(bytes.len() as u64).to_le_bytes());
    expect.extend_from_slice(&Hash::of(&[bytes]).value().to_le_bytes());
    if head != expect {
        return None;
    }
    entry.drain(..HEAD);
    Some(entry)
}

/// Removes the oldest entries until the rest is within the bound, and what was abandoned half-written.
fn sweep(folder: &Path, bound: u64) -> io::Result<()> {
    let now = SystemTime::now();
    let mut entries = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        // Another process may have swept it away.
        let Ok(about) = entry.metadata() else { continue };
        let time = about.modified().unwrap_or(SystemTime::UNIX_EPOCH);
        let path = entry.path();
        if path.extension().is_some_and(|end| end == SUFFIX) {
            entries.push((time, about.len(), path));
        } else if path.extension().is_some_and(|end| end == "part")
            && now.duration_since(time).is_ok_and(|age| age > ABANDONED)
        {
            fs::remove_file(path).unwrap_or_default();
        }
    }
    entries.sort();
    let mut sum: u64 = entries.iter().map(|(_, length, _)| length).sum();
    for (_, length, path) in entries {
        if sum <= bound {
            break;
        }
        fs::remove_file(path).unwrap_or_default();
        sum -= length;
    }
    Ok(())
}

#[cfg(test)]
pub(crate) mod tests;
