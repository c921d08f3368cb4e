//! Compiled programs that are kept between runs.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::room::{Room, ran};

/// A room, a folder for the cache, and a driver to compile for; none where there is no OpenCL.
fn with_opencl() -> Option<(Room, tempfile::TempDir)> {
    let room = Room::new();
    let there = room.run("good.scene -o probe.png --device opencl").code == Some(0);
    there.then(|| (room, tempfile::tempdir().unwrap()))
}

fn command(room: &Room, cache: &Path, name: &str) -> Command {
    let mut command = room.command(&format!("good.scene -o {name}.pfm --device opencl -q"));
    command.env("SCENEC_CACHE_DIR", cache);
    command
}

/// Renders with what is kept in a folder, and returns the file.
fn render(room: &Room, cache: &Path, name: &str) -> Vec<u8> {
    let ran = ran(command(room, cache, name).spawn().unwrap(), "");
    assert_eq!((ran.code, ran.words.as_str()), (Some(0), ""));
    fs::read(room.path(&format!("{name}.pfm"))).unwrap()
}

/// The programs in a folder.
fn programs(cache: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(cache.join("programs")).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

#[test]
fn a_program_is_kept_and_one_that_was_harmed_is_made_anew() {
    let Some((room, cache)) = with_opencl() else { return };
    let cache = cache.path();
    let expect = render(&room, cache, "cold");
    let [path] = programs(cache).try_into().unwrap();
    let whole = fs::metadata(&path).unwrap().len();
    assert!(render(&room, cache, "warm") == expect);
    let mut bytes = fs::read(&path).unwrap();
    bytes[whole as usize / 2] ^= 1;
    let half = bytes[..whole as usize / 2].to_vec();
    for harmed in [bytes, half, Vec::new()] {
        fs::write(&path, &harmed).unwrap();
        assert!(render(&room, cache, "again") == expect);
        assert_ne!(fs::read(&path).unwrap(), harmed);
        assert_eq!(programs(cache).len(), 1);
    }
}

#[test]
fn programs_at_once_do_not_disturb_each_other() {
    let Some((room, cache)) = with_opencl() else { return };
    let cache = cache.path();
    let children: Vec<_> = (0..3)
        .map(|number| command(&room, cache, &format!("at-once-{number}")).spawn().unwrap())
        .collect();
    for child in children {
        let ran = ran(child, "");
        assert_eq!((ran.code, ran.words.as_str()), (Some(0), ""));
    }
    let expect = render(&room, cache, "after");
    for number in 0..3 {
        assert!(fs::read(room.path(&format!("at-once-{number}.pfm"))).unwrap() == expect);
    }
    assert_eq!(programs(cache).len(), 1);
}

#[test]
fn a_folder_that_cannot_be_is_done_without() {
    let Some((room, cache)) = with_opencl() else { return };
    let file = cache.path().join("file");
    fs::write(&file, "").unwrap();
    let expect = render(&room, Path::new("off"), "off");
    assert!(!room.path("off").exists());
    assert!(render(&room, &file.join("below"), "below") == expect);
    assert_eq!(fs::read(&file).unwrap(), b"");
}
