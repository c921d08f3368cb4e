//! What the tracers are off by, oracle by oracle.

use std::f64::consts::FRAC_PI_4;

use scenec_picture::TraceError;
use scenec_scene::{DVec3, Scene};

use super::Reader;
use super::case::{OnDevice, Oracle, Sum};
use super::machines::{Machines, Shot};
use super::off::{Off, UNIT_SINGLE, against, each, off_colours, outline, same};
use super::picture_error as error;

/// The least turn that a look-at point can say, in radians, with a few digits to spare: 2^-44.
const LEAST_TURN: f64 = 256.0 * f64::EPSILON;

/// What an oracle needs besides the pictures at hand, to make more of them.
pub(super) struct Work<'a> {
    pub(super) read: Reader<'a>,
    pub(super) machines: &'a Machines<'a>,
    /// How a device is used besides.
    pub(super) besides: Option<OnDevice>,
}

impl Work<'_> {
    /// What each tracer is off by, as the oracle measures it.
    pub(super) fn errors(&self, oracle: &Oracle, scene: &Scene, reference: Shot) -> Result<Vec<Off>, String> {
        let mut shots = self.others(scene)?;
        match oracle {
            Oracle::Reference => Ok(against(&reference, &shots)),
            Oracle::Jitter => self.against_jitter(scene, &reference, &shots),
            Oracle::Leaves => self.against_leaves(scene, &reference, &shots),
            Oracle::Same { scene, calm, mirrored } => {
                let other = self.scene(scene)?;
                let mut others = self.others(&other)?;
                others.push(self.machines.reference(&other).map_err(said)?);
                let mask = calm.then(|| reference.frame.calm().unwrap_or_default());
                shots.push(reference);
                Ok(same(&shots, &others, mask.as_deref(), *mirrored))
            }
            Oracle::Finite => {
                let again = self.others(scene)?;
                Ok(each(&shots.iter().zip(&again).collect::<Vec<_>>(), |(a, b)| {
                    (a, error::unsteady(a, b))
                }))
            }
            Oracle::Sky => {
                shots.push(reference);
                Ok(each(&shots, |shot| (shot, error::seen(shot))))
            }
            Oracle::Colours { all, at } => {
                shots.push(reference);
                let all = all.as_ref().map(colour).transpose()?;
                Ok(each(&shots, |shot| (shot, off_colours(shot, all, at))))
            }
            Oracle::Ball { centre, radius } => {
                shots.push(reference);
                let number = |word: &String| word.parse::<f64>().map_err(|_| format!("`{word}` is no number"));
                let [x, y, z] = centre.each_ref().map(number);
                let way = DVec3::new(x?, y?, z?) - scene.settings.eyepos;
                let radius = number(radius)?;
                Ok(outline(&shots, scene, |d| error::within_ball(way, radius, d)))
            }
            Oracle::Plane { normal } => {
                shots.push(reference);
                let normal = DVec3::from_array(*normal).normalize();
                Ok(outline(&shots, scene, |d| (-d.dot(normal)).asin()))
            }
            Oracle::Refused { .. } => Ok(Vec::new()),
        }
    }

    /// The pictures of all tracers but the independent one.
    fn others(&self, scene: &Scene) -> Result<Vec<Shot>, String> {
        let mut shots = self.machines.others(scene).map_err(said)?;
        if let Some(how) = self.besides {
            shots.extend(self.machines.besides(scene, how).map_err(said)?);
        }
        Ok(shots)
    }

    /// The scene of a text.
    pub(super) fn scene(&self, text: &str) -> Result<Scene, String> {
        (self.read)(text).map_err(|codes| format!("the scene has errors: {}", codes.join(", ")))
    }

    /// The ratio of a tracer's distance from the reference to the reference's own distance from itself with its camera
    /// turned a little.
    fn against_jitter(&self, scene: &Scene, reference: &Shot, shots: &[Shot]) -> Result<Vec<Off>, String> {
        let by = |angle: f64| {
            let turned = self.turned(scene, angle, FRAC_PI_4)?;
            Ok::<_, String>(error::root_mean_square(&turned.exact, &reference.exact))
        };
        let (single, double) = (by(4.0 * UNIT_SINGLE)?, by(LEAST_TURN)?);
        Ok(each(shots, |shot| {
            let of_turn = if shot.single { single } else { double };
            (
                shot,
                error::root_mean_square(&shot.exact, &reference.exact) / of_turn.max(f64::MIN_POSITIVE),
            )
        }))
    }

    /// How many pixels of a tracer show what the reference shows neither there nor a little aside, in eight directions.
    fn against_leaves(&self, scene: &Scene, reference: &Shot, shots: &[Shot]) -> Result<Vec<Off>, String> {
        let mut found = Vec::new();
        for shot in shots {
            let mut strays = error::strays(shot, reference);
            let angle = if shot.single { 16.0 * UNIT_SINGLE } else { LEAST_TURN };
            for way in 0..8 {
                if strays.is_empty() {
                    break;
                }
                let still = error::strays(shot, &self.turned(scene, angle, FRAC_PI_4 * f64::from(way))?);
                strays.retain(|pixel| still.contains(pixel));
            }
            found.push((shot, strays.len() as f64));
        }
        Ok(each(&found, |(shot, count)| (shot, *count)))
    }

    /// The reference with its camera turned by an angle, to the right and from there as far up as `way` says; all in radians.
    fn turned(&self, scene: &Scene, angle: f64, way: f64) -> Result<Shot, String> {
        let mut scene = scene.clone();
        let look = scene.settings.lookat - scene.settings.eyepos;
        let across = look.cross(scene.settings.up).normalize_or_zero();
        let aside = across * way.cos() + across.cross(look).normalize_or_zero() * way.sin();
        scene.settings.lookat += aside * look.length() * angle;
        self.machines.reference(&scene).map_err(said)
    }
}

fn colour(sum: &Sum) -> Result<[f64; 3], String> {
    match sum {
        Sum::Colour(colour) => Ok(*colour),
        Sum::Word(word) => {
            let value = word.parse::<f64>().map_err(|_| format!("`{word}` is no number"))?;
            Ok([value; 3])
        }
    }
}

pub(super) fn said(error: TraceError) -> String {
    error.to_string()
}
