//! Where the time went.

use std::time::{Duration, Instant};

/// Wall time by stage.
pub(super) struct Clock {
    begin: Instant,
    last: Instant,
    stages: Vec<(&'static str, Duration)>,
}

impl Clock {
    pub(super) fn start() -> Self {
        let now = Instant::now();
        Self {
            begin: now,
            last: now,
            stages: Vec::new(),
        }
    }

    /// The time since the last lap belongs to this stage; a stage that runs again adds to its time.
    pub(super) fn lap(&mut self, stage: &'static str) {
        let now = Instant::now();
        let time = now - self.last;
        self.last = now;
        match self.stages.iter_mut().find(|(known, _)| *known == stage) {
            Some((_, sum)) => *sum += time,
            None => self.stages.push((stage, time)),
        }
    }

    /// The stages in the order in which they first ended.
    pub(super) fn stages(&self) -> &[(&'static str, Duration)] {
        &self.stages
    }

    /// From the start to the last lap.
    pub(super) fn total(&self) -> Duration {
        self.last - self.begin
    }
}
