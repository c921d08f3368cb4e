//! Trees of any size: they plan in bounded time and memory, and however they are written and divided they show the same.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test may, in its helpers too")]

use std::collections::HashMap;
use std::fmt::Write;
use std::time::{Duration, Instant};

use scenec_cpu::{Cpu, Number};
use scenec_device::{Precision, tracer};
use scenec_picture::{Frame, Limits, NOTHING, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;
use scenec_tests::{Numbers, device, frame, scene};

const STAGE: &str = "
width := 32
height := 24
raydepth := 2
lookat_x := .01
lookat_y := -.02
lookat_z := 0
ambient_r := .3
ambient_g := .5
ambient_b := .9
ambient_int_r := 1
ambient_int_g := 1
ambient_int_b := 1
*sun := 5 7 4 .8 .8 .7
?m0 := .1 .7 .2 0 0 1 16 .9 .4 .3
?m1 := .1 .5 .3 .3 0 1 40 .3 .8 .4
?m2 := .1 .3 .3 .1 .5 1.3 30 .5 .6 .9
";

/// How the combinations of a tree are written down.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Form {
    Plain,
    /// The right operand of each commutative one first, and what was the left one's comes second.
    Permuted,
    /// Of three operands that are joined alike the last two first: (a | b) | c = a | (b | c).
    Associated,
    /// By subtractions: a & b = a - (a - b).
    Subtracted,
    /// By complements within a ball around everything: a | b = all - ((all - a) - b).
    Complemented,
    /// Each ball is turned about its centre before anything else is done to it.
    Turned,
}

/// A random tree.
#[derive(Clone, Copy, Debug)]
struct Tree {
    leaves: u64,
    /// Of ten leaves, how many are half-spaces.
    planes: u64,
    /// The largest radius of a ball.
    radius: f64,
    /// Where the eye is.
    eye: [f64; 3],
}

const OUTSIDE: [f64; 3] = [1.7, 1.3, 2.9];

const TREES: [Tree; 9] = [
    Tree {
        leaves: 2,
        planes: 3,
        radius: 1.0,
        eye: OUTSIDE,
    },
    Tree {
        leaves: 24,
        planes: 0,
        radius: 0.8,
        eye: OUTSIDE,
    },
    Tree {
        leaves: 64,
        planes: 3,
        radius: 0.8,
        eye: OUTSIDE,
    },
    Tree {
        leaves: 64,
        planes: 3,
        radius: 0.8,
        eye: [0.1, 0.2, 0.15],
    },
    Tree {
        leaves: 64,
        planes: 10,
        radius: 0.0,
        eye: OUTSIDE,
    },
    Tree {
        leaves: 500,
        planes: 0,
        radius: 0.4,
        eye: OUTSIDE,
    },
    Tree {
        leaves: 500,
        planes: 3,
        radius: 0.4,
        eye: [0.1, 0.2, 0.15],
    },
    Tree {
        leaves: 500,
        planes: 10,
        radius: 0.0,
        eye: OUTSIDE,
    },
    Tree {
        leaves: 4096,
        planes: 0,
        radius: 0.15,
        eye: OUTSIDE,
    },
];

impl Tree {
    fn text(self, seed: u64, form: Form) -> String {
        let mut numbers = Numbers::new(seed);
        let mut text = STAGE.to_owned();
        for (axis, value) in ["x", "y", "z"].iter().zip(self.eye) {
            let _ = writeln!(text, "eyepos_{axis} := {value}");
        }
        for i in 0..self.leaves {
            let plane = numbers.below(10) < self.planes;
            let _ = writeln!(text, "!o{i} := {}", if plane { "hp" } else { "sphere" });
            if form == Form::Turned && !plane {
                let _ = writeln!(text, "!o{i} #x= 0.{i}\n!o{i} #y= 1.{i}");
            }
            if !plane {
                let radius = self.radius * numbers.between(0.3, 1.0);
                let flat = if numbers.below(3) == 0 {
                    numbers.between(0.4, 0.9)
                } else {
                    1.0
                };
                let _ = writeln!(text, "!o{i} *= {radius} {} {radius}", radius * flat);
            }
            for axis in ["x", "z"] {
                let _ = writeln!(text, "!o{i} #{axis}= {}", numbers.between(-3.1, 3.1));
            }
            let [x, y, z] = std::array::from_fn(|_| numbers.between(-1.0, 1.0));
            let _ = writeln!(text, "!o{i} += {x} {y} {z}\n!o{i} ?= m{}", numbers.below(3));
        }
        if form == Form::Complemented {
            text.push_str("!all := sphere\n!all *= 50 50 50\n");
        }
        let mut open: Vec<String> = (0..self.leaves).map(|i| format!("o{i}")).collect();
        let mut parts = HashMap::new();
        for joined in 0.. {
            if open.len() == 1 {
                break;
            }
            let a = open.swap_remove(numbers.below(open.len() as u64) as usize);
            let b = open.swap_remove(numbers.below(open.len() as u64) as usize);
            // What is joined last is united, so that there is something to see.
            let kinds = if open.len() < 3 { 3 } else { 6 };
            let op = ["|", "|", "|", "&", "-", "-"][numbers.below(kinds) as usize];
            let _ = match (form, op) {
                (Form::Permuted, "|" | "&") => writeln!(text, "!j{joined} := {b} {op} {a}"),
                (Form::Subtracted, "&") => writeln!(text, "!k{joined} := {a} - {b}\n!j{joined} := {a} - k{joined}"),
                (Form::Complemented, "|") => writeln!(
                    text,
                    "!k{joined} := all - {a}\n!l{joined} := k{joined} - {b}\n!j{joined} := all - l{joined}"
                ),
                (Form::Associated, "|" | "&") => match parts.get(&a) {
                    Some((inner, first, second)) if *inner == op => {
                        writeln!(
                            text,
                            "!k{joined} := {second} {op} {b}\n!j{joined} := {first} {op} k{joined}"
                        )
                    }
                    _ => writeln!(text, "!j{joined} := {a} {op} {b}"),
                },
                _ => writeln!(text, "!j{joined} := {a} {op} {b}"),
            };
            parts.insert(format!("j{joined}"), (op, a, b));
            open.push(format!("j{joined}"));
        }
        let _ = writeln!(text, "!{} <=", open[0]);
        text
    }

    fn scene(self, form: Form) -> Scene {
        scene("tree", &self.text(self.leaves + self.planes, form))
    }
}

fn whole(scene: &Scene) -> Window {
    Window::whole(scene.settings.width, scene.settings.height)
}

fn on_processor<R: Number>(scene: &Scene, plan: &Plan) -> Frame {
    frame(
        &mut Cpu::<R>::new(plan, 2).unwrap(),
        whole(scene),
        Limits::NO_CUTOFF,
        false,
    )
}

/// The same plan, each island in one piece.
fn undivided(plan: &Plan) -> Plan {
    let mut plan = plan.clone();
    plan.islands.iter_mut().for_each(|island| island.cells = None);
    plan
}

/// How many pixels see another leaf.
fn others(a: &Frame, b: &Frame) -> usize {
    let pairs = a.ids.iter().flatten().zip(b.ids.iter().flatten());
    pairs.filter(|(a, b)| a != b).count()
}

#[test]
fn cells_change_no_bit() {
    for tree in TREES {
        let scene = tree.scene(Form::Plain);
        let divided = plan(&scene).unwrap();
        let one = undivided(&divided);
        println!("{tree:?}: {:?}", divided.summary());
        let check = |a: Frame, b: Frame| {
            assert_eq!(others(&a, &b), 0, "{tree:?}");
            assert_eq!(a.picture, b.picture, "{tree:?}");
        };
        check(on_processor::<f32>(&scene, &divided), on_processor::<f32>(&scene, &one));
        check(on_processor::<f64>(&scene, &divided), on_processor::<f64>(&scene, &one));
    }
}

#[test]
fn random_trees_show_what_the_reference_shows() {
    for tree in TREES {
        let mut scene = tree.scene(Form::Plain);
        // The leaves that the eye sees are enough; colours are compared elsewhere.
        scene.settings.raydepth = 0;
        scene.lights.clear();
        let truth = frame(&mut Reference::new(&scene), whole(&scene), Limits::NO_CUTOFF, false);
        assert!(truth.ids.iter().flatten().any(|id| *id != NOTHING), "{tree:?}");
        let plan = plan(&scene).unwrap();
        let seen = others(&truth, &on_processor::<f64>(&scene, &plan));
        assert_eq!(seen, 0, "{tree:?}");
        // Single precision may take the other side of an outline.
        let seen = others(&truth, &on_processor::<f32>(&scene, &plan));
        assert!(seen <= 2, "{tree:?}: {seen} pixels");
    }
}

#[test]
fn trees_written_in_other_ways_are_the_same() {
    for tree in TREES {
        let scene = tree.scene(Form::Plain);
        let plain = on_processor::<f64>(&scene, &plan(&scene).unwrap());
        for form in [
            Form::Permuted,
            Form::Associated,
            Form::Subtracted,
            Form::Complemented,
            Form::Turned,
        ] {
            // A ball around everything cuts half-spaces off.
            if form == Form::Complemented && tree.planes > 0 {
                continue;
            }
            let scene = tree.scene(form);
            let other = on_processor::<f64>(&scene, &plan(&scene).unwrap());
            assert_eq!(others(&plain, &other), 0, "{tree:?} {form:?}");
            // What is turned has numbers of its own, a few roundings beside.
            if form != Form::Turned {
                assert_eq!(plain.picture, other.picture, "{tree:?} {form:?}");
            }
        }
    }
}

#[test]
fn devices_divide_the_same_way() {
    let Some(info) = device() else { return };
    for tree in TREES {
        let scene = tree.scene(Form::Plain);
        let divided = plan(&scene).unwrap();
        let shoot = |plan: &Plan, features: &Features| {
            let mut tracer = tracer(info, plan, Precision::F32, features).unwrap();
            frame(&mut *tracer, whole(&scene), Limits::NO_CUTOFF, false)
        };
        let special = shoot(&divided, &Features::of(&divided));
        let general = shoot(&divided, &Features::generic(&divided));
        assert_eq!(special.picture, general.picture, "{tree:?}");
        let whole = shoot(&undivided(&divided), &Features::generic(&divided));
        assert_eq!(special.picture, whole.picture, "{tree:?}");
        let seen = others(&special, &on_processor::<f32>(&scene, &divided));
        assert!(seen <= 2, "{tree:?}: {seen} pixels");
    }
}

/// Objects at random places, named h0, h1, ...
fn balls(count: u64, radius: f64) -> String {
    let mut numbers = Numbers::new(count);
    let mut text = String::new();
    for i in 0..count {
        let [x, y, z] = std::array::from_fn(|_| numbers.between(-1.0, 1.0));
        let _ = writeln!(
            text,
            "!h{i} := sphere\n!h{i} *= {radius} {radius} {radius}\n!h{i} += {x} {y} {z}"
        );
    }
    text
}

const BOX: &str = "
!f0 := hp
!f0 += 0 1 0
!f1 := hp
!f1 #x= pi
!f1 += 0 -1 0
!f2 := hp
!f2 #x= 1.5707963267948966
!f2 += 0 0 1
!f3 := hp
!f3 #x= -1.5707963267948966
!f3 += 0 0 -1
!f4 := hp
!f4 #z= 1.5707963267948966
!f4 += -1 0 0
!f5 := hp
!f5 #z= -1.5707963267948966
!f5 += 1 0 0
!c := f0 & f1
!c := c & f2
!c := c & f3
!c := c & f4
!c := c & f5
";

/// A chain over the objects h0, h1, ..., from what is there under the name `c`; operators by turns.
fn chain(text: &mut String, count: u64, operators: &[&str]) {
    for i in 0..count {
        let _ = writeln!(text, "!c := c {} h{i}", operators[i as usize % operators.len()]);
    }
    text.push_str("!c <=\n");
}

/// Plans a text; at most this many bytes for each leaf and this many seconds in a release build.
fn check_size(name: &str, objects: &str, islands: std::ops::RangeInclusive<usize>, bytes: u64) {
    let text = format!("{STAGE}eyepos_x := 2\neyepos_y := 2\neyepos_z := 4\n{objects}");
    let scene = scene(name, &text);
    let start = Instant::now();
    let plan = plan(&scene).unwrap();
    let took = start.elapsed();
    let summary = plan.summary();
    println!("{name}: {took:?} {summary:?}");
    assert!(islands.contains(&summary.islands), "{name}: {summary:?}");
    assert!(
        summary.bytes <= bytes * summary.leaves as u64 + 100_000,
        "{name}: {summary:?}"
    );
    // Ten times what an idle machine takes, and a build without optimisation is ten times slower again.
    let most = if cfg!(debug_assertions) { 300 } else { 30 };
    assert!(took < Duration::from_secs(most), "{name}: {took:?}");
}

/// A build without optimisation gets a tenth.
fn sized(count: u64) -> u64 {
    if cfg!(debug_assertions) { count / 10 } else { count }
}

#[test]
fn large_solids_plan_in_bounded_time_and_memory() {
    let first = "!c := sphere\n!c += 0 0 9\n";
    let ball = "!c := sphere\n";

    let count = sized(1_000_000);
    let mut unions = balls(count, 0.01) + first;
    chain(&mut unions, count, &["|"]);
    check_size("a chain of unions", &unions, count as usize..=count as usize + 1, 400);

    let count = sized(100_000);
    let mut deep = balls(count, 0.02) + ball;
    chain(&mut deep, count, &["|", "-", "&", "|", "-", "|", "-"]);
    check_size("a deep mixed tree", &deep, 0..=count as usize, 4000);

    let mut holed = balls(count / 100, 0.1) + BOX;
    chain(&mut holed, count / 100, &["-"]);
    check_size("a box less balls", &holed, 1..=1, 4000);

    let count = sized(65_536);
    let same: String = (0..count)
        .map(|i| format!("!h{i} := sphere\n!h{i} #y= {}\n", i % 7))
        .collect();
    for operators in [&["|"][..], &["&"], &["|", "&", "-"]] {
        let mut copies = same.clone() + ball;
        chain(&mut copies, count, operators);
        check_size("copies of one ball", &copies, 0..=1, 10);
    }

    let shells: String = (0..count)
        .map(|i| {
            let radius = 1.0 - i as f64 / count as f64 / 2.0;
            format!("!h{i} := sphere\n!h{i} *= {radius} {radius} {radius}\n")
        })
        .collect();
    let mut nested = shells + "!c := sphere\n!c *= 2 2 2\n";
    chain(&mut nested, count, &["-", "|"]);
    check_size("shells in shells", &nested, 0..=1, 4000);
}
