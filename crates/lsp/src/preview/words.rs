//! What the server and the process that draws say to each other. Plain data: no text of a scene, no pixels.

use serde::{Deserialize, Serialize};

/// A camera that takes the place of the file's.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct CameraWish {
    /// Where it stands, world units.
    pub eye: [f64; 3],
    /// Where it looks, world units.
    pub lookat: [f64; 3],
    /// Which way is up; the file's if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<[f64; 3]>,
    /// Horizontal field of view, radians; the file's if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fov: Option<f64>,
}

/// The camera of a picture.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct CameraUsed {
    /// Where it stands, world units.
    pub eye: [f64; 3],
    /// Where it looks, world units.
    pub lookat: [f64; 3],
    /// Which way is up.
    pub up: [f64; 3],
    /// Horizontal field of view, radians.
    pub fov: f64,
}

/// How far a picture is refined.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Quality {
    /// Every pixel, one sample each.
    Draft,
    /// Every pixel with the file's samples.
    Full,
}

/// How a scene is looked at.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Look {
    /// What the scene is called; speeds are remembered by it.
    pub name: String,
    /// The most columns and rows; the file's own if absent.
    pub size: Option<(u32, u32)>,
    /// The camera; the file's if absent.
    pub camera: Option<CameraWish>,
    /// Whether every base object shows, whatever the operators.
    pub ignore_operators: bool,
}

/// What is to be found out about a scene, whose text is the payload.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Task {
    /// Draw it, coarse at first.
    Draw {
        /// How far.
        quality: Quality,
        /// `auto`, `cpu`, or a request that the device crate understands.
        device: String,
    },
    /// Tell which solid a place in the picture shows.
    Pick {
        /// 0 at the left edge to 1 at the right one.
        x: f64,
        /// 0 at the upper edge to 1 at the lower one.
        y: f64,
    },
    /// Draw a line around what shows of a solid.
    Outline {
        /// Its number in the scene.
        solid: u32,
    },
}

/// From the server to the process that draws.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Order {
    /// Work.
    Job {
        /// Its number, which every answer repeats.
        job: u64,
        /// How the scene is looked at.
        look: Look,
        /// What is wanted.
        task: Task,
    },
    /// A job is wanted no more.
    Cancel {
        /// Its number.
        job: u64,
    },
    /// A question for a sign of life.
    Ping,
}

/// From the process that draws to the server.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Answer {
    /// The first word.
    Hello {
        /// Which words it speaks.
        protocol: u32,
    },
    /// A sign of life.
    Pong {
        /// Changes whenever something moves.
        beat: u64,
    },
    /// About a job.
    Job {
        /// Its number.
        job: u64,
        /// What about it.
        news: News,
    },
}

/// About a job. All but `Pass` end it.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum News {
    /// A picture, a PNG file in the payload.
    Pass(Pass),
    /// The last picture has been sent.
    Drawn {
        /// What it was drawn with.
        camera: CameraUsed,
        /// Why another device than the wanted one drew it, if so.
        remark: Option<String>,
    },
    /// The solid at the place; `None` for the sky.
    Picked {
        /// Its number in the scene.
        solid: Option<u32>,
    },
    /// A see-through PNG file in the payload, or nothing if nothing of the solid shows.
    Outlined {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// Given up, as was asked.
    Cancelled,
    /// It can't be done.
    Failed {
        /// Why, for people.
        message: String,
    },
}

/// One of the pictures of a job.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Pass {
    /// Counted from 0.
    pub pass: u32,
    /// Whether no finer one follows.
    pub last: bool,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What computed it, for people.
    pub device: String,
    /// From the beginning of the job until it was there.
    pub milliseconds: f64,
}

impl News {
    /// Whether nothing more will be said about the job.
    #[must_use]
    pub const fn ends(&self) -> bool {
        !matches!(self, Self::Pass(_))
    }
}
