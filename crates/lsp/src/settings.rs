//! What the user of an editor may set. Everything is optional; what can't be read leaves the rest as it is.

use serde::Deserialize;
use serde_json::{Map, Value};

/// The settings in force.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Settings {
    /// What draws the preview: `auto`, `cpu`, `opencl` or `opencl:NAME`.
    pub(crate) device: String,
    /// How finely the preview is drawn at last.
    pub(crate) quality: Quality,
    /// Whether the tree of solids is evaluated.
    pub(crate) csg: Csg,
    /// Whether the formatter puts values one below the other; what the file's configuration says if unset.
    pub(crate) align: Option<bool>,
    /// Which inlay hints are shown.
    pub(crate) hints: Hints,
    /// Whether code lenses are shown.
    pub(crate) lens: bool,
    /// Whether a hover over a material shows a ball made of it.
    pub(crate) ball: bool,
}

/// How finely the preview is drawn at last.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Quality {
    /// One ray a pixel, few reflections.
    Draft,
    /// As the file says.
    #[default]
    Full,
}

/// What is made of the operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Csg {
    /// The tree is evaluated.
    #[default]
    Tree,
    /// Every base object is drawn, whatever the operators.
    Ignore,
}

/// Which inlay hints are shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Hints {
    /// The names of values.
    pub(crate) fields: bool,
    /// Angles in other words.
    pub(crate) angles: bool,
    /// Where a submitted object ends up.
    pub(crate) positions: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            device: "auto".to_owned(),
            quality: Quality::default(),
            csg: Csg::default(),
            align: None,
            hints: Hints::default(),
            lens: true,
            ball: true,
        }
    }
}

impl Default for Hints {
    fn default() -> Self {
        Self {
            fields: true,
            angles: true,
            positions: true,
        }
    }
}

impl Settings {
    /// The settings that a client sent, in a section of the program's name or bare; `None` if it sent none. A key whose
    /// value makes no sense counts as unset.
    pub(crate) fn read(value: &Value) -> Option<Self> {
        let section = value.get("scenec").unwrap_or(value).as_object()?;
        let mut read = Map::new();
        for (key, value) in section {
            let alone = Value::Object(Map::from_iter([(key.clone(), value.clone())]));
            if serde_json::from_value::<Self>(alone).is_ok() {
                read.insert(key.clone(), value.clone());
            }
        }
        serde_json::from_value(Value::Object(read)).ok()
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::{Csg, Quality, Settings};

    fn check(value: Value, expect: Option<Settings>) {
        assert_eq!(Settings::read(&value), expect, "{value}");
    }

    #[test]
    fn what_is_set_counts_and_the_rest_stays() {
        let defaults = Settings::default();
        check(json!(null), None);
        check(json!({"scenec": null}), None);
        check(json!({}), Some(defaults.clone()));
        check(json!({"scenec": {}, "other": 1}), Some(defaults.clone()));
        let set = json!({"device": "cpu", "quality": "draft", "csg": "ignore", "align": true,
            "hints": {"angles": false}, "lens": false, "ball": false, "serverPath": "x"});
        let mut expect = Settings {
            device: "cpu".to_owned(),
            quality: Quality::Draft,
            csg: Csg::Ignore,
            align: Some(true),
            lens: false,
            ball: false,
            ..defaults.clone()
        };
        expect.hints.angles = false;
        check(set.clone(), Some(expect.clone()));
        check(json!({"scenec": set}), Some(expect));
        let only_lens = Settings {
            lens: false,
            ..defaults
        };
        check(
            json!({"device": 3, "quality": "best", "align": null, "hints": "none", "lens": false}),
            Some(only_lens),
        );
    }
}
