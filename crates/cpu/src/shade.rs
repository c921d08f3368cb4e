//! What surfaces send towards rays by themselves: Phong's model (1975) with shadows, and the sky.

use fearless_simd::{Simd, SimdBase, SimdFloat};

use crate::contact::Contacts;
use crate::hierarchy::{Scratch, blocked};
use crate::lanes::{
    LANES, Lanes, Set, Triple, Vector8, bits, load, load3, select, select3, set3, splat, splat3, store3,
};
use crate::ray::Rays;
use crate::stage::Stage;
use crate::vector::{Vector, dot, fma, scale, sub};

/// What is asked of the materials of up to eight surfaces.
struct Finish<R> {
    ambient: [R; LANES],
    diffuse: [R; LANES],
    specular: [R; LANES],
    shiny: [R; LANES],
    colour: Triple<R>,
}

impl<R: Lanes> Finish<R> {
    #[inline(always)]
    fn new<S: Simd>(stage: Stage<'_, R, S>, contacts: &Contacts<R>, lanes: u32) -> Self {
        let mut finish = Self {
            ambient: [R::ZERO; LANES],
            diffuse: [R::ZERO; LANES],
            specular: [R::ZERO; LANES],
            shiny: [R::ZERO; LANES],
            colour: [[R::ZERO; LANES]; 3],
        };
        for lane in Set(lanes) {
            let material = &stage.materials[contacts.material[lane] as usize];
            finish.ambient[lane] = material.ambient;
            finish.diffuse[lane] = material.diffuse;
            finish.specular[lane] = material.specular;
            finish.shiny[lane] = material.shiny;
            set3(&mut finish.colour, lane, material.colour);
        }
        finish
    }
}

/// Ambient, diffuse and highlights at the contacts of some rays; counts the rays towards lights.
#[inline(always)]
pub(crate) fn local<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    (rays, lanes): (&Rays<R>, u32),
    contacts: &Contacts<R>,
    shadows: &mut u64,
    scratch: &mut Scratch<R>,
) -> Triple<R> {
    let simd = stage.simd;
    let finish = Finish::new(stage, contacts, lanes);
    let colour = load3(simd, &finish.colour);
    let diffuse = load::<R, S>(simd, &finish.diffuse);
    let (point, normal) = (load3(simd, &contacts.point), load3(simd, &contacts.normal));
    let zero = splat::<R, S>(simd, R::ZERO);
    let surrounding = splat3(simd, stage.frame.ambient);
    let mut sum = scale(colour, load::<R, S>(simd, &finish.ambient));
    for i in 0..3 {
        sum[i] *= surrounding[i];
    }
    for (number, light) in stage.lights.iter().enumerate() {
        let way = Way::<R, S>::new(simd, light.position, point);
        let cosine = dot(normal, way.towards);
        let lanes = lanes & !way.at_light & !bits(cosine.simd_le(zero));
        if lanes == 0 {
            continue;
        }
        let shadow = Rays {
            end: way.distance,
            touches: light.touches,
            touches_end: light.touches_end,
            ..contacts.rays(simd, way.towards, rays.inside)
        };
        *shadows += u64::from(lanes.count_ones());
        let lit = lanes & !blocked(stage, &shadow, lanes, number, scratch);
        if lit == 0 {
            continue;
        }
        let highlight = highlights(stage, rays, lit, &finish, (normal, way.towards, cosine));
        let diffuse = diffuse * cosine;
        let mut brighter = sum;
        for i in 0..3 {
            brighter[i] = sum[i] + (diffuse * colour[i] + highlight) * splat::<R, S>(simd, light.colour[i]);
        }
        sum = select3::<R, S>(simd, lit, brighter, sum);
    }
    store3(sum)
}

/// Where a light is.
struct Way<R: Lanes, S: Simd> {
    /// The unit directions.
    towards: Vector8<R, S>,
    distance: [R; LANES],
    /// The points that it is at itself.
    at_light: u32,
}

impl<R: Lanes, S: Simd> Way<R, S> {
    /// Scaled before it is squared: a far light's square would overflow.
    #[inline(always)]
    fn new(simd: S, position: Vector<R>, point: Vector8<R, S>) -> Self {
        let way = sub(splat3(simd, position), point);
        let largest = way[0].abs().max(way[1].abs()).max(way[2].abs());
        let one = splat::<R, S>(simd, R::ONE);
        let way = scale(way, one / largest);
        let length = SimdFloat::sqrt(dot(way, way));
        Self {
            towards: scale(way, one / length),
            distance: (length * largest).to_array(),
            at_light: bits(largest.simd_eq(splat::<R, S>(simd, R::ZERO))),
        }
    }
}

/// Specular highlights of a light: max(0, R.V)^s as exp(s log1p(-|R - V|^2 / 2)), since R.V itself has lost the digits that a
/// large exponent asks for.
#[inline(always)]
fn highlights<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    rays: &Rays<R>,
    lanes: u32,
    finish: &Finish<R>,
    (normal, towards, cosine): (Vector8<R, S>, Vector8<R, S>, R::Eight<S>),
) -> R::Eight<S> {
    let simd = stage.simd;
    let specular = load::<R, S>(simd, &finish.specular);
    let zero = splat::<R, S>(simd, R::ZERO);
    let lanes = lanes & !bits(specular.simd_eq(zero));
    if lanes == 0 {
        return zero;
    }
    let one = splat::<R, S>(simd, R::ONE);
    let mirrored = fma(normal, cosine + cosine, scale(towards, -one));
    // V is the ray's direction turned round.
    let gap = fma(load3(simd, &rays.direction), one, mirrored);
    let short = dot(gap, gap) / splat::<R, S>(simd, R::TWO);
    let near = lanes & !bits(short.simd_ge(one));
    let short = short.to_array();
    let mut share = [R::ZERO; LANES];
    for lane in Set(near) {
        share[lane] = (finish.shiny[lane] * (-short[lane]).ln_1p()).exp();
    }
    // x^0 = 1, also for x = 0.
    let even = lanes & bits(load::<R, S>(simd, &finish.shiny).simd_eq(zero));
    let share = select::<R, S>(simd, even, one, load::<R, S>(simd, &share));
    select::<R, S>(simd, lanes, specular * share, zero)
}

/// What rays that meet nothing bring back.
#[inline(always)]
pub(crate) fn background<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, rays: &Rays<R>) -> Triple<R> {
    let simd = stage.simd;
    let one = splat::<R, S>(simd, R::ONE);
    let high = (load::<R, S>(simd, &rays.direction[1]) + one) / splat::<R, S>(simd, R::TWO);
    let low = one - high;
    let (nadir, zenith) = (splat3(simd, stage.frame.nadir), splat3(simd, stage.frame.zenith));
    let mut sky = scale(nadir, low);
    for i in 0..3 {
        sky[i] += high * zenith[i];
    }
    store3(sky)
}
