//! The settings of a document: what each is given as, and what a new scene would say.

use scenec_interpret::DefinitionId;
use scenec_scene::{SETTINGS, SettingInfo, SettingRange};

use crate::Document;
use crate::words::{angle, figure};

/// What a setting is when a scene is begun: a picture of usual size, a camera a little above the ground that looks at
/// the origin, and a pale sky. For an optional one it is the default.
pub(crate) fn usual(row: &SettingInfo) -> f64 {
    if let Some(default) = row.default {
        return default;
    }
    match row.name {
        "width" => 600.0,
        "height" => 400.0,
        "eyepos_y" => 1.5,
        "eyepos_z" => 5.0,
        "ambient_r" => 0.5,
        "ambient_g" => 0.7,
        "ambient_b" | "ambient_int_r" | "ambient_int_g" | "ambient_int_b" => 1.0,
        "raydepth" => 4.0,
        _ => 0.0,
    }
}

/// A value of a setting in words: an angle as one.
pub(crate) fn spoken(row: &SettingInfo, value: f64) -> String {
    if row.range == SettingRange::Angle {
        angle(value)
    } else {
        figure(value)
    }
}

impl Document {
    /// The last statement that binds a setting, under either of its spellings.
    pub(crate) fn setting(&self, row: &SettingInfo) -> Option<DefinitionId> {
        let number = SETTINGS.iter().position(|known| known.name == row.name)?;
        let symbols = self.facts().setting(number);
        symbols.filter_map(|symbol| self.binding(symbol, u32::MAX)).max()
    }

    /// The settings that the file never gives, the required ones or the optional ones.
    pub(crate) fn missing_settings(&self, required: bool) -> Vec<&'static SettingInfo> {
        let wanted = SETTINGS.iter().filter(|row| row.default.is_none() == required);
        wanted.filter(|row| self.setting(row).is_none()).collect()
    }
}
