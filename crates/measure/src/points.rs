//! The sample points of renders to a tolerance: Sobol's sequence in two dimensions, its digits scrambled.
//!
//! The first n of them count straight edges as well as those that other renders take, and hardly any direction worse than
//! others: a scramble leaves nothing for an edge to be in step with (Owen 1995).

/// Which scramble: any two numbers.
pub(crate) type Scramble = [u32; 2];

/// The one that is taken: of many that were tried, the one with the narrowest gaps between the first points.
pub(crate) const SCRAMBLE: Scramble = [0x674c_2410, 0x1ccc_24c0];

/// So many points, measured from the centre of a pixel of side 1.
pub(crate) fn scrambled_points(count: u32, scramble: Scramble) -> Vec<[f64; 2]> {
    let place = |bits: u32, scramble: u32| (f64::from(scrambled(bits, scramble)) + 0.5) / 32.0_f64.exp2() - 0.5;
    (0..count)
        .map(|k| [place(k.reverse_bits(), scramble[0]), place(second(k), scramble[1])])
        .collect()
}

/// The second coordinate of Sobol's points in units of 2^-32; the first is the number's digits in reverse.
fn second(number: u32) -> u32 {
    let (mut bits, mut direction, mut left) = (0, 1 << 31, number);
    while left != 0 {
        if left & 1 == 1 {
            bits ^= direction;
        }
        direction ^= direction >> 1;
        left >>= 1;
    }
    bits
}

/// Each digit is turned over or not, as the digits above it say: by a hash that spreads from low bits to high ones only
/// (Laine and Karras 2011), between two reversals.
fn scrambled(bits: u32, scramble: u32) -> u32 {
    let mut hash = bits.reverse_bits().wrapping_add(scramble);
    for factor in [0x6c50_b47c_u32, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        hash ^= hash.wrapping_mul(factor);
    }
    hash.reverse_bits()
}

#[cfg(test)]
mod tests {
    use super::{SCRAMBLE, Scramble, scrambled_points};

    /// Of so many points, a power of two, one lies in each box of all grids of as many boxes.
    fn check(scramble: Scramble, power: u32) {
        let points = scrambled_points(1 << power, scramble);
        for across in 0..=power {
            let boxes = [across, power - across].map(|power| f64::from(power).exp2());
            let place = |point: &[f64; 2]| [0, 1].map(|axis: usize| ((point[axis] + 0.5) * boxes[axis]) as u32);
            let mut places: Vec<_> = points.iter().map(place).collect();
            places.sort_unstable();
            places.dedup();
            assert_eq!(places.len(), points.len(), "{scramble:?}, {across} of {power}");
        }
    }

    #[test]
    fn the_points_are_a_net_whatever_the_scramble() {
        for scramble in [SCRAMBLE, [0, 0], [1, u32::MAX]] {
            for power in 0..=10 {
                check(scramble, power);
            }
        }
    }

    #[test]
    fn more_points_begin_with_the_fewer() {
        assert_eq!(scrambled_points(100, SCRAMBLE)[..64], scrambled_points(64, SCRAMBLE));
    }
}
