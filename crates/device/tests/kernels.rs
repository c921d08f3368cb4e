//! The kernels on a real compiler: shared structs lie alike on both sides.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    reason = "a test may, in its helpers too"
)]

use scenec_device::{DeviceInfo, Precision, Session, discover, options, probe, select};
use scenec_plan::LAYOUTS;

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
