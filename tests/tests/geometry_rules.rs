//! The rules on geometry, held to the oracle: what they say of random scenes is so in the picture.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::collections::BTreeMap;

use scenec_lint::check;
use scenec_picture::{Frame, Limits, NOTHING, Window};
use scenec_reference::Reference;
use scenec_scene::{Base, DVec3, Op, Scene, SolidId, SolidKind};
use scenec_tests::{frame, mended, random_scene, scene};
use scenec_text::{Code, Diagnostic, SourceFile};

/// Where scenes are looked at from, besides their own eye.
const EYES: [DVec3; 3] = [
    DVec3::new(3.1, 4.2, 2.3),
    DVec3::new(-2.7, -3.9, 4.1),
    DVec3::new(0.3, 0.2, -0.4),
];

fn findings(text: &str) -> Vec<Diagnostic> {
    check(&SourceFile::new("random", text).unwrap()).diagnostics
}

fn trace(scene: &Scene) -> Frame {
    let window = Window::whole(scene.settings.width, scene.settings.height);
    frame(&mut Reference::new(scene), window, Limits::NO_CUTOFF, false)
}

/// Small pictures of a text's scene from its own eye and from others.
fn views(text: &str) -> Vec<Frame> {
    let mut scene = scene("view", text);
    (scene.settings.width, scene.settings.height) = (24, 18);
    let eyes: Vec<_> = [scene.settings.eyepos].into_iter().chain(EYES).collect();
    let view = |eye| {
        scene.settings.eyepos = eye;
        trace(&scene)
    };
    eyes.into_iter().map(view).collect()
}

fn look_alike(a: &str, b: &str) -> bool {
    let same = |(a, b): (&Frame, &Frame)| {
        let (one, other) = (a.exact.as_ref().unwrap(), b.exact.as_ref().unwrap());
        let mut pixels = one.iter().flatten().zip(other.iter().flatten());
        a.ids == b.ids && pixels.all(|(a, b)| (a - b).abs() <= 1e-9)
    };
    views(a).iter().zip(&views(b)).all(same)
}

fn is_empty(text: &str) -> bool {
    let nothing = |frame: Frame| frame.ids.unwrap().iter().all(|id| *id == NOTHING);
    views(text).into_iter().all(nothing)
}

/// The text with the line at an offset replaced by another one.
fn with_line(text: &str, offset: u32, new: &str) -> String {
    let (before, after) = text.split_at(offset as usize);
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = after.find('\n').map_or(text.len(), |end| end + offset as usize);
    format!("{}{new}{}", &text[..start], &text[end..])
}

/// The text with another object submitted.
fn submitting(text: &str, name: &str) -> String {
    let submit = text.find(" <=").unwrap();
    with_line(text, submit as u32, &format!("!{name} <="))
}

/// The names in backticks, without their sigil.
fn names(message: &str) -> Vec<&str> {
    message.split('`').skip(1).step_by(2).map(|name| &name[1..]).collect()
}

/// The name that the line at an offset defines.
fn defines(text: &str, offset: u32) -> &str {
    let start = text[..offset as usize].rfind('\n').map_or(0, |end| end + 1);
    text[start..].split_whitespace().next().unwrap().trim_start_matches('!')
}

/// The operands of the combination at an offset.
fn operands(text: &str, offset: u32) -> [&str; 2] {
    let start = text[..offset as usize].rfind('\n').map_or(0, |end| end + 1);
    let words: Vec<_> = text[start..].lines().next().unwrap().split_whitespace().collect();
    [words[2], words[4]]
}

/// Whether a point is in a solid, straight from the inverse maps of its leaves.
fn holds(scene: &Scene, id: SolidId, point: DVec3) -> bool {
    match &scene.solid(id).kind {
        SolidKind::Leaf(leaf) => {
            let transform = scene.transform(leaf);
            let local = transform.inverse * (point - transform.centre);
            match leaf.base {
                Base::Sphere => local.length() <= 1.0,
                Base::HalfSpace => local.y <= 0.0,
            }
        }
        SolidKind::Paint { inside, .. } => holds(scene, *inside, point),
        SolidKind::Combine { op, left, right } => {
            let [left, right] = [*left, *right].map(|id| holds(scene, id, point));
            match op {
                Op::Union => left || right,
                Op::Intersection => left && right,
                Op::Subtraction => left && !right,
            }
        }
    }
}

/// Whether a finding is true; `None` for one of another group.
fn confirmed(text: &str, finding: &Diagnostic) -> Option<bool> {
    let at = finding.span().start;
    // A combination with one of its operands in the place of both.
    let keeping =
        |line: u32, name: &str| with_line(text, line, &format!("!{} := {name} | {name}", defines(text, line)));
    Some(match finding.code {
        Code::CoveredSolid => {
            let taker = finding.labels.last()?.span.start;
            let inner = names(&finding.message)[0];
            let [left, right] = operands(text, taker);
            assert!(inner == left || inner == right, "{inner}: {text}");
            let other = if inner == left { right } else { left };
            look_alike(text, &keeping(taker, other))
        }
        Code::IdleSubtraction => look_alike(text, &keeping(at, operands(text, at)[0])),
        Code::IdleIntersection => look_alike(text, &keeping(at, names(&finding.message)[1])),
        Code::EmptySubtraction | Code::EmptyIntersection => is_empty(&submitting(text, defines(text, at))),
        Code::BuriedLight => {
            let scene = scene("lights", text);
            let without = |scene: &Scene| {
                let mut scene = scene.clone();
                scene.lights.retain(|light| light.span != finding.span());
                scene
            };
            trace(&scene).exact == trace(&without(&scene)).exact
        }
        Code::BuriedEye => {
            let scene = scene("eye", text);
            holds(&scene, scene.root, scene.settings.eyepos)
        }
        Code::NothingInView => trace(&scene("view", text)).ids?.iter().all(|id| *id == NOTHING),
        Code::CoincidentOperands | Code::IllConditioned | Code::TooFarToResolve => false,
        _ => return None,
    })
}

/// Random scenes, and the same drawn together so that more of them nest, or apart so that more of them miss.
fn scenes() -> impl Iterator<Item = String> {
    (0..300).map(|seed| {
        let text = random_scene(seed);
        let scale = [1.0, 0.4, 3.0][seed as usize % 3];
        // One scale among three for the places, none for the sizes.
        let line = |line: &str| match line.split_once(" += ") {
            Some((name, values)) => {
                let values = values.split(' ').map(|value| value.parse::<f64>().unwrap() * scale);
                let values: Vec<_> = values.map(|value| value.to_string()).collect();
                format!("{name} += {}\n", values.join(" "))
            }
            None => format!("{line}\n"),
        };
        text.lines().map(line).collect()
    })
}

#[test]
fn what_is_said_of_random_scenes_is_so() {
    let mut confirmations: BTreeMap<&str, u32> = BTreeMap::new();
    for text in scenes() {
        for finding in findings(&text) {
            match confirmed(&text, &finding) {
                Some(true) => *confirmations.entry(finding.code.id()).or_default() += 1,
                Some(false) => panic!("not so: {finding:#?}\n{text}"),
                None => {}
            }
        }
    }
    // The test is of no use where nothing is ever said.
    for code in [
        Code::CoveredSolid,
        Code::IdleSubtraction,
        Code::EmptySubtraction,
        Code::EmptyIntersection,
        Code::IdleIntersection,
    ] {
        let count = confirmations.get(code.id()).copied().unwrap_or_default();
        assert!(count >= 5, "{code:?} came up {count} times: {confirmations:?}");
    }
}

const SETTINGS: &str = "width := 60\nheight := 40\nraydepth := 0\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
     eyepos_x := 0\neyepos_y := 1\neyepos_z := 500\nambient_r := 0.2\nambient_g := 0.2\nambient_b := 0.2\n\
     ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n";

/// A chain of unions of balls, each given by its radius and centre.
fn chain(balls: &[(f64, DVec3)]) -> String {
    let mut text = SETTINGS.to_owned();
    for (i, (radius, at)) in balls.iter().enumerate() {
        let DVec3 { x, y, z } = *at;
        text += &format!("!b{i} := sphere\n!b{i} *= {radius} {radius} {radius}\n!b{i} += {x} {y} {z}\n");
        text += &match i {
            0 => String::new(),
            1 => "!x := b0 | b1\n".to_owned(),
            _ => format!("!x := x | b{i}\n"),
        };
    }
    text + "!x <=\n"
}

#[test]
fn a_union_of_many_is_searched_as_if_pair_by_pair() {
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let balls: Vec<_> = (0..3000)
        .map(|_| {
            let at = DVec3::new(random(), random(), random()) * 20.0;
            (0.05 + 2.0 * random() * random(), at)
        })
        .collect();
    let held = |(small, at): &(f64, DVec3)| {
        balls
            .iter()
            .any(|(large, centre)| at.distance(*centre) + small < *large)
    };
    let expect = balls.iter().filter(|ball| held(ball)).count();
    let found = findings(&chain(&balls));
    assert!(
        found.iter().all(|finding| finding.code == Code::CoveredSolid),
        "{:?}",
        found.first()
    );
    assert!(found.len() == expect && expect > 100, "{} of {expect}", found.len());
}

#[test]
fn what_is_left_out_of_a_union_was_not_seen() {
    // Two that nothing holds, and many among them.
    let mut balls = vec![(1.5, DVec3::X), (1.5, DVec3::NEG_X)];
    balls.extend((0..24).map(|i| {
        let place = DVec3::new(f64::from(i * 7 % 5), f64::from(i * 5 % 3), f64::from(i % 4));
        (0.1 + f64::from(i * 11 % 13) * 0.08, place * 0.3 + 0.05)
    }));
    let mut text = chain(&balls);
    let colours = |text: &str| {
        views(text)
            .into_iter()
            .map(|frame| frame.exact.unwrap())
            .collect::<Vec<_>>()
    };
    let seen = colours(&text);
    let mut left_out = 0;
    while let Some(fix) = findings(&text).into_iter().find_map(|finding| finding.fix) {
        assert!(fix.title.starts_with("leave ") && !fix.safe, "{fix:?}");
        text = mended(&text, &fix);
        left_out += 1;
    }
    assert!(findings(&text).is_empty() && left_out > 10, "{left_out}: {text}");
    let now = colours(&text);
    let pairs = seen.iter().flatten().flatten().zip(now.iter().flatten().flatten());
    assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1e-9));
}

#[test]
fn deep_trees_and_balls_in_one_place_are_no_trouble() {
    let nested: Vec<_> = (1..20_000).map(|i| (f64::from(i) * 0.01, DVec3::ZERO)).collect();
    let covered = |text: &str, code| findings(text).iter().filter(|finding| finding.code == code).count();
    assert_eq!(covered(&chain(&nested), Code::CoveredSolid), nested.len() - 1);
    let same = vec![(1.5, DVec3::Y); 20_000];
    assert_eq!(covered(&chain(&same), Code::CoincidentOperands), same.len() - 1);
    let mut cheese = chain(&nested[..1]).replace("!x <=\n", "!x := b0 | b0\n");
    for i in 0..20_000 {
        cheese += &format!("!h{i} := sphere\n!h{i} += {} 9 0\n!x := x - h{i}\n", 3 * i);
    }
    assert_eq!(covered(&(cheese + "!x <=\n"), Code::IdleSubtraction), 20_000);
}
