//! What a plan keeps of small trees, and why it leaves out the rest.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_plan::{Reason, Summary, Tiers, plan};
use scenec_text::SourceFile;

const STAGE: &str = "
width := 8
height := 8
raydepth := 0
eyepos_x := 0
eyepos_y := 0
eyepos_z := 9
lookat_x := 0
lookat_y := 0
lookat_z := 0
ambient_r := 1
ambient_g := 1
ambient_b := 1
ambient_int_r := 1
ambient_int_g := 1
ambient_int_b := 1
";

/// Balls p and q that overlap, s inside p, f far from all; the half-space g below them, h whose surface cuts p, and a ball
/// t that is p again, turned.
const OBJECTS: &str = "
!p := sphere
!q := sphere
!q += 1 0 0
!s := sphere
!s *= .2 .3 .2
!s += -.5 0 0
!f := sphere
!f += 0 7 0
!g := hp
!g += 0 -3 0
!h := hp
!t := sphere
!t #x= 1
";

const NONE: Tiers = Tiers {
    single: 0,
    products: 0,
    programs: 0,
    divided: 0,
};

fn summary(combinations: &str) -> Summary {
    let text = format!("{STAGE}{OBJECTS}{combinations}");
    let source = SourceFile::new("test", &text).unwrap();
    let (interpretation, findings) = scenec_interpret::analyse(&source);
    let scene = interpretation.scene.unwrap_or_else(|| panic!("{findings:#?}"));
    plan(&scene).unwrap().summary()
}

/// The plan of a tree keeps so many base objects in such islands, and leaves out those it is made of for these reasons.
fn check(combinations: &str, kept: usize, tiers: Tiers, dropped: &[(Reason, usize)]) {
    let summary = summary(combinations);
    let reached = summary
        .dropped
        .iter()
        .filter(|dropped| dropped.reason != Reason::Unreached);
    let reasons: Vec<_> = reached.map(|dropped| (dropped.reason, dropped.count)).collect();
    assert_eq!(
        (summary.kept, summary.tiers, &reasons[..]),
        (kept, tiers, dropped),
        "{combinations}"
    );
    assert_eq!(summary.leaves, 7, "{combinations}");
}

#[test]
fn what_is_the_same_is_one() {
    let single = Tiers { single: 1, ..NONE };
    for combinations in [
        "!c := p | t\n!c <=\n",
        "!c := p & t\n!c <=\n",
        "!c := q & p\n!c := p | c\n!c <=\n",
    ] {
        let dropped = if combinations.contains('q') {
            Reason::Covered
        } else {
            Reason::Twin
        };
        check(combinations, 1, single, &[(dropped, 1)]);
    }
    let two = Tiers { products: 1, ..NONE };
    check("!c := p & q\n!d := q & p\n!c := c | d\n!c <=\n", 2, two, &[]);
    check("!c := p - q\n!c := c - q\n!c <=\n", 2, two, &[]);
    // p and q, said by subtractions.
    check("!c := p - q\n!c := p - c\n!c <=\n", 2, two, &[]);
}

#[test]
fn what_holds_no_point_is_nothing() {
    for combinations in [
        "!c := p - p\n!c <=\n",
        "!c := p - t\n!c <=\n",
        "!c := p & q\n!c := c - p\n!c <=\n",
        "!c := p - q\n!d := p & q\n!c := c & d\n!c <=\n",
        "!c := p & f\n!c <=\n",
        "!c := g & p\n!c <=\n",
        "!c := s - p\n!c <=\n",
        "!c := p | q\n!c := c - c\n!c <=\n",
    ] {
        let summary = summary(combinations);
        assert_eq!((summary.kept, summary.islands), (0, 0), "{combinations}");
        let other = |reason| reason != Reason::Unreached && reason != Reason::Nothing;
        assert!(
            summary.dropped.iter().all(|dropped| !other(dropped.reason)),
            "{combinations}"
        );
    }
}

#[test]
fn what_can_t_be_seen_for_its_place_is_left_out() {
    let single = Tiers { single: 1, ..NONE };
    let product = Tiers { products: 1, ..NONE };
    check("!c := p - f\n!c <=\n", 1, single, &[(Reason::Idle, 1)]);
    check("!c := s & p\n!c <=\n", 1, single, &[(Reason::Idle, 1)]);
    check(
        "!c := q - f\n!c := c - g\n!c := c - s\n!c := c & p\n!c <=\n",
        2,
        product,
        &[(Reason::Idle, 3)],
    );
    check(
        "!c := f - p\n!d := p & h\n!d := d | s\n!c := c | d\n!c := c - q\n!c <=\n",
        5,
        Tiers { programs: 1, ..NONE },
        &[],
    );
    check("!c := p | s\n!c := c & h\n!c <=\n", 2, product, &[(Reason::Covered, 1)]);
    check("!c := q - p\n!c := c - s\n!c <=\n", 2, product, &[(Reason::Idle, 1)]);
    let half = "!g += 0 9 0\n!c := g | p\n!c := c | f\n!c <=\n";
    check(half, 2, Tiers { single: 2, ..NONE }, &[(Reason::Covered, 1)]);
}

#[test]
fn the_root_s_unions_are_islands() {
    let tiers = Tiers {
        single: 1,
        products: 2,
        ..NONE
    };
    check(
        "!c := p & q\n!d := q - h\n!c := c | d\n!c := c | g\n!c <=\n",
        4,
        tiers,
        &[],
    );
}
