//! Where a ray crosses the surface of one island: the next distance at which the island's truth changes.
//!
//! An island that is divided into cells is followed from cell to cell. What is left of it in a cell has the very truths of
//! the whole there, so both ways find the very same crossings.

use scenec_plan::packed_structs::{Cell, Island};
use scenec_plan::{CELL_FULL, CELL_PART, CELLS_DEPTH, CELLS_REACH, Packed};

use crate::crossings::{Crossings, March, class_of, leaf_interval};
use crate::hits::Hit;
use crate::intervals::Intervals;
use crate::lanes::Lanes;
use crate::ray::Ray;

/// No cells.
const NONE: u32 = u32::MAX;

/// The first entry into an island after the start of a ray from outside, and not after `until`.
#[inline(always)]
pub(crate) fn entered<R: Lanes>(
    scene: &Packed<R>,
    island: &Island,
    ray: &Ray<R>,
    until: R,
    intervals: &mut Vec<Intervals<R>>,
) -> Option<Hit<R>> {
    let Some(leaf) = scene.lone(island) else {
        return change(scene, island, ray, (R::ZERO, until), false, intervals).0;
    };
    entered_leaf(scene, leaf, ray, until)
}

/// The same of an island that is one leaf.
#[inline(always)]
pub(crate) fn entered_leaf<R: Lanes>(scene: &Packed<R>, leaf: u32, ray: &Ray<R>, until: R) -> Option<Hit<R>> {
    let (enter, leave) = leaf_interval(scene, leaf, ray);
    if enter <= R::ZERO {
        // A ray from outside that starts within, by rounding: see `crease`.
        let blocked = R::ZERO < leave && -enter < leave && ray.class != class_of(scene, leaf);
        return blocked.then_some(Hit {
            distance: R::ZERO,
            leaf,
            leaving: false,
            ball: None,
        });
    }
    (enter < leave && enter <= until).then_some(Hit {
        distance: enter,
        leaf,
        leaving: false,
        ball: None,
    })
}

/// Where a ray leaves an island that holds it at `from`, perhaps infinitely far; nothing if the island does not.
#[inline(always)]
pub(crate) fn left<R: Lanes>(
    scene: &Packed<R>,
    island: &Island,
    ray: &Ray<R>,
    from: R,
    intervals: &mut Vec<Intervals<R>>,
) -> Option<Hit<R>> {
    if let Some(leaf) = scene.lone(island) {
        return left_leaf(scene, leaf, ray, from);
    }
    let (hit, held) = change(scene, island, ray, (from, R::INFINITY), true, intervals);
    let endless = Hit {
        distance: R::INFINITY,
        leaf: scene.members[island.members as usize],
        leaving: true,
        ball: None,
    };
    held.then(|| hit.unwrap_or(endless))
}

/// The same of an island that is one leaf.
#[inline(always)]
pub(crate) fn left_leaf<R: Lanes>(scene: &Packed<R>, leaf: u32, ray: &Ray<R>, from: R) -> Option<Hit<R>> {
    let (enter, leave) = leaf_interval(scene, leaf, ray);
    (enter <= from && from < leave).then_some(Hit {
        distance: leave,
        leaf,
        leaving: true,
        ball: None,
    })
}

/// The first change of an island after the first distance and not after the second, of a ray that is inside (or not) to
/// begin with; and whether the island says so too.
#[inline(always)]
fn change<R: Lanes>(
    scene: &Packed<R>,
    island: &Island,
    ray: &Ray<R>,
    (from, until): (R, R),
    inside: bool,
    intervals: &mut Vec<Intervals<R>>,
) -> (Option<Hit<R>>, bool) {
    // Farther out, rounding is larger than what the cells allow for.
    let far = ray.origin.iter().any(|x| x.abs() > R::of(CELLS_REACH));
    if island.cells == NONE || far {
        let crossings = Crossings::new(scene, island, ray, intervals);
        return change_of_whole(&crossings, (from, until), inside);
    }
    let mut march: Option<March<R>> = None;
    let mut walk = Walk::new(scene, ray, island.cells, from, until);
    while let Some((cell, end)) = walk.next() {
        if cell.kind == CELL_PART {
            let crossings = Crossings::new(scene, &scene.islands[cell.first as usize], ray, intervals);
            let march = march.get_or_insert_with(|| crossings.start(from, inside));
            if inside && !march.held {
                return (None, false);
            }
            if let Some(hit) = crossings.follow(march, end) {
                return (Some(hit), march.held);
            }
            march.at = end;
        } else {
            let march = march.get_or_insert_with(|| March::new(from, inside, cell.kind == CELL_FULL, None));
            march.at = end;
        }
    }
    match march {
        Some(march) if march.held || !inside => (march.finish(), march.held),
        _ => (None, false),
    }
}

/// The same of an island as one part.
#[inline(always)]
fn change_of_whole<R: Lanes>(
    crossings: &Crossings<'_, R>,
    (from, until): (R, R),
    inside: bool,
) -> (Option<Hit<R>>, bool) {
    let mut march = crossings.start(from, inside);
    if inside && !march.held {
        return (None, false);
    }
    let hit = crossings.follow(&mut march, until);
    (hit.or_else(|| march.finish()), march.held)
}

/// As [`entered`], of an island as one part.
#[inline(always)]
pub(crate) fn entered_whole<R: Lanes>(crossings: &Crossings<'_, R>, until: R) -> Option<Hit<R>> {
    change_of_whole(crossings, (R::ZERO, until), false).0
}

/// As [`left`], of an island as one part.
#[inline(always)]
pub(crate) fn left_whole<R: Lanes>(crossings: &Crossings<'_, R>, from: R) -> Option<Hit<R>> {
    let (hit, held) = change_of_whole(crossings, (from, R::INFINITY), true);
    held.then(|| hit.unwrap_or_else(|| crossings.endless()))
}

/// Whether an island is one part.
#[inline(always)]
pub(crate) const fn is_whole(island: &Island) -> bool {
    island.cells == NONE
}

/// Hands out an island's cells along a ray, near ones first, each with the distance at which the ray leaves it.
struct Walk<'a, R> {
    scene: &'a Packed<R>,
    ray: &'a Ray<R>,
    /// Where the cell that comes next begins.
    at: R,
    waiting: [(u32, R); CELLS_DEPTH + 1],
    count: usize,
}

impl<'a, R: Lanes> Walk<'a, R> {
    #[inline(always)]
    fn new(scene: &'a Packed<R>, ray: &'a Ray<R>, first: u32, from: R, until: R) -> Self {
        let mut waiting = [(0, R::ZERO); CELLS_DEPTH + 1];
        waiting[0] = (first, until);
        Self {
            scene,
            ray,
            at: from,
            waiting,
            count: 1,
        }
    }

    #[inline(always)]
    fn next(&mut self) -> Option<(&'a Cell, R)> {
        self.count = self.count.checked_sub(1)?;
        let (first, mut end) = self.waiting[self.count];
        let mut cell = &self.scene.cells[first as usize];
        while cell.kind < CELL_PART {
            let axis = cell.kind as usize;
            let (origin, direction) = (self.ray.origin[axis], self.ray.direction[axis]);
            let wall = R::of_f32(cell.wall);
            // A ray along the wall gives an infinity or no number, and stays on its side.
            let crossed = (wall - origin) / direction;
            let below = origin < wall || (origin == wall && direction <= R::ZERO);
            let (near, far) = (cell.first + u32::from(!below), cell.first + u32::from(below));
            let next = if crossed > R::ZERO && crossed <= self.at {
                far
            } else {
                if crossed > R::ZERO && crossed < end {
                    self.waiting[self.count] = (far, end);
                    self.count += 1;
                    end = crossed;
                }
                near
            };
            cell = &self.scene.cells[next as usize];
        }
        self.at = end;
        Some((cell, end))
    }
}
