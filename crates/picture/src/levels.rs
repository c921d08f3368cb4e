//! From numbers to what a file holds: integer levels, or the bytes of the floats themselves.

use crate::{EncodeError, Picture};

/// How a component becomes an integer level. Floating-point formats hold the numbers unchanged whatever this says.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Transfer {
    /// As it is.
    #[default]
    Linear,
    /// Encoded by the curve of sRGB (IEC 61966-2-1).
    Srgb,
}

impl Transfer {
    /// Every transfer with its name.
    pub const ALL: &[(Self, &'static str)] = &[(Self::Linear, "linear"), (Self::Srgb, "srgb")];

    /// A component in 0 to 1 through the curve.
    fn apply(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Srgb if value <= 0.003_130_8 => 12.92 * value,
            Self::Srgb => 1.055 * value.powf(1.0 / 2.4) - 0.055,
        }
    }
}

/// The level nearest to a component clamped to 0..1, of 0 to `top`. What is not a number becomes 0;
/// [`Picture::non_finite`] tells of it.
pub(crate) fn level(value: f32, transfer: Transfer, top: u16) -> u16 {
    let value = transfer.apply(f64::from(value).clamp(0.0, 1.0));
    // Half more, and the cast drops the fraction; it takes what is not a number for 0. Rounding itself would be a call, which for
    // millions of components takes longer than all else.
    (value * f64::from(top) + 0.5) as u16
}

/// One byte a component.
pub(crate) fn bytes8(picture: &Picture, transfer: Transfer) -> Result<Vec<u8>, EncodeError> {
    gather(picture, |value| [level(value, transfer, 255) as u8])
}

/// Two bytes a component, in this machine's order: what the codecs take.
pub(crate) fn bytes16(picture: &Picture, transfer: Transfer) -> Result<Vec<u8>, EncodeError> {
    gather(picture, |value| level(value, transfer, u16::MAX).to_ne_bytes())
}

/// Four bytes a component, in this machine's order: what the codecs take.
pub(crate) fn bytes32(picture: &Picture) -> Result<Vec<u8>, EncodeError> {
    gather(picture, f32::to_ne_bytes)
}

/// The components of all pixels, `N` bytes each. [`crate::MAX_PIXELS`] bounds the memory; missing memory is an error.
fn gather<const N: usize>(picture: &Picture, bytes: impl Fn(f32) -> [u8; N]) -> Result<Vec<u8>, EncodeError> {
    let components = picture.pixels().as_flattened();
    let mut all = Vec::new();
    all.try_reserve_exact(components.len() * N)
        .map_err(|_| EncodeError::Memory)?;
    all.extend(components.iter().flat_map(|&value| bytes(value)));
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::{Transfer, level};

    fn check(value: f32, transfer: Transfer, top: u16, expect: u16) {
        assert_eq!(level(value, transfer, top), expect, "{value} {transfer:?} of {top}");
    }

    #[test]
    fn levels_are_clamped_and_the_nearest() {
        let linear = Transfer::Linear;
        for (value, expect) in [
            (0.0, 0),
            (-0.0, 0),
            (1.0, 255),
            (7.0, 255),
            (-1.0, 0),
            (f32::INFINITY, 255),
            (f32::NAN, 0),
            (0.4999 / 255.0, 0),
            (0.5001 / 255.0, 1),
            (254.4999 / 255.0, 254),
        ] {
            check(value, linear, 255, expect);
        }
        check(0.5, linear, 65535, 32768);
        check(1e-5, linear, 65535, 1);
    }

    #[test]
    fn between_two_levels_the_nearer_one_is_taken() {
        for top in [255, u16::MAX] {
            for below in 0..top {
                let between = ((f64::from(below) + 0.5) / f64::from(top)) as f32;
                for value in [between.next_down(), between, between.next_up()] {
                    let nearest = (f64::from(value) * f64::from(top)).round();
                    assert_eq!(
                        f64::from(level(value, Transfer::Linear, top)),
                        nearest,
                        "{value} of {top}"
                    );
                }
            }
        }
    }

    #[test]
    fn srgb_follows_the_curve_of_the_standard() {
        let srgb = Transfer::Srgb;
        for (value, expect) in [(0.0, 0), (1.0, 255), (0.5, 188), (0.214_041_14, 128), (0.002, 7)] {
            check(value, srgb, 255, expect);
        }
        check(0.5, srgb, 65535, 48192);
    }
}
