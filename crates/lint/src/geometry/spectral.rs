//! The largest singular value of a matrix, never too small.

use scenec_scene::{DMat3, DVec3};

/// Turns of each pair of axes; off the diagonal they leave nothing that counts after four or five.
const SWEEPS: usize = 8;

/// An upper bound on the largest singular value, by Jacobi's method (1846) on the Gram matrix.
///
/// The turns keep the eigenvalues but for their rounding, and what is left off the diagonal is added (Gershgorin, 1931),
/// so the result is at least the true value less 2^-45 of it, however far the method came.
pub(crate) fn largest_singular(matrix: &DMat3) -> f64 {
    let axes = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    let mut gram = axes.map(|a| axes.map(|b| a.dot(b)));
    for _ in 0..SWEEPS {
        let before = gram;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            turn(&mut gram, p, q);
        }
        if gram == before {
            break;
        }
    }
    let disc = |i: usize| gram[i][i].abs() + gram[i][(i + 1) % 3].abs() + gram[i][(i + 2) % 3].abs();
    DVec3::new(disc(0), disc(1), disc(2)).max_element().sqrt()
}

/// Turns axes `p` and `q` so that the element that couples them vanishes (Rutishauser's formulas, 1966).
fn turn(gram: &mut [[f64; 3]; 3], p: usize, q: usize) {
    let coupling = gram[p][q];
    if coupling.abs() <= f64::EPSILON * 1e-3 * (gram[p][p] * gram[q][q]).abs().sqrt() {
        return;
    }
    let theta = (gram[q][q] - gram[p][p]) / (2.0 * coupling);
    let sign = if theta < 0.0 { -1.0 } else { 1.0 };
    let t = sign / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    gram[p][p] -= t * coupling;
    gram[q][q] += t * coupling;
    (gram[p][q], gram[q][p]) = (0.0, 0.0);
    let r = 3 - p - q;
    let (a, b) = (gram[r][p], gram[r][q]);
    (gram[r][p], gram[r][q]) = (c * a - s * b, s * a + c * b);
    (gram[p][r], gram[q][r]) = (gram[r][p], gram[r][q]);
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DMat3, DVec3};

    use super::largest_singular;

    fn check(matrix: DMat3, expect: f64) {
        let found = largest_singular(&matrix);
        assert!(
            (found - expect).abs() <= 1e-14 * expect,
            "{matrix}: {found}, not {expect}"
        );
    }

    #[test]
    fn singular_values_are_those_of_the_scales() {
        let turn = DMat3::from_rotation_x(0.3) * DMat3::from_rotation_y(1.1);
        let back = DMat3::from_rotation_z(-0.7) * DMat3::from_rotation_x(2.0);
        for scale in [
            DVec3::ONE,
            DVec3::new(1.0, 1.0, 1e-9),
            DVec3::new(3.0, -3.0, 1e-3),
            DVec3::new(1e-8, 2.0, 5e3),
        ] {
            check(turn * DMat3::from_diagonal(scale) * back, scale.abs().max_element());
        }
        check(DMat3::ZERO, 0.0);
    }

    #[test]
    fn a_shear_is_known_in_closed_form() {
        // The largest singular value of [1 k; 0 1] is k / 2 + sqrt(k^2 / 4 + 1).
        let shear = DMat3::from_cols(DVec3::X, DVec3::new(3.0, 1.0, 0.0), DVec3::Z);
        check(shear, 1.5 + (3.25_f64).sqrt());
    }
}
