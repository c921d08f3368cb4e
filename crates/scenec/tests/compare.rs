//! `scenec compare`: figures, heat maps, exit codes.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use scenec_picture::{Encoding, Format, Picture, load, save};
use tempfile::TempDir;

const SCENE: &str = "width := 20\nheight := 10\nraydepth := 1\neyepos_x := 0\neyepos_y := 0\neyepos_z := 4\n\
    lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := 1\nambient_g := 1\nambient_b := 1\n\
    ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n!a := sphere\n!a <=\n";

/// A folder with two scenes, one in error, and pictures that differ in one pixel of 200, by a half.
struct Room(TempDir);

impl Room {
    fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        fs::write(room.path("a.scene"), SCENE).unwrap();
        fs::write(room.path("bad.scene"), format!("{SCENE}!b := cube\n")).unwrap();
        let mut picture = Picture::black(20, 10).unwrap();
        room.save("black.pfm", &picture);
        picture.pixels_mut()[7] = [0.0, 0.5, 0.0];
        room.save("dot.exr", &picture);
        picture.pixels_mut()[8] = [f32::NAN, 0.0, 0.0];
        room.save("strange.pfm", &picture);
        room.save("small.png", &Picture::black(2, 2).unwrap());
        room
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn save(&self, name: &str, picture: &Picture) {
        let path = self.path(name);
        save(picture, &path, &Encoding::of(Format::from_path(&path).unwrap())).unwrap();
    }

    fn run(&self, arguments: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
        command.arg("compare").args(arguments.split_whitespace());
        command.current_dir(self.0.path()).output().unwrap()
    }

    /// It ends with this code, and these words are among what it says.
    fn check(&self, arguments: &str, code: i32, words: &[&str]) {
        let ran = self.run(arguments);
        let said = String::from_utf8([ran.stdout, ran.stderr].concat()).unwrap();
        assert_eq!(ran.status.code(), Some(code), "{arguments}: {said}");
        for words in words {
            assert!(said.contains(words), "{arguments}: {words}: {said}");
        }
    }
}

#[test]
fn figures_of_two_pictures() {
    let room = Room::new();
    let figures = [
        "black.pfm against dot.exr: 20 x 10\n",
        "rmse        2.041e-2\n",
        "max         5.000e-1\n",
        "p99         0.000e0\n",
        "share       0.500 % of",
        "flip        ",
        "non-finite  0 pixels\n",
    ];
    room.check("black.pfm dot.exr", 0, &figures);
    room.check(
        "dot.exr strange.pfm",
        0,
        &["max         0.000e0\n", "non-finite  1 pixel\n"],
    );
    let json = [
        "\"first\": \"black.pfm\"",
        "\"max\": 0.5,",
        "\"share\": 0.005,",
        "\"pixels_per_degree\": 20.0,",
        "\"over\": null",
    ];
    room.check(
        "black.pfm dot.exr --output-format json --pixels-per-degree 20",
        0,
        &json,
    );
}

#[test]
fn a_scene_stands_for_its_picture() {
    let room = Room::new();
    room.check("a.scene a.scene --fail-above 0", 0, &["max         0.000e0\n"]);
    room.check("a.scene black.pfm --fail-above 1/255", 1, &["above the limit: max is "]);
}

#[test]
fn a_figure_above_its_limit_is_a_failure() {
    let room = Room::new();
    room.check("black.pfm dot.exr --fail-above 0.5", 0, &[]);
    room.check(
        "black.pfm dot.exr --fail-above 1/3",
        1,
        &["max is 5.000e-1, and 3.333e-1 is allowed"],
    );
    room.check("black.pfm dot.exr --figure p99 --fail-above 0", 0, &[]);
    room.check("black.pfm dot.exr --figure share --fail-above 0.005", 0, &[]);
    room.check(
        "black.pfm dot.exr --figure rmse --fail-above 0.02",
        1,
        &["rmse is 2.041e-2"],
    );
    room.check("black.pfm dot.exr --figure flip --fail-above 0", 1, &["flip is "]);
    room.check("dot.exr strange.pfm --fail-above 1", 1, &["have no difference"]);
    let json = "black.pfm dot.exr --fail-above 0.25 --output-format json";
    room.check(json, 1, &["\"figure\": \"max\"", "\"limit\": 0.25"]);
}

#[test]
fn differences_are_painted() {
    let room = Room::new();
    room.check("dot.exr strange.pfm --heat heat.pfm", 0, &[]);
    let heat = load(&room.path("heat.pfm")).unwrap();
    assert_eq!(heat.pixels()[7], [0.0; 3]);
    assert_eq!(heat.pixels()[8], [0.0, 1.0, 0.4]);
    room.check("black.pfm dot.exr --heat heat.pfm", 0, &[]);
    assert!(load(&room.path("heat.pfm")).unwrap().pixels()[7][0] > 0.9);
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let room = Room::new();
    room.check("black.pfm small.png", 2, &["20 x 10 and 2 x 2"]);
    room.check("black.pfm none.png", 2, &["cannot read none.png"]);
    room.check("black.pfm none.scene", 2, &["cannot read none.scene"]);
    room.check("black.pfm bad.scene", 1, &["E008"]);
    room.check("- -", 2, &["one scene, not two"]);
    room.check("black.pfm dot.exr --heat heat.gif", 2, &["heat.gif"]);
    room.check("black.pfm dot.exr --heat none/heat.png", 2, &["none/heat.png"]);
    room.check("black.pfm dot.exr --figure rmse", 2, &["--fail-above"]);
    room.check(
        "black.pfm dot.exr --fail-above -1",
        2,
        &["a limit is a number of at least 0"],
    );
    room.check("black.pfm dot.exr --pixels-per-degree 0", 2, &["1 to 1000 pixels"]);
    assert!(!room.path("heat.gif").exists());
}
