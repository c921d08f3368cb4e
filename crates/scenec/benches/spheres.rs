//! How many balls a second the built-in tracer tests against rays where no hierarchy spares it any:
//! `cargo bench -p scenec --bench spheres`.
//!
//! Arguments after `--`: how many balls (1024), and how many rounds (9).

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a benchmark may stop at once, and prints"
)]

use std::fmt::Write;
use std::time::Instant;

use scenec_cpu::{Cpu, Number};
use scenec_picture::{Layers, Limits, Request, Tracer, Watch, Window};
use scenec_plan::Plan;

const SETTINGS: &str = "width := 640\nheight := 360\nraydepth := 0\neyepos_x := 0\neyepos_y := 0\neyepos_z := 9\n\
    lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := 1\nambient_g := 1\nambient_b := 1\nambient_int_r := 1\n\
    ambient_int_g := 1\nambient_int_b := 1\n?matt := 1 0 0 0 0 1 1 1 1 1\n";

fn main() {
    let mut arguments = std::env::args().skip(1).filter_map(|word| word.parse().ok());
    let balls = arguments.next().unwrap_or(1024);
    let rounds = arguments.next().unwrap_or(9);
    let mut plan = plan(balls);
    // All of them are tried by every ray.
    plan.nodes.clear();
    plan.linear = plan.islands.len();
    for threads in [1, 0] {
        measure::<f32>(&plan, balls, threads, rounds);
        measure::<f64>(&plan, balls, threads, rounds);
    }
}

/// Small balls all over the picture, without lights and without mirrors, so that each pixel is one ray.
fn plan(balls: usize) -> Plan {
    let mut text = SETTINGS.to_owned();
    for i in 0..balls {
        // Multiples of irrational numbers spread them evenly (Roberts 2018).
        let place = |step: f64| (i as f64 * step).fract().mul_add(8.0, -4.0);
        let (x, y) = (place(0.754_877_666_246_692_7), place(0.569_840_290_998_053_3));
        writeln!(
            text,
            "!s{i} := sphere\n!s{i} ?= matt\n!s{i} *= 0.05 0.05 0.05\n!s{i} += {x} {y} 0"
        )
        .unwrap();
        match i {
            0 => {}
            1 => writeln!(text, "!u1 := s0 | s1").unwrap(),
            _ => writeln!(text, "!u{i} := u{} | s{i}", i - 1).unwrap(),
        }
    }
    writeln!(text, "!u{} <=", balls - 1).unwrap();
    let scene = scenec_interpret::scene_of(&text).unwrap();
    scenec_plan::plan(&scene).unwrap()
}

fn measure<R: Number>(plan: &Plan, balls: usize, threads: usize, rounds: usize) {
    let mut tracer = Cpu::<R>::new(plan, threads).unwrap();
    let (width, height) = (plan.view.width, plan.view.height);
    let watch = Watch::new();
    let request = Request {
        window: Window {
            x: 0,
            y: 0,
            width,
            height,
        },
        limits: Limits::DEFAULT,
        layers: Layers::default(),
        watch: &watch,
    };
    let mut seconds: Vec<f64> = (0..rounds)
        .map(|_| {
            let start = Instant::now();
            let frame = tracer.trace(&request).unwrap();
            assert_eq!(frame.stats.rays(), u64::from(width) * u64::from(height));
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    let tests = f64::from(width) * f64::from(height) * balls as f64;
    println!(
        "{}: {:.2} thousand million tests a second, median of {rounds}",
        tracer.name(),
        tests / seconds[rounds / 2] / 1e9
    );
}
