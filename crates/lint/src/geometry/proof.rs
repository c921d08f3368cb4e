//! What was shown about two solids, with the figures, in words.

use std::fmt;

use scenec_scene::DVec3;

/// Why one solid lies inside another, or apart from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Proof {
    /// The figures of the leaves that decided.
    pub(crate) fact: Fact,
    /// Whether there were others as well, since a solid has several parts.
    pub(crate) parts: bool,
}

/// What was shown about two leaves, or the boxes around two solids.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fact {
    /// A ball in a ball.
    Radii { distance: f64, inner: f64, outer: f64 },
    /// An ellipsoid in an ellipsoid: the farthest point from the outer centre, where its surface is at 1.
    Reach { reach: f64 },
    /// An ellipsoid in a half-space: how deep it lies below the plane.
    Depth { depth: f64 },
    /// A half-space in a parallel one: how deep its plane lies.
    Parallel { depth: f64 },
    /// Two balls apart.
    Between { distance: f64, radii: f64 },
    /// A plane between two solids: how far they are apart along its normal.
    Gap { along: DVec3, gap: f64 },
    /// Boxes apart along an axis: where the one ends and the other begins.
    Boxes { axis: usize, end: f64, begin: f64 },
}

impl Fact {
    pub(crate) const fn alone(self) -> Proof {
        Proof {
            fact: self,
            parts: false,
        }
    }
}

impl Proof {
    /// This and another one together show it.
    pub(crate) const fn and_others(self) -> Self {
        Self { parts: true, ..self }
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.parts {
            write!(f, "part by part: ")?;
        }
        match self.fact {
            Fact::Radii { distance, inner, outer } => write!(
                f,
                "radius {} and {} between the centres are less than the radius {}",
                figure(inner),
                figure(distance),
                figure(outer)
            ),
            Fact::Reach { reach } => write!(f, "it reaches to {} of the way to the outer surface", figure(reach)),
            Fact::Depth { depth } => write!(f, "all of it lies at least {} below the plane", figure(depth)),
            Fact::Parallel { depth } => write!(f, "its plane lies {} below the other", figure(depth)),
            Fact::Between { distance, radii } => write!(
                f,
                "the centres are {} apart, the radii add up to {}",
                figure(distance),
                figure(radii)
            ),
            Fact::Gap { along, gap } => write!(
                f,
                "along ({} {} {}) they are {} apart",
                figure(along.x),
                figure(along.y),
                figure(along.z),
                figure(gap)
            ),
            Fact::Boxes { axis, end, begin } => {
                let axis = ["x", "y", "z"].get(axis).unwrap_or(&"?");
                write!(
                    f,
                    "one ends at {axis} = {}, the other begins at {}",
                    figure(end),
                    figure(begin)
                )
            }
        }
    }
}

/// A number to four digits.
pub(crate) fn figure(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{value:.3e}");
    }
    let digits = if size >= 1000.0 {
        0
    } else if size >= 1.0 || size == 0.0 {
        3
    } else {
        4
    };
    let text = format!("{value:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::figure;

    #[test]
    fn figures_are_short() {
        for (value, expect) in [
            (0.0, "0"),
            (0.30000001, "0.3"),
            (-2.5, "-2.5"),
            (123_456.7, "123457"),
            (1e7, "1.000e7"),
            (0.000_012_345, "1.234e-5"),
            (10.0, "10"),
        ] {
            assert_eq!(figure(value), expect);
        }
    }
}
