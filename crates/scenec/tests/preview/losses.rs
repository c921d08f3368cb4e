//! What happens when the process that draws is killed, stopped or missing.

use std::path::Path;
use std::process::Command;
use std::sync::mpsc::Receiver;
use std::time::Duration;

use scenec_lsp::preview::{Asked, Limits, News, Preview, Quality, Report, State};

use crate::room::{LONG, SEED, draw, led, look, slow};

const QUICK: Limits = Limits {
    ping: Duration::from_millis(100),
    first_wait: Duration::from_millis(10),
    ..Limits::DEFAULT
};

/// Sends a signal to the worker that wrote its number down.
fn signal(signal: &str, file: &Path) {
    let number = std::fs::read_to_string(file).unwrap();
    assert!(
        Command::new("kill")
            .args([signal, number.trim()])
            .status()
            .unwrap()
            .success()
    );
}

/// Waits for a status.
fn until(told: &Receiver<Report>, wanted: State) -> Option<String> {
    loop {
        match told.recv_timeout(LONG).expect("a report") {
            Report::Status { state, message, .. } if state == wanted => return message,
            _ => {}
        }
    }
}

/// A long picture that has begun to show.
fn begun(preview: &Preview, device: &str) -> Asked {
    let mut asked = preview.ask(look(None), draw(Quality::Full, device), slow().into());
    assert!(matches!(asked.wait(), Some((News::Pass(_), _))));
    asked
}

/// How a job ends: what the failure says, or the remark on the picture.
fn ending(mut asked: Asked) -> Result<Option<String>, String> {
    loop {
        match asked.wait().expect("an end") {
            (News::Failed { message }, _) => return Err(message),
            (News::Drawn { remark, .. }, _) => return Ok(remark),
            _ => {}
        }
    }
}

fn small(preview: &Preview, device: &str) -> Asked {
    preview.ask(look(Some((30, 20))), draw(Quality::Draft, device), SEED.into())
}

#[test]
fn a_worker_that_is_killed_is_replaced_and_its_device_shunned() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pid");
    let (preview, told) = led(Some(&file), QUICK);
    for _ in 0..2 {
        let asked = begun(&preview, "auto");
        signal("-KILL", &file);
        let failure = ending(asked).unwrap_err();
        assert!(failure.contains("the drawing process ended (signal: 9"), "{failure}");
        assert!(until(&told, State::Restarting).is_some_and(|message| message.contains("signal: 9")));
        until(&told, State::Ready);
    }
    let remark = ending(small(&preview, "auto")).unwrap();
    assert!(remark.is_some_and(|remark| remark.contains("so the cpu draws until a setting changes")));
    preview.forgive();
    assert_eq!(ending(small(&preview, "auto")), Ok(None));
}

#[test]
fn a_worker_that_falls_silent_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pid");
    let limits = Limits {
        silence: Duration::from_secs(8),
        ..QUICK
    };
    let (preview, told) = led(Some(&file), limits);
    let asked = begun(&preview, "cpu");
    signal("-STOP", &file);
    assert_eq!(ending(asked), Err("the drawing process fell silent".to_owned()));
    until(&told, State::Restarting);
    assert_eq!(ending(small(&preview, "cpu")), Ok(None));
}

#[test]
fn a_program_that_is_not_there_is_told_of() {
    let (sender, told) = std::sync::mpsc::channel();
    let report = move |report| sender.send(report).unwrap_or_default();
    let limits = Limits {
        longest_wait: Duration::from_secs(30),
        ..QUICK
    };
    let preview = Preview::new("/nonexistent/scenec".into(), Vec::new(), limits, report);
    let failure = ending(small(&preview, "cpu")).unwrap_err();
    assert!(
        failure.contains("can't be started from /nonexistent/scenec"),
        "{failure}"
    );
    assert!(until(&told, State::Down).is_some());
}

#[test]
fn a_worker_ends_with_its_leader() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pid");
    let (preview, _told) = led(Some(&file), QUICK);
    let asked = begun(&preview, "cpu");
    let number = std::fs::read_to_string(&file).unwrap();
    drop((preview, asked));
    let gone = (0..600).any(|_| {
        std::thread::sleep(Duration::from_millis(100));
        !Command::new("kill")
            .args(["-0", number.trim()])
            .output()
            .unwrap()
            .status
            .success()
    });
    assert!(gone, "process {number} goes on");
}
