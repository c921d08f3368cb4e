//! The tree of rays behind one sample: Whitted's recursion (1980) as a loop over a bounded stack.

use fearless_simd::Simd;
use scenec_picture::{NOTHING, Stats};
use scenec_plan::Real;
use scenec_plan::packed_structs::Material;

use crate::event::{Ball, Hit};
use crate::hierarchy::{self, Scratch};
use crate::lanes::{LANES, Lanes};
use crate::ray::Ray;
use crate::shade;
use crate::shape::contact;
use crate::stage::Stage;
use crate::vector::{Vector, dot, fma, neg, normalize, scale};

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

/// Rays by kind.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) shadow: u64,
    pub(crate) reflected: u64,
    pub(crate) refracted: u64,
}

impl Tally {
    /// The stats with these rays in them.
    pub(crate) const fn counted(self, stats: Stats) -> Stats {
        Stats {
            shadow: self.shadow,
            reflected: self.reflected,
            refracted: self.refracted,
            ..stats
        }
    }
}

/// Follows paths; one a thread, since it keeps its room.
pub(crate) struct Walker<'a, R, S> {
    scene: Stage<'a, R, S>,
    scratch: Scratch<R>,
    waiting: Vec<Branch<R>>,
    pub(crate) tally: Tally,
}

impl<'a, R: Lanes, S: Simd> Walker<'a, R, S> {
    pub(crate) fn new(scene: Stage<'a, R, S>) -> Self {
        Self {
            scene,
            scratch: Scratch::new(scene.lights.len()),
            waiting: Vec::new(),
            tally: Tally::default(),
        }
    }

    /// The colour that a ray from the eye brings back, and what it hits first: the leaf, or [`NOTHING`], and how far away.
    #[inline(always)]
    pub(crate) fn walk(&mut self, ray: Ray<R>, spent: &mut Spent<R>) -> (Vector<R>, (u32, R)) {
        let mut colour = [R::ZERO; 3];
        let nothing = (NOTHING, R::INFINITY);
        let mut first = None;
        let mut branch = Branch {
            ray,
            weight: R::ONE,
            bounces: self.scene.frame.raydepth,
        };
        loop {
            let hit = hierarchy::first(self.scene, &branch.ray, &mut self.scratch);
            first = first.or(Some(hit.map_or(nothing, |hit| (hit.leaf, hit.distance))));
            let next = match hit {
                None => {
                    let sky = shade::background(&self.scene, branch.ray.direction);
                    colour = fma(sky, branch.weight, colour);
                    None
                }
                Some(hit) => self.bounce(&branch, hit, &mut colour, spent),
            };
            match next.or_else(|| self.waiting.pop()) {
                Some(next) => branch = next,
                None => return (colour, first.unwrap_or(nothing)),
            }
        }
    }

    /// Adds what the surface itself sends, and returns the ray to follow; a second one waits.
    #[inline(always)]
    fn bounce(
        &mut self,
        branch: &Branch<R>,
        hit: Hit<R>,
        colour: &mut Vector<R>,
        spent: &mut Spent<R>,
    ) -> Option<Branch<R>> {
        let ray = &branch.ray;
        let (contact, material) = match hit.ball {
            Some(Ball { block, lane }) => {
                let (block, lane) = (&self.scene.wide.blocks[block as usize], lane as usize % LANES);
                let contact = contact(&block.shape(lane), ray, hit.distance, hit.leaving);
                (contact, block.material[lane])
            }
            None => {
                let leaf = &self.scene.leaves[hit.leaf as usize];
                let shape = &self.scene.shapes[leaf.shape as usize];
                (contact(shape, ray, hit.distance, hit.leaving), leaf.material)
            }
        };
        let material = &self.scene.materials[material as usize];
        let shadows = &mut self.tally.shadow;
        let local = shade::local(self.scene, material, ray, &contact, shadows, &mut self.scratch);
        *colour = fma(local, branch.weight, *colour);
        if branch.bounces == 0 {
            return None;
        }
        let mut mirrored = material.reflect;
        let mut through = None;
        if material.refract != R::ZERO {
            match refract(material, ray, contact.normal) {
                Some(direction) => through = Some(contact.ray(direction, true, !ray.inside)),
                None => mirrored += material.refract,
            }
        }
        let mirror =
            (mirrored != R::ZERO).then(|| contact.ray(reflect(ray.direction, contact.normal), false, ray.inside));
        let mirror = mirror.and_then(|ray| self.spawn(branch, ray, mirrored, spent));
        let through = through.and_then(|ray| self.spawn(branch, ray, material.refract, spent));
        self.tally.reflected += u64::from(mirror.is_some());
        self.tally.refracted += u64::from(through.is_some());
        match (mirror, through) {
            (Some(mirror), Some(through)) => {
                self.waiting.push(mirror);
                Some(through)
            }
            (mirror, through) => mirror.or(through),
        }
    }

    /// The branch, unless it can add too little or the pixel has no rays left.
    #[inline(always)]
    fn spawn(&self, parent: &Branch<R>, ray: Ray<R>, share: R, spent: &mut Spent<R>) -> Option<Branch<R>> {
        let weight = parent.weight * share;
        let bounces = parent.bounces - 1;
        let most = weight.abs() * self.scene.reach[bounces as usize];
        if most < self.scene.frame.cutoff && most <= spent.spare {
            spent.spare -= most;
            spent.dropped += most;
            return None;
        }
        if spent.rays >= self.scene.frame.ray_budget {
            spent.dropped += most;
            spent.over = true;
            return None;
        }
        spent.rays += 1;
        Some(Branch { ray, weight, bounces })
    }
}

/// The direction that a mirror sends a ray; renormalised, so that long paths do not drift.
#[inline(always)]
fn reflect<R: Real>(direction: Vector<R>, normal: Vector<R>) -> Vector<R> {
    let towards = dot(direction, normal);
    normalize(fma(normal, -(towards + towards), direction))
}

/// Snell's law in tangential and normal parts; nothing at total reflection. The tangential part comes from a difference
/// that is small near the perpendicular, where 1 - cos^2 would have no digits left.
#[inline(always)]
fn refract<R: Real>(material: &Material<R>, ray: &Ray<R>, normal: Vector<R>) -> Option<Vector<R>> {
    let cosine = -dot(normal, ray.direction);
    let tangent = fma(normal, cosine, ray.direction);
    if material.index == R::ZERO {
        // The ratio is 0 on the way out and infinite on the way in.
        let straight = ray.inside || dot(tangent, tangent) == R::ZERO;
        return straight.then(|| neg(normal));
    }
    let ratio = if ray.inside {
        material.index
    } else {
        R::ONE / material.index
    };
    let bent = scale(tangent, ratio);
    let rest = R::ONE - dot(bent, bent);
    (rest >= R::ZERO).then(|| normalize(fma(normal, -rest.sqrt(), bent)))
}
