use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::{Cache, Hash, folder};

/// A cache in a folder that is gone afterwards.
pub(crate) struct Room(PathBuf);

impl Room {
    pub(crate) fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("scenec-cache-{name}-{}", std::process::id()));
        fs::remove_dir_all(&folder).unwrap_or_default();
        Self(folder)
    }

    pub(crate) fn cache(&self, bound: u64) -> Cache {
        Cache {
            folder: Some(self.0.clone()),
            bound,
        }
    }

    fn files(&self) -> Vec<PathBuf> {
        let mut files: Vec<_> = fs::read_dir(&self.0)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .collect();
        files.sort();
        files
    }
}

impl Drop for Room {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).unwrap_or_default();
    }
}

fn key(number: u8) -> Hash {
    Hash::of(&[&[number]])
}

#[test]
fn what_was_put_is_found_again() {
    let room = Room::new("found");
    let cache = room.cache(1 << 20);
    assert_eq!(cache.get(key(1)), None);
    cache.put(key(1), b"one");
    cache.put(key(2), b"");
    cache.put(key(1), b"another");
    assert_eq!(cache.get(key(1)).as_deref(), Some(b"another".as_slice()));
    assert_eq!(cache.get(key(2)).as_deref(), Some(b"".as_slice()));
    assert!(cache.has(key(2)) && !cache.has(key(3)));
    cache.forget(key(2));
    assert_eq!(cache.get(key(2)), None);
    assert_eq!(room.files().len(), 1);
}

#[test]
fn an_entry_that_was_harmed_is_none() {
    let room = Room::new("harmed");
    let cache = room.cache(1 << 20);
    cache.put(key(1), b"a program");
    let path = room.files().pop().unwrap();
    let whole = fs::read(&path).unwrap();
    let mut harmed: Vec<Vec<u8>> = (0..whole.len()).map(|length| whole[..length].to_vec()).collect();
    harmed.extend((0..whole.len()).map(|at| {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x10;
        bytes
    }));
    harmed.push([whole.as_slice(), b"x"].concat());
    for bytes in harmed {
        fs::write(&path, &bytes).unwrap();
        assert_eq!(cache.get(key(1)), None, "{bytes:?}");
    }
    cache.put(key(1), b"a program");
    assert_eq!(cache.get(key(1)).as_deref(), Some(b"a program".as_slice()));
    // Whole, and under another's name.
    fs::copy(&path, cache.path(key(2)).unwrap()).unwrap();
    assert_eq!(cache.get(key(2)), None);
}

#[test]
fn the_bound_holds_and_what_was_used_last_stays() {
    let room = Room::new("bound");
    let cache = room.cache(4500);
    let age = |number: u8, seconds: u64| {
        let file = fs::File::options()
            .write(true)
            .open(cache.path(key(number)).unwrap())
            .unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(seconds))
            .unwrap();
    };
    for number in 0..4 {
        cache.put(key(number), &[number; 1000]);
        age(number, 100 - u64::from(number));
    }
    assert!(cache.get(key(0)).is_some());
    cache.put(key(4), &[4; 1000]);
    let there: Vec<_> = (0..5).filter(|number| cache.has(key(*number))).collect();
    assert_eq!(there, [0, 2, 3, 4]);
    cache.put(key(5), &[5; 1200]);
    assert!(!cache.has(key(5)), "an entry that would throw out all others");
}

#[test]
fn what_was_abandoned_is_swept_away() {
    let room = Room::new("swept");
    fs::create_dir_all(&room.0).unwrap();
    let [old, new] = ["old", "new"].map(|name| room.0.join(format!(".scenec-{name}.part")));
    for path in [&old, &new] {
        fs::write(path, "half").unwrap();
    }
    let file = fs::File::options().write(true).open(&old).unwrap();
    file.set_modified(SystemTime::now() - Duration::from_secs(7200))
        .unwrap();
    room.cache(1 << 20).put(key(1), b"one");
    assert!(!old.exists() && new.exists());
}

#[test]
fn without_a_folder_nothing_is_kept_and_nothing_fails() {
    let room = Room::new("without");
    fs::create_dir_all(&room.0).unwrap();
    let file = room.0.join("file");
    fs::write(&file, "").unwrap();
    for folder in [None, Some(file.join("below"))] {
        let cache = Cache { folder, bound: 1000 };
        cache.put(key(1), b"one");
        assert_eq!(cache.get(key(1)), None);
        cache.forget(key(1));
    }
}

#[test]
fn writers_and_readers_at_once_see_whole_entries() {
    let room = Room::new("at-once");
    let cache = room.cache(20_000);
    std::thread::scope(|scope| {
        for writer in 0..4u8 {
            let cache = &cache;
            scope.spawn(move || {
                for round in 0..40u8 {
                    cache.put(key(round % 8), &vec![writer; 1000 + usize::from(writer)]);
                    if let Some(bytes) = cache.get(key(round.wrapping_mul(3) % 8)) {
                        assert_eq!(bytes.len(), 1000 + usize::from(bytes[0]));
                        assert!(bytes.iter().all(|byte| *byte == bytes[0]));
                    }
                }
            });
        }
    });
    assert!(room.files().len() <= 8, "{:?}", room.files());
}

#[test]
fn the_folder_follows_the_conventions() {
    let check = |set: &[(&str, &str)], expect: Option<&str>| {
        let variable = |name: &str| {
            set.iter()
                .find(|(known, _)| *known == name)
                .map(|(_, value)| PathBuf::from(value))
        };
        assert_eq!(folder(variable).as_deref(), expect.map(Path::new), "{set:?}");
    };
    let home = ("HOME", "/home/a");
    check(&[home], Some("/home/a/.cache/scenec"));
    check(&[home, ("XDG_CACHE_HOME", "/c")], Some("/c/scenec"));
    check(&[home, ("XDG_CACHE_HOME", "c")], Some("/home/a/.cache/scenec"));
    check(&[("LOCALAPPDATA", "/local")], Some("/local/scenec"));
    check(&[home, ("SCENEC_CACHE_DIR", "mine")], Some("mine"));
    check(&[home, ("SCENEC_CACHE_DIR", "")], Some("/home/a/.cache/scenec"));
    check(&[home, ("SCENEC_CACHE_DIR", "off")], None);
    check(&[], None);
}
