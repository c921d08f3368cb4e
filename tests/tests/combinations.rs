//! The kernels in many combinations of their features: each compiles without a warning, each draws what the program for
//! the scene alone draws, byte for byte, and a simulator finds no fault in what it reads and writes.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test may, in its helpers too")]

use std::fs;
use std::process::Command;

use scenec_device::{DeviceInfo, Precision, Session, options, source, tracer};
use scenec_picture::{Frame, Limits, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_tests::{device, frame, gallery};

/// Switches that can be set together; what is off otherwise follows from them.
fn features(bits: u32) -> Features {
    let on = |bit: u32| bits >> bit & 1 == 1;
    Features {
        balls: on(0),
        ellipsoids: on(1),
        half_spaces: on(2),
        products: on(14),
        programs: on(3),
        cells: on(15),
        hierarchy: on(4),
        lights: on(5),
        touches: on(13),
        highlights: on(6),
        reflections: on(7),
        refractions: on(8),
        branching: on(9),
        inside: on(10),
        supersampling: on(11),
        distances: on(16),
        spread: on(17),
        eights: on(18),
        waiting: if on(9) { 4 } else { 1 },
        members: if on(12) { 16 } else { 0 },
    }
}

/// Switches in the table above.
const SWITCHES: u32 = 19;

/// Sets of switches in which every two of them take all four states together; so does each alone.
fn covering_sets() -> Vec<u32> {
    let mut open: Vec<(u32, u32, u32, u32)> = Vec::new();
    for a in 0..SWITCHES {
        for b in 0..a {
            open.extend([(a, 0, b, 0), (a, 0, b, 1), (a, 1, b, 0), (a, 1, b, 1)]);
        }
    }
    let covers = |set: u32, &(a, x, b, y): &(u32, u32, u32, u32)| set >> a & 1 == x && set >> b & 1 == y;
    let mut sets = Vec::new();
    while !open.is_empty() {
        // Some thousand sets that have nothing to do with each other are as good as all.
        let some = (0..1_u32 << 12).map(|k| k.wrapping_mul(0x9E37_79B1) >> (32 - SWITCHES));
        let best = some.max_by_key(|set| open.iter().filter(|pair| covers(*set, pair)).count());
        let best = best.unwrap();
        open.retain(|pair| !covers(best, pair));
        sets.push(best);
    }
    sets
}

fn precisions(info: &DeviceInfo) -> &'static [Precision] {
    if info.has_f64 {
        &[Precision::F32, Precision::F64]
    } else {
        &[Precision::F32]
    }
}

#[test]
fn every_pair_of_features_compiles_without_a_warning() {
    let Some(info) = device() else { return };
    let session = Session::open(info).unwrap();
    for &precision in precisions(info) {
        for set in covering_sets() {
            let features = features(set);
            let options = format!("{} -Werror", options(info, precision));
            if let Err(error) = session.build(&source(precision, &features), &options) {
                panic!("{precision} {features:?}: {error}\n{}", error.log().unwrap_or_default());
            }
        }
    }
}

/// What a plan needs, and a set of switches besides.
fn with(own: Features, set: Features) -> Features {
    Features {
        balls: own.balls || set.balls,
        ellipsoids: own.ellipsoids || set.ellipsoids,
        half_spaces: own.half_spaces || set.half_spaces,
        products: own.products || set.products,
        programs: own.programs || set.programs,
        cells: own.cells || set.cells,
        hierarchy: own.hierarchy || set.hierarchy,
        lights: own.lights || set.lights,
        touches: own.touches || set.touches,
        highlights: own.highlights || set.highlights,
        reflections: own.reflections || set.reflections,
        refractions: own.refractions || set.refractions,
        branching: own.branching || set.branching,
        inside: own.inside || set.inside,
        supersampling: own.supersampling || set.supersampling,
        distances: own.distances || set.distances,
        spread: own.spread || set.spread,
        eights: own.eights || set.eights,
        waiting: own.waiting.max(set.waiting),
        // Without room, members are computed anew, which serves any plan.
        members: if set.members == 0 {
            0
        } else {
            own.members.max(set.members)
        },
    }
}

/// A few pixels of a plan by a program with these features.
fn drawn(info: &DeviceInfo, plan: &Plan, precision: Precision, features: &Features) -> Frame {
    let mut tracer = tracer(info, plan, precision, features).unwrap();
    let window = Window::whole(plan.view.width, plan.view.height);
    frame(&mut *tracer, window, Limits::NO_CUTOFF, false)
}

/// The gallery in a few pixels each.
fn stamps(size: (u32, u32)) -> Vec<(String, Plan)> {
    let small = |(name, mut scene): (String, scenec_scene::Scene)| {
        (scene.settings.width, scene.settings.height) = size;
        scene.settings.samples = scene.settings.samples.min(2);
        scene.settings.raydepth = scene.settings.raydepth.min(2);
        (name, plan(&scene).unwrap())
    };
    gallery().into_iter().map(small).collect()
}

/// Each set of switches with one scene, and each scene with its own features; all draw the same.
fn check(size: (u32, u32)) {
    let Some(info) = device() else { return };
    println!("on {}", info.name);
    let (stamps, sets) = (stamps(size), covering_sets());
    // Coprime steps through both lists bring together other scenes and sets in the second precision.
    for (turn, &precision) in precisions(info).iter().enumerate() {
        let own: Vec<_> = stamps
            .iter()
            .map(|(_, plan)| drawn(info, plan, precision, &Features::of(plan)))
            .collect();
        for (number, set) in sets.iter().enumerate() {
            let which = (number + turn * 5) % stamps.len();
            let (name, plan) = &stamps[which];
            let features = with(Features::of(plan), features(*set));
            let seen = drawn(info, plan, precision, &features);
            assert!(seen.picture == own[which].picture, "{name} {precision} {features:?}");
            assert_eq!(seen.ids, own[which].ids, "{name} {precision} {features:?}");
        }
        println!("{precision}: {} programs", stamps.len() + sets.len());
    }
}

#[test]
fn a_feature_that_is_not_needed_changes_nothing() {
    check((9, 7));
}

#[test]
#[ignore = "the next one runs it, in the simulator"]
fn simulated() {
    // The simulator takes its time over every instruction.
    check((5, 3));
}

#[cfg(target_os = "linux")]
#[test]
fn the_simulator_finds_no_fault_in_any_combination() {
    if Command::new("oclgrind").arg("--version").output().is_err() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("log");
    let mut command = Command::new("oclgrind");
    // Its interpreter lacks an instruction that the optimiser of its compiler makes.
    command.args([
        "--build-options",
        "-cl-opt-disable",
        "--data-races",
        "--uninitialized",
        "--log",
    ]);
    command.arg(&log).arg(std::env::current_exe().unwrap());
    command.args(["--exact", "simulated", "--ignored", "--nocapture"]);
    let output = command.env("SCENEC_CACHE_DIR", "off").output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{said}{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(said.contains("on Oclgrind") && said.contains("f64: "), "{said}");
    // Its exit code says nothing of what it found.
    assert_eq!(fs::read_to_string(&log).unwrap_or_default(), "");
}
