//! The most that a ray can bring: what is lost with a ray that is not followed.

use scenec_scene::{DVec3, Light, Material, Settings};

/// For each number of reflections and refractions that a path may still have, from 0 to the scene's ray depth, a bound
/// on any component of what a ray brings.
///
/// A ray ends at a surface or in the sky, which alone give at most l; and each surface hands on at most p times what
/// further rays bring. So with j to go it is l (1 + p + ... + p^j).
pub(crate) fn bounds(settings: &Settings, materials: &[Material], lights: &[Light]) -> Vec<f64> {
    let light: DVec3 = lights.iter().map(|light| light.colour.abs()).sum();
    let ambient = (settings.ambient * settings.ambient_int).abs();
    let mut own = settings.ambient.abs().max(DVec3::ONE) * settings.ambient_int.abs();
    let mut handed_on = 0.0_f64;
    for material in materials {
        let colour = material.colour.abs();
        let lit = light * (material.diffuse.abs() * colour + material.specular.abs());
        own = own.max(material.ambient.abs() * colour * ambient + lit);
        handed_on = handed_on.max(material.reflect.abs() + material.refract.abs());
    }
    let own = own.max_element();
    let mut bound = 0.0;
    let next = |_| {
        bound = own + handed_on * bound;
        bound
    };
    (0..=settings.raydepth).map(next).collect()
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DEFAULT_MATERIAL, DVec3, Light, Material, Settings};

    use super::bounds;

    #[test]
    fn the_bound_is_a_geometric_sum() {
        let mut settings = Settings::gather(|_| None);
        (settings.ambient, settings.ambient_int) = (DVec3::new(0.5, 0.0, 2.0), DVec3::splat(0.1));
        settings.raydepth = 2;
        let material = Material {
            reflect: -0.25,
            refract: 0.25,
            ..DEFAULT_MATERIAL
        };
        let light = Light {
            position: DVec3::ZERO,
            colour: DVec3::new(1.0, 0.0, 3.0),
            span: Default::default(),
        };
        // Own: 0.1 * 0.8 * 0.2 + 3 * (0.7 * 0.8 + 0.2).
        let own = 0.016 + 3.0 * 0.76;
        for (bound, expect) in bounds(&settings, &[material], &[light]).iter().zip([1.0, 1.5, 1.75]) {
            assert!((bound - own * expect).abs() < 1e-14, "{bound}");
        }
    }
}
