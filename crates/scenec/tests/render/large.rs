//! Pictures that no memory holds.

use std::fs;
use std::io::Write;
use std::process::Command;
use std::thread;
use std::time::Duration;

use crate::room::{Room, SCENE};

#[test]
fn what_can_be_neither_held_nor_streamed_is_refused_with_the_figure() {
    let room = Room::new();
    for place in ["-o new.png", "-o - --format ppm"] {
        let arguments = format!("good.scene {place} --size 65535x65535 --device cpu");
        room.check(
            &arguments,
            2,
            "a picture of 65535 x 65535 pixels takes 48.0 GiB; at most 3 GiB are held at once",
        );
        room.check(&arguments, 2, "a file of ppm, pfm, hdr, raw is written piece by piece");
    }
}

/// The largest picture begins to be written, in little memory; told to stop, it leaves nothing.
fn check(device: &str) {
    let room = Room::new();
    if room.run(&format!("good.scene -o probe.ppm --device {device}")).code != Some(0) {
        return;
    }
    fs::remove_file(room.path("probe.ppm")).unwrap();
    let listening = ["env", "--default-signal=INT,TERM,HUP"];
    let arguments = format!("- -o large.ppm --size 65535x65535 --raydepth 0 --device {device}");
    let mut child = room.command_through(&listening, &arguments).spawn().unwrap();
    child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
    let part = || {
        let made = room.made();
        made.first()
            .map_or(0, |name| fs::metadata(room.path(name)).map_or(0, |about| about.len()))
    };
    let mut waited = 0;
    while part() < 1 << 20 && waited < 3000 {
        thread::sleep(Duration::from_millis(20));
        waited += 1;
    }
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
    let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    let kilobytes: u64 = most.trim().trim_end_matches(" kB").parse().unwrap();
    assert!(kilobytes < 1 << 20, "{most}");
    let mut kill = Command::new("kill");
    assert!(kill.args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let words = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), room.made()), (Some(130), Vec::new()), "{words}");
    assert!(words.contains("stopped before the picture was complete"), "{words}");
}

#[test]
fn the_largest_picture_is_streamed_and_stopped() {
    check("cpu");
    check("opencl");
}
