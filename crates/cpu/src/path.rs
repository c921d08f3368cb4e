//! The trees of rays behind samples: Whitted's recursion (1980) as a loop over bounded stacks, for many pixels at once.
//!
//! Each pixel follows one ray at a time, in the order in which it would if it were alone; of all pixels that are under way,
//! the rays are taken in eights.

use fearless_simd::Simd;
use scenec_picture::{NOTHING, Stats};
use scenec_plan::Real;
use scenec_plan::packed_structs::Material;

use crate::contact::Contacts;
use crate::hierarchy::{self, Scratch};
use crate::hits::Hits;
use crate::lanes::{LANES, Lanes, Set, Triple, lane3, load3, store3};
use crate::ray::{Ray, Rays};
use crate::shade;
use crate::stage::{Prepared, Stage};
use crate::vector::{Vector, dot, fma, neg, normalize, reflect, scale};

/// A ray that waits for its turn.
#[derive(Clone, Copy, Debug)]
struct Branch<R> {
    ray: Ray<R>,
    /// What its colour is multiplied by on the way to the sample.
    weight: R,
    /// How often it may still bounce.
    bounces: u32,
}

/// What one pixel has used up and left out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spent<R> {
    /// Rays, shadow rays aside.
    pub(crate) rays: u32,
    /// The most that the dropped branches could have added.
    pub(crate) dropped: R,
    /// The most that may yet be dropped for being small.
    pub(crate) spare: R,
    /// Whether a branch was dropped for the budget.
    pub(crate) over: bool,
}

impl<R: Real> Spent<R> {
    /// Nothing used, and this much that may be dropped for being small.
    pub(crate) const fn new(spare: R) -> Self {
        Self {
            rays: 0,
            dropped: R::ZERO,
            spare,
            over: false,
        }
    }
}

/// A sample of a pixel under way.
#[derive(Debug)]
pub(crate) struct Sample<R> {
    /// What it has brought back so far.
    pub(crate) colour: Vector<R>,
    /// What the pixel has used up.
    pub(crate) spent: Spent<R>,
    /// What the pixel's first ray hits: the leaf, or [`NOTHING`], and how far away.
    pub(crate) first: Option<(u32, R)>,
    /// Branches that wait.
    waiting: Vec<Branch<R>>,
}

impl<R: Real> Sample<R> {
    const NEW: Self = Self {
        colour: [R::ZERO; 3],
        spent: Spent::new(R::ZERO),
        first: None,
        waiting: Vec::new(),
    };
}

/// Up to eight rays under way, each of another pixel.
#[derive(Clone, Copy)]
pub(crate) struct Paths<R> {
    pub(crate) rays: Rays<R>,
    /// What their colours are multiplied by.
    pub(crate) weight: [R; LANES],
    /// How often they may still bounce.
    pub(crate) bounces: [u32; LANES],
    /// Which samples they belong to.
    pub(crate) sample: [u32; LANES],
    /// Which of them there are.
    pub(crate) lanes: u32,
}

impl<R: Real> Paths<R> {
    pub(crate) const NONE: Self = Self {
        rays: Rays::EMPTY,
        weight: [R::ONE; LANES],
        bounces: [0; LANES],
        sample: [0; LANES],
        lanes: 0,
    };
}

/// Rays of one generation, in eights.
struct Wave<R> {
    paths: Vec<Paths<R>>,
    count: usize,
}

impl<R: Real> Wave<R> {
    const fn new() -> Self {
        Self {
            paths: Vec::new(),
            count: 0,
        }
    }

    #[inline(always)]
    fn push(&mut self, sample: u32, branch: &Branch<R>) {
        let lane = self.count % LANES;
        if lane == 0 {
            self.paths.push(Paths::NONE);
        }
        self.count += 1;
        if let Some(paths) = self.paths.last_mut() {
            paths.rays.set(lane, &branch.ray);
            paths.weight[lane] = branch.weight;
            paths.bounces[lane] = branch.bounces;
            paths.sample[lane] = sample;
            paths.lanes |= 1 << lane;
        }
    }

    fn clear(&mut self) {
        self.paths.clear();
        self.count = 0;
    }
}

/// Rays by kind.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    shadow: u64,
    reflected: u64,
    refracted: u64,
}

/// Room that one thread uses again and again.
pub(crate) struct Room<R> {
    scratch: Scratch<R>,
    /// The rays that come next.
    next: Wave<R>,
    /// Room for those that are being followed.
    wave: Wave<R>,
    samples: Vec<Sample<R>>,
    tally: Tally,
}

impl<R: Real> Room<R> {
    pub(crate) fn new(scene: &Prepared<R>) -> Self {
        Self {
            scratch: Scratch::new(scene),
            next: Wave::new(),
            wave: Wave::new(),
            samples: Vec::new(),
            tally: Tally::default(),
        }
    }
}

/// Follows paths.
pub(crate) struct Walker<'a, R, S> {
    scene: Stage<'a, R, S>,
    room: &'a mut Room<R>,
}

impl<'a, R: Lanes, S: Simd> Walker<'a, R, S> {
    /// For so many pixels, of which nothing is known. This much may be dropped of each sample for being small.
    #[inline(always)]
    pub(crate) fn new(scene: Stage<'a, R, S>, room: &'a mut Room<R>, count: usize, spare: R) -> Self {
        room.tally = Tally::default();
        room.samples.resize_with(count, || Sample::NEW);
        for sample in &mut room.samples {
            (sample.first, sample.spent) = (None, Spent::new(spare));
        }
        Self { scene, room }
    }

    /// The stats with the rays in them that were followed.
    pub(crate) const fn counted(&self, stats: Stats) -> Stats {
        let tally = self.room.tally;
        Stats {
            shadow: tally.shadow,
            reflected: tally.reflected,
            refracted: tally.refracted,
            ..stats
        }
    }

    /// The pixels' samples.
    #[inline(always)]
    pub(crate) fn samples(&mut self) -> &mut [Sample<R>] {
        &mut self.room.samples
    }

    /// Follows all that came from the rays so far, until nothing is left.
    #[inline(always)]
    pub(crate) fn follow(&mut self) {
        let mut wave = std::mem::replace(&mut self.room.wave, Wave::new());
        while self.room.next.count != 0 {
            std::mem::swap(&mut wave, &mut self.room.next);
            for paths in &wave.paths {
                self.step(paths);
            }
            wave.clear();
        }
        self.room.wave = wave;
    }

    /// Each ray up to what it hits.
    // Not a part of every place that asks: all of the tracer is.
    #[inline(never)]
    pub(crate) fn step(&mut self, paths: &Paths<R>) {
        self.scene.simd.vectorize(
            #[inline(always)]
            || {
                let hits = hierarchy::first(self.scene, &paths.rays, paths.lanes, &mut self.room.scratch);
                let missed = paths.lanes & !hits.met;
                if missed != 0 {
                    let sky = shade::background(self.scene, &paths.rays);
                    for lane in Set(missed) {
                        self.bring(paths, lane, &sky, (NOTHING, R::INFINITY));
                        self.go_on(paths.sample[lane], None);
                    }
                }
                if hits.met != 0 {
                    self.bounce(paths, &hits);
                }
            },
        );
    }

    /// Adds what a ray brings back.
    #[inline(always)]
    fn bring(&mut self, paths: &Paths<R>, lane: usize, colour: &Triple<R>, hit: (u32, R)) {
        let sample = &mut self.room.samples[paths.sample[lane] as usize];
        sample.first = sample.first.or(Some(hit));
        sample.colour = fma(lane3(colour, lane), paths.weight[lane], sample.colour);
    }

    /// The sample's next ray, or one that waited, belongs to the next generation.
    #[inline(always)]
    fn go_on(&mut self, number: u32, next: Option<Branch<R>>) {
        if let Some(next) = next.or_else(|| self.room.samples[number as usize].waiting.pop()) {
            self.room.next.push(number, &next);
        }
    }

    /// Adds what the surfaces themselves send, and finds the rays to follow.
    #[inline(always)]
    fn bounce(&mut self, paths: &Paths<R>, hits: &Hits<R>) {
        let (stage, rays) = (self.scene, &paths.rays);
        let contacts = Contacts::new(stage, rays, hits);
        let shadows = &mut self.room.tally.shadow;
        let local = shade::local(stage, (rays, hits.met), &contacts, shadows, &mut self.room.scratch);
        let mirrored = self.mirrored(paths, hits.met, &contacts);
        for lane in Set(hits.met) {
            self.bring(paths, lane, &local, (hits.leaf[lane], hits.distance[lane]));
            let material = &stage.materials[contacts.material[lane] as usize];
            let mut next = None;
            if paths.bounces[lane] != 0 && sends_on(material) {
                next = self.branches(paths, lane, (&contacts, material, lane3(&mirrored, lane)));
            }
            self.go_on(paths.sample[lane], next);
        }
    }

    /// The directions that mirrors send the rays, if any of them goes on.
    #[inline(always)]
    fn mirrored(&self, paths: &Paths<R>, lanes: u32, contacts: &Contacts<R>) -> Triple<R> {
        let (stage, mut any) = (self.scene, false);
        for lane in Set(lanes) {
            let material = &stage.materials[contacts.material[lane] as usize];
            any |= paths.bounces[lane] != 0 && sends_on(material);
        }
        if !any {
            return paths.rays.direction;
        }
        let direction = load3::<R, S>(stage.simd, &paths.rays.direction);
        store3(reflect(direction, load3(stage.simd, &contacts.normal)))
    }

    /// The ray to follow; a second one waits.
    #[inline(always)]
    fn branches(
        &mut self,
        paths: &Paths<R>,
        lane: usize,
        (contacts, material, direction): (&Contacts<R>, &Material<R>, Vector<R>),
    ) -> Option<Branch<R>> {
        let inside = paths.rays.inside >> lane & 1 == 1;
        let mut mirrored = material.reflect;
        let mut through = None;
        if material.refract != R::ZERO {
            let arriving = lane3(&paths.rays.direction, lane);
            match refract(material, arriving, inside, lane3(&contacts.normal, lane)) {
                Some(direction) => through = Some(contacts.ray(lane, direction, true, !inside)),
                None => mirrored += material.refract,
            }
        }
        let mirror = (mirrored != R::ZERO).then(|| contacts.ray(lane, direction, false, inside));
        let scene = self.scene.scene;
        let sample = &mut self.room.samples[paths.sample[lane] as usize];
        let parent = (paths.weight[lane], paths.bounces[lane] - 1);
        let mirror = mirror.and_then(|ray| spawn(scene, parent, ray, mirrored, &mut sample.spent));
        let through = through.and_then(|ray| spawn(scene, parent, ray, material.refract, &mut sample.spent));
        self.room.tally.reflected += u64::from(mirror.is_some());
        self.room.tally.refracted += u64::from(through.is_some());
        match (mirror, through) {
            (Some(mirror), Some(through)) => {
                sample.waiting.push(mirror);
                Some(through)
            }
            (mirror, through) => mirror.or(through),
        }
    }
}

/// The branch, unless it can add too little or the pixel has no rays left.
#[inline(always)]
fn spawn<R: Lanes>(
    scene: &Prepared<R>,
    (weight, bounces): (R, u32),
    ray: Ray<R>,
    share: R,
    spent: &mut Spent<R>,
) -> Option<Branch<R>> {
    let weight = weight * share;
    let most = weight.abs() * scene.reach[bounces as usize];
    if most < scene.frame.cutoff && most <= spent.spare {
        spent.spare -= most;
        spent.dropped += most;
        return None;
    }
    if spent.rays >= scene.frame.ray_budget {
        spent.dropped += most;
        spent.over = true;
        return None;
    }
    spent.rays += 1;
    Some(Branch { ray, weight, bounces })
}
/// Whether rays go on from what is made of it.
#[inline(always)]
fn sends_on<R: Real>(material: &Material<R>) -> bool {
    material.reflect != R::ZERO || material.refract != R::ZERO
}

/// Snell's law in tangential and normal parts; nothing at total reflection. The tangential part comes from a difference
/// that is small near the perpendicular, where 1 - cos^2 would have no digits left.
#[inline(always)]
fn refract<R: Lanes>(
    material: &Material<R>,
    direction: Vector<R>,
    inside: bool,
    normal: Vector<R>,
) -> Option<Vector<R>> {
    let cosine = -dot(normal, direction);
    let tangent = fma(normal, cosine, direction);
    if material.index == R::ZERO {
        // The ratio is 0 on the way out and infinite on the way in.
        let straight = inside || dot(tangent, tangent) == R::ZERO;
        return straight.then(|| neg(normal));
    }
    let ratio = if inside {
        material.index
    } else {
        R::ONE / material.index
    };
    let bent = scale(tangent, ratio);
    let rest = R::ONE - dot(bent, bent);
    (rest >= R::ZERO).then(|| normalize(fma(normal, -rest.sqrt(), bent)))
}
