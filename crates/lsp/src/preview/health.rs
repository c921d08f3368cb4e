//! How the process that draws fares: when it gets another chance, and when it gives no hope.
//!
//! It owns counts and times, and knows neither processes nor channels.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use super::supervisor::{Limits, State};
use super::words::Task;

/// After so many ends without a picture between, the process is started again only when it is asked for something.
const MOST_LOSSES: u32 = 5;
/// After so many ends with a device at work, the processor draws.
const MOST_DEVICE_LOSSES: u32 = 2;
/// While there is nothing to wait for.
const LONG: Duration = Duration::from_secs(3600);

pub(super) struct Health {
    limits: Limits,
    /// Ends since the last picture.
    losses: u32,
    device_losses: u32,
    /// Why it ended last.
    why: String,
    /// No start before this.
    not_before: Option<Instant>,
    /// Cancelled jobs of which it has not said that they ended.
    abandoned: BTreeMap<u64, Instant>,
    /// The longest text on the way.
    bytes: usize,
    busy: bool,
    asked: Instant,
    heard: Instant,
    moved: Instant,
    beat: u64,
}

impl Health {
    pub(super) fn new(limits: Limits, now: Instant) -> Self {
        Self {
            limits,
            losses: 0,
            device_losses: 0,
            why: String::new(),
            not_before: None,
            abandoned: BTreeMap::new(),
            bytes: 0,
            busy: false,
            asked: now,
            heard: now,
            moved: now,
            beat: 0,
        }
    }

    /// How long nothing has to be looked after if nothing happens.
    pub(super) fn wait(&self, running: bool, now: Instant) -> Duration {
        match self.not_before {
            Some(time) if !running => time.saturating_duration_since(now),
            _ if self.busy || !self.abandoned.is_empty() => self.limits.ping,
            _ => LONG,
        }
    }

    /// Why nothing can be asked for now, if so.
    pub(super) fn refusal(&self, now: Instant) -> Option<String> {
        let left = self.not_before?.saturating_duration_since(now);
        let down = self.losses >= MOST_LOSSES && !left.is_zero();
        down.then(|| format!("{}; it is tried again in {} s", self.trouble(), left.as_secs() + 1))
    }

    /// What went wrong last, and how often if that is why it is given up.
    pub(super) fn trouble(&self) -> String {
        if self.losses < MOST_LOSSES {
            return self.why.clone();
        }
        format!("{}, {} times in a row", self.why, self.losses)
    }

    pub(super) fn forgive(&mut self) {
        (self.losses, self.device_losses, self.not_before) = (0, 0, None);
    }

    /// Whether to start it; `waiting`: whether something is to be done.
    pub(super) fn may_start(&mut self, waiting: bool, now: Instant) -> bool {
        let due = self.not_before.is_none_or(|time| time <= now);
        let again = self.not_before.is_some() && self.losses < MOST_LOSSES;
        if due && !waiting && !again {
            // Down: there is no time to wait for any more.
            self.not_before = None;
        }
        due && (waiting || again)
    }

    pub(super) fn starting(&mut self) -> State {
        self.not_before = None;
        self.busy = false;
        if self.losses == 0 {
            State::Starting
        } else {
            State::Restarting
        }
    }

    /// The task as it may be asked for: a device that took the process down is asked no more.
    pub(super) fn allowed(&self, task: &Task) -> Task {
        match task {
            Task::Draw { quality, device } if self.shunned(device) => Task::Draw {
                quality: *quality,
                device: "cpu".to_owned(),
            },
            other => other.clone(),
        }
    }

    fn shunned(&self, device: &str) -> bool {
        device != "cpu" && self.device_losses >= MOST_DEVICE_LOSSES
    }

    /// A job with so much text is on its way.
    pub(super) fn sent(&mut self, bytes: usize, now: Instant) {
        self.bytes = self.bytes.max(bytes);
        self.moved(now);
    }

    pub(super) fn abandon(&mut self, job: u64, now: Instant) {
        self.abandoned.insert(job, now);
    }

    pub(super) fn ended(&mut self, job: u64) {
        self.abandoned.remove(&job);
    }

    pub(super) fn moved(&mut self, now: Instant) {
        (self.heard, self.moved) = (now, now);
    }

    pub(super) fn pong(&mut self, beat: u64, now: Instant) {
        self.heard = now;
        if beat != self.beat {
            (self.beat, self.moved) = (beat, now);
        }
    }

    /// A picture is done. Says so if another device than the wanted one had to draw it.
    pub(super) fn drawn(&mut self, task: &Task) -> Option<String> {
        self.losses = 0;
        let Task::Draw { device, .. } = task else {
            return None;
        };
        if self.shunned(device) {
            return Some(format!(
                "with the device `{device}` {} {MOST_DEVICE_LOSSES} times, so the cpu draws until a setting changes",
                self.why
            ));
        }
        if device != "cpu" {
            self.device_losses = 0;
        }
        None
    }

    /// Whether it is time to ask for a sign of life.
    pub(super) fn ask_for_life(&mut self, busy: bool, now: Instant) -> bool {
        let busy = busy || !self.abandoned.is_empty();
        if busy && !self.busy {
            self.moved(now);
        }
        if !busy {
            self.bytes = 0;
        }
        self.busy = busy;
        let due = busy && now.duration_since(self.asked) >= self.limits.ping;
        if due {
            self.asked = now;
        }
        due
    }

    /// Why it has to go, if so.
    pub(super) fn hopeless(&self, busy: bool, now: Instant) -> Option<&'static str> {
        let stall = self.limits.stall + Duration::from_secs((self.bytes >> 20) as u64);
        if !busy && self.abandoned.is_empty() {
            None
        } else if now.duration_since(self.heard) > self.limits.silence {
            Some("the drawing process fell silent")
        } else if now.duration_since(self.moved) > stall {
            Some("the drawing process made no progress any more")
        } else if self.abandoned.values().any(|since| now.duration_since(*since) > stall) {
            Some("the drawing process could not be stopped")
        } else {
            None
        }
    }

    /// It ended with these tasks on its hands.
    pub(super) fn lost<'a>(&mut self, why: &str, tasks: impl Iterator<Item = &'a Task>, now: Instant) -> State {
        let wait = self.limits.first_wait.saturating_mul(1 << self.losses.min(16));
        self.not_before = Some(now + wait.min(self.limits.longest_wait));
        self.losses += 1;
        self.why = why.to_owned();
        let with_device =
            |task: &Task| matches!(task, Task::Draw { device, .. } if device != "cpu" && !self.shunned(device));
        if tasks.into_iter().any(with_device) {
            self.device_losses += 1;
        }
        self.abandoned.clear();
        self.busy = false;
        if self.losses < MOST_LOSSES {
            State::Restarting
        } else {
            State::Down
        }
    }
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use super::Health;
    use crate::preview::{Limits, Quality, State, Task};

    const SECOND: Duration = Duration::from_secs(1);

    /// Patience in whole seconds: 4 of silence, 8 of standing still, new starts after 1 and then at most 4.
    fn health() -> (Health, Instant) {
        let now = Instant::now();
        let limits = Limits {
            ping: SECOND,
            silence: SECOND * 4,
            stall: SECOND * 8,
            first_wait: SECOND,
            longest_wait: SECOND * 4,
        };
        (Health::new(limits, now), now)
    }

    fn draw(device: &str) -> Task {
        Task::Draw {
            quality: Quality::Draft,
            device: device.to_owned(),
        }
    }

    #[test]
    fn starts_are_spaced_out_and_end() {
        let (mut health, mut now) = health();
        assert!(!health.may_start(false, now) && health.may_start(true, now));
        assert_eq!(health.starting(), State::Starting);
        for wait in [1, 2, 4, 4] {
            assert_eq!(health.lost("gone", [].iter(), now), State::Restarting);
            assert!(!health.may_start(true, now), "before its time");
            assert_eq!(health.wait(false, now), SECOND * wait);
            now += SECOND * wait;
            assert!(health.may_start(false, now));
            assert_eq!(health.starting(), State::Restarting);
            assert_eq!(health.trouble(), "gone");
        }
        assert_eq!(health.lost("gone", [].iter(), now), State::Down);
        assert_eq!(
            health.refusal(now).as_deref(),
            Some("gone, 5 times in a row; it is tried again in 5 s")
        );
        now += SECOND * 4;
        assert!(health.refusal(now).is_none() && !health.may_start(false, now) && health.may_start(true, now));
        health.drawn(&draw("cpu"));
        assert_eq!(health.lost("gone", [].iter(), now), State::Restarting);
    }

    #[test]
    fn a_device_that_kills_twice_is_shunned() {
        let (mut health, now) = health();
        let auto = draw("auto");
        health.lost("it ended", [draw("cpu")].iter(), now);
        health.lost("it ended", [auto.clone()].iter(), now);
        assert_eq!(health.allowed(&auto), auto);
        assert_eq!(health.drawn(&draw("cpu")), None);
        health.lost("it ended", [auto.clone()].iter(), now);
        assert_eq!(health.allowed(&auto), draw("cpu"));
        assert!(
            health
                .drawn(&auto)
                .is_some_and(|why| why.contains("`auto` it ended 2 times"))
        );
        assert_eq!(health.drawn(&draw("cpu")), None);
        health.forgive();
        assert_eq!(health.allowed(&auto), auto);
    }

    #[test]
    fn silence_and_standing_still_are_told_apart() {
        let (mut health, mut now) = health();
        assert!(health.ask_for_life(true, now + SECOND));
        assert_eq!(health.hopeless(true, now + SECOND * 4), None);
        assert_eq!(
            health.hopeless(true, now + SECOND * 6),
            Some("the drawing process fell silent")
        );
        assert_eq!(health.hopeless(false, now + SECOND * 6), None);
        health.moved(now);
        for _ in 0..4 {
            health.pong(7, now);
            now += SECOND * 2;
            assert_eq!(health.hopeless(true, now), None);
        }
        now += SECOND;
        health.pong(7, now);
        assert_eq!(
            health.hopeless(true, now),
            Some("the drawing process made no progress any more")
        );
        health.pong(8, now);
        assert_eq!(health.hopeless(true, now), None);
    }

    #[test]
    fn a_job_that_goes_on_in_spite_of_all_is_noticed() {
        let (mut health, mut now) = health();
        health.abandon(3, now);
        now += SECOND * 9;
        health.moved(now);
        assert_eq!(
            health.hopeless(false, now),
            Some("the drawing process could not be stopped")
        );
        health.ended(3);
        assert_eq!(health.hopeless(false, now), None);
    }

    #[test]
    fn long_texts_take_long() {
        let (mut health, now) = health();
        health.sent(5 << 20, now);
        for second in 1..=12 {
            health.pong(0, now + SECOND * second);
        }
        assert_eq!(health.hopeless(true, now + SECOND * 12), None);
        assert!(health.hopeless(true, now + SECOND * 14).is_some());
    }
}
