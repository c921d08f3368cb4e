//! The settings of a document: what each is given as, and what is proposed for it.

use scenec_interpret::DefinitionId;
use scenec_scene::{SETTINGS, SettingInfo, SettingRange};
use scenec_text::Code;

use crate::Document;
use crate::words::{angle, figure};

/// What stands between a setting and its value.
const ASSIGNS: &str = " := ";

/// A value of a setting in words: an angle as one.
pub(crate) fn spoken(row: &SettingInfo, value: f64) -> String {
    if row.range == SettingRange::Angle {
        angle(value)
    } else {
        figure(value)
    }
}

impl Document {
    /// The lines that would give the settings that are missing: what the finding about them proposes.
    pub(crate) fn proposed_settings(&self) -> Vec<&str> {
        let mut findings = self.diagnostics().iter();
        let help = findings.find(|found| found.code == Code::MissingSettings);
        let help = help.and_then(|found| found.help.as_deref()).unwrap_or_default();
        help.lines().filter(|line| line.contains(ASSIGNS)).collect()
    }

    /// What a setting would be given as: as proposed where it is missing, else as a new scene has it.
    pub(crate) fn proposed(&self, row: &SettingInfo) -> String {
        // Optional ones are never missed.
        let missed = row.default.is_none().then(|| self.proposed_settings());
        let mut lines = missed.into_iter().flatten();
        let value = lines.find_map(|line| line.strip_prefix(row.name)?.strip_prefix(ASSIGNS));
        value.map_or_else(|| row.usual.to_string(), str::to_owned)
    }

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
