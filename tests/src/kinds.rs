//! A few programs for many scenes that still try what each of them can do without.

use scenec_plan::Features;

/// Programs for scenes of some kinds. A kind is what [`Features::of`] says of a scene's plan, and each program is that of one
/// kind.
///
/// A program that can do more than a scene needs is right by definition; what may be wrong is to leave something out. So it
/// matters less that a scene is drawn by the program of its own kind than that each thing it does not need is left out by some
/// program that draws it.
#[derive(Clone, Debug)]
pub struct Programs {
    kinds: Vec<Features>,
    all: Values,
}

/// One part in so many of all that scenes do not need may be in every program that draws them.
const PARTS: usize = 20;

impl Programs {
    /// Enough for these scenes, none of which has an island with more members than programs have room for: of those it is said
    /// that they need no room, though a program with some would not do.
    #[must_use]
    pub fn of(scenes: &[Features]) -> Self {
        let mut kinds: Vec<Features> = Vec::new();
        for kind in scenes {
            if !kinds.contains(kind) {
                kinds.push(*kind);
            }
        }
        let mut programs = Self {
            kinds: Vec::new(),
            all: scenes
                .iter()
                .map(values)
                .reduce(|a, b| pairs(a, b, u32::max))
                .unwrap_or_default(),
        };
        let mut drawn: Vec<Drawn> = scenes.iter().map(|kind| programs.begin(kind)).collect();
        let enough = unneeded(drawn.iter().copied()) / PARTS;
        while unneeded(drawn.iter().copied()) > enough {
            let after = |program: &&Features| unneeded(drawn.iter().map(|drawn| drawn.by(program)));
            let Some(next) = kinds.iter().min_by_key(after) else {
                break;
            };
            drawn.iter_mut().for_each(|drawn| *drawn = drawn.by(next));
            programs.kinds.push(*next);
        }
        programs
    }

    /// The kinds that have a program, first those that more is left out by.
    #[must_use]
    pub fn kinds(&self) -> &[Features] {
        &self.kinds
    }

    /// The programs to draw a scene of this kind by: its own, or as many as still leave out something that it does not need and
    /// the others have. None, if there is nothing to leave out.
    #[must_use]
    pub fn drawing(&self, kind: &Features) -> Vec<Features> {
        let mut drawing = Vec::new();
        let mut drawn = self.begin(kind);
        while let Some(next) = self.kinds.iter().min_by_key(|program| drawn.by(program).unneeded()) {
            if drawn.by(next).unneeded() == drawn.unneeded() {
                break;
            }
            drawn = drawn.by(next);
            drawing.push(*next);
        }
        drawing
    }

    /// A scene that was drawn by a program that leaves out nothing.
    fn begin(&self, kind: &Features) -> Drawn {
        Drawn {
            needs: values(kind),
            with: self.all,
        }
    }
}

/// Numbers that grow with what a program can do.
type Values = [u32; 22];

fn values(features: &Features) -> Values {
    features.list().map(|(_, value)| value)
}

fn pairs(a: Values, b: Values, join: fn(u32, u32) -> u32) -> Values {
    std::array::from_fn(|i| join(a[i], b[i]))
}

/// What a scene needs, and what every program has that drew it.
#[derive(Clone, Copy)]
struct Drawn {
    needs: Values,
    with: Values,
}

impl Drawn {
    /// After a program drew the scene, if it has all that it takes.
    fn by(&self, program: &Features) -> Self {
        let has = values(program);
        let able = pairs(has, self.needs, u32::min) == self.needs;
        Self {
            with: if able {
                pairs(self.with, has, u32::min)
            } else {
                self.with
            },
            ..*self
        }
    }

    /// How much was never left out.
    fn unneeded(&self) -> usize {
        (0..self.needs.len()).filter(|i| self.with[*i] > self.needs[*i]).count()
    }
}

fn unneeded(drawn: impl Iterator<Item = Drawn>) -> usize {
    drawn.map(|drawn| drawn.unneeded()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTHING: Features = Features {
        balls: false,
        ellipsoids: false,
        half_spaces: false,
        products: false,
        programs: false,
        cells: false,
        hierarchy: false,
        eights: false,
        lights: false,
        touches: false,
        highlights: false,
        reflections: false,
        refractions: false,
        branching: false,
        inside: false,
        supersampling: false,
        distances: false,
        spread: false,
        waiting: 1,
        members: 0,
    };

    /// A kind: what it needs by letters, and its room for members.
    fn kind(needs: &str, members: u32) -> Features {
        Features {
            balls: needs.contains('b'),
            lights: needs.contains('l'),
            cells: needs.contains('c'),
            members,
            ..NOTHING
        }
    }

    /// How many programs are made for some kinds, and how many draw a scene of each.
    fn check(kinds: &[Features], made: usize, drawn: &[usize]) {
        let programs = Programs::of(kinds);
        assert_eq!(programs.kinds().len(), made, "{programs:?}");
        for (kind, count) in kinds.iter().zip(drawn) {
            let drawing = programs.drawing(kind);
            assert_eq!(drawing.len(), *count, "{kind:?}");
            let after = drawing
                .iter()
                .fold(programs.begin(kind), |drawn, program| drawn.by(program));
            assert_eq!(after.with, values(kind));
        }
    }

    #[test]
    fn what_kinds_do_not_need_is_left_out() {
        // There is nothing to leave out.
        check(&[], 0, &[]);
        check(&[kind("b", 0), kind("b", 0)], 0, &[0, 0]);
        check(&[kind("bl", 0), kind("b", 0)], 1, &[0, 1]);
        // The third has what the others have in common.
        check(&[kind("bl", 0), kind("bc", 0), kind("b", 0)], 2, &[1, 1, 2]);
        // Room for members counts like all else.
        check(&[kind("b", 4), kind("b", 2), kind("bl", 2)], 2, &[1, 2, 1]);
    }

    #[test]
    fn a_little_may_never_be_left_out() {
        let mut kinds = vec![kind("bl", 0); PARTS];
        kinds.push(kind("bc", 0));
        let programs = Programs::of(&kinds);
        assert_eq!(programs.kinds(), [kinds[0]]);
        assert!(programs.drawing(&kinds[PARTS]).is_empty());
    }
}
