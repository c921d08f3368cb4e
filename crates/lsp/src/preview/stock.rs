//! What has been made of the last texts, so that a camera that moves doesn't make the worker read the file again.

use std::collections::HashSet;
use std::sync::Arc;

use scenec_ide::meaning;
use scenec_plan::{Plan, plan};
use scenec_scene::{Scene, Settings, SolidId, SolidKind};
use scenec_text::SourceFile;

use super::view::settings;
use super::words::Look;

/// How many scenes are kept, and the bytes of text beyond which only the last one is.
const SCENES: usize = 4;
const BYTES: usize = 16 << 20;
/// How many plans of one scene are kept: the picture's, and that of an outline or a pick in another size.
const PLANS: usize = 2;

/// The scenes of the last texts, the latest one last.
#[derive(Default)]
pub(super) struct Stock {
    scenes: Vec<Kept>,
}

struct Kept {
    text: String,
    ignore_operators: bool,
    scene: Scene,
    /// As the file has them; those in `scene` are of the last look.
    settings: Settings,
    plans: Vec<(Settings, Arc<Plan>)>,
}

/// A scene ready to be traced.
pub(super) struct Ready<'a> {
    pub(super) plan: Arc<Plan>,
    pub(super) scene: &'a Scene,
}

impl Stock {
    /// The plan of a text for one way to look at it.
    ///
    /// # Errors
    /// A sentence for people: the text has errors, the camera sees nothing, or the scene can't be planned.
    pub(super) fn ready(&mut self, text: String, look: &Look) -> Result<Ready<'_>, String> {
        let known = |kept: &Kept| kept.ignore_operators == look.ignore_operators && kept.text == text;
        let kept = match self.scenes.iter().position(known) {
            Some(index) => self.scenes.remove(index),
            None => Kept::read(text, look)?,
        };
        self.make_room(kept.text.len());
        self.scenes.push(kept);
        self.scenes.last_mut().ok_or("there is no scene")?.ready(look)
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.scenes.clear();
    }

    fn make_room(&mut self, bytes: usize) {
        let held = |scenes: &[Kept]| bytes + scenes.iter().map(|kept| kept.text.len()).sum::<usize>();
        while !self.scenes.is_empty() && (self.scenes.len() >= SCENES || held(&self.scenes) > BYTES) {
            self.scenes.remove(0);
        }
    }
}

impl Kept {
    fn read(text: String, look: &Look) -> Result<Self, String> {
        let source = SourceFile::new(look.name.as_str(), text).map_err(|_| "the text is too large".to_owned())?;
        let mut scene = meaning(&source).ok_or("the text has errors")?;
        if look.ignore_operators {
            scene = scene.ignoring_operators();
        }
        Ok(Self {
            text: source.text().to_owned(),
            ignore_operators: look.ignore_operators,
            settings: scene.settings.clone(),
            scene,
            plans: Vec::new(),
        })
    }

    fn ready(&mut self, look: &Look) -> Result<Ready<'_>, String> {
        self.scene.settings = settings(&self.settings, look)?;
        let known = self
            .plans
            .iter()
            .position(|(settings, _)| *settings == self.scene.settings);
        let (settings, plan) = match known {
            Some(index) => self.plans.remove(index),
            None => {
                let plan = plan(&self.scene).map_err(|error| format!("the scene can't be traced: {error}"))?;
                (self.scene.settings.clone(), Arc::new(plan))
            }
        };
        if self.plans.len() >= PLANS {
            self.plans.remove(0);
        }
        self.plans.push((settings, Arc::clone(&plan)));
        Ok(Ready {
            plan,
            scene: &self.scene,
        })
    }
}

impl Ready<'_> {
    /// The numbers by which a traced picture may call the base objects below a solid.
    ///
    /// Leaves that are one surface lie in one place, and a plan need not keep all of them: surfaces are compared, and not
    /// numbers.
    pub(super) fn leaves_below(&self, solid: SolidId) -> HashSet<u32> {
        let mut surfaces = HashSet::new();
        let mut seen = HashSet::new();
        let mut open = vec![solid];
        while let Some(id) = open.pop() {
            if !seen.insert(id) {
                continue;
            }
            match self.scene.solids.get(id.index()).map(|solid| &solid.kind) {
                Some(SolidKind::Leaf(_)) => surfaces.extend(self.surface(id.0)),
                Some(SolidKind::Paint { inside, .. }) => open.push(*inside),
                Some(SolidKind::Combine { left, right, .. }) => open.extend([*left, *right]),
                None => {}
            }
        }
        let traced = self.plan.leaves.iter().map(|leaf| leaf.solid);
        traced
            .filter(|solid| self.surface(*solid).is_some_and(|surface| surfaces.contains(&surface)))
            .collect()
    }

    /// What makes two leaves the same surface: the base object and its transform, bit by bit.
    fn surface(&self, solid: u32) -> Option<(scenec_scene::Base, [u64; 12])> {
        let SolidKind::Leaf(leaf) = &self.scene.solids.get(solid as usize)?.kind else {
            return None;
        };
        let transform = self.scene.transform(leaf);
        let mut bits = [0; 12];
        let numbers = transform.linear.to_cols_array().into_iter();
        let numbers = numbers.chain(transform.centre.to_array());
        for (bits, number) in bits.iter_mut().zip(numbers) {
            *bits = number.to_bits();
        }
        Some((leaf.base, bits))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use scenec_scene::SolidId;

    use super::Stock;
    use crate::preview::{CameraWish, Look};

    const SEED: &str = include_str!("../../../../scenes/seed.scene");

    fn look(eye: Option<[f64; 3]>) -> Look {
        let camera = eye.map(|eye| CameraWish {
            eye,
            lookat: [0.0; 3],
            up: None,
            fov: None,
        });
        Look {
            name: "seed".to_owned(),
            size: None,
            camera,
            ignore_operators: false,
        }
    }

    #[test]
    fn a_known_text_and_camera_are_not_planned_again() {
        let mut stock = Stock::default();
        let mut plan = |text: &str, look: &Look| stock.ready(text.to_owned(), look).unwrap().plan;
        let first = plan(SEED, &look(None));
        let moved = plan(SEED, &look(Some([5.0, 1.0, 1.0])));
        assert!(!Arc::ptr_eq(&first, &moved));
        assert!(Arc::ptr_eq(&first, &plan(SEED, &look(None))));
        let other = SEED.replace("width := 600", "width := 60");
        assert_eq!(plan(&other, &look(None)).view.width, 60);
        let ignoring = Look {
            ignore_operators: true,
            ..look(None)
        };
        assert!(!Arc::ptr_eq(&first, &plan(SEED, &ignoring)));
        assert!(Arc::ptr_eq(&first, &plan(SEED, &look(None))));
        for number in 0..20 {
            plan(&format!("{SEED}\na := {number}"), &look(None));
        }
        assert!(!Arc::ptr_eq(&first, &plan(SEED, &look(None))));
        assert!(stock.scenes.len() <= super::SCENES);
    }

    #[test]
    fn a_text_with_errors_is_told() {
        let error = Stock::default().ready("!".to_owned(), &look(None)).err();
        assert_eq!(error.as_deref(), Some("the text has errors"));
    }

    #[test]
    fn leaves_below_a_solid_are_found_by_their_surface() {
        let text = SEED.replace(
            "!u := sph | plane",
            "!twin := sphere\n!twin += 0 1.75 0\n!twin ?= base\n!u := sph | plane\n!u := u | twin",
        );
        let mut stock = Stock::default();
        let ready = stock.ready(text, &look(None)).unwrap();
        let below = |solid: u32| {
            let mut leaves: Vec<u32> = ready.leaves_below(SolidId(solid)).into_iter().collect();
            leaves.sort_unstable();
            leaves
        };
        // Sphere, plane and the sphere's twin, then the two unions; the plan keeps one of the two that are alike.
        assert_eq!(below(0), [0]);
        assert_eq!(below(1), [1]);
        assert_eq!(below(2), [0]);
        assert_eq!(below(3), [0, 1]);
        assert_eq!(below(99), Vec::<u32>::new());
    }
}
