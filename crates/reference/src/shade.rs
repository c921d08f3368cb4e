//! What a ray brings back: Whitted's model ("An Improved Illumination Model for Shaded Display", 1980) over Phong's.

use scenec_picture::NOTHING;
use scenec_scene::{DVec3, Light, Material, MaterialId, Scene};

use crate::bound::bounds;
use crate::hash::Hash;
use crate::list::Hit;
use crate::shape::{Line, unit};
use crate::tally::{Kind, Tally};
use crate::tree::Tree;

/// A scene as rays meet it.
#[derive(Clone, Debug)]
pub(crate) struct World {
    tree: Tree,
    materials: Vec<Material>,
    lights: Vec<Light>,
    /// The colour of the ambient light.
    ambient: DVec3,
    /// The sky straight down and straight up.
    sky: [DVec3; 2],
    /// The most that a ray brings, by the reflections and refractions that it may still have.
    bounds: Vec<f64>,
    raydepth: u32,
}

/// What one ray from the eye brings back.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Sight {
    /// The light.
    pub(crate) colour: DVec3,
    /// The leaf that the ray itself hits, or [`NOTHING`].
    pub(crate) leaf: u32,
    /// How far that is from the eye.
    pub(crate) distance: f64,
    /// A number for the tree of rays.
    pub(crate) path: u64,
}

/// A ray that is still to be followed.
struct Job {
    line: Line,
    /// Whether it is inside the solid when it starts; unknown from the eye.
    side: Option<bool>,
    /// The share of what it brings that reaches the eye.
    weight: f64,
    /// How many reflections and refractions may follow.
    to_go: u32,
    kind: Kind,
}

impl World {
    pub(crate) fn new(scene: &Scene) -> Self {
        let tree = Tree::new(scene);
        let used: Vec<Material> = tree.materials().map(|id| *scene.material(id)).collect();
        let settings = &scene.settings;
        Self {
            bounds: bounds(settings, &used, &scene.lights),
            tree,
            materials: scene.materials.clone(),
            lights: scene.lights.clone(),
            ambient: settings.ambient * settings.ambient_int,
            sky: [settings.ambient_int, settings.ambient * settings.ambient_int],
            raydepth: settings.raydepth,
        }
    }

    /// Follows a ray from the eye, and all that come of it. Nothing is left out for being faint: an oracle has no
    /// cut-off; what the budget does not allow for is.
    pub(crate) fn look(&self, eye: DVec3, direction: DVec3, tally: &mut Tally) -> Sight {
        let mut sight = Sight {
            colour: DVec3::ZERO,
            leaf: NOTHING,
            distance: f64::INFINITY,
            path: 0,
        };
        let mut path = Hash::EMPTY;
        let mut jobs = vec![Job {
            line: Line {
                start: self.tree.spot(eye),
                ..Line::new(eye, direction)
            },
            side: None,
            weight: 1.0,
            to_go: self.raydepth,
            kind: Kind::Primary,
        }];
        while let Some(job) = jobs.pop() {
            if !tally.affords(job.kind) {
                tally.drop(job.weight.abs() * self.bounds[job.to_go as usize]);
                continue;
            }
            let Some(hit) = self.tree.along(&job.line).first(job.side) else {
                path.add(NOTHING);
                sight.colour += job.weight * self.background(job.line.direction);
                continue;
            };
            if matches!(job.kind, Kind::Primary) {
                sight.leaf = hit.edge.leaf.0;
                sight.distance = hit.edge.t * direction.length();
            }
            path.add(hit.edge.leaf.0);
            path.add(hit.edge.material.0);
            path.add(u32::from(hit.entering));
            sight.colour += job.weight * self.surface(&hit, job.line.direction, tally, &mut path);
            if job.to_go > 0 {
                self.go_on(&job, &hit, &mut jobs, &mut path);
            }
        }
        sight.path = path.0;
        sight
    }

    /// What a ray that meets nothing sees.
    fn background(&self, direction: DVec3) -> DVec3 {
        let height = (direction.y + 1.0) / 2.0;
        let [low, high] = self.sky;
        (1.0 - height) * low + height * high
    }

    /// The light that a surface sends back by itself.
    fn surface(&self, hit: &Hit, direction: DVec3, tally: &mut Tally, path: &mut Hash) -> DVec3 {
        let material = self.material(hit.edge.material);
        let normal = facing(hit);
        let mut colour = material.ambient * material.colour * self.ambient;
        for (number, light) in self.lights.iter().enumerate() {
            let way = light.position - hit.edge.spot.point;
            let to_light = unit(way);
            let Some(l) = to_light.filter(|l| normal.dot(*l) > 0.0) else {
                path.add(0);
                continue;
            };
            tally.shadow();
            let line = Line::from_surface(hit.edge.spot, way).to_light(number);
            // The light stands at t = 1.
            if self
                .tree
                .along(&line)
                .first(Some(!hit.entering))
                .is_some_and(|between| between.edge.t < 1.0)
            {
                path.add(1);
                continue;
            }
            path.add(2);
            let cosine = normal.dot(l);
            let mirrored = 2.0 * cosine * normal - l;
            // Rounding may make a cosine of a little more than 1, which a large exponent would blow up.
            let highlight = mirrored.dot(-direction).clamp(0.0, 1.0).powf(material.shiny);
            colour += light.colour * (material.diffuse * cosine * material.colour + material.specular * highlight);
        }
        colour
    }

    /// The rays that leave a surface which another one hit.
    fn go_on(&self, job: &Job, hit: &Hit, jobs: &mut Vec<Job>, path: &mut Hash) {
        let material = self.material(hit.edge.material);
        let (d, normal) = (job.line.direction, facing(hit));
        let wanted = material.refract != 0.0;
        let through = refracted(d, normal, hit.entering, material.index).filter(|_| wanted);
        // What can't go through follows the mirror's direction.
        let total = wanted && through.is_none();
        let reflect = material.reflect + if total { material.refract } else { 0.0 };
        path.add(u32::from(total));
        let mut spawn = |direction: DVec3, side: bool, share: f64, kind: Kind| {
            if share != 0.0 {
                jobs.push(Job {
                    line: Line::from_surface(hit.edge.spot, direction),
                    side: Some(side),
                    weight: job.weight * share,
                    to_go: job.to_go - 1,
                    kind,
                });
            }
        };
        spawn(
            (d - 2.0 * d.dot(normal) * normal).normalize(),
            !hit.entering,
            reflect,
            Kind::Reflected,
        );
        if let Some(through) = through {
            spawn(through, hit.entering, material.refract, Kind::Refracted);
        }
    }

    fn material(&self, id: MaterialId) -> &Material {
        &self.materials[id.index()]
    }
}

/// The unit normal on the side that the ray came from.
fn facing(hit: &Hit) -> DVec3 {
    if hit.entering {
        hit.edge.normal
    } else {
        -hit.edge.normal
    }
}

/// The unit direction behind a surface, after Snell; `None` where all is reflected. `normal` faces the ray.
///
/// The part of the direction along the surface is multiplied by the ratio of the indices, the one before to the one
/// behind, whatever its sign; the rest of the unit length goes along the normal. A ratio of 1/0 leaves nothing but the
/// perpendicular ray to go through.
pub(crate) fn refracted(direction: DVec3, normal: DVec3, entering: bool, index: f64) -> Option<DVec3> {
    let ratio = if entering { 1.0 / index } else { index };
    let along = direction - normal.dot(direction) * normal;
    let bent = if along == DVec3::ZERO { along } else { ratio * along };
    let room = 1.0 - bent.dot(bent);
    // Infinities and their quotients fail this too.
    (room >= 0.0).then(|| (bent - room.sqrt() * normal).normalize())
}
