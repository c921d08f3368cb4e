//! Devices that are there, and devices that are not.

use std::process::Command;

use scenec_picture::load;

use crate::room::{Room, ran};

#[test]
fn a_device_that_is_not_there_is_a_failure_and_auto_does_without() {
    let room = Room::new();
    for (device, place) in [
        ("opencl", "old.png"),
        ("opencl:0", "new.png"),
        ("opencl:strange", "old.png"),
    ] {
        let arguments = format!("good.scene -o {place} --device {device}");
        room.check(&arguments, 3, "there is no OpenCL device: ");
    }
    let auto = room.run_bare("good.scene -o new.png");
    assert_eq!(auto.code, Some(0), "{}", auto.words);
    assert_eq!(auto.words.lines().count(), 1, "{}", auto.words);
    assert!(
        auto.words.starts_with("wrote new.png: 48 x 32, cpu f32, "),
        "{}",
        auto.words
    );
}

#[test]
fn an_opencl_device_renders_or_says_why_not() {
    let room = Room::new();
    let ran = room.run("good.scene -o new.png --device opencl");
    match ran.code {
        Some(0) => assert!(load(&room.path("new.png")).is_ok()),
        code => assert_eq!((code, room.made()), (Some(3), Vec::new()), "{}", ran.words),
    }
}

/// A simulator passes for a GPU that can't compile the kernels: one word in them means something else to it.
#[cfg(target_os = "linux")]
#[test]
fn a_gpu_that_fails_is_replaced_unless_it_was_asked_for() {
    if Command::new("oclgrind").arg("--version").output().is_err() {
        return;
    }
    let room = Room::new();
    let simulator = ["oclgrind", "--build-options", "-Dreal=,"];
    let run = |arguments| ran(room.command_through(&simulator, arguments).spawn().unwrap(), "");
    let named = run("good.scene -o new.png --device opencl");
    assert_eq!((named.code, room.made()), (Some(3), Vec::new()), "{}", named.words);
    assert!(named.words.contains("\nerror: "), "{}", named.words);

    // A short while is not worth a device.
    let short = run("good.scene -o short.png");
    assert_eq!(
        (short.code, short.words.lines().count()),
        (Some(0), 1),
        "{}",
        short.words
    );
    let auto = run("good.scene -o new.png --size 1600x1000 --samples 8 --threads 1");
    assert_eq!(auto.code, Some(0), "{}", auto.words);
    let mut lines = auto.words.lines().skip_while(|line| !line.starts_with("warning: "));
    assert!(
        lines.next().is_some_and(|line| line.contains("so the cpu takes over")),
        "{}",
        auto.words
    );
    assert!(
        lines.next().is_some_and(|line| line.starts_with("wrote new.png: ")),
        "{}",
        auto.words
    );
}
