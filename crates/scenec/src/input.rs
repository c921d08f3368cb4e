//! Reading scene files, or standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use scenec_text::{Diagnostic, MAX_FILE_BYTES, SourceFile};

/// Reads a file, or standard input where the path is `-`, with a finding for each run of bytes that is no UTF-8.
///
/// # Errors
/// A sentence for the user: the file can't be opened or read, is a directory, or is too large.
pub(crate) fn read(path: &Path) -> Result<(SourceFile, Vec<Diagnostic>), String> {
    let standard = path.as_os_str() == "-";
    let name = if standard {
        "<stdin>".into()
    } else {
        path.to_string_lossy()
    };
    read_as(path, &name)
}

/// As [`read`], with a name of the caller's choice.
///
/// # Errors
/// As for [`read`].
pub(crate) fn read_as(path: &Path, name: &str) -> Result<(SourceFile, Vec<Diagnostic>), String> {
    let bytes = if path.as_os_str() == "-" {
        read_all(io::stdin().lock(), 0)
    } else {
        File::open(path).and_then(|file| {
            let size = file.metadata().map_or(0, |about| about.len());
            read_all(file, size)
        })
    };
    let bytes = bytes.map_err(|error| format!("cannot read {name}: {error}"))?;
    let too_large = |_| format!("cannot read {name}: it has more than {MAX_FILE_BYTES} bytes");
    SourceFile::from_bytes(name, bytes).map_err(too_large)
}

/// Everything there is, up to one byte more than a file may have. Its size, if that is known, spares a large file from being moved
/// again and again while it is read; what is no plain file may say anything.
fn read_all(reader: impl Read, size: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(size.min(MAX_FILE_BYTES) as usize)?;
    reader.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
