//! A whole file or none: what is written stands under its name only when all of it is there.

use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

use crate::{EncodeError, Encoding, Picture, encode};

/// Writes the picture into a file, whole or not at all; [`write_whole`] says how, and what may stand at `path`.
///
/// # Errors
/// With the path: whatever the encoding refuses, before the disk is touched, and whatever the disk does.
pub fn save(picture: &Picture, path: &Path, encoding: &Encoding) -> Result<(), SaveError> {
    encoding
        .check(picture.width(), picture.height())
        .and_then(|()| write_whole(path, |out| encode(picture, encoding, out)))
        .map_err(|cause| SaveError {
            path: path.to_owned(),
            cause,
        })
}

/// Writes a file beside its place and moves it there when it is complete: on any failure there is what was there
/// before, and nothing new beside it.
///
/// A file at `path` is replaced; where `path` is a link, the file that it leads to is. A directory is refused. Into what
/// is neither (a pipe, a device) the bytes go as they are, once they are complete. The permissions are those of any new
/// file.
///
/// # Errors
/// Those of `write`, and those of the disk.
pub fn write_whole<E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>,
) -> Result<(), E> {
    let there = fs::metadata(path);
    if there.as_ref().is_ok_and(fs::Metadata::is_dir) {
        return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
    }
    match there {
        Ok(there) if !there.is_file() => pour(path, write),
        Ok(_) => replace(&fs::canonicalize(path)?, write),
        Err(_) => replace(path, write),
    }
}

fn replace<E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>,
) -> Result<(), E> {
    // A bare file name has the empty path as its parent.
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let mut builder = tempfile::Builder::new();
    builder.prefix(".scenec-").suffix(".part");
    // A temporary file is its owner's alone unless it is asked for otherwise. The system takes the process's mask off
    // these bits when it makes the file, as it does for any other.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let part = builder.tempfile_in(folder.unwrap_or(Path::new(".")))?;
    let mut out = BufWriter::new(part.as_file().try_clone()?);
    write(&mut out)?;
    out.flush()?;
    // On the disk before its name is, or a power cut could leave the name with nothing in it.
    out.get_ref().sync_all()?;
    part.persist(path).map_err(|failed| failed.error)?;
    Ok(())
}

fn pour<E: From<io::Error>>(path: &Path, write: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>) -> Result<(), E> {
    // Some formats go back to fill in their header, which a pipe can't.
    let mut out = BufWriter::new(tempfile::tempfile()?);
    write(&mut out)?;
    out.flush()?;
    let mut bytes = out.get_ref();
    bytes.rewind()?;
    io::copy(&mut bytes, &mut OpenOptions::new().write(true).open(path)?)?;
    Ok(())
}

/// A picture that could not be saved, and where.
#[derive(Debug)]
pub struct SaveError {
    /// Where it was to stand.
    pub path: PathBuf,
    /// What went wrong.
    pub cause: EncodeError,
}

impl fmt::Display for SaveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "can't write {}: {}", self.path.display(), self.cause)
    }
}

impl std::error::Error for SaveError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.cause)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::io::{self, Write};
    use std::path::Path;

    use super::{save, write_whole};
    use crate::{Encoding, Format, Picture, load};

    fn entries(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    /// Saving fails, says this, and changes nothing in the folder.
    fn check(folder: &Path, path: &Path, encoding: &Encoding, picture: &Picture, expect: &str) {
        let before = entries(folder);
        let error = save(picture, path, encoding).unwrap_err().to_string();
        assert!(error.contains(expect), "{error}");
        assert!(error.contains(&path.display().to_string()), "{error}");
        assert_eq!(entries(folder), before);
    }

    #[test]
    fn a_failure_leaves_what_was_there_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let old = folder.join("old.jpg");
        fs::write(&old, "old").unwrap();
        let (small, png) = (Picture::black(1, 1).unwrap(), Encoding::of(Format::PNG));
        let wide = Picture::black(65536, 1).unwrap();
        let jpeg = Encoding::of(Format::from_path(&old).unwrap());
        check(folder, &old, &jpeg, &wide, "at most 65535");
        check(folder, folder, &png, &small, "directory");
        check(folder, &folder.join("none/a.png"), &png, &small, "No such file");
        check(folder, &old.join("a.png"), &png, &small, "Not a directory");
        let halfway = write_whole(&old, |out| {
            out.write_all(&[7; 100_000])?;
            Err(io::Error::from(io::ErrorKind::StorageFull))
        });
        assert_eq!(halfway.unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(fs::read(&old).unwrap(), b"old");
        assert_eq!(entries(folder), 1);
    }

    #[test]
    fn a_saved_picture_takes_the_place_of_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let mut picture = Picture::black(17, 13).unwrap();
        picture.pixels_mut()[20] = [0.25, -3.0, 1e9];
        let path = folder.path().join("a.pfm");
        let encoding = Encoding::of(Format::from_path(&path).unwrap());
        for _ in 0..2 {
            save(&picture, &path, &encoding).unwrap();
            assert_eq!(load(&path).unwrap(), picture);
            assert_eq!(entries(folder.path()), 1);
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_saved_file_has_the_permissions_of_any_other_and_links_stay_links() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let [any, real, link] = ["any", "real.png", "link.png"].map(|name| folder.path().join(name));
        fs::write(&any, "").unwrap();
        let (picture, png) = (Picture::black(1, 1).unwrap(), Encoding::of(Format::PNG));
        save(&picture, &real, &png).unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&real), mode(&any));
        fs::write(&real, "").unwrap();
        symlink(&real, &link).unwrap();
        save(&picture, &link, &png).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(load(&real).unwrap(), picture);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_are_written_to_and_never_replaced() {
        let (picture, png) = (Picture::black(1, 1).unwrap(), Encoding::of(Format::PNG));
        save(&picture, Path::new("/dev/null"), &png).unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
        let full = save(&picture, Path::new("/dev/full"), &png).unwrap_err();
        assert!(full.to_string().contains("No space"), "{full}");
    }
}
