//! Error against run time: bounds hold, and what is written is what was found.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_measure::{Bench, Bound, Effort, Report, Setting, csv, page, png, svg};
use scenec_picture::{TraceError, Watch};
use scenec_scene::Scene;
use scenec_tests::{device, gallery, random_scene, scene};

/// All families in a second or so.
const EFFORT: Effort = Effort {
    pixels: 24 * 16,
    reference_samples: 64,
    samples: &[1, 4, 16],
    variants: &[1, 4, 16],
    cutoffs: &[0.25, 1.0 / 64.0, 0.0],
    repeats: 1,
    seconds: None,
};

fn bench<'a>(scene: &'a Scene, effort: Effort, watch: &'a Watch, counter: &'a Watch) -> Bench<'a> {
    Bench {
        scene,
        effort,
        device: None,
        shelf: None,
        salt: Vec::new(),
        watch,
        counter,
    }
}

/// The report of a scene, each process of which takes a second.
fn report(scene: &Scene, effort: Effort) -> Report {
    let (watch, counter) = (Watch::new(), Watch::new());
    let bench = bench(scene, effort, &watch, &counter);
    let report = bench.run(&mut |_, _| Ok(1.0)).unwrap();
    assert_eq!(counter.done(), bench.work());
    report
}

/// No row is more wrong than it says.
fn check(name: &str, scene: Scene, effort: Effort) {
    let report = report(&effort.shrunk(scene), effort);
    let words = |row: &scenec_measure::Row| {
        let (found, bound) = (row.figures.max_abs, row.bound);
        format!("{}, {}: {found} of {bound:?}", row.family, row.knob)
    };
    let defects: Vec<_> = report.defects().map(words).collect();
    assert!(defects.is_empty(), "{name}: own {}: {defects:#?}", report.truth.own_max);
}

#[test]
fn a_picture_is_as_large_as_there_is_time_for() {
    let sized = |seconds: Option<f64>| {
        let effort = Effort {
            pixels: 48 * 32,
            seconds,
            ..EFFORT
        };
        let (mut scene, watch) = (small(), Watch::new());
        (scene.settings.width, scene.settings.height) = (480, 320);
        let settings = effort.fitted(scene, None, &watch).unwrap().settings;
        (settings.width, settings.height)
    };
    assert_eq!(sized(None), (48, 32));
    assert_eq!(sized(Some(1e9)), (48, 32));
    assert_eq!(sized(Some(1e-9)), (24, 16));
}

fn small() -> Scene {
    let text = "width := 24\nheight := 16\nraydepth := 3\neyepos_x := 0\neyepos_y := 1\neyepos_z := 4\n\
                lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := .2\nambient_g := .4\nambient_b := .9\n\
                ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n?m := .1 .5 .4 .5 0 1 30 .9 .6 .4\n\
                !a := sphere\n!f := hp\n!f += 0 -1 0\n!s := a | f\n!s ?= m\n!s <=\n*l := 3 4 2 .8 .8 .8\n";
    scene("small", text)
}

#[test]
fn no_picture_of_the_gallery_is_more_wrong_than_it_says() {
    for (name, scene) in gallery() {
        check(&name, scene, EFFORT);
    }
}

/// Few pixels at four samples.
const TINY: Effort = Effort {
    pixels: 16 * 12,
    samples: &[4],
    variants: &[4],
    cutoffs: &[0.25],
    ..EFFORT
};

/// The seeds of a property test: some of them, or as many as `SCENEC_SEEDS` says; and in any case those at which an estimate
/// has been too small before, because something lay between all samples of a pixel and of those around it.
fn seeds(some: u64) -> impl Iterator<Item = u64> {
    let asked = std::env::var("SCENEC_SEEDS").map(|count| count.parse().unwrap());
    let count = asked.unwrap_or(some);
    (0..count).chain([492, 807, 894].into_iter().filter(move |seed| *seed >= count))
}

#[test]
fn no_random_picture_is_more_wrong_than_it_says() {
    for seed in seeds(150) {
        check(&format!("seed {seed}"), scene("random", &random_scene(seed)), TINY);
    }
}

#[test]
fn at_the_samples_of_the_reference_truncation_and_rounding_are_all_that_is_wrong() {
    let effort = Effort {
        reference_samples: 4,
        ..TINY
    };
    for seed in seeds(150) {
        let report = report(&effort.shrunk(scene("random", &random_scene(seed))), effort);
        for row in &report.rows {
            let bound = row.bound.truncation + row.bound.rounding;
            let words = || format!("seed {seed}, {}, {}: {:?}", row.family, row.knob, row.bound);
            assert!(row.figures.max_abs <= bound, "{}: {}", words(), row.figures.max_abs);
        }
    }
}

#[test]
fn a_picture_that_is_more_wrong_than_it_says_is_a_defect() {
    let mut report = report(&small(), EFFORT);
    assert_eq!(report.defects().count(), 0);
    report.rows[0].bound = Bound::default();
    assert_eq!(
        report.defects().map(|row| row.knob.as_str()).collect::<Vec<_>>(),
        ["samples 1"]
    );
    assert!(page(&[("small".to_owned(), report)], |_| String::new()).contains("**DEFECT**"));
}

/// The bench of the small scene with a device, if there is one, whose processes take so long.
fn on_device(
    effort: Effort,
    process: &mut dyn FnMut(&Setting) -> Result<f64, TraceError>,
) -> Option<Result<Report, TraceError>> {
    let (watch, counter, scene) = (Watch::new(), Watch::new(), small());
    let bench = Bench {
        device: Some(device()?),
        ..bench(&scene, effort, &watch, &counter)
    };
    Some(bench.run(&mut |setting, _| process(setting)))
}

#[test]
fn of_fast_math_nothing_is_promised() {
    let Some(report) = on_device(TINY, &mut |_| Ok(1.0)) else {
        return;
    };
    let mut report = report.unwrap();
    assert_eq!(report.defects().count(), 0);
    let fast = |row: &scenec_measure::Row| row.family == "opencl fast-math f32";
    let place = report.rows.iter().position(fast).unwrap();
    // However wrong it is, and however quick.
    let row = &mut report.rows[place];
    assert!(!row.front && row.tracer.contains("fast-math"), "{}", row.tracer);
    row.figures.max_abs = row.bound.max + report.truth.own_max + 1.0;
    let row = &report.rows[place];
    assert!(report.is_unpromised(row) && !report.is_defect(row));
    let text = page(&[("small".to_owned(), report)], |_| String::new());
    assert!(
        text.contains("not promised |") && !text.contains("**DEFECT**"),
        "{text}"
    );
}

#[test]
fn fast_math_that_does_not_end_is_left_out() {
    let mut asked = 0;
    let report = on_device(EFFORT, &mut |setting| {
        if setting.machine.promises() {
            return Ok(1.0);
        }
        asked += 1;
        Err(TraceError::Failed("it did not end".to_owned()))
    });
    let Some(report) = report else { return };
    let report = report.unwrap();
    assert!(report.rows.iter().all(|row| row.setting.machine.promises()));
    assert_eq!((report.notes.len(), asked), (1, 1), "{:?}", report.notes);
}

#[test]
fn the_table_has_all_families_and_the_front_is_not_beaten() {
    let report = report(&small(), EFFORT);
    let mut families: Vec<_> = report.rows.iter().map(|row| row.family.as_str()).collect();
    families.dedup();
    assert_eq!(
        families,
        ["cpu f32", "cpu f64", "cpu f32 x4, cut-off", "cpu f32 x4, depth"]
    );
    assert_eq!(report.rows.len(), 3 + 3 + 3 + 3);
    for row in &report.rows {
        let beaten = report
            .rows
            .iter()
            .any(|other| other.kernel.median < row.kernel.median && other.figures.rmse < row.figures.rmse);
        assert!(!(beaten && row.front), "{}, {}", row.family, row.knob);
        assert_eq!((row.process.cold, row.process.median, row.process.mad), (1.0, 1.0, 0.0));
    }
    // More samples are better, fewer bounces worse; a cut-off that drops something says how much.
    let error = |knob: &str| report.rows.iter().find(|row| row.knob == knob).unwrap().figures.rmse;
    assert!(error("samples 16") < error("samples 1"));
    assert!(error("raydepth 0") > error("raydepth 2"));
    let dropped = |knob: &str| {
        report
            .rows
            .iter()
            .find(|row| row.knob == knob)
            .unwrap()
            .bound
            .truncation
    };
    assert!(dropped("cut-off 1/4") > dropped("no cut-off"));
    assert!(dropped("raydepth 0") > dropped("raydepth 2"));
}

#[test]
fn a_report_is_a_table_a_page_and_a_diagram() {
    let reports = [("a | b".to_owned(), report(&small(), EFFORT))];
    let table = csv(&reports);
    assert_eq!(table.lines().count(), 1 + 12);
    assert!(table.starts_with("scene,family,knob,"));
    let line = table.lines().nth(7).unwrap();
    assert!(
        line.starts_with("a | b,\"cpu f32 x4, cut-off\",cut-off 1/4,\"cpu f32, "),
        "{line}"
    );
    let text = page(&reports, |index| format!("wp-{index}.svg"));
    for words in [
        "## a \\| b",
        "![work and precision](wp-0.svg)",
        "**cpu f64**",
        "| raydepth 2 |",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let drawing = svg("a | b", &reports[0].1).unwrap();
    assert!(drawing.starts_with("<svg") && drawing.contains("cpu f32 x4, depth") && drawing.contains("1/255"));
    let picture = png("a | b", &reports[0].1).unwrap();
    assert_eq!((picture.width(), picture.height()), (1200, 800));
    // The frame, the letters and the curves are neither white nor alike.
    let dark = picture
        .pixels()
        .iter()
        .filter(|pixel| pixel.iter().sum::<f32>() < 1.5)
        .count();
    assert!((2000..200_000).contains(&dark), "{dark}");
}

#[test]
fn references_are_kept_until_something_changes() {
    let shelf = tempfile::tempdir().unwrap();
    let (watch, counter) = (Watch::new(), Watch::new());
    let scene = small();
    let mut other = small();
    other.lights[0].colour.x += 1e-15;
    let run = |scene: &Scene, salt: &[u8]| {
        let bench = Bench {
            shelf: Some(shelf.path().join("deep")),
            salt: salt.to_owned(),
            ..bench(scene, EFFORT, &watch, &counter)
        };
        bench.run(&mut |_, _| Ok(1.0)).unwrap().truth
    };
    let first = run(&scene, b"");
    assert!(!first.kept);
    let second = run(&scene, b"");
    assert!(second.kept);
    assert_eq!(
        (first.exact, first.own_max, first.own_rms),
        (second.exact, second.own_max, second.own_rms)
    );
    assert!(!run(&other, b"").kept);
    assert!(!run(&scene, b"another program").kept);
    // What is not whole is made anew.
    for entry in std::fs::read_dir(shelf.path().join("deep")).unwrap() {
        let path = entry.unwrap().path();
        let bytes = std::fs::read(&path).unwrap();
        std::fs::write(&path, &bytes[..bytes.len() - 1]).unwrap();
    }
    assert!(!run(&scene, b"").kept);
}

#[test]
fn somebody_may_say_stop_at_any_time() {
    let (watch, counter) = (Watch::new(), Watch::new());
    let scene = small();
    let bench = bench(&scene, EFFORT, &watch, &counter);
    let mut runs = 0;
    let stopped = bench.run(&mut |_, _| {
        runs += 1;
        watch.stop();
        Ok(1.0)
    });
    assert_eq!((stopped.unwrap_err(), runs), (TraceError::Cancelled, 1));
    assert_eq!(bench.run(&mut |_, _| Ok(1.0)).unwrap_err(), TraceError::Cancelled);
}
