//! What is said.

use std::fs;

use crate::room::{Room, SCENE};

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
