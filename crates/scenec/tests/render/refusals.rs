//! What is refused before anything is traced.

use std::fs;

use crate::room::{Room, SCENE, ran};

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
        ("--precision f16", "possible values: auto, f32, f64"),
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
fn a_scene_beyond_the_tracers_is_refused() {
    let room = Room::new();
    // In either of two solids and not in both: each such step names the tree before it twice, and no law makes it shorter.
    let step = |i: u32| format!("!b := sphere\n!b += .0{i} 0 0\n!u := a | b\n!c := a & b\n!a := u - c\n");
    let doubled: String = (10..40).map(step).collect();
    let scene = SCENE.replace("!ball := a - b", &format!("{doubled}!ball := a - b"));
    fs::write(room.path("vast.scene"), scene).unwrap();
    room.check(
        "vast.scene -o new.png --device cpu",
        2,
        "error: the scene can't be traced: ",
    );
}
