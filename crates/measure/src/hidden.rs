//! Surfaces that show in a pixel though none of its samples meets them: what samples can't know, the scene does.

use scenec_cpu::Cpu;
use scenec_picture::{Layers, Limits, NOTHING, Request, TraceError, Tracer, Watch, Window};
use scenec_plan::{Plan, PlanError, plan, sample_points};
use scenec_scene::{DVec3, Scene};

/// As many points of the sequence are asked which surface shows; that costs no light and no bounce.
const POINTS: u32 = 512;

/// The largest part of a pixel that a straight edge can cut off without any of [`POINTS`] in it.
const EMPTY: f64 = 6.15e-3;

/// A surface that shows in a pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Shown {
    leaf: u32,
    /// The first point that meets it.
    first: u32,
    /// How many points do.
    points: u32,
}

/// Which surfaces show in each pixel of a scene, and from which number of samples on that is known.
#[derive(Clone, Debug)]
pub(crate) struct Hidden {
    pixels: Vec<Vec<Shown>>,
    width: usize,
}

/// What a surface may bring: this much by itself in any light, and so much more or less for lights and further rays.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Light {
    ambient: DVec3,
    about: DVec3,
}

impl Hidden {
    /// Looks at the scene; `counter` hears of [`Hidden::work`] points in each pixel.
    ///
    /// # Errors
    /// There is no plan, or somebody says stop.
    pub(crate) fn of(scene: &Scene, watch: &Watch, counter: &Watch) -> Result<Self, TraceError> {
        let mut bare = scene.clone();
        bare.lights.clear();
        bare.settings.raydepth = 0;
        let (width, height) = (bare.settings.width, bare.settings.height);
        let bare = plan(&bare).map_err(|error: PlanError| TraceError::Failed(error.to_string()))?;
        let mut cpu = Cpu::<f64>::new(&bare, 0)?;
        let window = Window::whole(width, height);
        let mut found = Self {
            pixels: vec![Vec::new(); usize::try_from(window.pixels()).unwrap_or(usize::MAX)],
            width: width.max(1) as usize,
        };
        for (number, point) in (0..).zip(sample_points(POINTS)) {
            cpu.divide(width, height, &[point]);
            let request = Request {
                window,
                limits: Limits::NO_CUTOFF,
                layers: Layers {
                    ids: true,
                    ..Layers::default()
                },
                watch,
            };
            for (shown, leaf) in found
                .pixels
                .iter_mut()
                .zip(cpu.trace(&request)?.ids.into_iter().flatten())
            {
                meet(shown, leaf, number);
            }
            counter.advance(window.pixels());
        }
        Ok(found)
    }

    /// How many points of each pixel are looked at.
    pub(crate) const fn work() -> u64 {
        POINTS as u64
    }

    /// What the surfaces may add to each component of a pixel that none of so many samples meets, of its own or of the eight
    /// pixels around it: their share of the pixel, and what an edge may cut off unseen, times how far what
    /// they bring may be from `colour`. What a neighbour meets is in the contrast.
    pub(crate) fn bring(&self, index: usize, samples: u32, colour: [f64; 3], lights: &Lights) -> [f64; 3] {
        let Some(shown) = self.pixels.get(index) else {
            return [0.0; 3];
        };
        let hidden = shown.iter().filter(|one| !self.is_met(index, one.leaf, samples));
        let sum = hidden.fold(DVec3::ZERO, |sum, one| {
            let share = f64::from(one.points) / Self::work() as f64 + EMPTY;
            sum + share * lights.beside(one.leaf, DVec3::from(colour))
        });
        sum.to_array()
    }

    fn is_met(&self, index: usize, leaf: u32, samples: u32) -> bool {
        let (column, row) = (index % self.width, index / self.width);
        let columns = column.saturating_sub(1)..self.width.min(column + 2);
        let rows = row.saturating_sub(1)..row + 2;
        let mut around = rows.flat_map(|row| columns.clone().map(move |column| row * self.width + column));
        around.any(|place| {
            let shown = self.pixels.get(place).map(Vec::as_slice).unwrap_or_default();
            let at = shown.binary_search_by_key(&leaf, |one| one.leaf);
            at.is_ok_and(|at| shown[at].first < samples)
        })
    }
}

/// A point meets a leaf, or nothing: the sky counts as a surface too.
fn meet(shown: &mut Vec<Shown>, leaf: u32, first: u32) {
    match shown.binary_search_by_key(&leaf, |one| one.leaf) {
        Ok(at) => shown[at].points += 1,
        Err(at) => shown.insert(at, Shown { leaf, first, points: 1 }),
    }
}

/// What each surface of a plan may bring.
#[derive(Clone, Debug)]
pub(crate) struct Lights {
    /// By the leaf's number in the scene, ascending.
    leaves: Vec<(u32, Light)>,
    sky: Light,
}

impl Lights {
    pub(crate) fn of(plan: &Plan) -> Self {
        let view = &plan.view;
        let light = plan
            .lights
            .iter()
            .fold(DVec3::ZERO, |sum, lamp| sum + lamp.colour.abs());
        let bounces = plan.view.raydepth.checked_sub(1).map(|depth| depth as usize);
        let further = bounces.and_then(|depth| plan.reach.get(depth)).copied().unwrap_or(0.0);
        let of_leaf = |leaf: &scenec_plan::Leaf| {
            let material = &plan.materials[leaf.material as usize];
            let lit = (material.colour * material.diffuse).abs() + DVec3::splat(material.specular.abs());
            let gain = material.reflect.abs() + material.refract.abs();
            let handed = if gain > 0.0 { gain * further } else { 0.0 };
            let light = Light {
                ambient: material.colour * view.ambient * material.ambient,
                about: light * lit + DVec3::splat(handed),
            };
            (leaf.solid, light)
        };
        let mut leaves: Vec<_> = plan.leaves.iter().map(of_leaf).collect();
        leaves.sort_by_key(|(leaf, _)| *leaf);
        Self {
            leaves,
            // Between its two ends.
            sky: Light {
                ambient: (view.nadir + view.zenith) / 2.0,
                about: (view.nadir - view.zenith).abs() / 2.0,
            },
        }
    }

    /// How far what a leaf brings may be from a colour.
    fn beside(&self, leaf: u32, colour: DVec3) -> DVec3 {
        let far = |light: &Light| (light.ambient - colour).abs() + light.about;
        if leaf == NOTHING {
            return far(&self.sky);
        }
        let first = self.leaves.partition_point(|(number, _)| *number < leaf);
        let same = self.leaves[first..].iter().take_while(|(number, _)| *number == leaf);
        same.fold(DVec3::ZERO, |most, (_, light)| most.max(far(light)))
    }
}

#[cfg(test)]
mod tests {
    use scenec_plan::sample_points;
    use scenec_scene::DVec3;

    use super::{EMPTY, Hidden, Light, Lights, POINTS, Shown, meet};
    use crate::discrepancy::empty;

    #[test]
    fn no_edge_cuts_off_more_than_is_said() {
        let found = empty(&sample_points(POINTS));
        assert!(found <= EMPTY && EMPTY < 1.01 * found, "{found}");
    }

    /// What the middle one of three pixels may get from leaf 1, which so many points of it meet: the first of them, and the first
    /// in the pixel to its right, are these.
    fn check(points: u32, first: u32, first_beside: u32, samples: u32, expect: f64) {
        let mut pixels = vec![Vec::new(); 3];
        meet(&mut pixels[1], 0, 0);
        meet(&mut pixels[1], 1, first);
        for _ in 1..points {
            meet(&mut pixels[1], 1, POINTS);
        }
        meet(&mut pixels[2], 1, first_beside);
        assert_eq!(pixels[1][1], Shown { leaf: 1, first, points });
        let (none, light) = (
            DVec3::ZERO,
            Light {
                ambient: DVec3::X,
                about: DVec3::splat(0.5),
            },
        );
        let lights = Lights {
            leaves: vec![
                (
                    0,
                    Light {
                        ambient: none,
                        about: none,
                    },
                ),
                (1, light),
            ],
            sky: Light {
                ambient: none,
                about: none,
            },
        };
        let found = Hidden { pixels, width: 3 }.bring(1, samples, [0.25, 0.25, 0.0], &lights);
        for (found, far) in found.into_iter().zip([1.25, 0.75, 0.5]) {
            assert!((found - expect * far).abs() < 1e-12, "{found} {}", expect * far);
        }
    }

    #[test]
    fn what_no_sample_meets_counts_by_its_share() {
        check(51, 16, 16, 16, 51.0 / 512.0 + EMPTY);
        check(51, 15, POINTS, 16, 0.0);
        check(51, POINTS, 15, 16, 0.0);
        check(51, 16, 16, 17, 0.0);
    }
}
