//! Where rays cross the surface of one island: the next distances at which the island's truth changes.
//!
//! An island that is divided into cells is followed from cell to cell. What is left of it in a cell has the very truths of
//! the whole there, so both ways find the very same crossings.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::packed_structs::{Cell, Island};
use scenec_plan::{CELL_FULL, CELL_PART, CELLS_REACH, Instruction};

use crate::crossings::{Crossings, March};
use crate::hits::Hit;
use crate::intervals::{Intervals, intervals};
use crate::lanes::{LANES, Lanes, Set, bits, load, select, splat};
use crate::ray::{Rays, touches};
use crate::stage::Stage;

/// No cells.
const NONE: u32 = u32::MAX;

/// Room that is used again and again.
pub(crate) struct Room<R> {
    /// The intervals of one part's members.
    intervals: Vec<Intervals<R>>,
    /// Cells that wait.
    waiting: Vec<Ahead<R>>,
}

impl<R> Room<R> {
    pub(crate) const fn new() -> Self {
        Self {
            intervals: Vec::new(),
            waiting: Vec::new(),
        }
    }
}

/// What is asked about rays at an island.
#[derive(Clone, Copy)]
pub(crate) struct Question<'a, R> {
    pub(crate) rays: &'a Rays<R>,
    pub(crate) lanes: u32,
    /// After these distances ...
    pub(crate) from: &'a [R; LANES],
    /// ... and not after these.
    pub(crate) until: &'a [R; LANES],
    /// Whether the rays are inside to begin with.
    pub(crate) inside: bool,
}

impl<R> Question<'_, R> {
    /// The same about those of the rays that are among these.
    #[inline(always)]
    fn of(mut self, lanes: u32) -> Self {
        self.lanes &= lanes;
        self
    }
}

/// The first changes of an island along rays.
pub(crate) struct Changes<R> {
    pub(crate) hits: [Option<Hit<R>>; LANES],
    /// The rays that are inside to begin with, as the island has it.
    pub(crate) held: u32,
}

impl<R: Lanes> Changes<R> {
    const NONE: Self = Self {
        hits: [None; LANES],
        held: 0,
    };

    #[inline(always)]
    fn set(&mut self, lane: usize, hit: Option<Hit<R>>, held: bool) {
        self.hits[lane] = hit;
        self.held |= u32::from(held) << lane;
    }
}

/// Where rays enter an island from outside, or leave it from within.
// A function of its own, not a part of every place that asks: it is long.
#[inline(never)]
pub(crate) fn changes<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    island: &Island,
    question: Question<'_, R>,
    room: &mut Room<R>,
) -> Changes<R> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let mut changes = Changes::NONE;
            let divided = question.of(within_reach(question.rays, island));
            let mut whole = question.of(!divided.lanes);
            if whole.lanes != 0 && island.cells != NONE && island.product != 0 {
                // Of a large product there is much to reckon with; from far away most rays miss it.
                let leaf = |member: u32| stage.members[(island.members + member) as usize];
                whole = whole.of(within_rest(stage, island, whole, |member| {
                    crossed(stage, leaf(member), whole.rays)
                }));
            }
            if whole.lanes != 0 {
                meet(stage, island, whole, room, &mut changes);
            }
            if divided.lanes != 0 {
                follow(stage, island, divided, room, &mut changes);
            }
            changes
        },
    )
}

/// Asks an island as one part.
#[inline(always)]
fn meet<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    island: &Island,
    question: Question<'_, R>,
    room: &mut Room<R>,
    changes: &mut Changes<R>,
) {
    for lane in Set(gather(stage, island, question, &mut room.intervals)) {
        let one = (lane, question.rays.class[lane]);
        let crossings = Crossings::new((stage.scene, island), &room.intervals, one);
        let mut march = crossings.start(question.from[lane], question.inside);
        if march.held || !question.inside {
            let hit = crossings.follow(&mut march, question.until[lane]);
            changes.set(lane, hit.or_else(|| march.finish()), march.held);
        }
    }
}

/// The rays that can be followed from cell to cell. Farther out, rounding is larger than what the cells allow for.
#[inline(always)]
fn within_reach<R: Lanes>(rays: &Rays<R>, island: &Island) -> u32 {
    let mut set = 0;
    if island.cells != NONE {
        for lane in 0..LANES {
            let mut far = false;
            for axis in &rays.origin {
                far |= axis[lane].abs() > R::of(CELLS_REACH);
            }
            set |= u32::from(!far) << lane;
        }
    }
    set
}

/// Finds the intervals of a part's members, and which of the rays may have a change there. Others have none if they are on the
/// side to begin with where they are to be.
#[inline(always)]
fn gather<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    part: &Island,
    question: Question<'_, R>,
    found: &mut Vec<Intervals<R>>,
) -> u32 {
    let simd = stage.simd;
    found.clear();
    for leaf in &stage.members[part.members as usize..part.members_end as usize] {
        let (enter, leave) = crossed(stage, *leaf, question.rays);
        found.push([enter.to_array(), leave.to_array()]);
    }
    if part.product == 0 {
        return question.lanes;
    }
    within_rest(stage, part, question, |member| {
        let [enter, leave] = &found[member as usize];
        (load::<R, S>(simd, enter), load::<R, S>(simd, leave))
    })
}

/// Where rays enter and leave a leaf.
#[inline(always)]
fn crossed<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, leaf: u32, rays: &Rays<R>) -> (R::Eight<S>, R::Eight<S>) {
    let shape = &stage.shapes[stage.leaves[leaf as usize].shape as usize];
    intervals(stage.simd, shape, rays, touches(stage.scene, rays))
}

/// The rays that come to where all members of a product are that are not taken away: it is nowhere else.
#[inline(always)]
fn within_rest<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    part: &Island,
    question: Question<'_, R>,
    interval: impl Fn(u32) -> (R::Eight<S>, R::Eight<S>),
) -> u32 {
    let simd = stage.simd;
    let (mut first, mut last) = (load::<R, S>(simd, question.from), load::<R, S>(simd, question.until));
    let mut held = question.lanes;
    for word in &stage.program[part.program as usize..part.program_end as usize] {
        let (operation, member) = Instruction(*word).parts();
        if operation == 0 {
            let (enter, leave) = interval(member);
            held &= bits(enter.simd_lt(leave));
            first = first.max(enter);
            last = last.min(leave);
        }
    }
    held & bits(first.simd_le(last))
}

/// Follows rays from cell to cell.
#[inline(always)]
fn follow<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    island: &Island,
    question: Question<'_, R>,
    room: &mut Room<R>,
    changes: &mut Changes<R>,
) {
    let Question { rays, from, inside, .. } = question;
    let mut marches: [Option<March<R>>; LANES] = [const { None }; LANES];
    let mut walk = Walk::new(stage, rays, *from, &mut room.waiting);
    walk.push(island.cells, question.lanes, *question.until);
    while let Some((cell, step)) = walk.next() {
        if cell.kind == CELL_PART {
            let part = &stage.islands[cell.first as usize];
            let within = Question {
                rays,
                lanes: step.lanes,
                from: &walk.at,
                until: &step.end,
                inside,
            };
            let may = gather(stage, part, within, &mut room.intervals);
            for lane in Set(step.lanes) {
                let one = (lane, rays.class[lane]);
                let crossings = Crossings::new((stage.scene, part), &room.intervals, one);
                let march = marches[lane].get_or_insert_with(|| crossings.start(from[lane], inside));
                if inside && !march.held {
                    walk.done |= 1 << lane;
                } else if (inside || !march.is_settled() || may >> lane & 1 == 1)
                    && let Some(hit) = crossings.follow(march, step.end[lane])
                {
                    walk.done |= 1 << lane;
                    changes.set(lane, Some(hit), march.held);
                }
            }
        }
        for lane in Set(step.lanes) {
            let held = cell.kind == CELL_FULL;
            let march = marches[lane].get_or_insert_with(|| March::new(from[lane], inside, held, None));
            march.at = step.end[lane];
            walk.at[lane] = step.end[lane];
        }
    }
    for lane in Set(question.lanes & !walk.done) {
        if let Some(march) = &marches[lane]
            && (march.held || !inside)
        {
            changes.set(lane, march.finish(), march.held);
        }
    }
}

/// A cell that rays are to go to, ...
#[derive(Clone, Copy)]
struct Ahead<R> {
    cell: u32,
    lanes: u32,
    /// ... up to these distances.
    end: [R; LANES],
}

/// Hands out an island's cells along rays, to each ray its near ones first.
struct Walk<'a, R, S> {
    stage: Stage<'a, R, S>,
    rays: &'a Rays<R>,
    /// Where the cells that come next begin.
    at: [R; LANES],
    /// The rays that have come to their end.
    done: u32,
    waiting: &'a mut Vec<Ahead<R>>,
}

impl<'a, R: Lanes, S: Simd> Walk<'a, R, S> {
    #[inline(always)]
    fn new(stage: Stage<'a, R, S>, rays: &'a Rays<R>, at: [R; LANES], waiting: &'a mut Vec<Ahead<R>>) -> Self {
        waiting.clear();
        Self {
            stage,
            rays,
            at,
            done: 0,
            waiting,
        }
    }

    #[inline(always)]
    fn push(&mut self, cell: u32, lanes: u32, end: [R; LANES]) {
        if lanes != 0 {
            self.waiting.push(Ahead { cell, lanes, end });
        }
    }

    #[inline(always)]
    fn next(&mut self) -> Option<(&'a Cell, Ahead<R>)> {
        loop {
            let mut step = self.waiting.pop()?;
            step.lanes &= !self.done;
            if step.lanes == 0 {
                continue;
            }
            let cell = &self.stage.scene.cells[step.cell as usize];
            if cell.kind >= CELL_PART {
                return Some((cell, step));
            }
            self.divide(cell, &step);
        }
    }

    /// Sends rays to the two sides of a wall, each to the side first that it comes to first.
    #[inline(always)]
    fn divide(&mut self, cell: &Cell, step: &Ahead<R>) {
        let simd = self.stage.simd;
        let axis = cell.kind as usize;
        let origin = load::<R, S>(simd, &self.rays.origin[axis]);
        let direction = load::<R, S>(simd, &self.rays.direction[axis]);
        let (zero, wall) = (splat::<R, S>(simd, R::ZERO), splat::<R, S>(simd, R::of_f32(cell.wall)));
        let end = load::<R, S>(simd, &step.end);
        // A ray along the wall gives an infinity or no number, and stays on its side.
        let crossed = (wall - origin) / direction;
        let ahead = bits(crossed.simd_gt(zero));
        let below = bits(origin.simd_lt(wall) | (origin.simd_eq(wall) & direction.simd_le(zero)));
        let behind_wall = ahead & bits(crossed.simd_le(load::<R, S>(simd, &self.at)));
        let both = ahead & !behind_wall & bits(crossed.simd_lt(end)) & step.lanes;
        let near_end = select::<R, S>(simd, both, crossed, end).to_array();
        let (low, high) = (cell.first, cell.first + 1);
        self.push(high, both & below, step.end);
        self.push(low, both & !below, step.end);
        // Whoever is behind the wall already has nothing to do on the near side.
        let now_low = below ^ behind_wall;
        self.push(high, step.lanes & !now_low, near_end);
        self.push(low, step.lanes & now_low, near_end);
    }
}
