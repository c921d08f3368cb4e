//! One member of a case through every tracer, and what comes of it.

use std::f64::consts::FRAC_PI_4;

use scenec_picture::{TraceError, Watch};
use scenec_scene::{DVec3, Scene};

use super::case::{Case, Filled, OnDevice, Oracle, Run, Sum};
use super::machines::{Machines, Shot};
use super::picture_error as error;
use super::{CaseError, Reader};
use crate::povray;

/// What came of one member of a case.
#[derive(Clone, PartialEq, Debug)]
pub struct Verdict {
    /// The case's name.
    pub case: String,
    /// The case's title.
    pub title: String,
    /// The member's name; empty if it is the only one.
    pub run: String,
    /// How much a relative change of the input is magnified, where that is known.
    pub condition: Option<f64>,
    /// The worst error of the tracers in single precision, with the largest that is allowed.
    pub single: Option<Outcome>,
    /// The same in double precision, the independent tracer among them where it is not the oracle.
    pub double: Option<Outcome>,
    /// Why single precision is not held to anything here, if it is not.
    pub beyond_single: Option<String>,
    /// Why the tracers take doubles here by themselves, if they do in each of its scenes.
    pub wider: Option<String>,
    /// Why it was not run on a device on which it is to be run besides, if it was not.
    pub not_run: Option<&'static str>,
    /// What POV-Ray makes of it, if it was asked: the share of pixels off the edges where it shows another surface than the
    /// reference, or why there is no picture of its.
    pub povray: Option<Result<f64, String>>,
}

/// An error beside its threshold.
#[derive(Clone, PartialEq, Debug)]
pub struct Outcome {
    /// The worst error, in the units of the oracle.
    pub error: f64,
    /// Which tracer it is of.
    pub tracer: String,
    /// The largest error allowed.
    pub threshold: f64,
}

impl Outcome {
    /// Whether the error is no larger than it may be.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.error <= self.threshold
    }
}

impl Verdict {
    /// Whether every tracer that is held to something holds it.
    #[must_use]
    pub fn holds(&self) -> bool {
        let single = self.single.as_ref().filter(|_| self.beyond_single.is_none());
        single.is_none_or(Outcome::holds) && self.double.as_ref().is_none_or(Outcome::holds)
    }
}

/// Judges one member of a case.
///
/// # Errors
/// If the case itself is wrong: its scene has errors that nothing expects, or can't be traced at all.
pub fn judge(case: &Case, run: &Run, read: Reader<'_>, machines: &Machines<'_>) -> Result<Verdict, CaseError> {
    let filled = case.filled(run, 0);
    let mut found: Option<Findings> = None;
    let going = |_: &u32| !machines.watch.is_some_and(Watch::stopped);
    for scene in (0..case.scenes(machines.all)).take_while(going) {
        let one = findings(&case.filled(run, scene), read, machines).map_err(|message| CaseError {
            name: format!("{} {}", case.name, run.name).trim().to_owned(),
            message,
        })?;
        found = Some(match found {
            Some(found) => found.and(one),
            None => one,
        });
    }
    let found = found.unwrap_or_default();
    let worst = |single: bool, threshold: f64| {
        let of = found.errors.iter();
        let of = of.filter(|one| one.single.is_none_or(|it| it == single));
        of.max_by(|a, b| a.error.total_cmp(&b.error)).map(|one| Outcome {
            error: one.error,
            tracer: one.tracer.clone(),
            threshold,
        })
    };
    Ok(Verdict {
        case: case.name.clone(),
        title: case.title.clone(),
        run: run.name.clone(),
        condition: run.condition,
        single: worst(true, filled.single),
        double: worst(false, filled.double),
        beyond_single: run.beyond_single.clone(),
        wider: found.wider,
        not_run: found.not_run,
        povray: found.povray,
    })
}

/// What is found of a member.
#[derive(Default)]
struct Findings {
    errors: Vec<Off>,
    wider: Option<String>,
    not_run: Option<&'static str>,
    povray: Option<Result<f64, String>>,
}

impl Findings {
    /// What is found of this and another scene of the member.
    fn and(mut self, other: Self) -> Self {
        self.errors.extend(other.errors);
        self.wider = self.wider.filter(|_| other.wider.is_some());
        self.not_run = self.not_run.or(other.not_run);
        self.povray = match (self.povray, other.povray) {
            (Some(Ok(a)), Some(Ok(b))) => Some(Ok(a.max(b))),
            (Some(Err(_)) | None, Some(seen)) => Some(seen),
            (seen, _) => seen,
        };
        self
    }
}

fn findings(filled: &Filled, read: Reader<'_>, machines: &Machines<'_>) -> Result<Findings, String> {
    if let Oracle::Refused { code } = &filled.oracle {
        let refused = matches!(read(&filled.scene), Err(codes) if codes.contains(code));
        let error = Off {
            tracer: "interpreter".to_owned(),
            single: None,
            error: if refused { 0.0 } else { 1.0 },
        };
        return Ok(Findings {
            errors: vec![error],
            ..Findings::default()
        });
    }
    let work = Work {
        read,
        machines,
        besides: filled.device,
    };
    let scene = work.scene(&filled.scene)?;
    let wider = Machines::beyond_single(&scene).map_err(said)?;
    let reference = machines.reference(&scene).map_err(said)?;
    Ok(Findings {
        wider: wider.map(|reason| reason.to_string()),
        not_run: filled.device.and_then(|how| machines.lack(how)),
        povray: machines.povray.then(|| second_opinion(&scene, &reference)),
        errors: work.errors(&filled.oracle, &scene, reference)?,
    })
}

fn second_opinion(scene: &Scene, reference: &Shot) -> Result<f64, String> {
    let ids = reference.frame.ids.as_deref().unwrap_or_default();
    let seen = povray::leaves(scene)?;
    Ok(povray::astray(&seen, ids, scene.settings.width as usize))
}

/// What one tracer is off by; `single` is open where the precision makes no difference.
struct Off {
    tracer: String,
    single: Option<bool>,
    error: f64,
}

struct Work<'a> {
    read: Reader<'a>,
    machines: &'a Machines<'a>,
    /// How a device is used besides.
    besides: Option<OnDevice>,
}

impl Work<'_> {
    fn errors(&self, oracle: &Oracle, scene: &Scene, reference: Shot) -> Result<Vec<Off>, String> {
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

    fn scene(&self, text: &str) -> Result<Scene, String> {
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

/// Half the distance from 1 to the next number of single precision.
const UNIT_SINGLE: f64 = 1.0 / (1_u32 << 24) as f64;
/// The same of double precision.
const UNIT_DOUBLE: f64 = f64::EPSILON / 2.0;
/// The least turn that a look-at point can say, in radians, with a few digits to spare: 2^-44.
const LEAST_TURN: f64 = 256.0 * f64::EPSILON;

fn said(error: TraceError) -> String {
    error.to_string()
}

fn each<'a, T>(list: &'a [T], off: impl Fn(&'a T) -> (&'a Shot, f64)) -> Vec<Off> {
    let one = |item: &'a T| {
        let (shot, error) = off(item);
        Off {
            tracer: shot.tracer.clone(),
            single: Some(shot.single),
            // Whatever a picture is held to, it is to be of numbers.
            error: if shot.frame.picture.non_finite() == 0 {
                error
            } else {
                f64::INFINITY
            },
        }
    };
    list.iter().map(one).collect()
}

fn against(reference: &Shot, shots: &[Shot]) -> Vec<Off> {
    let calm = reference.frame.calm().unwrap_or_default();
    each(shots, |shot| {
        let leaves = shot
            .frame
            .ids
            .iter()
            .flatten()
            .zip(reference.frame.ids.iter().flatten());
        let wrong = leaves.zip(&calm).any(|((a, b), calm)| *calm && a != b);
        let colours = error::largest(&shot.exact, &reference.exact, |i| calm.get(i) == Some(&true));
        (shot, if wrong { colours.max(1.0) } else { colours })
    })
}

fn same(shots: &[Shot], others: &[Shot], calm: Option<&[bool]>, mirrored: bool) -> Vec<Off> {
    let twin = |shot: &Shot| others.iter().position(|other| other.tracer == shot.tracer);
    let pairs: Vec<_> = shots
        .iter()
        .filter_map(|shot| Some((shot, &others[twin(shot)?])))
        .collect();
    each(&pairs, |(shot, other)| {
        let width = shot.frame.picture.width() as usize;
        let mut expect = other.exact.clone();
        if mirrored {
            expect.chunks_mut(width).for_each(<[_]>::reverse);
        }
        let counts = |i: usize| calm.is_none_or(|calm| calm.get(i) == Some(&true));
        (shot, error::largest(&shot.exact, &expect, counts))
    })
}

fn outline(shots: &[Shot], scene: &Scene, inside: impl Fn(DVec3) -> f64) -> Vec<Off> {
    each(shots, |shot| {
        let unit = if shot.single { UNIT_SINGLE } else { UNIT_DOUBLE };
        (shot, error::beyond_outline(shot, scene, unit, &inside))
    })
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

fn off_colours(shot: &Shot, all: Option<[f64; 3]>, at: &[(u32, u32, [f64; 3])]) -> f64 {
    let width = shot.frame.picture.width();
    let everywhere = all.map_or(0.0, |all| {
        shot.exact
            .iter()
            .map(|pixel| error::apart(*pixel, all))
            .fold(0.0, f64::max)
    });
    let spot = |(x, y, colour): &(u32, u32, [f64; 3])| {
        let pixel = shot.exact.get((y * width + x) as usize);
        pixel.map_or(f64::INFINITY, |pixel| error::apart(*pixel, *colour))
    };
    at.iter().map(spot).fold(everywhere, f64::max)
}
