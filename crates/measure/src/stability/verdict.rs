//! What came of one member of a case.

/// What came of one member of a case.
#[derive(Clone, PartialEq, Debug)]
pub struct Verdict {
    /// The case's name.
    pub case: String,
    /// The case's title.
    pub title: String,
    /// The member's name; empty if it is the only one.
    pub run: String,
    /// How much a relative change of the input is magnified, where that is known.
    pub condition: Option<f64>,
    /// The worst error of the tracers in single precision, with the largest that is allowed.
    pub single: Option<Outcome>,
    /// The same in double precision, the independent tracer among them where it is not the oracle.
    pub double: Option<Outcome>,
    /// Why single precision is not held to anything here, if it is not.
    pub beyond_single: Option<String>,
    /// Why the tracers take doubles here by themselves, if they do in each of its scenes.
    pub wider: Option<String>,
    /// Why it was not run on a device on which it is to be run besides, if it was not.
    pub not_run: Option<&'static str>,
    /// What POV-Ray makes of it, if it was asked: the share of pixels off the edges where it shows another surface than the
    /// reference, or why there is no picture of its.
    pub povray: Option<Result<f64, String>>,
}

/// An error beside its threshold.
#[derive(Clone, PartialEq, Debug)]
pub struct Outcome {
    /// The worst error, in the units of the oracle.
    pub error: f64,
    /// Which tracer it is of.
    pub tracer: String,
    /// The largest error allowed.
    pub threshold: f64,
}

impl Outcome {
    /// Whether the error is no larger than it may be.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.error <= self.threshold
    }
}

impl Verdict {
    /// Whether every tracer that is held to something holds it.
    #[must_use]
    pub fn holds(&self) -> bool {
        let single = self.single.as_ref().filter(|_| self.beyond_single.is_none());
        single.is_none_or(Outcome::holds) && self.double.as_ref().is_none_or(Outcome::holds)
    }
}
