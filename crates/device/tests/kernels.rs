//! The kernels on a real compiler: shared structs lie alike on both sides, and every combination of features compiles.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    reason = "a test may, in its helpers too"
)]

use scenec_device::{DeviceInfo, Precision, Session, discover, options, probe, select, source};
use scenec_plan::{Features, LAYOUTS};

/// The device to compile for; none where OpenCL is absent and nobody insists on it.
fn device() -> Option<&'static DeviceInfo> {
    let found = select("opencl", discover());
    if std::env::var_os("SCENEC_REQUIRE_OPENCL").is_some() {
        return Some(found.expect("SCENEC_REQUIRE_OPENCL is set, so a device must be found"));
    }
    found.inspect_err(|error| println!("skipped: {error}")).ok()
}

fn precisions(info: &DeviceInfo) -> Vec<Precision> {
    if info.has_f64 {
        vec![Precision::F32, Precision::F64]
    } else {
        vec![Precision::F32]
    }
}

#[test]
fn structs_have_the_same_size_and_offsets_on_the_device() {
    let Some(info) = device() else { return };
    let session = Session::open(info).unwrap();
    for precision in precisions(info) {
        let real = if precision == Precision::F64 { 8 } else { 4 };
        let mut expect = Vec::new();
        for layout in LAYOUTS {
            expect.push(layout.bytes(real) as u32);
            let mut offset = 0;
            for field in layout.fields {
                expect.push(offset as u32);
                offset += field.kind.bytes(real) * field.count.unwrap_or(1);
            }
        }
        let program = session.build(&probe(precision), &options(info, precision)).unwrap();
        let out = session.zeros::<u32>(expect.len()).unwrap();
        session.run(&program, "probe", &[(&out).into()], [1, 1]).unwrap();
        let mut seen = vec![0; expect.len()];
        session.read(&out, 0, &mut seen).unwrap();
        assert_eq!(seen, expect, "{precision}");
    }
}

/// Switches that a scene can set together; what is off otherwise follows from them.
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
        waiting: if on(9) { 4 } else { 1 },
        members: if on(12) { 16 } else { 0 },
    }
}

/// Switches in the table above.
const SWITCHES: u32 = 17;

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
        // 2^13 sets are few enough to look for the best one each time.
        let best = (0..1 << SWITCHES).max_by_key(|set| open.iter().filter(|pair| covers(*set, pair)).count());
        let best = best.unwrap();
        open.retain(|pair| !covers(best, pair));
        sets.push(best);
    }
    sets
}

#[test]
fn every_pair_of_features_compiles_without_a_warning() {
    let Some(info) = device() else { return };
    let session = Session::open(info).unwrap();
    for precision in precisions(info) {
        for set in covering_sets() {
            let features = features(set);
            let options = format!("{} -Werror", options(info, precision));
            if let Err(error) = session.build(&source(precision, &features), &options) {
                panic!("{precision} {features:?}: {error}\n{}", error.log().unwrap_or_default());
            }
        }
    }
}
