//! What a worker draws and finds.

use scenec_lsp::preview::{CameraWish, Look, News, Order, Quality, Task};

use crate::room::{LONG, SEED, Worker, draw, led, look, passes, picture, rendered, slow};

/// The last pass is the picture of `scenec render`, pixel by pixel.
fn check(worker: &mut Worker, job: u64, look: Look, quality: Quality, text: &str, arguments: &[&str]) -> usize {
    worker.job(job, look, draw(quality, "cpu"), text);
    let news = worker.news(job);
    assert!(
        matches!(news.last(), Some((News::Drawn { remark: None, .. }, _))),
        "{news:?}"
    );
    let (passes, last) = passes(&news);
    assert_eq!(last, rendered(text, arguments), "{arguments:?}");
    for (number, pass) in (0..).zip(&passes) {
        assert_eq!((pass.pass, pass.last), (number, pass.pass as usize + 1 == passes.len()));
    }
    assert!(
        passes.windows(2).all(|pair| pair[0].width <= pair[1].width),
        "{passes:?}"
    );
    passes.len()
}

#[test]
fn the_last_pass_is_the_picture_that_is_rendered() {
    let mut worker = Worker::start();
    let first = check(&mut worker, 1, look(None), Quality::Full, SEED, &[]);
    assert!(first >= 2, "an unknown scene begins coarse");
    check(
        &mut worker,
        2,
        look(Some((300, 300))),
        Quality::Full,
        SEED,
        &["--size", "300x200"],
    );
    let many = format!("{SEED}\nsamples := 4\n");
    check(
        &mut worker,
        3,
        look(Some((150, 150))),
        Quality::Full,
        &many,
        &["--size", "150x100"],
    );
    check(
        &mut worker,
        4,
        look(Some((150, 150))),
        Quality::Draft,
        &many,
        &["--size", "150x100", "--samples", "1"],
    );
    let ignoring = Look {
        ignore_operators: true,
        ..look(Some((90, 60)))
    };
    let cut = SEED.replace("sph | plane", "sph - plane");
    check(
        &mut worker,
        5,
        ignoring,
        Quality::Draft,
        &cut,
        &["--size", "90x60", "--csg", "ignore"],
    );
}

#[test]
fn another_camera_is_the_same_as_one_in_the_file() {
    let mut worker = Worker::start();
    let camera = CameraWish {
        eye: [3.0, 2.0, -1.0],
        lookat: [0.0, 1.0, 0.0],
        up: None,
        fov: Some(1.0),
    };
    let wish = Look {
        camera: Some(camera),
        ..look(Some((90, 60)))
    };
    worker.job(1, wish, draw(Quality::Full, "cpu"), SEED);
    let (_, moved) = passes(&worker.news(1));
    let written = "eyepos_x := 3\neyepos_y := 2\neyepos_z := -1\nlookat_y := 1\nfov := 1\n";
    assert_eq!(moved, rendered(&format!("{SEED}\n{written}"), &["--size", "90x60"]));
    let blind = CameraWish {
        lookat: camera.eye,
        ..camera
    };
    worker.job(
        2,
        Look {
            camera: Some(blind),
            ..look(None)
        },
        draw(Quality::Full, "cpu"),
        SEED,
    );
    let news = worker.news(2);
    assert!(
        matches!(&news[..], [(News::Failed { message }, _)] if message.contains("where it looks")),
        "{news:?}"
    );
}

#[test]
fn a_broken_text_and_a_device_that_is_not_there_are_told() {
    let mut worker = Worker::start();
    worker.job(1, look(None), draw(Quality::Full, "cpu"), "!x := ball\n");
    let news = worker.news(1);
    assert!(
        matches!(&news[..], [(News::Failed { message }, _)] if message == "the text has errors"),
        "{news:?}"
    );
    worker.job(
        2,
        look(Some((60, 40))),
        draw(Quality::Full, "opencl:no such device"),
        SEED,
    );
    let news = worker.news(2);
    let Some((
        News::Drawn {
            remark: Some(remark), ..
        },
        _,
    )) = news.last()
    else {
        panic!("{news:?}");
    };
    assert!(remark.contains("so the cpu draws"), "{remark}");
    assert_eq!(passes(&news).1, rendered(SEED, &["--size", "60x40"]));
}

#[test]
fn any_device_draws_nearly_the_same() {
    let mut worker = Worker::start();
    worker.job(1, look(Some((60, 40))), draw(Quality::Full, "opencl"), SEED);
    let (passes, last) = passes(&worker.news(1));
    assert!(passes.last().is_some_and(|pass| pass.last));
    let expect = rendered(SEED, &["--size", "60x40"]);
    let apart = last.pixels().as_flattened().iter().zip(expect.pixels().as_flattened());
    let most = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(most <= 1.5 / 255.0, "{most}");
}

#[test]
fn a_job_is_cancelled_and_a_click_is_answered_meanwhile() {
    let mut worker = Worker::start();
    worker.job(1, look(None), draw(Quality::Full, "cpu"), &slow());
    worker.job(2, look(None), Task::Pick { x: 0.5, y: 0.9 }, &slow());
    assert!(
        matches!(worker.news(2)[..], [(News::Picked { solid: Some(1) }, _)]),
        "the plane"
    );
    worker.order(&Order::Ping, "");
    worker.order(&Order::Cancel { job: 1 }, "");
    assert!(matches!(worker.news(1).last(), Some((News::Cancelled, _))));
    worker.job(3, look(None), Task::Pick { x: 0.5, y: 0.01 }, SEED);
    assert!(matches!(worker.news(3)[..], [(News::Picked { solid }, _)] if solid != Some(1)));
    check(
        &mut worker,
        4,
        look(Some((60, 40))),
        Quality::Draft,
        SEED,
        &["--size", "60x40"],
    );
}

#[test]
fn a_click_finds_the_solid_that_the_picture_shows() {
    let text = "width := 90\nheight := 60\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\neyepos_x := 0\neyepos_y := 0\n\
        eyepos_z := 5\nambient_r := 1\nambient_g := 1\nambient_b := 1\nambient_int_r := 1\nambient_int_g := 1\n\
        ambient_int_b := 1\nraydepth := 0\n!a := sphere\n!a += -2 0 0\n!b := sphere\n!b += 2 0 0\n!c := a | b\n!c <=\n";
    let mut worker = Worker::start();
    for (job, x, expect) in [
        (1, 0.3, Some(0)),
        (2, 0.7, Some(1)),
        (3, 0.5, None),
        (4, -1.0, None),
        (5, f64::MAX, None),
    ] {
        worker.job(job, look(None), Task::Pick { x, y: 0.5 }, text);
        assert!(
            matches!(worker.news(job)[..], [(News::Picked { solid }, _)] if solid == expect),
            "{x}"
        );
    }
    // The overlay without its opacity is the line on black, and lies in the half of its object.
    worker.job(6, look(None), Task::Outline { solid: 0 }, text);
    let news = worker.news(6);
    let [(News::Outlined { width: 90, height: 60 }, png)] = &news[..] else {
        panic!("{news:?}");
    };
    let line = picture(png);
    let lit = |column: usize| (0..60).any(|row| line.row(row)[column] != [0.0; 3]);
    assert!((0..45).any(lit) && !(45..90).any(lit));
    worker.job(7, look(None), Task::Outline { solid: 99 }, text);
    assert!(matches!(&worker.news(7)[..], [(News::Outlined { .. }, png)] if png.is_empty()));
}

#[test]
fn the_end_of_the_line_is_the_end_even_in_the_midst_of_a_picture() {
    assert_eq!(Worker::start().end(b""), Some(0));
    let mut worker = Worker::start();
    worker.job(1, look(None), draw(Quality::Full, "cpu"), &slow());
    worker.hear();
    assert_eq!(worker.end(b""), Some(0));
    assert_eq!(Worker::start().end(b"Content-Length: 5\r\n\r\n"), Some(2));
}

#[test]
fn the_hand_passes_everything_on_and_cancels_at_once() {
    let (preview, _told) = led(None, scenec_lsp::preview::Limits::DEFAULT);
    let mut asked = preview.ask(look(Some((60, 40))), draw(Quality::Full, "cpu"), SEED.into());
    let mut news = Vec::new();
    while let Some(one) = asked.wait() {
        news.push(one);
    }
    assert_eq!(passes(&news).1, rendered(SEED, &["--size", "60x40"]));
    let begin = std::time::Instant::now();
    drop(preview.ask(look(None), draw(Quality::Full, "cpu"), slow().into()));
    let mut next = preview.ask(look(None), Task::Pick { x: 0.5, y: 0.9 }, SEED.into());
    assert!(matches!(next.wait(), Some((News::Picked { solid: Some(1) }, _))));
    assert!(begin.elapsed() < LONG);
}
