//! From pixels to directions.

use scenec_scene::{DVec3, Settings};

use crate::shape::unit;

/// The root of g^3 = g + 1, of which the sample points' steps are made.
const PLASTIC: f64 = 1.324_717_957_244_746;

/// The eye and where its pixels look.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eye {
    /// Where it is.
    pub(crate) place: DVec3,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    width: f64,
    height: f64,
    spread: f64,
}

impl Eye {
    /// `None` if it looks nowhere or nothing is up.
    pub(crate) fn new(settings: &Settings) -> Option<Self> {
        let forward = unit(settings.lookat - settings.eyepos)?;
        let up = unit(settings.up)?;
        let mut right = forward.cross(up);
        if right.length() <= 1e-12 {
            let mut axes = [DVec3::X, DVec3::Y, DVec3::Z];
            axes.sort_by(|a, b| forward.dot(*a).abs().total_cmp(&forward.dot(*b).abs()));
            right = forward.cross(axes[0]);
        }
        let right = right.normalize();
        Some(Self {
            place: settings.eyepos,
            forward,
            right,
            up: right.cross(forward),
            width: f64::from(settings.width),
            height: f64::from(settings.height),
            spread: (settings.fov / 2.0).tan(),
        })
    }

    /// The unit direction through a point of the picture, in pixels from its upper left corner.
    pub(crate) fn towards(&self, x: f64, y: f64) -> DVec3 {
        let across = self.spread * (2.0 * x / self.width - 1.0);
        let upwards = self.spread * (self.height / self.width) * (1.0 - 2.0 * y / self.height);
        (self.forward + self.right * across + self.up * upwards).normalize()
    }
}

/// Point number `k` in a pixel's square, to the right and down from its upper left corner: Roberts's R2 sequence ("The
/// Unreasonable Effectiveness of Quasirandom Sequences", 2018), begun at the centre.
pub(crate) fn sample_point(k: u32) -> (f64, f64) {
    let k = f64::from(k);
    ((0.5 + k / PLASTIC).fract(), (0.5 + k / (PLASTIC * PLASTIC)).fract())
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DVec3, Settings};

    use super::{Eye, PLASTIC, sample_point};

    fn check(lookat: DVec3, up: DVec3, x: f64, y: f64, expect: DVec3) {
        let mut settings = Settings::gather(|_| None);
        (settings.width, settings.height) = (40, 20);
        (settings.lookat, settings.up) = (lookat, up);
        let direction = Eye::new(&settings).unwrap().towards(x, y);
        assert!((direction - expect.normalize()).length() < 1e-15, "{direction}");
    }

    #[test]
    fn pixels_look_where_the_formula_says() {
        let ahead = -DVec3::Z * 3.0;
        check(ahead, DVec3::Y, 20.0, 10.0, DVec3::new(0.0, 0.0, -1.0));
        check(ahead, DVec3::Y, 40.0, 10.0, DVec3::new(1.0, 0.0, -1.0));
        check(ahead, DVec3::Y, 0.0, 0.0, DVec3::new(-1.0, 0.5, -1.0));
        check(ahead, DVec3::X, 20.0, 0.0, DVec3::new(0.5, 0.0, -1.0));
        // Straight up, x stands in: r = f x X = -Z.
        check(DVec3::Y, DVec3::Y, 40.0, 10.0, DVec3::new(0.0, 1.0, -1.0));
    }

    #[test]
    fn nowhere_is_no_view() {
        let settings = Settings::gather(|_| None);
        assert!(Eye::new(&settings).is_none());
    }

    #[test]
    fn sample_points_begin_at_the_centre_and_fill_the_square() {
        assert_eq!(sample_point(0), (0.5, 0.5));
        assert!((PLASTIC.powi(3) - PLASTIC - 1.0).abs() < 1e-14);
        let (mut x, mut y) = (0.0, 0.0);
        for k in 0..1024 {
            let point = sample_point(k);
            assert!((0.0..1.0).contains(&point.0) && (0.0..1.0).contains(&point.1));
            (x, y) = (x + point.0 / 1024.0, y + point.1 / 1024.0);
        }
        assert!((x - 0.5).abs() < 2e-3 && (y - 0.5).abs() < 2e-3, "{x} {y}");
    }
}
