//! Ctrl-C.

use std::io::Write;
use std::process::{Child, Command};
use std::time::Duration;
use std::{fs, thread};

use crate::room::{Room, SCENE};

fn interrupt(child: &Child) {
    let mut kill = Command::new("kill");
    assert!(kill.args(["-INT", &child.id().to_string()]).status().unwrap().success());
}

/// Waits until the program catches Ctrl-C, which it does once it begins to trace.
fn wait_for_the_handler(child: &Child) {
    let status = format!("/proc/{}/status", child.id());
    for _ in 0..600 {
        let status = fs::read_to_string(&status).unwrap_or_default();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        let mask = caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        if mask.is_some_and(|mask| mask & 0b10 != 0) {
            return;
        }
        thread::sleep(Duration::from_millis(20));
    }
    panic!("the program never set a handler");
}

/// Renders until it is interrupted so many times, and returns what it said.
fn interrupted(room: &Room, arguments: &str, times: u32) -> String {
    // A shell may have made this test deaf to Ctrl-C, and what is deaf stays deaf.
    let listening = ["env", "--default-signal=INT,TERM,HUP"];
    let mut command = room.command_through(&listening, &format!("- {arguments}"));
    let mut child = command.spawn().unwrap();
    // The scene comes through the pipe: the handler is set once it has ended.
    child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
    wait_for_the_handler(&child);
    for _ in 0..times {
        thread::sleep(Duration::from_millis(200));
        interrupt(&child);
    }
    let output = child.wait_with_output().unwrap();
    let words = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(130), "{arguments}: {words}");
    words
}

fn check(arguments: &str, times: u32) {
    let room = Room::new();
    fs::write(room.path("old.png"), "old").unwrap();
    let words = interrupted(&room, &format!("-o old.png {arguments}"), times);
    assert_eq!(fs::read(room.path("old.png")).unwrap(), b"old");
    assert_eq!(room.made(), ["old.png"]);
    assert!(
        times > 1 || words.contains("stopped before the picture was complete"),
        "{words}"
    );
}

#[test]
fn ctrl_c_leaves_nothing_behind() {
    check("--size 4000x4000 --samples 4 --device cpu", 1);
    check("--size 4000x4000 --samples 4096 --device reference", 1);
}

#[test]
fn a_second_ctrl_c_does_not_wait() {
    check("--size 4000x4000 --samples 4096 --raydepth 1024 --device cpu", 2);
}

#[test]
fn a_pipe_that_nobody_reads_is_given_up() {
    let room = Room::new();
    let mut make = Command::new("mkfifo");
    assert!(make.arg(room.path("pipe.png")).status().unwrap().success());
    interrupted(&room, "-o pipe.png --device cpu", 2);
}
