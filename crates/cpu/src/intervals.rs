//! Where up to eight rays run inside a surface's solid: the very numbers that [`crate::shape`] finds for one.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::packed_structs::{Shape, Touch};

use crate::balls::equal;
use crate::lanes::{LANES, Lanes, bits, load, load3, select, splat, splat3};
use crate::ray::Rays;
use crate::shape::{HALF_SPACE, Slope, approach, interval, other_root, parallel, plane_normal, slope, to_local};
use crate::vector::{Arithmetic, dot, sub};

/// Where rays enter and leave.
pub(crate) type Intervals<R> = [[R; LANES]; 2];

/// Of a ball, ellipsoid or half-space; `touches` are the surfaces that the rays' light lies on.
#[inline(always)]
pub(crate) fn intervals<R: Lanes, S: Simd>(
    simd: S,
    shape: &Shape<R>,
    rays: &Rays<R>,
    touches: &[Touch<R>],
) -> (R::Eight<S>, R::Eight<S>) {
    if !touches.is_empty() {
        // What is known of the light decides there, whatever the numbers say.
        let [enter, leave] = one_by_one(shape, rays, touches);
        return (load::<R, S>(simd, &enter), load::<R, S>(simd, &leave));
    }
    let own = equal(&rays.class, shape.class);
    if shape.kind == HALF_SPACE {
        half_space(simd, shape, rays, own)
    } else {
        quadric(simd, shape, rays, own)
    }
}

/// Which rays from outside enter at a distance of at most `until`, and where; one that starts within by rounding does at 0, if the
/// crossing behind is the nearer one.
#[inline(always)]
pub(crate) fn entries<R: Lanes, S: Simd>(
    simd: S,
    (enter, leave): (R::Eight<S>, R::Eight<S>),
    until: R::Eight<S>,
) -> (u32, [R; LANES]) {
    let zero = splat::<R, S>(simd, R::ZERO);
    let within = bits(enter.simd_le(zero) & leave.simd_gt(zero) & (-enter).simd_lt(leave));
    let ahead = bits(enter.simd_gt(zero) & enter.simd_lt(leave) & enter.simd_le(until));
    (within | ahead, select::<R, S>(simd, ahead, enter, zero).to_array())
}

/// Which rays are inside at a distance, and where these leave.
#[inline(always)]
pub(crate) fn ends<R: Lanes, S: Simd>(
    (enter, leave): (R::Eight<S>, R::Eight<S>),
    at: R::Eight<S>,
) -> (u32, [R; LANES]) {
    (bits(enter.simd_le(at) & at.simd_lt(leave)), leave.to_array())
}

#[inline(never)]
fn one_by_one<R: Lanes>(shape: &Shape<R>, rays: &Rays<R>, touches: &[Touch<R>]) -> Intervals<R> {
    let [mut enter, mut leave] = [[R::ZERO; LANES]; 2];
    for (lane, (enter, leave)) in enter.iter_mut().zip(&mut leave).enumerate() {
        (*enter, *leave) = interval(shape, &rays.get(lane), touches);
    }
    [enter, leave]
}

#[inline(always)]
fn quadric<R: Lanes, S: Simd>(simd: S, shape: &Shape<R>, rays: &Rays<R>, own: u32) -> (R::Eight<S>, R::Eight<S>) {
    let zero = splat::<R, S>(simd, R::ZERO);
    let mut inverse = [zero; 9];
    for (all, one) in inverse.iter_mut().zip(shape.inverse) {
        *all = splat::<R, S>(simd, one);
    }
    let start = sub(load3(simd, &rays.origin), splat3(simd, shape.centre));
    let direction = to_local(shape.kind, &inverse, load3(simd, &rays.direction));
    let (enter, leave) = approach(to_local(shape.kind, &inverse, start), direction).ends();
    if own == 0 {
        return (enter, leave);
    }
    let other = other_root(dot(load3(simd, &rays.local), direction), direction);
    let other = select::<R, S>(simd, rays.into, other, zero);
    (
        select::<R, S>(simd, own, zero, enter),
        select::<R, S>(simd, own, other, leave),
    )
}

#[inline(always)]
fn half_space<R: Lanes, S: Simd>(simd: S, shape: &Shape<R>, rays: &Rays<R>, own: u32) -> (R::Eight<S>, R::Eight<S>) {
    let normal = splat3(simd, plane_normal(shape));
    let (origin, direction) = (load3(simd, &rays.origin), load3(simd, &rays.direction));
    let Slope { towards, above, terms } = slope(normal, splat3(simd, shape.centre), origin, direction);
    let (zero, ever) = (splat::<R, S>(simd, R::ZERO), splat::<R, S>(simd, R::INFINITY));
    let along = bits(towards.size().simd_le(splat::<R, S>(simd, parallel()) * terms));
    let up = bits(towards.simd_gt(zero));
    let below = bits(above.simd_le(zero));
    let crossing = -above / towards;
    let enter = select::<R, S>(
        simd,
        !along & up | along & below,
        -ever,
        select::<R, S>(simd, along, ever, crossing),
    );
    let leave = select::<R, S>(
        simd,
        !along & up,
        crossing,
        select::<R, S>(simd, along & !below, -ever, ever),
    );
    if own == 0 {
        return (enter, leave);
    }
    // Of one class are this plane's half-spaces on either side, so this product is 1 or -1.
    let above = bits(dot(normal, load3(simd, &rays.local)).simd_ge(zero));
    (
        select::<R, S>(simd, own, select::<R, S>(simd, above, -ever, zero), enter),
        select::<R, S>(simd, own, select::<R, S>(simd, above, zero, ever), leave),
    )
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdBase, dispatch};
    use scenec_plan::packed_structs::Shape;

    use super::intervals;
    use crate::lanes::{LANES, Lanes};
    use crate::ray::{Ray, Rays};
    use crate::shape::{BALL, HALF_SPACE, interval};
    use crate::vector::normalize;

    /// Numbers between -1 and 1 without end (Knuth's MMIX generator).
    struct Random(u64);

    impl Random {
        fn next<R: Lanes>(&mut self) -> R {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            R::of((self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
        }

        fn three<R: Lanes>(&mut self) -> [R; 3] {
            [self.next(), self.next(), self.next()]
        }

        fn shape<R: Lanes>(&mut self, kind: u32) -> Shape<R> {
            let mut inverse = [R::ZERO; 9];
            inverse.fill_with(|| self.next());
            if kind == HALF_SPACE {
                [inverse[0], inverse[1], inverse[2]] = normalize(self.three());
            }
            if kind == BALL {
                inverse[0] = R::ONE + inverse[0] * inverse[0];
            }
            Shape {
                centre: self.three(),
                inverse,
                linear: inverse,
                kind,
                class: 1,
            }
        }

        /// Every fourth starts on the shape, every seventh runs along a plane.
        fn ray<R: Lanes>(&mut self, shape: &Shape<R>, number: u32) -> Ray<R> {
            let normal = [shape.inverse[0], shape.inverse[1], shape.inverse[2]];
            let direction = if number.is_multiple_of(7) {
                [normal[1], -normal[0], R::ZERO]
            } else {
                self.three()
            };
            let local = normalize(self.three());
            // Of the two that start on it, one goes either way.
            let first = number < 4;
            let side = if first { normal } else { normal.map(|x| -x) };
            Ray {
                origin: self.three(),
                direction: normalize(direction),
                local: if shape.kind == HALF_SPACE { side } else { local },
                class: number % 4,
                into: first,
                inside: false,
                end: R::INFINITY,
            }
        }
    }

    /// Eight at once are the same bits as one by one.
    fn check<R: Lanes>(kind: u32) {
        let mut random = Random(kind.into());
        for _ in 0..200 {
            let shape = random.shape::<R>(kind);
            let mut rays = Rays::EMPTY;
            let one: Vec<_> = (0..8).map(|number| random.ray(&shape, number)).collect();
            for (lane, ray) in one.iter().enumerate() {
                rays.set(lane, ray);
            }
            let (enter, leave): ([R; LANES], [R; LANES]) = dispatch!(Level::new(), simd => {
                let (enter, leave) = intervals(simd, &shape, &rays, &[]);
                (enter.to_array(), leave.to_array())
            });
            for (lane, ray) in one.iter().enumerate() {
                let expected = interval(&shape, ray, &[]);
                let bits = |x: R| (x.to_f64() + 0.0).to_bits();
                let same = |a: R, b: R| bits(a) == bits(b) || a.to_f64().is_nan() && b.to_f64().is_nan();
                assert!(
                    same(enter[lane], expected.0) && same(leave[lane], expected.1),
                    "{shape:?} {ray:?}: {:?}, not {expected:?}",
                    (enter[lane], leave[lane])
                );
            }
        }
    }

    #[test]
    fn eight_rays_are_as_good_as_one() {
        for kind in 0..=HALF_SPACE {
            check::<f32>(kind);
            check::<f64>(kind);
        }
    }
}
