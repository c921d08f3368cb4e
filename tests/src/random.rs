//! Seeded random scenes: trees of spheres and half-spaces under all operators, with mirrors and glass.

use std::fmt::Write;

use scenec_measure::Numbers;

/// The text of a scene of 1 to 16 leaves, the same for the same seed: every shape of tree, a third of the leaves
/// half-spaces, ellipsoids among the spheres, some mirrors and glass, and now and then the eye inside.
#[must_use]
pub fn random_scene(seed: u64) -> String {
    let mut numbers = Numbers::new(seed);
    let mut text = String::new();
    let near = numbers.below(4) == 0;
    let eye = if near { 0.6 } else { 4.0 };
    let mut setting = |name: &str, value: f64| {
        let _ = writeln!(text, "{name} := {value}");
    };
    setting("width", 48.0);
    setting("height", 36.0);
    setting("raydepth", 4.0);
    for axis in ["x", "y", "z"] {
        setting(&format!("lookat_{axis}"), 0.0);
        setting(&format!("eyepos_{axis}"), numbers.between(-eye, eye));
    }
    for colour in ["r", "g", "b"] {
        setting(&format!("ambient_{colour}"), numbers.between(0.2, 1.0));
        setting(&format!("ambient_int_{colour}"), numbers.between(0.5, 1.0));
    }
    for i in 0..2 {
        let [x, y, z] = std::array::from_fn(|_| numbers.between(-6.0, 6.0));
        let _ = writeln!(text, "*l{i} := {x} {y} {z} {} 0.6 0.5", numbers.between(0.2, 0.9));
    }
    for i in 0..4 {
        material(&mut text, &mut numbers, i);
    }
    let leaves = 1 + numbers.below(16);
    for i in 0..leaves {
        leaf(&mut text, &mut numbers, i);
    }
    join(&mut text, &mut numbers, leaves);
    text
}

/// Joins any two of what is left until one is left, and submits that.
fn join(text: &mut String, numbers: &mut Numbers, leaves: u64) {
    let mut open: Vec<String> = (0..leaves).map(|i| format!("o{i}")).collect();
    let mut joined = 0;
    while open.len() > 1 {
        let a = open.swap_remove(numbers.below(open.len() as u64) as usize);
        let b = open.swap_remove(numbers.below(open.len() as u64) as usize);
        let op = ["|", "|", "&", "-"][numbers.below(4) as usize];
        let _ = writeln!(text, "!j{joined} := {a} {op} {b}");
        open.push(format!("j{joined}"));
        joined += 1;
    }
    let _ = writeln!(text, "!{} <=", open[0]);
}

fn material(text: &mut String, numbers: &mut Numbers, i: u64) {
    let (reflect, refract) = match numbers.below(4) {
        0 => (0.5, 0.0),
        1 => (0.2, 0.7),
        _ => (0.0, 0.0),
    };
    let index = numbers.between(1.1, 1.8);
    let shiny = numbers.between(1.0, 60.0);
    let [r, g, b] = std::array::from_fn(|_| numbers.between(0.0, 1.0));
    let _ = writeln!(
        text,
        "?m{i} := 0.2 0.5 0.3 {reflect} {refract} {index} {shiny} {r} {g} {b}"
    );
}

fn leaf(text: &mut String, numbers: &mut Numbers, i: u64) {
    let sphere = numbers.below(3) > 0;
    let _ = writeln!(text, "!o{i} := {}", if sphere { "sphere" } else { "hp" });
    if sphere && numbers.below(2) == 0 {
        let [a, b, c] = std::array::from_fn(|_| numbers.between(0.4, 2.0));
        let _ = writeln!(text, "!o{i} *= {a} {b} {c}");
    }
    for axis in ["x", "y", "z"] {
        let _ = writeln!(text, "!o{i} #{axis}= {}", numbers.between(-3.0, 3.0));
    }
    let [x, y, z] = std::array::from_fn(|_| numbers.between(-1.5, 1.5));
    let _ = writeln!(text, "!o{i} += {x} {y} {z}\n!o{i} ?= m{}", numbers.below(4));
}

/// The text of a scene of 1 to 12 leaves on a grid: sizes are powers of two and half, places are multiples of a half and turns are
/// quarter ones, so that faces coincide, balls touch and contain each other, and edges meet; as people place things.
#[must_use]
pub fn aligned_scene(seed: u64) -> String {
    let mut numbers = Numbers::new(seed);
    let mut text = String::from(
        "width := 48\nheight := 36\nraydepth := 4\nlookat_x := .02\nlookat_y := -.03\nlookat_z := .01\n\
         ambient_r := .3\nambient_g := .5\nambient_b := .9\nambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n\
         *l := 3.1 4.3 5.7 .9 .8 .7\n",
    );
    for axis in ["x", "y", "z"] {
        let _ = writeln!(text, "eyepos_{axis} := {}", numbers.between(2.0, 4.0));
    }
    for i in 0..4 {
        material(&mut text, &mut numbers, i);
    }
    let leaves = 1 + numbers.below(12);
    for i in 0..leaves {
        aligned_leaf(&mut text, &mut numbers, i);
    }
    join(&mut text, &mut numbers, leaves);
    text
}

fn aligned_leaf(text: &mut String, numbers: &mut Numbers, i: u64) {
    let sphere = numbers.below(3) > 0;
    let _ = writeln!(text, "!o{i} := {}", if sphere { "sphere" } else { "hp" });
    if sphere {
        let one = numbers.below(3);
        let [a, b, c] = std::array::from_fn(|_| ["1", ".5", "2"][numbers.below(3) as usize]);
        let (b, c) = if one == 0 { (b, c) } else { (a, a) };
        let _ = writeln!(text, "!o{i} *= {a} {b} {c}");
    }
    for axis in ["x", "z"] {
        let turn = ["0", "1.5707963267948966", "pi", "-1.5707963267948966"][numbers.below(4) as usize];
        let _ = writeln!(text, "!o{i} #{axis}= {turn}");
    }
    let [x, y, z] = std::array::from_fn(|_| numbers.below(5) as f64 / 2.0 - 1.0);
    let _ = writeln!(text, "!o{i} += {x} {y} {z}\n!o{i} ?= m{}", numbers.below(4));
}
