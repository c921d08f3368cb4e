//! Points on surfaces, eight at once.

use fearless_simd::Simd;

use crate::hits::{Ball, Hits};
use crate::lanes::{LANES, Lanes, Set, Triple, Vector8, lane3, load, load3, select, select3, set3, store3};
use crate::ray::{Ray, Rays};
use crate::shape::{BALL, HALF_SPACE, approach, on_ellipsoid, plane_normal};
use crate::stage::Stage;
use crate::vector::{add, dot, fma, neg, normalize, scale, sub};

/// Where rays meet surfaces.
pub(crate) struct Contacts<R> {
    /// In plan coordinates.
    pub(crate) point: Triple<R>,
    /// On the shape's own unit sphere; of a half-space, the normal.
    local: Triple<R>,
    /// Of length 1, turned to the side that the ray comes from.
    pub(crate) normal: Triple<R>,
    /// The class of the surface.
    class: [u32; LANES],
    /// Which material.
    pub(crate) material: [u32; LANES],
    /// Half-spaces.
    flat: u32,
    /// Whether the ray comes from within the shape's solid.
    leaving: u32,
}

/// What the formulas want to know of balls and half-spaces.
struct Surfaces<R> {
    /// As a [`scenec_plan::packed_structs::Shape`] has it.
    centre: Triple<R>,
    /// 1 / radius.
    inverse: [R; LANES],
    radius: [R; LANES],
    /// Of half-spaces.
    outward: Triple<R>,
    balls: u32,
    /// Balls that the rays start on.
    own: u32,
}

impl<R: Lanes> Contacts<R> {
    /// Where these rays meet what they hit.
    #[inline(always)]
    pub(crate) fn new<S: Simd>(stage: Stage<'_, R, S>, rays: &Rays<R>, hits: &Hits<R>) -> Self {
        let mut contacts = Self {
            point: [[R::ZERO; LANES]; 3],
            local: [[R::ZERO; LANES]; 3],
            normal: [[R::ZERO; LANES]; 3],
            class: [u32::MAX; LANES],
            material: [0; LANES],
            flat: 0,
            leaving: hits.leaving,
        };
        let mut surfaces = Surfaces {
            centre: [[R::ZERO; LANES]; 3],
            inverse: [R::ONE; LANES],
            radius: [R::ONE; LANES],
            outward: [[R::ZERO; LANES]; 3],
            balls: 0,
            own: 0,
        };
        let mut others = 0;
        for lane in Set(hits.met) {
            others |= contacts.gather(stage, rays, hits, lane, &mut surfaces);
        }
        contacts.meet(stage.simd, rays, hits, &surfaces);
        for lane in Set(others) {
            let leaf = &stage.leaves[hits.leaf[lane] as usize];
            let leaving = hits.leaving >> lane & 1 == 1;
            let shape = &stage.shapes[leaf.shape as usize];
            let (point, local, normal) = on_ellipsoid(shape, &rays.get(lane), hits.distance[lane], leaving);
            set3(&mut contacts.point, lane, point);
            set3(&mut contacts.local, lane, local);
            set3(&mut contacts.normal, lane, if leaving { neg(normal) } else { normal });
        }
        contacts
    }

    /// Looks up what one ray hits; the lane's bit if it is an ellipsoid.
    #[inline(always)]
    fn gather<S: Simd>(
        &mut self,
        stage: Stage<'_, R, S>,
        rays: &Rays<R>,
        hits: &Hits<R>,
        lane: usize,
        surfaces: &mut Surfaces<R>,
    ) -> u32 {
        let bit = 1 << lane;
        let (kind, centre, [inverse, radius], class, material);
        if let Some(Ball { block, lane: place }) = hits.ball(lane) {
            let (block, place) = (&stage.wide.blocks[block as usize], place as usize % LANES);
            (kind, centre) = (BALL, lane3(&block.centre, place));
            [inverse, radius] = [block.inverse[place], block.radius[place]];
            (class, material) = (block.class[place], block.material[place]);
        } else {
            let leaf = &stage.leaves[hits.leaf[lane] as usize];
            let shape = &stage.shapes[leaf.shape as usize];
            (kind, centre) = (shape.kind, shape.centre);
            [inverse, radius] = [shape.inverse[0], shape.linear[0]];
            (class, material) = (shape.class, leaf.material);
            set3(&mut surfaces.outward, lane, plane_normal(shape));
        }
        (self.class[lane], self.material[lane]) = (class, material);
        set3(&mut surfaces.centre, lane, centre);
        match kind {
            BALL => {
                (surfaces.inverse[lane], surfaces.radius[lane]) = (inverse, radius);
                surfaces.balls |= bit;
                surfaces.own |= u32::from(class == rays.class[lane]) << lane;
                0
            }
            HALF_SPACE => {
                self.flat |= bit;
                0
            }
            _ => bit,
        }
    }

    /// Finds the points on balls and half-spaces.
    #[inline(always)]
    fn meet<S: Simd>(&mut self, simd: S, rays: &Rays<R>, hits: &Hits<R>, surfaces: &Surfaces<R>) {
        let centre = load3(simd, &surfaces.centre);
        let (origin, direction) = (load3(simd, &rays.origin), load3(simd, &rays.direction));
        let distance = load::<R, S>(simd, &hits.distance);
        let leaving = hits.leaving;
        let mut point = centre;
        let mut outward = load3(simd, &surfaces.outward);
        if surfaces.balls != 0 {
            let inverse = load::<R, S>(simd, &surfaces.inverse);
            let direction = scale(direction, inverse);
            let approach = approach(scale(sub(origin, centre), inverse), direction);
            let half = select::<R, S>(simd, leaving, approach.half(), -approach.half());
            let own = fma(direction, distance, load3(simd, &rays.local));
            let local = normalize(select3::<R, S>(simd, surfaces.own, own, approach.point(half)));
            point = add(centre, scale(local, load::<R, S>(simd, &surfaces.radius)));
            self.local = store3(local);
            outward = select3::<R, S>(simd, surfaces.balls, local, outward);
        }
        if self.flat != 0 {
            let there = fma(direction, distance, origin);
            // One projection takes the rounding across the plane away.
            let off = dot(outward, sub(there, centre));
            point = select3::<R, S>(simd, self.flat, fma(outward, -off, there), point);
        }
        // The kind of crossing decides on which side the ray comes from, not a product that rounding may turn over at
        // grazing incidence.
        let normal: Vector8<R, S> = select3::<R, S>(simd, leaving, neg(outward), outward);
        self.point = store3(point);
        self.normal = store3(normal);
    }

    /// The ray that leaves a contact in this direction, `behind` the surface or on the side of the one that came.
    #[inline(always)]
    pub(crate) fn ray(&self, lane: usize, direction: [R; 3], behind: bool, inside: bool) -> Ray<R> {
        let normal = lane3(&self.normal, lane);
        let side = if behind { neg(normal) } else { normal };
        let flat = self.flat >> lane & 1 == 1;
        Ray {
            origin: lane3(&self.point, lane),
            direction,
            local: if flat { side } else { lane3(&self.local, lane) },
            class: self.class[lane],
            into: (self.leaving >> lane & 1 == 1) != behind,
            inside,
            end: R::INFINITY,
        }
    }

    /// The rays that leave all contacts on the side of the ones that came, which run inside where these did.
    #[inline(always)]
    pub(crate) fn rays<S: Simd>(&self, simd: S, direction: Vector8<R, S>, inside: u32) -> Rays<R> {
        Rays {
            origin: self.point,
            direction: store3(direction),
            local: store3(select3::<R, S>(
                simd,
                self.flat,
                load3(simd, &self.normal),
                load3(simd, &self.local),
            )),
            class: self.class,
            into: self.leaving,
            inside,
            ..Rays::EMPTY
        }
    }
}
