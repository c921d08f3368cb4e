//! `scenec devices`, on whatever the machine has and on a machine without OpenCL.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::process::Command;

/// The listing begins with these words, line by line, and has a line that ends in `last`.
fn check(drivers: Option<&str>, expect: &[&str], last: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
    command.arg("devices");
    if let Some(folder) = drivers {
        command.env("OCL_ICD_VENDORS", folder).env_remove("OCL_ICD_FILENAMES");
    }
    let output = command.output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    for (line, start) in text.lines().zip(expect) {
        assert!(line.starts_with(start), "{start}: {text}");
    }
    assert!(text.lines().last().unwrap().ends_with(last), "{last}: {text}");
    text
}

#[test]
fn the_built_in_tracers_are_always_there() {
    check(None, &["DEVICE ", "cpu ", "reference "], "");
}

#[test]
fn a_machine_without_opencl_says_why() {
    let text = check(
        Some("/nonexistent"),
        &["DEVICE ", "cpu ", "reference ", ""],
        "takes cpu",
    );
    assert!(text.contains("\nnote: "), "{text}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_listing_that_cannot_be_written_is_a_failure() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
    let output = command.arg("devices").stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let words = String::from_utf8(output.stderr).unwrap();
    assert!(words.starts_with("error: cannot write <stdout>"), "{words}");
}
