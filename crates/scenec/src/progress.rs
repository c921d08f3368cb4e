//! How far the work has come, on a terminal and only if it takes long enough to wonder.

use std::io::{self, IsTerminal};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use scenec_picture::Watch;

/// Whoever is done sooner than this has nothing to show.
const PATIENCE: Duration = Duration::from_millis(500);
const INTERVAL: Duration = Duration::from_millis(100);

/// Does the work while a bar on standard error follows the watch up to `pixels` more pixels. Without a terminal, or if
/// it is not wanted, there is no bar; afterwards there is none in any case.
pub(crate) fn shown<T>(watch: &Watch, pixels: u64, wanted: bool, work: impl FnOnce() -> T) -> T {
    if wanted {
        counted(watch, pixels, "pixels", work)
    } else {
        work()
    }
}

/// The same for a watch that counts something else, of which there are `number` to do.
pub(crate) fn counted<T>(watch: &Watch, number: u64, unit: &'static str, work: impl FnOnce() -> T) -> T {
    if !io::stderr().is_terminal() {
        return work();
    }
    let pace = Pace {
        begin: Instant::now(),
        before: watch.done(),
        number,
        unit,
    };
    let (working, done) = mpsc::channel::<()>();
    thread::scope(|scope| {
        // A bar that can't be drawn is no reason not to work.
        let _bar = thread::Builder::new().spawn_scoped(scope, move || follow(watch, &pace, &done));
        let outcome = work();
        drop(working);
        outcome
    })
}

/// Draws until the other end of the channel is gone.
fn follow(watch: &Watch, pace: &Pace, done: &Receiver<()>) {
    let waiting = |time| matches!(done.recv_timeout(time), Err(RecvTimeoutError::Timeout));
    if !waiting(PATIENCE) {
        return;
    }
    let bar = ProgressBar::with_draw_target(Some(pace.number), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:32} {percent:>3}%  {msg}") {
        bar.set_style(style);
    }
    loop {
        let finished = watch.done().saturating_sub(pace.before);
        bar.set_message(if watch.stopped() {
            "stopping".to_owned()
        } else {
            pace.words(finished, pace.begin.elapsed())
        });
        bar.set_position(finished.min(pace.number));
        bar.tick();
        if !waiting(INTERVAL) {
            break;
        }
    }
    bar.finish_and_clear();
}

struct Pace {
    begin: Instant,
    /// What the watch had counted before.
    before: u64,
    number: u64,
    unit: &'static str,
}

impl Pace {
    /// Speed and the time left, from the mean so far.
    fn words(&self, finished: u64, elapsed: Duration) -> String {
        let speed = finished as f64 / elapsed.as_secs_f64().max(1e-9);
        if finished == 0 {
            return "starting".to_owned();
        }
        let left = self.number.saturating_sub(finished) as f64 / speed;
        format!("{} {}/s, {} left", count(speed), self.unit, duration(left))
    }
}

fn count(number: f64) -> String {
    match number {
        1e6.. => format!("{:.1} M", number / 1e6),
        1e3.. => format!("{:.1} k", number / 1e3),
        _ => format!("{number:.0}"),
    }
}

fn duration(seconds: f64) -> String {
    // The cast saturates; nobody waits for so long.
    let whole = seconds.ceil() as u64;
    match (whole / 3600, whole / 60 % 60, whole % 60) {
        (0, 0, seconds) => format!("{seconds} s"),
        (0, minutes, seconds) => format!("{minutes} min {seconds} s"),
        (hours, minutes, _) => format!("{hours} h {minutes} min"),
    }
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use super::Pace;

    fn check(traced: u64, seconds: u64, expect: &str) {
        let pace = Pace {
            begin: Instant::now(),
            before: 0,
            number: 4_000_000,
            unit: "pixels",
        };
        assert_eq!(pace.words(traced, Duration::from_secs(seconds)), expect);
    }

    #[test]
    fn the_pace_is_told_in_units_that_fit() {
        check(0, 1, "starting");
        check(3_000_000, 2, "1.5 M pixels/s, 1 s left");
        check(250_000, 10, "25.0 k pixels/s, 2 min 30 s left");
        check(1000, 10, "100 pixels/s, 11 h 6 min left");
        check(4_000_000, 10, "400.0 k pixels/s, 0 s left");
    }
}
