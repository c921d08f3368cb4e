//! A folder to render in, and the program at work there.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use scenec_picture::{Picture, load};
use tempfile::TempDir;

/// A mirror, a light and a bitten ball: every option changes the picture.
pub(crate) const SCENE: &str = "width := 48\nheight := 32\nraydepth := 3\n\
    eyepos_x := 4\neyepos_y := 1\neyepos_z := 0.5\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
    ambient_r := 0.2\nambient_g := 0.2\nambient_b := 1\nambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n\
    ?shiny := 0.1 0.5 0.3 0.4 0 1 4 0.3 0.8 0.3\n\
    !a := sphere\n!a ?= shiny\n!a += 0 0.5 0\n!b := sphere\n!b += 1 0.9 0\n!ball := a - b\n\
    !floor := hp\n!floor ?= shiny\n!floor += 0 -0.5 0\n!all := ball | floor\n!all <=\n\
    *sun := 3 4 1 1 1 1\n";

/// A folder with `good.scene` and `bad.scene` in it.
pub(crate) struct Room(TempDir);

/// How it ended, and what it wrote to standard output and standard error.
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) out: Vec<u8>,
    pub(crate) words: String,
}

impl Room {
    pub(crate) fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        fs::write(room.path("good.scene"), SCENE).unwrap();
        fs::write(room.path("bad.scene"), format!("!x := cube\n{SCENE}")).unwrap();
        room
    }

    pub(crate) fn folder(&self) -> &Path {
        self.0.path()
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    /// What there is besides the scenes.
    pub(crate) fn made(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder()).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.filter(|name| !name.ends_with(".scene")).collect()
    }

    /// `scenec render` in this folder, with words apart by blanks.
    pub(crate) fn command(&self, arguments: &str) -> Command {
        self.command_through(&[], arguments)
    }

    /// The same, run by another program.
    pub(crate) fn command_through(&self, program: &[&str], arguments: &str) -> Command {
        let own = [env!("CARGO_BIN_EXE_scenec"), "render"];
        let mut words = program.iter().copied().chain(own).chain(arguments.split_whitespace());
        let mut command = Command::new(words.next().unwrap());
        command.current_dir(self.folder()).args(words);
        // What this machine's user keeps is no part of a test.
        command.env("SCENEC_CACHE_DIR", "off");
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    pub(crate) fn run(&self, arguments: &str) -> Ran {
        ran(self.command(arguments).spawn().unwrap(), "")
    }

    /// Runs where there is no OpenCL.
    pub(crate) fn run_bare(&self, arguments: &str) -> Ran {
        let mut command = self.command(arguments);
        command
            .env("OCL_ICD_VENDORS", "/nonexistent")
            .env_remove("OCL_ICD_FILENAMES");
        ran(command.spawn().unwrap(), "")
    }

    /// The picture that `good.scene` becomes.
    pub(crate) fn picture(&self, arguments: &str) -> Picture {
        let ran = self.run(&format!("good.scene -o picture.pfm {arguments}"));
        assert_eq!(ran.code, Some(0), "{arguments}: {}", ran.words);
        load(&self.path("picture.pfm")).unwrap()
    }

    /// The arguments fail with this code and these words; what was there stays, and nothing is new.
    pub(crate) fn check(&self, arguments: &str, code: i32, expect: &str) {
        let old = self.path("old.png");
        fs::write(&old, "old").unwrap();
        let ran = self.run_bare(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {}", ran.words);
        assert!(ran.words.contains(expect), "{arguments}: {}", ran.words);
        assert!(ran.out.is_empty(), "{arguments}: something on standard output");
        assert_eq!(fs::read(&old).unwrap(), b"old", "{arguments}");
        assert_eq!(self.made(), ["old.png"], "{arguments}");
    }
}

/// Feeds the program and waits for it.
pub(crate) fn ran(mut child: Child, input: &str) -> Ran {
    let mut stdin = child.stdin.take().unwrap();
    // A program that fails early reads nothing.
    stdin.write_all(input.as_bytes()).unwrap_or_default();
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    Ran {
        code: output.status.code(),
        out: output.stdout,
        words: String::from_utf8(output.stderr).unwrap(),
    }
}
