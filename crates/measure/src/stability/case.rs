//! A case as its file says it.

use std::fmt;

use serde::Deserialize;

use super::template::{Repeat, fill, words};
use super::tree::Tree;

/// One awkward scene, or a family of them, and what it is judged by.
#[derive(Clone, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// The name of its file, without the extension.
    #[serde(skip)]
    pub name: String,
    /// What is awkward, in one phrase.
    pub title: String,
    /// Why, and where the thresholds come from.
    pub why: String,
    /// The statements that follow those of the stage; words in braces are filled in by the runs.
    scene: String,
    /// What the picture is held to.
    pub oracle: Oracle,
    /// The largest error allowed in single precision, in the units of the oracle.
    single: f64,
    /// The same in double precision.
    double: f64,
    /// Statements that are written many times over, by the word that stands for them.
    #[serde(default)]
    repeat: Vec<Repeat>,
    /// A solid that is drawn by lot, by the word that stands for it; each run then has many scenes.
    tree: Option<Tree>,
    /// The members of the family; one without changes if there is none.
    #[serde(default)]
    run: Vec<Run>,
}

/// What a picture is held to, and with that the unit of its error.
#[derive(Clone, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "lowercase", tag = "by")]
pub enum Oracle {
    /// The independent tracer. Error: the largest difference of a colour's component on calm pixels, or 1 where
    /// another object shows.
    Reference,
    /// Another scene that must look the same. Error: the largest difference of a colour's component.
    Same {
        /// Its statements, after those of the stage.
        scene: String,
        /// Whether only calm pixels count, those whose neighbourhood took the same ways.
        #[serde(default)]
        calm: bool,
        /// Whether it must look the same in a mirror, left and right exchanged.
        #[serde(default)]
        mirrored: bool,
    },
    /// Nothing but sky. Error: the share of pixels that see an object.
    Sky,
    /// Finite numbers, the same ones each time. Error: the share of pixels with others.
    Finite,
    /// Errors in the text. Error: 0 if there is one with this code, 1 otherwise.
    Refused {
        /// The code.
        code: String,
    },
    /// Known colours. Error: the largest difference of a colour's component.
    Colours {
        /// Of every pixel.
        all: Option<Sum>,
        /// Of some: column, row and colour.
        #[serde(default)]
        at: Vec<(u32, u32, [f64; 3])>,
    },
    /// The outline of a ball. Error: how far the worst wrong pixel lies from the outline, in units in the last place of
    /// a direction (2^-24 or 2^-53).
    Ball {
        /// Its centre, world units; in words, so that a run can fill them in.
        centre: [String; 3],
        /// Its radius.
        radius: String,
    },
    /// The horizon of a plane that the eye stands before. Error: as for a ball.
    Plane {
        /// Its outward normal.
        normal: [f64; 3],
    },
    /// The independent tracer, where the scene is chaotic. Error: the root mean square difference from it, divided by
    /// that of its own picture from a camera turned by 4 units in the last place of a direction.
    Jitter,
    /// The independent tracer, by what shows and not by colours. Error: how many pixels show an object that it shows neither
    /// there nor with its camera turned by 16 units in the last place of a direction.
    Leaves,
}

/// A colour that is the same in all components, or not; a run may fill it in.
#[derive(Clone, PartialEq, Debug, Deserialize)]
#[serde(untagged)]
pub enum Sum {
    /// A word that a run fills in with a number for all components.
    Word(String),
    /// Red, green and blue.
    Colour([f64; 3]),
}

/// A member of a family.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// What stands in its row of the table.
    #[serde(default)]
    pub name: String,
    /// What the words in braces become.
    #[serde(default)]
    with: std::collections::BTreeMap<String, String>,
    /// How much a relative change of the input is magnified, where that is known.
    pub condition: Option<f64>,
    /// In place of the family's.
    single: Option<f64>,
    /// In place of the family's.
    double: Option<f64>,
    /// In place of the family's.
    oracle: Option<Oracle>,
    /// Why single precision is not held to anything here, if it is not.
    pub beyond_single: Option<String>,
    /// On which device, or in which manner on the one that there is, it is run besides.
    pub(super) device: Option<OnDevice>,
}

/// How an OpenCL device is used besides as a render uses it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum OnDevice {
    /// With programs that keep the numbers below the smallest normal one.
    Denormals,
    /// In work-groups of so many items each way.
    Groups(usize),
    /// Every graphics processor that there is.
    Graphics,
}

/// A member of a family, filled in.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Filled {
    /// The whole scene.
    pub(super) scene: String,
    /// What it is held to, with another scene whole as well.
    pub(super) oracle: Oracle,
    pub(super) single: f64,
    pub(super) double: f64,
    pub(super) device: Option<OnDevice>,
}

/// A case that can't be read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CaseError {
    /// The case.
    pub name: String,
    /// What is wrong with its file.
    pub message: String,
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name, self.message)
    }
}

impl std::error::Error for CaseError {}

/// What every scene of the suite begins with; a later statement of the same name takes the place of one here.
const STAGE: &str = "width := 48\nheight := 36\nraydepth := 4\nfov := .8\neyepos_x := 0\neyepos_y := 0\neyepos_z := 5\n\
    lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := .3\nambient_g := .5\nambient_b := .9\n\
    ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n?red := 1 0 0 0 0 1 1 1 0 0\n\
    ?blue := 1 0 0 0 0 1 1 0 0 1\n?white := 0 1 0 0 0 1 1 1 1 1\n?mirror := .1 .1 0 .8 0 1 1 .9 .9 .9\n\
    ?glass := 0 .1 0 .1 .9 1.5 1 .9 1 .9\n";

impl Case {
    /// Reads a case.
    ///
    /// # Errors
    /// A sentence about what its file says that no case does.
    pub fn read(name: &str, text: &str) -> Result<Self, CaseError> {
        let wrong = |message: String| CaseError {
            name: name.to_owned(),
            message,
        };
        let mut case: Self = toml::from_str(text).map_err(|error| wrong(error.to_string()))?;
        name.clone_into(&mut case.name);
        if case.run.is_empty() {
            case.run.push(Run::default());
        }
        Ok(case)
    }

    /// Its members; at least one.
    #[must_use]
    pub fn runs(&self) -> &[Run] {
        &self.run
    }

    /// How many scenes each member has: 1, or as many as are drawn by lot for a quick look, or all of them.
    pub(super) fn scenes(&self, all: bool) -> u32 {
        self.tree.as_ref().map_or(1, |tree| tree.scenes(all))
    }

    /// One scene of a member, with every word filled in.
    pub(super) fn filled(&self, run: &Run, scene: u32) -> Filled {
        let tree = self.tree.as_ref();
        let tree = tree.map(|tree| (&tree.word, tree.text(scene, |text| words(text, &run.with))));
        let whole = |scene: &str| {
            let filled = fill(scene, &run.with, &self.repeat);
            let filled = match &tree {
                Some((word, text)) => filled.replace(&format!("{{{word}}}"), text),
                None => filled,
            };
            format!("{STAGE}{filled}")
        };
        let word = |word: &String| fill(word, &run.with, &self.repeat);
        let oracle = match run.oracle.as_ref().unwrap_or(&self.oracle).clone() {
            Oracle::Same { scene, calm, mirrored } => Oracle::Same {
                scene: whole(&scene),
                calm,
                mirrored,
            },
            Oracle::Ball { centre, radius } => Oracle::Ball {
                centre: centre.each_ref().map(word),
                radius: word(&radius),
            },
            Oracle::Refused { code } => Oracle::Refused { code: word(&code) },
            Oracle::Colours {
                all: Some(Sum::Word(all)),
                at,
            } => Oracle::Colours {
                all: Some(Sum::Word(word(&all))),
                at,
            },
            other => other,
        };
        Filled {
            scene: whole(&self.scene),
            oracle,
            single: run.single.unwrap_or(self.single),
            double: run.double.unwrap_or(self.double),
            device: run.device,
        }
    }
}
