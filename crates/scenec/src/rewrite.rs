//! New words for a file that is there: whole or not at all, and still the same file to everybody else.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use crate::interrupt::while_writing;

/// Replaces what is in a file. It keeps its permissions; where the path is a link, the file that it leads to changes.
///
/// # Errors
/// A sentence for the user: the file may not be written, or the disk fails. Then it is as it was.
pub(crate) fn rewrite(path: &Path, text: &str) -> Result<(), String> {
    while_writing(|| replace(path, text)).map_err(|error| format!("cannot write {}: {error}", path.display()))
}

fn replace(path: &Path, text: &str) -> io::Result<()> {
    let path = fs::canonicalize(path)?;
    let there = fs::metadata(&path)?;
    if !there.is_file() {
        return Err(io::Error::other("it is no regular file"));
    }
    // Moving another file into its place would succeed all the same.
    if there.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "it is read-only"));
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut part = tempfile::Builder::new()
        .prefix(".scenec-")
        .suffix(".part")
        .tempfile_in(folder)?;
    part.write_all(text.as_bytes())?;
    part.as_file().set_permissions(there.permissions())?;
    part.as_file().sync_all()?;
    part.persist(&path).map_err(|failed| failed.error)?;
    Ok(())
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use std::fs;
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::path::Path;

    use super::rewrite;

    /// Rewriting the path fails with these words and leaves nothing beside it.
    fn check(path: &Path, words: &str) {
        let entries = || fs::read_dir(path.parent().unwrap()).unwrap().count();
        let before = entries();
        let error = rewrite(path, "new").unwrap_err();
        assert!(error.starts_with("cannot write ") && error.contains(words), "{error}");
        assert_eq!(entries(), before);
    }

    #[test]
    fn a_file_keeps_its_permissions_and_a_link_its_target() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["a.scene", "b.scene"].map(|name| folder.path().join(name));
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&file, &link).unwrap();
        rewrite(&link, "new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    }

    #[test]
    fn what_may_not_be_written_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.scene");
        check(&file, "No such file");
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
        check(&file, "it is read-only");
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        fs::create_dir(folder.path().join("d")).unwrap();
        check(&folder.path().join("d"), "it is no regular file");
    }
}
