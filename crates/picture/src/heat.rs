//! Where two pictures differ, as a picture.

use crate::compare::same_size;
use crate::{FlipError, Picture};

/// Differences at and below this are black. They double from here on sixteen times until 1, which is white.
const LEAST: f32 = 1.0 / 65536.0;

/// What a pixel is painted that holds a number which is not finite: no mixture of the others.
const STRANGE: [f32; 3] = [0.0, 1.0, 0.4];

/// The colours of equal steps of the logarithm; 1/256, about a level of eight bits, is the middle one.
const STOPS: [[f32; 3]; 5] = [
    [0.0, 0.0, 0.0],
    [0.2, 0.1, 0.6],
    [0.9, 0.1, 0.1],
    [1.0, 0.8, 0.1],
    [1.0, 1.0, 1.0],
];

/// A picture of the largest difference of each pixel's components: black up to 1/65536, blue about 1/4096, red about
/// 1/256, yellow about 1/16, white from 1 on, and green where a number is not finite.
///
/// # Errors
/// If the sizes differ, or there is no memory for it.
pub fn heat(first: &Picture, second: &Picture) -> Result<Picture, FlipError> {
    same_size(first, second)?;
    let mut map = Picture::black(first.width(), first.height())?;
    let pairs = first.pixels().iter().zip(second.pixels());
    for (pixel, (first, second)) in map.pixels_mut().iter_mut().zip(pairs) {
        let worst = [0, 1, 2].map(|index| (first[index] - second[index]).abs());
        *pixel = if first.iter().chain(second).all(|value| value.is_finite()) {
            colour(worst.into_iter().fold(0.0, f32::max))
        } else {
            STRANGE
        };
    }
    Ok(map)
}

fn colour(difference: f32) -> [f32; 3] {
    let steps = (STOPS.len() - 1) as f32;
    let place = (difference / LEAST).max(1.0).log2() / (1.0 / LEAST).log2() * steps;
    let place = place.min(steps);
    let below = place.floor().min(steps - 1.0);
    let stop = |index: f32| STOPS.get(index as usize).copied().unwrap_or_default();
    let (low, high) = (stop(below), stop(below + 1.0));
    [0, 1, 2].map(|index| low[index] + (high[index] - low[index]) * (place - below))
}

#[cfg(test)]
mod tests {
    use super::{LEAST, STOPS, STRANGE, heat};
    use crate::Picture;

    fn check(difference: f32, expect: [f32; 3]) {
        let mut other = Picture::black(1, 1).unwrap();
        other.pixels_mut()[0] = [0.0, -difference, difference / 2.0];
        let map = heat(&Picture::black(1, 1).unwrap(), &other).unwrap();
        let near = |(a, b): (&f32, &f32)| (a - b).abs() < 1e-6;
        let found = map.pixels()[0];
        assert!(found.iter().zip(&expect).all(near), "{difference}: {found:?}");
    }

    #[test]
    fn each_factor_of_sixteen_is_a_colour() {
        for (difference, colour) in [
            (0.0, 0),
            (LEAST, 0),
            (1.0 / 4096.0, 1),
            (1.0 / 256.0, 2),
            (1.0 / 16.0, 3),
        ] {
            check(difference, STOPS[colour]);
        }
        check(1.0, [1.0; 3]);
        check(1e30, [1.0; 3]);
        check(1.0 / 64.0, [0.95, 0.45, 0.1]);
        check(f32::INFINITY, STRANGE);
        check(f32::NAN, STRANGE);
    }

    #[test]
    fn sizes_must_agree() {
        let (wide, high) = (Picture::black(2, 1).unwrap(), Picture::black(1, 2).unwrap());
        assert!(heat(&wide, &high).is_err());
    }
}
