//! The variables that the language reads: one table for the interpreter, the checker, the manual and the editor.

use crate::DVec3;

/// The values of all settings, in range.
#[derive(Clone, PartialEq, Debug)]
pub struct Settings {
    /// Pixel columns, 1 to 65535.
    pub width: u32,
    /// Pixel rows, 1 to 65535.
    pub height: u32,
    /// Where the camera looks, world units.
    pub lookat: DVec3,
    /// Where the camera stands, world units.
    pub eyepos: DVec3,
    /// Colour of the ambient light and of the sky overhead.
    pub ambient: DVec3,
    /// Intensity of the ambient light and the sky, by component.
    pub ambient_int: DVec3,
    /// The most reflections and refractions that one path may have, 0 to 1024.
    pub raydepth: u32,
    /// Horizontal field of view, radians, more than 0 and less than pi.
    pub fov: f64,
    /// Which way is up; not zero.
    pub up: DVec3,
    /// Sample points per pixel, 1 to 4096.
    pub samples: u32,
}

/// What a setting may hold.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SettingRange {
    /// Any finite number.
    Any,
    /// A whole number between two bounds, both included.
    Whole(u32, u32),
    /// A number strictly between 0 and pi.
    Angle,
}

/// A row of the table of settings.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SettingInfo {
    /// The variable's name.
    pub name: &'static str,
    /// Another spelling of the same setting.
    pub alias: Option<&'static str>,
    /// The value of a file that does not say; `None` for a required one.
    pub default: Option<f64>,
    /// What a new scene begins with: a picture of usual size, a camera a little above the ground that looks at the origin,
    /// a pale sky. For an optional setting it is the default.
    pub usual: f64,
    /// What it may hold.
    pub range: SettingRange,
    /// What it means, in one phrase.
    pub meaning: &'static str,
}

const fn required(name: &'static str, usual: f64, range: SettingRange, meaning: &'static str) -> SettingInfo {
    SettingInfo {
        name,
        alias: None,
        default: None,
        usual,
        range,
        meaning,
    }
}

const fn optional(name: &'static str, default: f64, range: SettingRange, meaning: &'static str) -> SettingInfo {
    SettingInfo {
        default: Some(default),
        ..required(name, default, range, meaning)
    }
}

use SettingRange::{Angle, Any, Whole};

/// Every setting, in the order in which missing ones are listed.
pub const SETTINGS: &[SettingInfo] = &[
    required("width", 600.0, Whole(1, 65535), "pixel columns"),
    required("height", 400.0, Whole(1, 65535), "pixel rows"),
    required("lookat_x", 0.0, Any, "x of the point that the camera looks at"),
    required("lookat_y", 0.0, Any, "y of the point that the camera looks at"),
    required("lookat_z", 0.0, Any, "z of the point that the camera looks at"),
    required("eyepos_x", 0.0, Any, "x of the camera's place"),
    required("eyepos_y", 1.0, Any, "y of the camera's place"),
    required("eyepos_z", 5.0, Any, "z of the camera's place"),
    required("ambient_r", 0.2, Any, "red of the ambient light and the sky overhead"),
    required("ambient_g", 0.3, Any, "green of the ambient light and the sky overhead"),
    required("ambient_b", 0.5, Any, "blue of the ambient light and the sky overhead"),
    required("ambient_int_r", 1.0, Any, "intensity of the ambient red"),
    required("ambient_int_g", 1.0, Any, "intensity of the ambient green"),
    required("ambient_int_b", 1.0, Any, "intensity of the ambient blue"),
    SettingInfo {
        alias: Some("max_reflections"),
        ..required(
            "raydepth",
            4.0,
            Whole(0, 1024),
            "the most reflections and refractions of one path",
        )
    },
    optional(
        "fov",
        std::f64::consts::FRAC_PI_2,
        Angle,
        "horizontal field of view in radians",
    ),
    optional("up_x", 0.0, Any, "x of the up direction"),
    optional("up_y", 1.0, Any, "y of the up direction"),
    optional("up_z", 0.0, Any, "z of the up direction"),
    optional("samples", 1.0, Whole(1, 4096), "sample points per pixel"),
];

/// The row of a setting, by its name or its other spelling.
#[must_use]
pub fn setting(name: &str) -> Option<&'static SettingInfo> {
    SETTINGS.iter().find(|row| row.name == name || row.alias == Some(name))
}

impl SettingRange {
    /// Whether a finite value is allowed.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Any => value.is_finite(),
            Self::Whole(low, high) => value.fract() == 0.0 && (f64::from(low)..=f64::from(high)).contains(&value),
            Self::Angle => value > 0.0 && value < std::f64::consts::PI,
        }
    }

    /// The range in words, as in "must be ...".
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Self::Any => "a finite number".to_owned(),
            Self::Whole(low, high) => format!("a whole number from {low} to {high}"),
            Self::Angle => "more than 0 and less than pi".to_owned(),
        }
    }
}

impl Settings {
    /// Gathers the settings from a reader of values by name. A missing value takes its default, or 0 where there is
    /// none; whole numbers are clamped into their range. The caller has checked both before.
    #[must_use]
    pub fn gather(value: impl Fn(&str) -> Option<f64>) -> Self {
        let read = |name: &str| {
            let row = setting(name);
            value(name).or_else(|| row.and_then(|row| row.default)).unwrap_or(0.0)
        };
        let whole = |name: &str| match setting(name).map(|row| row.range) {
            // Inside 0 to 65535 after the clamp, so the cast is exact for whole numbers.
            Some(Whole(low, high)) => read(name).clamp(f64::from(low), f64::from(high)) as u32,
            _ => 0,
        };
        let vector = |x: &str, y: &str, z: &str| DVec3::new(read(x), read(y), read(z));
        Self {
            width: whole("width"),
            height: whole("height"),
            lookat: vector("lookat_x", "lookat_y", "lookat_z"),
            eyepos: vector("eyepos_x", "eyepos_y", "eyepos_z"),
            ambient: vector("ambient_r", "ambient_g", "ambient_b"),
            ambient_int: vector("ambient_int_r", "ambient_int_g", "ambient_int_b"),
            raydepth: whole("raydepth"),
            fov: read("fov"),
            up: vector("up_x", "up_y", "up_z"),
            samples: whole("samples"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{SETTINGS, setting};

    fn check(name: &str, value: f64, expect: bool) {
        assert_eq!(
            setting(name).map(|row| row.range.holds(value)),
            Some(expect),
            "{name} = {value}"
        );
    }

    #[test]
    fn ranges_hold_their_bounds() {
        check("width", 1.0, true);
        check("width", 65535.0, true);
        check("width", 65536.0, false);
        check("width", 0.0, false);
        check("width", 1.5, false);
        check("max_reflections", 1024.0, true);
        check("fov", 0.0, false);
        check("fov", std::f64::consts::PI, false);
        check("fov", 1e-9, true);
        check("eyepos_x", -1e300, true);
    }

    #[test]
    fn what_a_new_scene_begins_with_is_allowed() {
        for row in SETTINGS {
            assert!(row.range.holds(row.usual), "{}", row.name);
            assert!(row.default.is_none_or(|default| default == row.usual), "{}", row.name);
        }
    }
}
