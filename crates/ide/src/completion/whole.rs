//! Whole lines: statements, names to go on with, and settings that are still missing.

use scenec_scene::SettingInfo;
use scenec_syntax::Space;

use super::form::Writer;
use super::{Completion, CompletionKind, Cursor};
use crate::settings::spoken;

impl Cursor<'_> {
    /// What a line may begin with.
    pub(super) fn line_start(&self) -> Vec<Completion> {
        let missing = self.document.missing_settings(true);
        if self.more {
            let settings = missing.iter().map(|row| Completion {
                detail: row.meaning.to_owned(),
                ..self.item(CompletionKind::Setting, row.name)
            });
            return settings.chain(self.names(Space::Variable)).collect();
        }
        let mut list = Vec::new();
        if missing.len() > 1 {
            list.push(self.all(&missing));
        }
        list.extend(missing.iter().map(|row| self.setting(row)));
        list.extend(self.statements(None));
        list.extend(
            self.document
                .missing_settings(false)
                .into_iter()
                .map(|row| self.setting(row)),
        );
        list.extend(self.names(Space::Variable));
        list
    }

    /// What may stand behind a sigil at the start of a line: a name, or a whole statement with the sigil.
    pub(super) fn subjects(&self, space: Space) -> Vec<Completion> {
        let mut list = self.names(space);
        if !self.more
            && let Some(sigil) = self.before.first()
        {
            let whole = self.statements(Some(space)).into_iter();
            list.extend(whole.map(|item| Completion {
                replace: sigil.span.to(self.replace),
                ..item
            }));
        }
        list
    }

    fn setting(&self, row: &SettingInfo) -> Completion {
        let mut writer = Writer::new();
        self.assign(&mut writer, row);
        let default = row
            .default
            .map(|value| format!("; {} if it is not given", spoken(row, value)));
        Completion {
            detail: row.meaning.to_owned(),
            documentation: format!("Holds {}{}.", row.range.words(), default.unwrap_or_default()),
            insert: writer.text,
            snippet: true,
            ..self.item(CompletionKind::Setting, row.name)
        }
    }

    /// One item for everything that is missing.
    fn all(&self, missing: &[&SettingInfo]) -> Completion {
        let mut writer = Writer::new();
        for row in missing {
            if !writer.text.is_empty() {
                writer.text.push('\n');
            }
            self.assign(&mut writer, row);
        }
        let names: Vec<_> = missing.iter().map(|row| format!("`{}`", row.name)).collect();
        Completion {
            detail: format!("the {} settings that this file does not give", missing.len()),
            documentation: names.join(", "),
            insert: writer.text,
            snippet: true,
            ..self.item(CompletionKind::Setting, "all missing settings")
        }
    }

    fn assign(&self, writer: &mut Writer, row: &SettingInfo) {
        writer.plain(row.name);
        writer.plain(" := ");
        writer.stop(&self.document.proposed(row));
    }
}
