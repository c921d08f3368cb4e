//! A small ball of a material as a picture inside Markdown, for hovers.

use std::collections::VecDeque;
use std::io::Cursor;
use std::sync::{Mutex, OnceLock};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use scenec_cpu::Cpu;
use scenec_ide::meaning;
use scenec_picture::{Encoding, Format, Frame, Layers, Limits, Request, Tracer, Watch, Window, encode};
use scenec_plan::plan;
use scenec_scene::{Material, MaterialId, Scene};
use scenec_text::SourceFile;

use crate::documents::lock;

/// What is drawn; its first material is the one in question.
const SCENE: &str = include_str!("ball.scene");
const SUBJECT: MaterialId = MaterialId(1);
/// How many balls are kept: about a megabyte of text.
const KEPT: usize = 64;
/// Glass in glass in glass looks no different after so many rays, and a hover must not wait.
const LIMITS: Limits = Limits {
    cutoff: 1.0 / 64.0,
    ray_budget: 256,
};

/// A Markdown image of a ball of a material; `None` if it can't be drawn.
pub(crate) fn ball(material: &Material) -> Option<String> {
    static STUDIO: OnceLock<Mutex<Studio>> = OnceLock::new();
    lock(STUDIO.get_or_init(Mutex::default)).ball(material)
}

/// What makes two materials look the same: all ten values, bit by bit.
type Key = [u64; 10];

#[derive(Default)]
struct Studio {
    scene: Option<Scene>,
    cpu: Option<Cpu<f32>>,
    /// The latest one last.
    done: VecDeque<(Key, String)>,
}

impl Studio {
    fn ball(&mut self, material: &Material) -> Option<String> {
        let key = material.values().map(f64::to_bits);
        if let Some((_, image)) = self.done.iter().find(|(known, _)| *known == key) {
            return Some(image.clone());
        }
        let image = image(&self.frame(material)?)?;
        if self.done.len() >= KEPT {
            self.done.pop_front();
        }
        self.done.push_back((key, image.clone()));
        Some(image)
    }

    fn frame(&mut self, material: &Material) -> Option<Frame> {
        if self.scene.is_none() {
            self.scene = meaning(&SourceFile::new("ball", SCENE).ok()?);
        }
        let scene = self.scene.as_mut()?;
        *scene.materials.get_mut(SUBJECT.index())? = *material;
        let plan = plan(scene).ok()?;
        match &mut self.cpu {
            Some(cpu) => cpu.show(&plan),
            None => self.cpu = Some(Cpu::new(&plan, 0).ok()?),
        }
        let request = Request {
            window: Window::whole(plan.view.width, plan.view.height),
            limits: LIMITS,
            layers: Layers::default(),
            watch: &Watch::new(),
        };
        self.cpu.as_mut()?.trace(&request).ok()
    }
}

fn image(frame: &Frame) -> Option<String> {
    let mut png = Cursor::new(Vec::new());
    encode(&frame.picture, &Encoding::of(Format::from_name("png")?), &mut png).ok()?;
    let png = STANDARD.encode(png.into_inner());
    Some(format!("![a ball of the material](data:image/png;base64,{png})"))
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DVec3, Material};
    use scenec_text::Span;

    use super::{KEPT, Studio};

    fn material(values: [f64; 10]) -> Material {
        Material::from_values(values, Span::default())
    }

    const MATT: [f64; 10] = [0.1, 0.7, 0.2, 0.0, 0.0, 1.0, 16.0, 0.8, 0.1, 0.1];
    const MIRROR: [f64; 10] = [0.0, 0.1, 0.5, 0.9, 0.0, 1.0, 60.0, 1.0, 1.0, 1.0];
    const GLASS: [f64; 10] = [0.0, 0.0, 0.5, 0.1, 0.9, 1.5, 60.0, 1.0, 1.0, 1.0];

    #[test]
    fn materials_are_told_apart_and_remembered() {
        let mut studio = Studio::default();
        let images: Vec<_> = [MATT, MIRROR, GLASS]
            .iter()
            .map(|values| studio.ball(&material(*values)).unwrap())
            .collect();
        assert!(images[0] != images[1] && images[1] != images[2] && images[0] != images[2]);
        assert!(
            images
                .iter()
                .all(|image| image.starts_with("![") && image.len() < 16_000)
        );
        assert_eq!(studio.done.len(), 3);
        let elsewhere = Material {
            span: None,
            ..material(MIRROR)
        };
        assert_eq!(studio.ball(&elsewhere).as_ref(), Some(&images[1]));
        assert_eq!(studio.done.len(), 3);
    }

    #[test]
    fn the_store_is_bounded_and_no_values_are_too_strange() {
        let mut studio = Studio::default();
        for number in 0..KEPT + 10 {
            let mut strange = material(GLASS);
            strange.colour = DVec3::splat(number as f64 * 1e300);
            assert!(studio.ball(&strange).is_some());
        }
        assert_eq!(studio.done.len(), KEPT);
        for index in [0.0, -1.5, 1e-300, f64::MAX] {
            let mut values = GLASS;
            values[5] = index;
            values[3] = 1e10;
            assert!(studio.ball(&material(values)).is_some());
        }
    }

    /// Times depend on the machine; rays don't. Two threads trace so many in about four milliseconds.
    #[test]
    fn a_hover_does_not_wait_for_a_ball() {
        let mut studio = Studio::default();
        for values in [MATT, MIRROR, GLASS] {
            let stats = studio.frame(&material(values)).unwrap().stats;
            assert!(stats.rays() < 120_000, "{values:?}: {stats:?}");
        }
    }
}
