//! The camera's frame: how a pixel becomes a direction.

use crate::{DVec3, Settings};

/// An orthonormal frame at the eye with the picture plane at distance 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Camera {
    /// Where it stands, world units.
    pub eye: DVec3,
    /// Unit view direction, f.
    pub forward: DVec3,
    /// From the picture's centre to its right edge: r tan(fov/2).
    pub right: DVec3,
    /// From the picture's centre to its upper edge: u tan(fov/2) H/W.
    pub up: DVec3,
}

/// Whether a camera frame exists and took the up direction as it was given.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum View {
    /// It did.
    Clear(Camera),
    /// The view direction lies along the up direction; the least aligned axis served as up.
    AlongUp(Camera),
    /// The eye stands where it looks: there is no direction.
    NoDirection,
    /// The up direction is zero.
    NoUp,
}

/// The camera of these settings.
///
/// The view direction counts as along up where |up x f| <= 1e-12 |up|: below that, what is left of the cross product is
/// mostly the rounding of its own terms (about 2^-52 each) and the frame would turn with the last bits of the input.
#[must_use]
pub fn view(settings: &Settings) -> View {
    // Differences are scaled before they are squared, so that a far eye does not overflow.
    let Some(forward) = unit(settings.lookat - settings.eyepos) else {
        return View::NoDirection;
    };
    let Some(up) = unit(settings.up) else {
        return View::NoUp;
    };
    let side = forward.cross(up);
    if side.length() > 1e-12 {
        return View::Clear(frame(settings, forward, side));
    }
    let size = forward.abs();
    let axis = if size.x <= size.y && size.x <= size.z {
        DVec3::X
    } else if size.y <= size.z {
        DVec3::Y
    } else {
        DVec3::Z
    };
    View::AlongUp(frame(settings, forward, forward.cross(axis)))
}

fn frame(settings: &Settings, forward: DVec3, side: DVec3) -> Camera {
    let right = side.normalize();
    let half = (settings.fov / 2.0).tan();
    let aspect = f64::from(settings.height) / f64::from(settings.width.max(1));
    Camera {
        eye: settings.eyepos,
        forward,
        right: right * half,
        up: right.cross(forward) * (half * aspect),
    }
}

fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    (largest > 0.0 && largest.is_finite()).then(|| (v / largest).normalize())
}

#[cfg(test)]
mod tests {
    use super::{View, view};
    use crate::{DVec3, Settings};

    fn settings(eye: DVec3, lookat: DVec3, up: DVec3) -> Settings {
        let mut settings = Settings::gather(|_| None);
        settings.width = 200;
        settings.height = 100;
        (settings.eyepos, settings.lookat, settings.up) = (eye, lookat, up);
        settings
    }

    #[test]
    fn the_frame_is_right_handed_and_as_wide_as_the_field_of_view() {
        let View::Clear(camera) = view(&settings(DVec3::Z * 5.0, DVec3::ZERO, DVec3::Y)) else {
            panic!("a plain view");
        };
        assert!((camera.forward + DVec3::Z).length() < 1e-15);
        assert!((camera.right - DVec3::X).length() < 1e-15);
        assert!((camera.up - DVec3::Y * 0.5).length() < 1e-15);
    }

    #[test]
    fn what_gives_no_frame_is_told_apart() {
        assert_eq!(view(&settings(DVec3::X, DVec3::X, DVec3::Y)), View::NoDirection);
        assert_eq!(view(&settings(DVec3::X, DVec3::ZERO, DVec3::ZERO)), View::NoUp);
        assert!(matches!(
            view(&settings(DVec3::Y, DVec3::ZERO, DVec3::Y * 1e-200)),
            View::AlongUp(_)
        ));
        assert!(matches!(
            view(&settings(DVec3::X * 1e300, DVec3::ZERO, DVec3::Y * 1e300)),
            View::Clear(_)
        ));
    }
}
