//! What a pixel costs.

use scenec_picture::Stats;

/// How a ray came about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Primary,
    Reflected,
    Refracted,
}

/// The account of a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tally {
    /// How many rays it may still use.
    left: u32,
    /// Rays used.
    rays: Stats,
    /// The most that rays not followed would have brought, all together; `None` if all were followed.
    dropped: Option<f64>,
}

impl Tally {
    /// An empty account.
    pub(crate) fn new(budget: u32) -> Self {
        Self {
            left: budget,
            rays: Stats::default(),
            dropped: None,
        }
    }

    /// The pixel's share of a frame's account, after all of its samples.
    pub(crate) fn stats(&self, samples: u32) -> Stats {
        Stats {
            dropped: self.dropped.unwrap_or(0.0) / f64::from(samples),
            over_budget: u64::from(self.dropped.is_some()),
            ..self.rays
        }
    }

    /// Whether there are no rays left.
    pub(crate) const fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Pays for a ray; not if the budget is used up.
    pub(crate) fn affords(&mut self, kind: Kind) -> bool {
        if self.left == 0 {
            return false;
        }
        self.left -= 1;
        match kind {
            Kind::Primary => self.rays.primary += 1,
            Kind::Reflected => self.rays.reflected += 1,
            Kind::Refracted => self.rays.refracted += 1,
        }
        true
    }

    /// Counts a ray towards a light, which costs nothing.
    pub(crate) fn shadow(&mut self) {
        self.rays.shadow += 1;
    }

    /// A ray that would have brought at most this is not followed.
    pub(crate) fn drop(&mut self, most: f64) {
        self.dropped = Some(self.dropped.unwrap_or(0.0) + most);
    }
}
