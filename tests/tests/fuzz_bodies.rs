//! The bodies of the fuzz targets, on what proptest thinks of: a short run of each wherever the tests run.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

#[path = "../fuzz/bodies.rs"]
mod bodies;

use proptest::prelude::*;

/// Pieces that together reach every statement, every finding of the early stages, and comments that silence findings.
const PIECES: &[&str] = &[
    "!a := sphere\n",
    "!b := hp\r\n",
    "!c := a | b\n",
    "!c := a - b / why\n",
    "!d := c & a\n",
    "!a += 1 0 0\n",
    "!a *= 1 1 1\n",
    "!b #y= pi\n",
    "!c <=\n",
    "!a ?= m\n",
    "?m := 1 1 1 1 1 1 1 1 1 1\n",
    "?m := .5 .5 0 0 1 -1 0 1 2 -1\n",
    "*l := 1 2 3 1 1 1\n",
    "x := 1\n",
    "y := - x\n",
    "width := 8\n",
    "raydepth := 1e3\n",
    "/ scenec: allow W008\n",
    "/ scenec: allow\n",
    "/\u{FEFF}\n",
    "\n",
    "\r\n\r\n",
    "\r",
    " ",
    "\u{2028}",
    "!",
    "x",
    ":=",
    "|",
    "-",
    "1.2.3",
    "1e999",
    "1e-999",
    "é",
    "#x=",
    "$",
    "\0",
];

fn check(bytes: &[u8]) {
    bodies::parse(bytes);
    bodies::lint(bytes);
    bodies::fmt(bytes);
}

proptest! {
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        check(&bytes);
    }

    #[test]
    fn any_pieces(pieces in prop::collection::vec(prop::sample::select(PIECES), 0..40)) {
        check(pieces.concat().as_bytes());
    }

    #[test]
    fn any_pieces_with_a_wrong_byte(
        pieces in prop::collection::vec(prop::sample::select(PIECES), 0..20),
        byte in any::<u8>(),
        place in any::<prop::sample::Index>(),
    ) {
        let mut bytes = pieces.concat().into_bytes();
        bytes.insert(place.index(bytes.len() + 1), byte);
        check(&bytes);
    }
}

/// The gallery and the fixtures, which reach what random pieces seldom do.
#[test]
fn the_scenes_of_the_project() {
    let mut seen = 0;
    for folder in ["scenes", "tests/fixtures"] {
        for entry in std::fs::read_dir(scenec_tests::root().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "scene") {
                check(&std::fs::read(path).unwrap());
                seen += 1;
            }
        }
    }
    assert!(seen > 40, "only {seen} scenes were found");
}
