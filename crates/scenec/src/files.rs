//! Which files a command is about: those that are named, and the scenes below folders that are named.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use ignore::{DirEntry, Walk, WalkBuilder};
use scenec_text::{Diagnostic, SourceFile};

use crate::input;

/// The extensions of scene files.
const EXTENSIONS: [&str; 2] = ["scene", "rti"];

/// How many files of any kind are soon looked at.
const SOON: usize = 20_000;

/// A file to be read, or standard input where the path is `-`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Input {
    pub(crate) path: PathBuf,
    /// What reports call it.
    pub(crate) name: String,
}

/// Arguments about which files a command is about.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct FileOptions {
    /// Files, and folders to look for *.scene and *.rti in; `-` reads standard input; without any, the current folder
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// What standard input is called in reports, and which file's scenec.toml holds for it
    #[arg(long, value_name = "NAME")]
    stdin_filename: Option<PathBuf>,
}

/// What the arguments stand for.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Inputs {
    /// In the order of the arguments, those of a folder by name; no file twice.
    pub(crate) files: Vec<Input>,
    /// What could not be looked into, in sentences for the user.
    pub(crate) failures: Vec<String>,
}

impl FileOptions {
    /// Whether standard input is read.
    pub(crate) fn standard(&self) -> bool {
        self.paths.iter().any(|path| path.as_os_str() == "-")
            || (self.paths.is_empty() && self.stdin_filename.is_some())
    }

    /// Whether the arguments are about one file, by its name.
    pub(crate) fn is_one_file(&self) -> bool {
        match self.paths.as_slice() {
            [] => self.standard(),
            [one] => !is_folder(one),
            _ => false,
        }
    }

    /// The files that there are now.
    pub(crate) fn find(&self) -> Inputs {
        let mut inputs = Inputs::default();
        let mut seen = HashSet::new();
        let default = [PathBuf::from(if self.standard() { "-" } else { "." })];
        let paths = if self.paths.is_empty() {
            default.as_slice()
        } else {
            &self.paths
        };
        for path in paths {
            if is_folder(path) {
                below(path, &mut inputs, &mut seen);
            } else {
                self.add(path, &mut inputs, &mut seen);
            }
        }
        inputs
    }

    fn add(&self, path: &Path, inputs: &mut Inputs, seen: &mut HashSet<PathBuf>) {
        if path.as_os_str() != "-" {
            return push(path, inputs, seen);
        }
        if seen.insert(path.to_owned()) {
            let name = match &self.stdin_filename {
                Some(name) => name.display().to_string(),
                None => "<stdin>".to_owned(),
            };
            let path = path.to_owned();
            inputs.files.push(Input { path, name });
        }
    }

    /// The file whose configuration holds for an input.
    pub(crate) fn place<'a>(&'a self, input: &'a Input) -> &'a Path {
        match &self.stdin_filename {
            Some(name) if input.is_standard() => name,
            _ => &input.path,
        }
    }
}

impl Input {
    pub(crate) fn is_standard(&self) -> bool {
        self.path.as_os_str() == "-"
    }

    /// Reads it, with a finding for each run of bytes that is no UTF-8.
    ///
    /// # Errors
    /// A sentence for the user.
    pub(crate) fn read(&self) -> Result<(SourceFile, Vec<Diagnostic>), String> {
        input::read_as(&self.path, &self.name)
    }
}

fn is_folder(path: &Path) -> bool {
    path.as_os_str() != "-" && fs::metadata(path).is_ok_and(|there| there.is_dir())
}

fn push(path: &Path, inputs: &mut Inputs, seen: &mut HashSet<PathBuf>) {
    let shown = path.strip_prefix(".").unwrap_or(path);
    if seen.insert(shown.to_owned()) {
        inputs.files.push(Input {
            path: path.to_owned(),
            name: shown.display().to_string(),
        });
    }
}

/// All that lies below a folder and that no `.gitignore` leaves out, hidden files aside.
fn walk(folder: &Path) -> Walk {
    // A folder that was copied out of its repository still has its ignore files.
    WalkBuilder::new(folder).require_git(false).build()
}

/// The path of a scene file; `None` for anything else, links among it.
fn scene(entry: DirEntry) -> Option<PathBuf> {
    let extension = entry.path().extension().unwrap_or_default();
    let is_scene = entry.file_type().is_some_and(|kind| kind.is_file())
        && EXTENSIONS.iter().any(|known| extension.eq_ignore_ascii_case(known));
    is_scene.then(|| entry.into_path())
}

/// The scenes below a folder, for somebody who can't wait: of a large folder only those that are soon found, and nothing of
/// what can't be looked into.
pub(crate) fn scenes_soon_found(folder: &Path) -> Vec<PathBuf> {
    let entries = walk(folder).take(SOON);
    let mut found: Vec<PathBuf> = entries.filter_map(|entry| scene(entry.ok()?)).collect();
    found.sort();
    found
}

/// The scenes below a folder that no `.gitignore` leaves out, hidden ones and links aside.
fn below(folder: &Path, inputs: &mut Inputs, seen: &mut HashSet<PathBuf>) {
    let mut found = Vec::new();
    for entry in walk(folder) {
        match entry {
            Ok(entry) => found.extend(scene(entry)),
            Err(error) => inputs
                .failures
                .push(format!("cannot look through {}: {error}", folder.display())),
        }
    }
    found.sort();
    for path in &found {
        push(path, inputs, seen);
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};

    use super::FileOptions;

    fn check(root: &Path, paths: &[&str], expect: &[&str]) {
        let options = FileOptions {
            paths: paths.iter().map(|path| root.join(path)).collect(),
            stdin_filename: None,
        };
        let found: Vec<PathBuf> = options.find().files.into_iter().map(|input| input.path).collect();
        let expect: Vec<PathBuf> = expect.iter().map(|path| root.join(path)).collect();
        assert_eq!(found, expect, "{paths:?}");
    }

    #[test]
    fn folders_give_the_scenes_that_no_ignore_file_leaves_out() {
        let root = tempfile::tempdir().unwrap();
        let root = root.path();
        fs::create_dir_all(root.join("b/out")).unwrap();
        for file in [
            "c.scene",
            "a.RTI",
            "n.txt",
            "b/x.scene",
            "b/out/y.scene",
            "b/z.scene",
            ".h.scene",
        ] {
            fs::write(root.join(file), "").unwrap();
        }
        fs::write(root.join("b/.gitignore"), "out/\nz.*\n").unwrap();
        check(root, &["."], &["./a.RTI", "./b/x.scene", "./c.scene"]);
        check(root, &["b", "b/z.scene", "b"], &["b/x.scene", "b/z.scene"]);
        check(root, &["n.txt", "none.scene"], &["n.txt", "none.scene"]);
    }

    #[test]
    fn standard_input_may_have_a_name() {
        let options = |paths: &[&str], name: Option<&str>| FileOptions {
            paths: paths.iter().map(PathBuf::from).collect(),
            stdin_filename: name.map(PathBuf::from),
        };
        let names = |options: FileOptions| {
            options
                .find()
                .files
                .into_iter()
                .map(|input| input.name)
                .collect::<Vec<_>>()
        };
        assert_eq!(names(options(&["-", "x", "-", "./x"], None)), ["<stdin>", "x"]);
        assert_eq!(names(options(&["-"], Some("a.scene"))), ["a.scene"]);
        assert_eq!(names(options(&[], Some("a.scene"))), ["a.scene"]);
    }
}
