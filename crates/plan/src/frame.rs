//! The camera, the lights and the materials in plan units, and the bound on what a ray can bring back.

use scenec_scene::{DVec3, Material, Scene};

use crate::PlanError;
use crate::flatten::Flat;
use crate::shape::{Shape, ShapeKind};
use crate::together::found;

/// What the tracers need to know of the camera and the sky.
#[derive(Clone, Debug)]
pub struct View {
    /// Pixel columns.
    pub width: u32,
    /// Pixel rows.
    pub height: u32,
    /// The most bounces of one path.
    pub raydepth: u32,
    /// Sample points in a pixel's square, measured from its centre: x to the right, y down, each from -1/2 up to 1/2.
    pub samples: Vec<[f64; 2]>,
    /// Where the camera stands, plan units.
    pub eye: DVec3,
    /// Unit view direction.
    pub forward: DVec3,
    /// From the picture's centre to its right edge at distance 1.
    pub right: DVec3,
    /// From the picture's centre to its upper edge at distance 1.
    pub up: DVec3,
    /// The ambient light A on every surface.
    pub ambient: DVec3,
    /// The background straight below.
    pub nadir: DVec3,
    /// The background straight above.
    pub zenith: DVec3,
}

impl View {
    /// How many rays the eye sends out.
    pub(crate) fn rays(&self) -> f64 {
        f64::from(self.width) * f64::from(self.height) * self.samples.len() as f64
    }
}

/// A point light.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Lamp {
    /// Where it stands, plan units.
    pub position: DVec3,
    /// Its colour I.
    pub colour: DVec3,
    /// First and one past the last of [`crate::Plan::touches`] that tell which surfaces it lies on.
    pub touches: (u32, u32),
}

/// A surface that a light lies on. A ray to that light meets this surface at the light itself, not a rounding before it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Touch {
    /// The surface's class.
    pub class: u32,
    /// The light on the surface's own unit sphere; of no meaning for a half-space.
    pub local: DVec3,
}

/// Where the plan's coordinates lie in the world.
pub(crate) struct Place {
    pub(crate) origin: DVec3,
    pub(crate) scale: f64,
    camera: scenec_scene::Camera,
}

/// Chooses the plan's coordinates: the origin is the point of the bounded objects' box nearest to the eye, so that
/// numbers are small where rays bounce; the unit is a power of two near the scene's size, so that nothing leaves the
/// range of single precision only because the author counts in millimetres or light years.
pub(crate) fn place(scene: &Scene, flat: &Flat) -> Result<Place, PlanError> {
    let camera = match scenec_scene::view(&scene.settings) {
        scenec_scene::View::Clear(camera) | scenec_scene::View::AlongUp(camera) => camera,
        _ => return Err(PlanError::NoView),
    };
    let bounds = flat.finite_bounds();
    let origin = if bounds.is_empty() {
        camera.eye
    } else {
        bounds.nearest(camera.eye)
    };
    let mut extent = (camera.eye - origin).abs().max_element();
    if !bounds.is_empty() {
        // The halves, since the whole may overflow.
        extent = extent.max((bounds.max / 2.0 - bounds.min / 2.0).max_element());
    }
    for shape in flat.shapes.iter().filter(|shape| shape.kind() == ShapeKind::HalfSpace) {
        extent = extent.max(distance(shape, origin));
    }
    let exponent = if extent > 0.0 {
        extent.log2().floor().clamp(-900.0, 900.0)
    } else {
        0.0
    };
    Ok(Place {
        origin,
        scale: (-exponent).exp2(),
        camera,
    })
}

fn distance(plane: &Shape, origin: DVec3) -> f64 {
    plane.normal().dot(plane.centre - origin).abs()
}

pub(crate) fn view(scene: &Scene, place: &Place) -> View {
    let settings = &scene.settings;
    let camera = &place.camera;
    View {
        width: settings.width,
        height: settings.height,
        raydepth: settings.raydepth,
        samples: sample_points(settings.samples),
        eye: (camera.eye - place.origin) * place.scale,
        forward: camera.forward,
        right: camera.right,
        up: camera.up,
        ambient: settings.ambient * settings.ambient_int,
        nadir: settings.ambient_int,
        zenith: settings.ambient * settings.ambient_int,
    }
}

/// The first `count` points of the R2 sequence (Roberts 2018), measured from the centre of a unit square: multiples of
/// (1/g, 1/g^2) modulo 1, where g^3 = g + 1. The first is the centre, and any prefix of a longer run is a shorter one.
#[must_use]
pub fn sample_points(count: u32) -> Vec<[f64; 2]> {
    const G: f64 = 1.324_717_957_244_746;
    let point = |k: u32| [1.0 / G, 1.0 / (G * G)].map(|step| (0.5 + f64::from(k) * step).fract() - 0.5);
    (0..count).map(point).collect()
}

pub(crate) fn lamps(scene: &Scene, place: &Place) -> Vec<Lamp> {
    let lamp = |light: &scenec_scene::Light| {
        // Beyond 2^100 times the scene's size all its points see a light in the same direction; nearer, it is in the
        // range of single precision.
        let position = (light.position - place.origin) * place.scale;
        let position = position * (100.0_f64.exp2() / position.abs().max_element()).min(1.0);
        Lamp {
            position,
            colour: light.colour,
            touches: (0, 0),
        }
    };
    // A black light adds nothing, wherever it stands.
    scene
        .lights
        .iter()
        .filter(|light| light.colour != DVec3::ZERO)
        .map(lamp)
        .collect()
}

/// Finds the surfaces that the lights lie on.
pub(crate) fn touches(lamps: &mut [Lamp], shapes: &[Shape]) -> Vec<Touch> {
    let mut touches: Vec<Touch> = Vec::new();
    for lamp in lamps {
        let first = touches.len();
        let touched = found(shapes, |shape| {
            let class = shape.class;
            shape.touched_by(lamp.position).map(|local| Touch { class, local })
        });
        for touch in touched {
            if touches[first..].iter().all(|known| known.class != touch.class) {
                touches.push(touch);
            }
        }
        lamp.touches = (first as u32, touches.len() as u32);
    }
    touches
}

/// Entry j bounds what a ray with j bounces left can bring back, in any component: what a surface gives by itself plus
/// (|kr| + |kt|) times the entry before, or the background (Hall and Greenberg 1983 for the idea). May be infinite.
pub(crate) fn reach(scene: &Scene, materials: &[Material], lamps: &[Lamp]) -> Vec<f64> {
    let ambient = scene.settings.ambient * scene.settings.ambient_int;
    let sky = scene.settings.ambient_int.abs().max(ambient.abs()).max_element();
    let light = lamps.iter().fold(DVec3::ZERO, |sum, lamp| sum + lamp.colour.abs());
    let own = materials.iter().fold(0.0_f64, |most, material| {
        let diffuse = (material.colour * material.diffuse).abs() + DVec3::splat(material.specular.abs());
        most.max(((material.colour * ambient * material.ambient).abs() + light * diffuse).max_element())
    });
    let gain = materials.iter().fold(0.0_f64, |most, material| {
        most.max(material.reflect.abs() + material.refract.abs())
    });
    let mut reach = vec![sky.max(own)];
    for _ in 0..scene.settings.raydepth {
        let before = reach.last().copied().unwrap_or_default();
        reach.push(sky.max(own + gain * before));
    }
    reach
}

#[cfg(test)]
mod tests {
    use super::sample_points;

    #[test]
    fn sample_points_start_at_the_centre_and_nest() {
        let many = sample_points(64);
        assert_eq!(many[0], [0.0, 0.0]);
        assert_eq!(sample_points(32), many[..32]);
        assert!(many.iter().flatten().all(|x| (-0.5..0.5).contains(x)));
        let mean = many
            .iter()
            .fold([0.0, 0.0], |sum, p| [sum[0] + p[0] / 64.0, sum[1] + p[1] / 64.0]);
        assert!(mean.iter().all(|x| x.abs() < 0.02), "{mean:?}");
    }
}
