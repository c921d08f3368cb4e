//! `scenec bench`: what is written, exit codes, and Ctrl-C.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use scenec_picture::load;
use tempfile::TempDir;

const SCENE: &str = "width := 300\nheight := 200\nraydepth := 1\neyepos_x := 0\neyepos_y := 0\neyepos_z := 4\n\
    lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := 1\nambient_g := 1\nambient_b := 1\n\
    ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n!a := sphere\n!a <=\n";

struct Room(TempDir);

impl Room {
    fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        fs::write(room.path("a.scene"), SCENE).unwrap();
        fs::write(room.path("bad.scene"), format!("{SCENE}!b := cube\n")).unwrap();
        room
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &str) -> Command {
        // A shell may have made this test deaf to Ctrl-C, and what is deaf stays deaf.
        let mut command = Command::new("env");
        command.args(["--default-signal=INT,HUP,TERM", env!("CARGO_BIN_EXE_scenec"), "bench"]);
        command
            .args(arguments.split_whitespace())
            .args(["--cache", "kept", "--device", "none"]);
        command
            .current_dir(self.0.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    /// It ends with this code, and these words are among what it says.
    fn check(&self, arguments: &str, code: i32, words: &[&str]) {
        let ran = self.command(arguments).output().unwrap();
        let said = String::from_utf8([ran.stdout, ran.stderr].concat()).unwrap();
        assert_eq!(ran.status.code(), Some(code), "{arguments}: {said}");
        for words in words {
            assert!(said.contains(words), "{arguments}: {words}: {said}");
        }
    }
}

#[test]
fn a_table_a_page_and_diagrams_are_written() {
    let room = Room::new();
    let words = [
        "a.scene: 12 x 8, 14 rows, reference of 256 samples, its own",
        "wrote out/wp.svg, out/wp.png, out/report.csv",
    ];
    room.check("a.scene -o out --quick --size 12x8 --heat", 0, &words);
    let read = |name: &str| fs::read_to_string(room.path(name)).unwrap();
    assert_eq!(read("out/report.csv").lines().count(), 15);
    assert!(read("out/report.md").contains("![work and precision](wp.svg)"));
    assert!(read("out/wp.svg").starts_with("<svg"));
    assert_eq!(load(&room.path("out/wp.png")).unwrap().width(), 1200);
    assert_eq!(load(&room.path("out/heat-1-14.png")).unwrap().width(), 12);
    // The second time the reference is there.
    room.check(
        "a.scene a.scene -o out --quick --size 12x8",
        0,
        &["256 samples (kept), ", "out/wp-2.svg"],
    );
}

#[test]
fn what_cannot_be_measured_is_refused_before_anything_is() {
    let room = Room::new();
    room.check("bad.scene -o out", 1, &["E008"]);
    room.check("none.scene -o out", 2, &["cannot read none.scene"]);
    room.check("- -o out", 2, &["a bench needs files"]);
    room.check("a.scene -o a.scene", 2, &["cannot write a.scene"]);
    room.check("a.scene -o out --quick --full", 2, &["cannot be used with"]);
    assert!(!room.path("out/report.csv").exists());
}

#[test]
fn without_pov_ray_nobody_asks_it() {
    let room = Room::new();
    let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
    command.args(["bench", "--stability", "--povray", "--device", "none"]);
    let ran = command.env("PATH", "").current_dir(room.0.path()).output().unwrap();
    let said = String::from_utf8_lossy(&ran.stderr);
    assert_eq!(ran.status.code(), Some(2), "{said}");
    assert!(said.contains("there is no `povray` on the path"), "{said}");
    assert!(ran.stdout.is_empty());
}

#[cfg(target_os = "linux")]
#[test]
fn a_bench_that_is_stopped_writes_nothing() {
    let room = Room::new();
    let child = room.command("a.scene -o out --full").spawn().unwrap();
    // It listens before it makes its folder, and has work for a long time after that.
    while !room.path("out").exists() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let mut kill = Command::new("kill");
    assert!(kill.args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(
        ended.status.code(),
        Some(130),
        "{}",
        String::from_utf8_lossy(&ended.stderr)
    );
    assert_eq!(fs::read_dir(room.path("out")).unwrap().count(), 0);
}
