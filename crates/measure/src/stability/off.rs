//! What tracers are off by where their pictures, and those they are held against, are at hand.

use scenec_scene::{DVec3, Scene};

use super::machines::Shot;
use super::picture_error as error;

/// Half the distance from 1 to the next number of single precision.
pub(super) const UNIT_SINGLE: f64 = 1.0 / (1_u32 << 24) as f64;
/// The same of double precision.
const UNIT_DOUBLE: f64 = f64::EPSILON / 2.0;

/// What one tracer is off by; `single` is open where the precision makes no difference.
pub(super) struct Off {
    pub(super) tracer: String,
    pub(super) single: Option<bool>,
    pub(super) error: f64,
}

pub(super) fn each<'a, T>(list: &'a [T], off: impl Fn(&'a T) -> (&'a Shot, f64)) -> Vec<Off> {
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

pub(super) fn against(reference: &Shot, shots: &[Shot]) -> Vec<Off> {
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

pub(super) fn same(shots: &[Shot], others: &[Shot], calm: Option<&[bool]>, mirrored: bool) -> Vec<Off> {
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

pub(super) fn outline(shots: &[Shot], scene: &Scene, inside: impl Fn(DVec3) -> f64) -> Vec<Off> {
    each(shots, |shot| {
        let unit = if shot.single { UNIT_SINGLE } else { UNIT_DOUBLE };
        (shot, error::beyond_outline(shot, scene, unit, &inside))
    })
}

pub(super) fn off_colours(shot: &Shot, all: Option<[f64; 3]>, at: &[(u32, u32, [f64; 3])]) -> f64 {
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
