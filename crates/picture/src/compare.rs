//! How far two pictures are apart, in figures.

use std::fmt;

use crate::Picture;

/// The distance of two pictures. Pixels with a number that is not finite, in either, are counted and left out of the
/// other figures.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Figures {
    /// Root of the mean square of the components' differences.
    pub rmse: f64,
    /// The largest difference of any component.
    pub max_abs: f64,
    /// 99 in 100 pixels are off by no more than this, in their worst component.
    pub p99_abs: f64,
    /// The share of pixels, 0 to 1, of which a component is off by more than 1/255.
    pub off_share: f64,
    /// Pixels left out because one of their numbers is not finite.
    pub non_finite: u64,
}

/// Two pictures of different sizes have no distance.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SizesDiffer {
    /// Columns and rows of the first.
    pub first: (u32, u32),
    /// Columns and rows of the second.
    pub second: (u32, u32),
}

impl fmt::Display for SizesDiffer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ((a, b), (c, d)) = (self.first, self.second);
        write!(f, "pictures of {a} x {b} and {c} x {d} pixels can't be compared")
    }
}

impl std::error::Error for SizesDiffer {}

/// The distance of two pictures.
///
/// # Errors
/// If their sizes differ.
pub fn compare(first: &Picture, second: &Picture) -> Result<Figures, SizesDiffer> {
    same_size(first, second)?;
    let wide = |pixel: &[f32; 3]| pixel.map(f64::from);
    Ok(figures(
        first.pixels().iter().map(wide).zip(second.pixels().iter().map(wide)),
    ))
}

/// Refuses pictures of different sizes.
pub(crate) fn same_size(first: &Picture, second: &Picture) -> Result<(), SizesDiffer> {
    let [first, second] = [first, second].map(|picture| (picture.width(), picture.height()));
    if first == second {
        Ok(())
    } else {
        Err(SizesDiffer { first, second })
    }
}

/// The distance of a picture from one in f64, row by row, of the same size. Pixels that only one of them has are not
/// compared.
#[must_use]
pub fn compare_exact(picture: &Picture, exact: &[[f64; 3]]) -> Figures {
    let wide = picture.pixels().iter().map(|pixel| pixel.map(f64::from));
    figures(wide.zip(exact.iter().copied()))
}

fn figures(pairs: impl Iterator<Item = ([f64; 3], [f64; 3])>) -> Figures {
    let mut worst = Vec::new();
    let mut squares = 0.0;
    let mut non_finite = 0;
    for (first, second) in pairs {
        if !first.iter().chain(&second).all(|value| value.is_finite()) {
            non_finite += 1;
            continue;
        }
        let differences = [0, 1, 2].map(|index| (first[index] - second[index]).abs());
        squares += differences
            .iter()
            .map(|difference| difference * difference)
            .sum::<f64>();
        worst.push(differences.into_iter().fold(0.0, f64::max));
    }
    let count = worst.len();
    if count == 0 {
        return Figures {
            non_finite,
            ..Figures::default()
        };
    }
    let off = worst.iter().filter(|&&difference| difference > 1.0 / 255.0).count();
    // The nearest rank: the smallest one that at least 99 in 100 don't exceed.
    let rank = (count - count / 100).saturating_sub(1);
    let (_, p99, beyond) = worst.select_nth_unstable_by(rank, f64::total_cmp);
    let p99 = *p99;
    Figures {
        rmse: (squares / (3 * count) as f64).sqrt(),
        max_abs: beyond.iter().copied().fold(p99, f64::max),
        p99_abs: p99,
        off_share: off as f64 / count as f64,
        non_finite,
    }
}

#[cfg(test)]
mod tests {
    use super::{Figures, compare, compare_exact};
    use crate::Picture;

    /// Black against a picture with these pixels changed, of 20 x 10.
    fn check(changes: &[(usize, [f32; 3])], expect: Figures) {
        let black = Picture::black(20, 10).unwrap();
        let mut other = black.clone();
        for &(index, pixel) in changes {
            other.pixels_mut()[index] = pixel;
        }
        let figures = compare(&black, &other).unwrap();
        assert_eq!(figures, compare(&other, &black).unwrap());
        assert_eq!(figures, compare_exact(&other, &[[0.0; 3]; 200]));
        assert!((figures.rmse - expect.rmse).abs() < 1e-12, "{figures:?}");
        let rest = Figures {
            rmse: expect.rmse,
            ..figures
        };
        assert_eq!(rest, expect);
    }

    #[test]
    fn the_figures_of_a_few_changed_pixels() {
        check(&[], Figures::default());
        let one = Figures {
            rmse: (0.25_f64 / 600.0).sqrt(),
            max_abs: 0.5,
            p99_abs: 0.0,
            off_share: 1.0 / 200.0,
            non_finite: 0,
        };
        check(&[(7, [0.0, -0.5, 0.0])], one);
        let three = Figures {
            rmse: (3.0 * 0.25_f64 / 600.0).sqrt(),
            p99_abs: 0.5,
            off_share: 3.0 / 200.0,
            ..one
        };
        check(
            &[(0, [0.5, 0.0, 0.0]), (1, [0.5, 0.0, 0.0]), (199, [0.0, 0.0, 0.5])],
            three,
        );
        let lost = Figures {
            non_finite: 2,
            ..Figures::default()
        };
        check(&[(0, [f32::NAN, 0.0, 0.0]), (1, [0.0, f32::INFINITY, 0.0])], lost);
    }

    #[test]
    fn sizes_must_agree() {
        let error = compare(&Picture::black(2, 1).unwrap(), &Picture::black(1, 2).unwrap()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "pictures of 2 x 1 and 1 x 2 pixels can't be compared"
        );
    }
}
