//! `scenec plan`: what it says of a scene, in words and as an object.

#![allow(clippy::unwrap_used, reason = "a test may, in its helpers too")]

use std::io::Write;
use std::process::{Command, Stdio};

/// Two balls that are one, a ball that is not submitted, a bitten ball, and a floor.
const SCENE: &str = "width := 64\nheight := 48\nraydepth := 2\n\
    eyepos_x := 4\neyepos_y := 1\neyepos_z := 0.5\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
    ambient_r := 0.2\nambient_g := 0.2\nambient_b := 1\nambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n\
    ?shiny := 0.1 0.5 0.3 0.4 0 1 4 0.3 0.8 0.3\n\
    !a := sphere\n!a ?= shiny\n!a += 0 0.5 0\n!b := sphere\n!b += 1 0.9 0\n!ball := a - b\n\
    !floor := hp\n!floor += 0 -0.5 0\n!c := sphere\n!c += 0 0 3\n!d := sphere\n!d += 0 0 3\n!lost := sphere\n\
    !two := c | d\n!some := ball | two\n!all := some | floor\n!all <=\n*sun := 3 4 1 1 1 1\n";

/// How it ended, and what it wrote to standard output and standard error.
fn plan(arguments: &str) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
    command.arg("plan").args(arguments.split_whitespace());
    command
        .env("OCL_ICD_VENDORS", "/nonexistent")
        .env_remove("OCL_ICD_FILENAMES");
    let pipe = Stdio::piped;
    let mut child = command.stdin(pipe()).stdout(pipe()).stderr(pipe()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // A program that fails early reads nothing.
    stdin.write_all(SCENE.as_bytes()).unwrap_or_default();
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// What a scene is planned to; times aside, which are never the same.
fn check(arguments: &str) -> String {
    let (code, out, words) = plan(arguments);
    assert_eq!(code, Some(0), "{arguments}: {words}");
    let timeless = |line: &str| match line.split_once("\"milliseconds\": ") {
        Some((before, _)) => format!("{before}\"milliseconds\": ..."),
        None => match (line.split_once("about "), line.split_once(" ms on")) {
            (Some((before, _)), Some((_, after))) => format!("{before}about ... ms on{after}"),
            _ => line.to_owned(),
        },
    };
    out.lines().map(timeless).collect::<Vec<_>>().join("\n")
}

#[test]
fn people_are_told_what_is_kept_and_left_out_and_why() {
    insta::assert_snapshot!("text", check("- -q"));
}

#[test]
fn programs_are_told_the_same() {
    let object = check("- -q --output-format json --size 128x96 --samples 4 --device cpu");
    insta::assert_snapshot!("json", object);
}

#[test]
fn the_kernels_are_printed_as_they_would_be_compiled() {
    let (code, out, _) = plan("- -q --emit-kernel");
    assert_eq!(code, Some(0));
    for line in [
        "typedef float real;",
        "#define BALLS 1",
        "#define REFRACTIONS 0",
        "#line 1 \"trace.cl\"",
    ] {
        assert!(out.lines().any(|one| one == line), "{line}: {out}");
    }
    let (_, doubles, _) = plan("- -q --emit-kernel --precision f64");
    assert!(doubles.contains("typedef double real;"), "{doubles}");
}

#[test]
fn what_cannot_be_planned_ends_in_words() {
    for (arguments, code, expect) in [
        ("none.scene", 2, "none.scene"),
        ("- --crop 60,0,10,1", 2, "reaches beyond the picture"),
        ("- --device opencl", 3, "there is no OpenCL device"),
        ("- --emit-kernel --output-format json", 2, "cannot be used with"),
    ] {
        let (ended, out, words) = plan(arguments);
        assert_eq!((ended, out.as_str()), (Some(code), ""), "{arguments}: {words}");
        assert!(words.contains(expect), "{arguments}: {words}");
    }
}
