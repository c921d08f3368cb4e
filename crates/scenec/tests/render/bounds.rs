//! How wrong a picture may be: tolerances, maps, and what is said.

use scenec_picture::{Picture, load};

use crate::room::Room;

/// The map of a render with these arguments.
fn map(room: &Room, name: &str, arguments: &str) -> Picture {
    map_by("cpu", room, name, arguments)
}

fn map_by(device: &str, room: &Room, name: &str, arguments: &str) -> Picture {
    let ran = room.run(&format!(
        "good.scene -o new.png --device {device} --error-map {name} {arguments}"
    ));
    assert_eq!(ran.code, Some(0), "{}", ran.words);
    load(&room.path(name)).unwrap()
}

#[test]
fn a_tolerance_is_kept_or_the_exit_code_says_so() {
    let room = Room::new();
    let kept = room.run("good.scene -o new.png --tolerance 1/16 --stats");
    assert_eq!(kept.code, Some(0), "{}", kept.words);
    for words in [
        " samples per pixel, ",
        "bound     at most ",
        " (proven)",
        " (estimated)",
    ] {
        assert!(kept.words.contains(words), "{words}: {}", kept.words);
    }
    for quiet in ["", " --quiet"] {
        let missed = room.run(&format!(
            "good.scene -o new.png --tolerance 0.1% --most-samples 16{quiet}"
        ));
        assert_eq!(missed.code, Some(4), "{}", missed.words);
        let words = "pixels may be off by more than 1.000e-3";
        assert!(missed.words.contains(words), "{}", missed.words);
        assert!(
            missed.words.contains("more samples than allowed would be needed"),
            "{}",
            missed.words
        );
        assert!(room.path("new.png").exists());
    }
}

#[test]
fn a_map_holds_the_bounds_as_numbers_or_as_colours() {
    let room = Room::new();
    let most = |map: &Picture| {
        map.pixels()
            .as_flattened()
            .iter()
            .fold(0.0_f32, |most, value| most.max(*value))
    };
    let uniform = map(&room, "map.exr", "--samples 4");
    let finer = map(&room, "map.exr", "--samples 256");
    let kept = map(&room, "map.pfm", "--tolerance 1/16");
    assert!(most(&uniform) > most(&finer) && most(&finer) > 0.0);
    assert!(most(&kept) > 0.0 && most(&kept) <= 1.0 / 16.0);
    let colours = map(&room, "map.png", "--tolerance 1/16");
    assert!(colours.pixels().iter().any(|pixel| pixel[0] != pixel[2]));
    assert_eq!((kept.width(), kept.height()), (48, 32));
}

#[test]
fn every_tracer_tells_how_wrong_it_may_be() {
    let room = Room::new();
    let expect = map(&room, "map.pfm", "--samples 16 --precision f64");
    let opencl = room.run("good.scene -o new.png --device opencl").code == Some(0);
    for device in ["reference"].into_iter().chain(opencl.then_some("opencl")) {
        let found = map_by(device, &room, "other.pfm", "--samples 16 --precision f64");
        let pairs = found.pixels().iter().zip(expect.pixels());
        let apart = pairs.map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max);
        // Of the slow tracer's nothing is dropped.
        assert!(apart <= 1.0 / 1024.0, "{device}: {apart}");
        let kept = map_by(device, &room, "other.pfm", "--tolerance 1/16");
        assert!(
            kept.pixels().as_flattened().iter().all(|bound| *bound <= 1.0 / 16.0),
            "{device}"
        );
        let told = room.run(&format!("good.scene -o new.png --device {device} --stats"));
        assert!(told.words.contains(" (estimated)"), "{device}: {}", told.words);
    }
}

#[test]
fn a_picture_is_the_same_with_a_map_of_its_bounds() {
    let room = Room::new();
    map(&room, "map.png", "--samples 3");
    let with = std::fs::read(room.path("new.png")).unwrap();
    assert_eq!(room.run("good.scene -o new.png --device cpu --samples 3").code, Some(0));
    assert_eq!(with, std::fs::read(room.path("new.png")).unwrap());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let room = Room::new();
    for (arguments, words) in [
        ("--tolerance 0", "a tolerance is a number above 0"),
        ("--tolerance 1/64 --samples 4", "cannot be used with"),
        ("--tolerance 1/64 --cutoff 0", "cannot be used with"),
        (
            "--tolerance 1/64 --device opencl --fast-math",
            "--tolerance is about what is promised, and with --fast-math nothing is",
        ),
        ("--most-samples 16", "--tolerance"),
        ("--tolerance 1/64 --most-samples 15", "15 is not in 16..=262144"),
        ("--error-map -", "needs the name of a file"),
        ("--error-map ./new.png", "it is the picture itself"),
        ("--error-map good.scene", "the extension of good.scene"),
        ("--error-map m.gif", "the extension of m.gif"),
    ] {
        room.check(&format!("good.scene -o new.png {arguments}"), 2, words);
    }
}
