//! `scenec render`: exit codes, what is written, and what is left alone.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};

use scenec_picture::{Format, Picture, load, load_raw};
use tempfile::TempDir;

/// A mirror, a light and a bitten ball: every option changes the picture.
const SCENE: &str = "width := 48\nheight := 32\nraydepth := 3\n\
    eyepos_x := 4\neyepos_y := 1\neyepos_z := 0.5\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
    ambient_r := 0.2\nambient_g := 0.2\nambient_b := 1\nambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n\
    ?shiny := 0.1 0.5 0.3 0.4 0 1 4 0.3 0.8 0.3\n\
    !a := sphere\n!a ?= shiny\n!a += 0 0.5 0\n!b := sphere\n!b += 1 0.9 0\n!ball := a - b\n\
    !floor := hp\n!floor ?= shiny\n!floor += 0 -0.5 0\n!all := ball | floor\n!all <=\n\
    *sun := 3 4 1 1 1 1\n";

/// A folder with `good.scene` and `bad.scene` in it.
struct Room(TempDir);

struct Ran {
    code: Option<i32>,
    out: Vec<u8>,
    words: String,
}

impl Room {
    fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        fs::write(room.path("good.scene"), SCENE).unwrap();
        fs::write(room.path("bad.scene"), format!("!x := cube\n{SCENE}")).unwrap();
        room
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// What there is besides the scenes.
    fn made(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.filter(|name| !name.ends_with(".scene")).collect()
    }

    /// `scenec render` in this folder, with words apart by blanks.
    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
        command.current_dir(self.0.path()).arg("render");
        command.args(arguments.split_whitespace());
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    fn run(&self, arguments: &str) -> Ran {
        ran(self.command(arguments).spawn().unwrap(), "")
    }

    /// Runs where there is no OpenCL.
    fn run_bare(&self, arguments: &str) -> Ran {
        let mut command = self.command(arguments);
        command
            .env("OCL_ICD_VENDORS", "/nonexistent")
            .env_remove("OCL_ICD_FILENAMES");
        ran(command.spawn().unwrap(), "")
    }

    /// The picture that `good.scene` becomes.
    fn picture(&self, arguments: &str) -> Picture {
        let ran = self.run(&format!("good.scene -o picture.pfm {arguments}"));
        assert_eq!(ran.code, Some(0), "{arguments}: {}", ran.words);
        load(&self.path("picture.pfm")).unwrap()
    }

    /// The arguments fail with this code and these words; what was there stays, and nothing is new.
    fn check(&self, arguments: &str, code: i32, expect: &str) {
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

fn ran(mut child: Child, input: &str) -> Ran {
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

#[test]
fn a_file_with_errors_renders_nothing() {
    let room = Room::new();
    room.check("bad.scene -o new.png", 1, "E008");
    room.check("bad.scene -o old.png", 1, "1 error in bad.scene");
    room.check("bad.scene -o old.png --quiet", 1, "E008");
    room.check("bad.scene -o - --format png", 1, "E008");
}

#[test]
fn what_cannot_be_read_or_written_is_known_beforehand() {
    let room = Room::new();
    room.check("none.scene -o new.png", 2, "cannot read none.scene");
    room.check(". -o new.png", 2, "cannot read .:");
    room.check("good.scene -o none/new.png", 2, "cannot write none/new.png");
    room.check("good.scene -o good.scene/new.png", 2, "cannot write good.scene/new.png");
    room.check("good.scene -o . --format png", 2, "cannot write .: is a directory");
    room.check("good.scene -o good.scene --format png", 2, "it is the scene itself");
    room.check("good.scene -o new.gif", 2, "png, jpg, jpeg, bmp");
    room.check("good.scene -o new", 2, "--format");
    room.check("good.scene -o -", 2, "--format says what to write: png, jpeg");
    // Errors in the file come after those in the arguments: the cheaper ones first.
    room.check("bad.scene -o new.gif", 2, "the extension of new.gif");
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_files_is_known_beforehand() {
    let room = Room::new();
    room.check("good.scene -o /proc/new.png", 2, "cannot write /proc/new.png");
    room.check("good.scene -o /dev/full --format png", 2, "No space");
    let mut command = room.command("good.scene -o - --format png --device cpu");
    command.stdout(fs::OpenOptions::new().write(true).open("/dev/full").unwrap());
    let full = ran(command.spawn().unwrap(), "");
    assert_eq!(full.code, Some(2), "{}", full.words);
    assert!(full.words.contains("cannot write <stdout>: No space"), "{}", full.words);
}

#[test]
fn arguments_out_of_range_are_refused_in_the_words_of_the_settings() {
    let room = Room::new();
    let size = "must be a whole number from 1 to 65535";
    for (arguments, expect) in [
        ("--size 0x4", size),
        ("--size 4x65536", size),
        ("--size 4", "written as 600x400"),
        ("--samples 0", "`samples` must be a whole number from 1 to 4096"),
        ("--samples -1", "`samples` must be a whole number from 1 to 4096"),
        ("--raydepth 1025", "`raydepth` must be a whole number from 0 to 1024"),
        ("--cutoff -1", "a cut-off is a number of at least 0"),
        ("--ray-budget 0", "0 is not in 1.."),
        ("--threads 0", "0 is not in 1..=1024"),
        ("--quality 101", "101 is not in 1..=100"),
        ("--device gpu", "a device is auto, cpu"),
        ("--precision f16", "possible values: f32, f64"),
        ("--depth 12", "possible values: 8, 16, float"),
        ("--crop 1,2,3", "X,Y,W,H"),
        (
            "--crop 1,0,48,32",
            "reaches beyond the picture, which has 48 x 32 pixels",
        ),
        ("--crop 4294967295,0,1,1", "reaches beyond"),
        ("--size 4x4 --crop 0,0,5,4", "which has 4 x 4 pixels"),
        ("--size 65535x65535", "48.0 GiB"),
    ] {
        room.check(&format!("good.scene -o new.png {arguments}"), 2, expect);
    }
    room.check("good.scene", 2, "--output <OUT>");
    room.check(
        "good.scene -o new.tga --depth 16",
        2,
        "tga does not hold 16-bit components",
    );
    room.check(
        "good.scene -o new.webp --size 16384x1",
        2,
        "webp holds at most 16383 pixels",
    );
}

#[test]
fn a_device_that_is_not_there_is_a_failure_and_auto_does_without() {
    let room = Room::new();
    for device in ["opencl", "opencl:0", "opencl:strange"] {
        room.check(
            &format!("good.scene -o old.png --device {device}"),
            3,
            "no OpenCL device",
        );
        room.check(
            &format!("good.scene -o new.png --device {device}"),
            3,
            "no OpenCL device",
        );
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
fn every_opencl_device_renders_or_says_why_not() {
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
    let Ok(simulator) = Command::new("oclgrind").arg("--version").output() else {
        return;
    };
    assert!(simulator.status.success());
    let room = Room::new();
    let run = |arguments: &str| {
        let mut command = Command::new("oclgrind");
        command.args(["--build-options", "-Dreal=,", env!("CARGO_BIN_EXE_scenec"), "render"]);
        command.current_dir(room.0.path()).args(arguments.split_whitespace());
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        ran(command.spawn().unwrap(), "")
    };
    let named = run("good.scene -o new.png --device opencl");
    assert_eq!((named.code, room.made()), (Some(3), Vec::new()), "{}", named.words);
    assert!(named.words.contains("\nerror: "), "{}", named.words);

    let auto = run("good.scene -o new.png");
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

#[test]
fn every_format_is_written_whole() {
    let room = Room::new();
    for format in Format::all() {
        for extension in format.extensions() {
            let name = format!("new.{extension}");
            let ran = room.run(&format!("good.scene -o {name} --device cpu"));
            assert_eq!(ran.code, Some(0), "{name}: {}", ran.words);
            let path = room.path(&name);
            let picture = load(&path).or_else(|_| load_raw(&path, 48, 32)).unwrap();
            assert_eq!((picture.width(), picture.height()), (48, 32), "{name}");
            fs::remove_file(path).unwrap();
        }
        assert_eq!(room.made(), Vec::<String>::new());
    }
}

#[test]
fn standard_input_and_output_carry_the_scene_and_the_picture_alone() {
    let room = Room::new();
    let file = room.run("good.scene -o file.png --device cpu");
    assert_eq!(file.code, Some(0));
    let child = room.command("- -o - --format PNG --device cpu").spawn().unwrap();
    let piped = ran(child, SCENE);
    assert_eq!(piped.code, Some(0), "{}", piped.words);
    assert!(piped.words.starts_with("wrote <stdout>: 48 x 32"), "{}", piped.words);
    assert!(piped.out.starts_with(b"\x89PNG"));
    assert!(
        piped.out == fs::read(room.path("file.png")).unwrap(),
        "other bytes than the file's"
    );
}

#[test]
fn the_format_that_is_named_wins_over_the_extension() {
    let room = Room::new();
    for (name, start) in [("jpg", b"\xFF\xD8".as_slice()), ("bmp", b"BM"), ("png", b"\x89PNG")] {
        let ran = room.run(&format!("good.scene -o new.png --format {name} --device cpu"));
        assert_eq!(ran.code, Some(0), "{}", ran.words);
        assert!(fs::read(room.path("new.png")).unwrap().starts_with(start), "{name}");
    }
}

#[test]
fn settings_are_replaced() {
    let room = Room::new();
    let size = |picture: &Picture| (picture.width(), picture.height());
    let cpu = |arguments: &str| room.picture(&format!("--device cpu {arguments}"));
    let plain = cpu("");
    assert_eq!(size(&plain), (48, 32));
    assert_eq!(size(&cpu("--size 7x5")), (7, 5));
    for changed in [
        "--samples 4",
        "--raydepth 0",
        "--csg ignore",
        "--cutoff 0.5",
        "--ray-budget 1",
    ] {
        let other = cpu(changed);
        assert_eq!(size(&other), (48, 32));
        assert!(other != plain, "{changed} changed nothing");
    }
    assert!(cpu("--samples 1 --raydepth 3 --csg tree --cutoff 1/4096") == plain);
}

#[test]
fn encodings_differ_where_they_should() {
    let room = Room::new();
    let bytes = |arguments: &str| {
        let ran = room.run(&format!("good.scene --device cpu {arguments}"));
        assert_eq!(ran.code, Some(0), "{arguments}: {}", ran.words);
        fs::read(room.path("new")).unwrap()
    };
    let plain = bytes("-o new --format png");
    assert!(plain != bytes("-o new --format png --transfer srgb"));
    assert!(plain != bytes("-o new --format png --depth 16"));
    assert!(plain == bytes("-o new --format png --depth 8 --transfer linear"));
    assert!(bytes("-o new --format jpeg --quality 5").len() < bytes("-o new --format jpeg").len());
}

#[test]
fn a_crop_is_the_part_of_the_whole() {
    let room = Room::new();
    for device in ["cpu", "cpu --precision f64", "reference"] {
        let whole = room.picture(&format!("--samples 2 --device {device}"));
        for (x, y, width, height) in [(11, 3, 20, 17), (0, 0, 48, 1), (47, 31, 1, 1), (0, 0, 48, 32)] {
            let part = room.picture(&format!(
                "--samples 2 --crop {x},{y},{width},{height} --device {device}"
            ));
            let rows = (y..y + height).flat_map(|row| &whole.row(row)[x as usize..(x + width) as usize]);
            assert_eq!((part.width(), part.height()), (width, height));
            assert!(part.pixels().iter().eq(rows), "{device}: {x},{y},{width},{height}");
        }
    }
}

#[test]
fn the_same_request_gives_the_same_bytes_on_any_number_of_threads() {
    let room = Room::new();
    let bytes = |arguments: &str| {
        let ran = room.run(&format!("good.scene -o - --format exr --size 90x60 {arguments}"));
        assert_eq!(ran.code, Some(0), "{arguments}: {}", ran.words);
        ran.out
    };
    for device in ["--device cpu", "--device cpu --precision f64", "--device reference"] {
        let one = bytes(&format!("{device} --threads 1"));
        assert!(one == bytes(&format!("{device} --threads 1")), "{device}: another run");
        assert!(
            one == bytes(&format!("{device} --threads 2")),
            "{device}: another thread"
        );
    }
}

#[test]
fn a_line_says_what_was_written_and_quiet_says_nothing() {
    let room = Room::new();
    fs::write(room.path("odd.scene"), format!("{SCENE}widht := 3\n")).unwrap();
    let odd = room.run("odd.scene -o new.png --device reference --threads 2 --crop 1,1,3,2 --ray-budget 1 --samples 2");
    assert_eq!(odd.code, Some(0));
    for words in [
        "W009",
        "warning: 6 pixels met the ray budget of 1",
        "wrote new.png: 3 x 2, reference f64, 2 threads, ",
    ] {
        assert!(odd.words.contains(words), "{words}: {}", odd.words);
    }
    let quiet = room.run("odd.scene -o new.png --device cpu --samples 2 --ray-budget 1 --quiet");
    assert_eq!((quiet.code, quiet.words.as_str()), (Some(0), ""));
}

#[test]
fn the_account_tells_of_every_stage() {
    let room = Room::new();
    let told = room.run("good.scene -o new.png --device cpu --stats --quiet --crop 0,0,8,4 --csg ignore");
    assert_eq!(told.code, Some(0), "{}", told.words);
    for words in [
        "size      8 x 4 of 48 x 32, samples 1, raydepth 3\n",
        "device    cpu f32, ",
        "kept      3 of 3 base objects in 3 islands, 1 of 1 lights",
        " in all: 32 from the eye, ",
        "; 0 pixels met their ray budget\n",
        "time      read ",
        ", encode ",
    ] {
        assert!(told.words.contains(words), "{words}: {}", told.words);
    }
}

#[cfg(target_os = "linux")]
mod interruption {
    use std::io::Write;
    use std::process::{Child, Command};
    use std::time::Duration;
    use std::{fs, thread};

    use super::{Room, SCENE};

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

    fn check(arguments: &str, times: u32) {
        let room = Room::new();
        fs::write(room.path("old.png"), "old").unwrap();
        let mut command = room.command(&format!("- -o old.png {arguments}"));
        let mut child = command.spawn().unwrap();
        // The scene comes through the pipe: the handler is set once it has ended.
        child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
        wait_for_the_handler(&child);
        for _ in 0..times {
            interrupt(&child);
            thread::sleep(Duration::from_millis(200));
        }
        let output = child.wait_with_output().unwrap();
        let words = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(130), "{arguments}: {words}");
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
}
