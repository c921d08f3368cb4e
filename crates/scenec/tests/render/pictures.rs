//! What is written.

use std::fs;

use scenec_picture::{Format, Picture, load, load_raw};

use crate::room::{Room, SCENE, ran};

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
