//! A folder with files, and the program at work there.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

use tempfile::TempDir;

/// Everything a scene needs but an object; eighteen lines.
pub(crate) const SETTINGS: &str = "width := 48\nheight := 32\nraydepth := 0\n\
    eyepos_x := 4\neyepos_y := 1\neyepos_z := 0.5\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
    ambient_r := 0.2\nambient_g := 0.2\nambient_b := 1\nambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n\
    *lamp := 4 4 4 1 1 1\n!ball := sphere\n!ball <=\n";

/// A folder of its own.
pub(crate) struct Room(TempDir);

/// How it ended, and what it wrote to standard output and standard error.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Room {
    /// A folder with these files, in folders below where their names say so.
    pub(crate) fn with(files: &[(&str, &str)]) -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        for (name, text) in files {
            room.write(name, text.as_bytes());
        }
        room
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, bytes: &[u8]) {
        fs::create_dir_all(self.path(name).parent().unwrap()).unwrap();
        fs::write(self.path(name), bytes).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// What there is, hidden files included.
    pub(crate) fn entries(&self) -> Vec<String> {
        let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
        let mut entries: Vec<_> = fs::read_dir(self.0.path()).unwrap().map(name).collect();
        entries.sort();
        entries
    }

    /// The program in this folder, with words apart by blanks; nothing that the user set colours its reports.
    pub(crate) fn command(&self, arguments: &str) -> Command {
        command_in(self.0.path(), arguments)
    }

    /// The same, which hears Ctrl-C even if a shell has made this test deaf to it: what is deaf stays deaf.
    #[cfg(target_os = "linux")]
    pub(crate) fn hearing(&self, arguments: &str) -> Command {
        let mut command = Command::new("env");
        command.args(["--default-signal=INT,HUP,TERM", env!("CARGO_BIN_EXE_scenec")]);
        prepared(command, self.0.path(), arguments)
    }

    pub(crate) fn run(&self, arguments: &str) -> Ran {
        self.feed(arguments, b"")
    }

    /// The same, with bytes on standard input.
    pub(crate) fn feed(&self, arguments: &str, bytes: &[u8]) -> Ran {
        feed(self.command(arguments), bytes)
    }
}

pub(crate) fn command_in(folder: &Path, arguments: &str) -> Command {
    prepared(Command::new(env!("CARGO_BIN_EXE_scenec")), folder, arguments)
}

fn prepared(mut command: Command, folder: &Path, arguments: &str) -> Command {
    command
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .env_remove("NO_COLOR")
        .env_remove("CLICOLOR_FORCE")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// Runs a command with bytes on standard input.
pub(crate) fn feed(mut command: Command, bytes: &[u8]) -> Ran {
    let mut child: Child = command.spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    let bytes = bytes.to_owned();
    // A command that never reads its input closes the pipe, and one that writes much waits for its reader.
    let writer = std::thread::spawn(move || {
        let _ = input.write_all(&bytes);
    });
    let output: Output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    let words = |bytes| String::from_utf8(bytes).unwrap();
    Ran {
        code: output.status.code(),
        out: words(output.stdout),
        err: words(output.stderr),
    }
}
