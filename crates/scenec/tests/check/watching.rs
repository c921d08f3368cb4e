//! `--watch`: once more after every change, until Ctrl-C.

#![cfg(unix)]

use std::io::{BufRead, BufReader};
use std::process::Command;

use crate::room::{Room, SETTINGS};

#[test]
fn a_change_is_checked_and_ctrl_c_ends_with_130() {
    let room = Room::with(&[("a.scene", SETTINGS)]);
    let mut child = room.hearing("check --watch --output-format concise").spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut next = || lines.next().unwrap().unwrap();
    assert_eq!(next(), "1 file: no problems");
    room.write("a.scene", format!("{SETTINGS}5\n").as_bytes());
    assert!(next().starts_with("a.scene:19:1: error[E005]"));
    assert_eq!(next(), "1 error in 1 file");
    room.write("sub/b.scene", SETTINGS.as_bytes());
    assert!(next().starts_with("a.scene:19:1: error[E005]"));
    assert_eq!(next(), "1 error in 2 files");
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &pid]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
}
