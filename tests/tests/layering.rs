//! The walls of the house: which crate may use which, and which outside crate is used where.
//!
//! The table here is the architecture. A manifest that says anything else fails, whichever of the two is wrong.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may, in its helpers too")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use scenec_tests::root;

/// One crate: its package, what it may use of ours, and what it may use from outside.
struct Room {
    name: &'static str,
    ours: &'static [&'static str],
    outside: &'static [&'static str],
}

const fn room(name: &'static str, ours: &'static [&'static str], outside: &'static [&'static str]) -> Room {
    Room { name, ours, outside }
}

/// Every crate but the one of these tests, which may see everything.
const ROOMS: &[Room] = &[
    room("scenec-text", &[], &["strsim"]),
    room("scenec-syntax", &["scenec-text"], &["logos"]),
    room("scenec-scene", &["scenec-text"], &["glam"]),
    room(
        "scenec-interpret",
        &["scenec-text", "scenec-syntax", "scenec-scene"],
        &["hashbrown"],
    ),
    room(
        "scenec-lint",
        &["scenec-text", "scenec-syntax", "scenec-scene", "scenec-interpret"],
        &[],
    ),
    room(
        "scenec-ide",
        &[
            "scenec-text",
            "scenec-syntax",
            "scenec-scene",
            "scenec-interpret",
            "scenec-lint",
        ],
        &[],
    ),
    room(
        "scenec-plan",
        &["scenec-text", "scenec-scene"],
        &["hashbrown", "obvhs", "rayon"],
    ),
    room("scenec-picture", &[], &["image", "tempfile"]),
    room("scenec-reference", &["scenec-scene", "scenec-picture"], &[]),
    room(
        "scenec-cpu",
        &["scenec-plan", "scenec-picture"],
        &["fearless_simd", "rayon"],
    ),
    room("scenec-memory", &[], &["libc"]),
    room("scenec-opencl-loader", &[], &["libloading"]),
    room("scenec-kernels", &[], &[]),
    room(
        "scenec-device",
        &[
            "scenec-plan",
            "scenec-picture",
            "scenec-kernels",
            "scenec-opencl-loader",
        ],
        &["ocl"],
    ),
    room(
        "scenec-measure",
        &[
            "scenec-scene",
            "scenec-plan",
            "scenec-picture",
            "scenec-reference",
            "scenec-cpu",
            "scenec-device",
        ],
        &["plotters", "serde", "tempfile", "toml"],
    ),
    room(
        "scenec-lsp",
        &[
            "scenec-text",
            "scenec-scene",
            "scenec-ide",
            "scenec-plan",
            "scenec-picture",
            "scenec-cpu",
            "scenec-device",
        ],
        &[
            "base64",
            "ropey",
            "rustix",
            "serde",
            "serde_json",
            "tokio",
            "tower-lsp",
            "tower-service",
        ],
    ),
    room(
        "scenec",
        &[
            "scenec-text",
            "scenec-syntax",
            "scenec-scene",
            "scenec-interpret",
            "scenec-lint",
            "scenec-lsp",
            "scenec-plan",
            "scenec-picture",
            "scenec-reference",
            "scenec-cpu",
            "scenec-device",
            "scenec-measure",
            "scenec-memory",
        ],
        &[
            "ariadne",
            "clap",
            "ctrlc",
            "ignore",
            "indicatif",
            "serde_json",
            "similar",
            "tempfile",
            "toml",
        ],
    ),
];

/// Outside crates that more than one room may use; any other belongs to one room alone.
const SHARED: &[&str] = &["hashbrown", "rayon", "serde", "serde_json", "tempfile", "toml"];

/// The most lines that a source file may have.
const LONGEST: usize = 500;

struct Manifest {
    name: String,
    dependencies: BTreeSet<String>,
}

/// The package of a manifest and what it depends on, by package name and for every platform; what only its tests
/// or its build need is left out.
fn manifest(text: &str) -> Manifest {
    let table: toml::Table = text.parse().expect("a manifest");
    let mut dependencies = BTreeSet::new();
    let platforms = table.get("target").and_then(toml::Value::as_table);
    let tables = platforms.into_iter().flat_map(toml::Table::values);
    for entry in tables
        .filter_map(|platform| platform.get("dependencies"))
        .chain(table.get("dependencies"))
    {
        for (name, how) in entry.as_table().expect("a table of dependencies") {
            // A renamed dependency is what it is, not what it is called.
            let package = how.get("package").and_then(toml::Value::as_str).unwrap_or(name);
            dependencies.insert(package.to_owned());
        }
    }
    let name = table["package"]["name"].as_str().expect("a name").to_owned();
    Manifest { name, dependencies }
}

fn manifests() -> Vec<Manifest> {
    let crates = std::fs::read_dir(root().join("crates")).unwrap();
    let folders = crates.map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    folders
        .chain([root().join("kernels")])
        .map(|folder| manifest(&std::fs::read_to_string(folder.join("Cargo.toml")).unwrap()))
        .collect()
}

/// What a manifest does that the table does not allow.
fn check(rooms: &[Room], manifest: &Manifest) -> Vec<String> {
    let name = &manifest.name;
    let Some(room) = rooms.iter().find(|room| room.name == name) else {
        return vec![format!("{name} is in no row of the table")];
    };
    let allowed = |one: &&String| room.ours.iter().chain(room.outside).any(|other| other == one);
    let strangers = manifest.dependencies.iter().filter(|one| !allowed(one));
    strangers.map(|one| format!("{name} may not use {one}")).collect()
}

#[test]
fn every_crate_keeps_to_its_row() {
    let manifests = manifests();
    let wrong: Vec<String> = manifests.iter().flat_map(|one| check(ROOMS, one)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for room in ROOMS {
        assert!(
            manifests.iter().any(|one| one.name == room.name),
            "no crate is called {}",
            room.name
        );
    }
}

#[test]
fn an_outside_crate_has_one_room() {
    for room in ROOMS {
        for outside in room.outside.iter().filter(|one| !SHARED.contains(one)) {
            let users: Vec<_> = ROOMS
                .iter()
                .filter(|other| other.outside.contains(outside))
                .map(|r| r.name)
                .collect();
            assert_eq!(users, [room.name], "{outside} is used in several rooms");
        }
    }
}

#[test]
fn the_check_finds_what_it_is_for() {
    let of = |text: &str| check(&[room("one", &["two"], &["three"])], &manifest(text));
    let package = |name: &str, rest: &str| format!("[package]\nname = \"{name}\"\n[dependencies]\n{rest}");
    let fine = "two.workspace = true\nthree = \"1\"\n";
    assert!(of(&package("one", fine)).is_empty());
    assert_eq!(of(&package("stranger", fine)), ["stranger is in no row of the table"]);
    assert_eq!(
        of(&package("one", &format!("{fine}four = \"1\"\n"))),
        ["one may not use four"]
    );
    let renamed = format!("{fine}two2 = {{ package = \"four\", version = \"1\" }}\n");
    assert_eq!(of(&package("one", &renamed)), ["one may not use four"]);
    let platform = format!("{fine}[target.'cfg(unix)'.dependencies]\nfour = \"1\"\n");
    assert_eq!(of(&package("one", &platform)), ["one may not use four"]);
    let tests_only = format!("{fine}[dev-dependencies]\nfour = \"1\"\n");
    assert!(of(&package("one", &tests_only)).is_empty());
}

#[test]
fn the_page_on_the_architecture_names_every_crate() {
    let page = std::fs::read_to_string(root().join("docs/architecture.md")).unwrap();
    for room in ROOMS {
        let short = room.name.trim_start_matches("scenec-");
        let row = page.lines().find(|line| line.starts_with(&format!("| `{short}` |")));
        let row = row.unwrap_or_else(|| panic!("the table has no row for `{short}`"));
        for outside in room.outside {
            assert!(
                row.contains(outside),
                "the row of `{short}` does not tell that it uses {outside}"
            );
        }
    }
}

/// Every Rust source file below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found
}

#[test]
fn no_source_file_is_too_long() {
    let files = sources(&root().join("crates"));
    assert!(files.len() > 20, "only {} files were found", files.len());
    for path in files {
        let lines = std::fs::read_to_string(&path).unwrap().lines().count();
        assert!(lines <= LONGEST, "{} has {lines} lines", path.display());
    }
}
