//! Where references are kept, and whose they are.

use std::env;
use std::path::PathBuf;
use std::time::SystemTime;

/// The user's folder for references.
pub(super) fn folder() -> Option<PathBuf> {
    Some(scenec_device::cache_folder()?.join("references"))
}

/// Tells this program from one that was built at another time, whose references may be others.
pub(super) fn salt() -> Vec<u8> {
    let about = env::current_exe().and_then(|path| path.metadata());
    let built = about.and_then(|about| Ok((about.len(), about.modified()?)));
    let Ok((length, time)) = built else {
        return Vec::new();
    };
    let since = time.duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    [length.to_le_bytes().as_slice(), &since.as_nanos().to_le_bytes()].concat()
}
