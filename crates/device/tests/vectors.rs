//! Two vectors are added on a real device, in every precision it has.
//!
//! Without OpenCL there is nothing to run: the tests say so and pass, unless `SCENEC_REQUIRE_OPENCL=1` insists.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may do both, in its helpers too"
)]

use scenec_device::{Arg, DeviceInfo, Plain, Program, Session, discover, gpu, select};
use std::fmt::Debug;
use std::ops::Add;
use std::time::Instant;

const ADD: &str = "
kernel void add(global const real *a, global const real *b, global real *sum, uint count, ulong shift) {
    uint i = get_global_id(1) * 1000 + get_global_id(0);
    if (get_global_id(0) < 1000 && i < count)
        sum[i] = a[i] + b[i] + (real)shift;
}
";

/// The device to test on, or none with a word about it.
fn device() -> Option<&'static DeviceInfo> {
    match select("opencl", discover()) {
        Ok(device) => Some(device),
        Err(error) if std::env::var("SCENEC_REQUIRE_OPENCL").is_ok_and(|set| set == "1") => panic!("{error}"),
        Err(error) => {
            println!("skipped: {error}");
            None
        }
    }
}

/// Adds `count` elements, and compares with the same sum here.
fn check<T>(session: &Session, real: &str, count: u32, make: impl Fn(u32) -> T)
where
    T: Plain + Add<Output = T> + PartialEq + Default,
{
    let start = Instant::now();
    let program = session.build(ADD, &format!("-D real={real}")).unwrap();
    let built = start.elapsed();
    let a: Vec<T> = (0..count).map(&make).collect();
    let b: Vec<T> = (0..count).map(|i| make(3 * i)).collect();
    let (left, right) = (session.upload(&a).unwrap(), session.upload(&b).unwrap());
    let sum = session.zeros::<T>(count as usize).unwrap();
    let args: [Arg<'_>; 5] = [
        (&left).into(),
        (&right).into(),
        (&sum).into(),
        count.into(),
        7u64.into(),
    ];
    let start = Instant::now();
    let time = session
        .run(&program, "add", &args, [1000, count.div_ceil(1000)])
        .unwrap();
    println!(
        "{real} x {count}: built in {built:?}, first run {:?}, of it {time} ns in the kernel",
        start.elapsed()
    );
    let mut got = vec![T::default(); count as usize];
    session.read(&sum, 0, &mut got).unwrap();
    let expect: Vec<T> = a.into_iter().zip(b).map(|(a, b)| a + b + make(7)).collect();
    assert!(got == expect, "{real} x {count}");
}

#[test]
fn sums_are_right_in_every_precision() {
    let Some(device) = device() else { return };
    println!("{device:#?}");
    let session = Session::open(device).unwrap();
    for count in [1, 15, 1000, 4321] {
        check(&session, "float", count, |i| i as f32);
        if device.has_f64 {
            check(&session, "double", count, f64::from);
        }
    }
    check(&session, "uint", 100, |i| i);
}

#[test]
fn empty_vectors_have_a_place() {
    let Some(device) = device() else { return };
    let session = Session::open(device).unwrap();
    let program = session.build(ADD, "-D real=float").unwrap();
    let (none, sum) = (session.upload::<f32>(&[]).unwrap(), session.zeros::<f32>(0).unwrap());
    assert!(none.is_empty() && sum.is_empty());
    let args: [Arg<'_>; 5] = [(&none).into(), (&none).into(), (&sum).into(), 0u32.into(), 0u64.into()];
    session.run(&program, "add", &args, [1, 1]).unwrap();
    assert_eq!(session.run(&program, "add", &args, [0, 1]), Ok(0));
    session.read(&sum, 0, &mut []).unwrap();
}

#[test]
fn parts_are_read_and_ranges_checked() {
    let Some(device) = device() else { return };
    let session = Session::open(device).unwrap();
    let buffer = session.upload(&[1u32, 2, 3, 4]).unwrap();
    let mut two = [0; 2];
    session.read(&buffer, 1, &mut two).unwrap();
    assert_eq!(two, [2, 3]);
    for start in [3, 4, usize::MAX] {
        let error = session.read(&buffer, start, &mut two).unwrap_err();
        assert!(error.to_string().contains("4 elements"), "{error}");
    }
}

/// `fault` must fail with `part` in a message of one line.
fn check_fault<T: Debug>(fault: Result<T, scenec_device::DeviceError>, part: &str) {
    let error = fault.unwrap_err();
    assert!(error.to_string().contains(part), "{error}");
    assert!(!error.to_string().contains('\n'), "{error}");
}

#[test]
fn mistakes_are_errors_with_words() {
    let Some(device) = device() else { return };
    let session = Session::open(device).unwrap();
    let broken = session.build("kernel void f() { y = 1; }", "").unwrap_err();
    assert!(broken.log().is_some_and(|log| log.contains('y')), "{broken:?}");
    check_fault(Err::<(), _>(broken), "the kernels don't compile for");
    check_fault(session.build(ADD, "-D real=float -no-such-option"), "compile");
    check_fault(session.build("\0", ""), "zero byte");
    let program: Program = session.build(ADD, "-D real=float").unwrap();
    let buffer = session.zeros::<f32>(1).unwrap();
    check_fault(
        session.run(&program, "subtract", &[], [1, 1]),
        "prepare the kernel subtract",
    );
    check_fault(
        session.run(&program, "add", &[(&buffer).into()], [1, 1]),
        "takes 5 arguments, not 1",
    );
    let wrong: [Arg<'_>; 5] = [
        (&buffer).into(),
        (&buffer).into(),
        (&buffer).into(),
        1u64.into(),
        1u64.into(),
    ];
    check_fault(session.run(&program, "add", &wrong, [1, 1]), "CL_INVALID_ARG_SIZE");
    check_fault(session.zeros::<f64>(usize::MAX), "bytes in one buffer");
    let mut elsewhere = device.clone();
    elsewhere.index = usize::MAX;
    check_fault(Session::open(&elsewhere), "not a device of this machine");
}

#[test]
fn every_listed_device_can_be_opened() {
    for device in &discover().devices {
        Session::open(device).unwrap();
    }
    if let Some(device) = gpu(discover()) {
        Session::open(device).unwrap();
    }
}
