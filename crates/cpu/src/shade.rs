//! What a surface sends towards the ray by itself: Phong's model (1975) with shadows, and the sky.

use fearless_simd::Simd;
use scenec_plan::packed_structs::{Light, Material};
use scenec_plan::{Packed, Real};

use crate::hierarchy::{Scratch, blocked};
use crate::lanes::Lanes;
use crate::ray::{End, Ray};
use crate::shape::Contact;
use crate::stage::Stage;
use crate::vector::{Vector, dot, fma, scale, sub};

/// Ambient, diffuse and highlights at a contact of `ray`; counts the rays towards lights.
#[inline(always)]
pub(crate) fn local<R: Lanes, S: Simd>(
    scene: Stage<'_, R, S>,
    material: &Material<R>,
    ray: &Ray<R>,
    contact: &Contact<R>,
    shadows: &mut u64,
    scratch: &mut Scratch<R>,
) -> Vector<R> {
    let ambient = scene.frame.ambient;
    let mut sum: Vector<R> = std::array::from_fn(|i| material.ambient * material.colour[i] * ambient[i]);
    for (number, light) in scene.lights.iter().enumerate() {
        let Some((towards, distance)) = way(light, contact.point) else {
            continue;
        };
        let cosine = dot(contact.normal, towards);
        if cosine <= R::ZERO {
            continue;
        }
        let end = End {
            distance,
            touches: light.touches,
            touches_end: light.touches_end,
        };
        let shadow = Ray {
            end,
            ..contact.ray(towards, false, ray.inside)
        };
        *shadows += 1;
        if blocked(scene, &shadow, (number, distance), scratch) {
            continue;
        }
        let diffuse = material.diffuse * cosine;
        let highlight = if material.specular == R::ZERO {
            R::ZERO
        } else {
            material.specular * phong(material, ray, contact.normal, towards, cosine)
        };
        sum = std::array::from_fn(|i| sum[i] + (diffuse * material.colour[i] + highlight) * light.colour[i]);
    }
    sum
}

/// The unit direction to a light and its distance; nothing for a light in the point itself. Scaled before it is squared:
/// a far light's square would overflow.
#[inline(always)]
fn way<R: Real>(light: &Light<R>, point: Vector<R>) -> Option<(Vector<R>, R)> {
    let way = sub(light.position, point);
    let largest = way[0].abs().max(way[1].abs()).max(way[2].abs());
    if largest == R::ZERO {
        return None;
    }
    let way = scale(way, R::ONE / largest);
    let length = dot(way, way).sqrt();
    Some((scale(way, R::ONE / length), length * largest))
}

/// max(0, R.V)^s as exp(s log1p(-|R - V|^2 / 2)): R.V itself has lost the digits that a large exponent asks for.
#[inline(always)]
fn phong<R: Real>(material: &Material<R>, ray: &Ray<R>, normal: Vector<R>, towards: Vector<R>, cosine: R) -> R {
    if material.shiny == R::ZERO {
        // x^0 = 1, also for x = 0.
        return R::ONE;
    }
    let mirrored = fma(normal, cosine + cosine, scale(towards, -R::ONE));
    // V is the ray's direction turned round.
    let gap = fma(ray.direction, R::ONE, mirrored);
    let short = dot(gap, gap) / R::TWO;
    if short >= R::ONE {
        R::ZERO
    } else {
        (material.shiny * (-short).ln_1p()).exp()
    }
}

/// What a ray that meets nothing brings back.
#[inline(always)]
pub(crate) fn background<R: Real>(scene: &Packed<R>, direction: Vector<R>) -> Vector<R> {
    let high = (direction[1] + R::ONE) / R::TWO;
    let frame = &scene.frame;
    std::array::from_fn(|i| (R::ONE - high) * frame.nadir[i] + high * frame.zenith[i])
}
