//! One file a feature: from the protocol's parameters to the feature and back to the protocol's answer.

pub(crate) mod actions;
pub(crate) mod colour;
pub(crate) mod completion;
pub(crate) mod diagnostics;
pub(crate) mod format;
pub(crate) mod greeting;
pub(crate) mod hover;
pub(crate) mod inlay;
pub(crate) mod lens;
pub(crate) mod names;
pub(crate) mod outline;
#[cfg(debug_assertions)]
pub(crate) mod panic;
pub(crate) mod scene_outline;
pub(crate) mod scene_pick;
pub(crate) mod scene_plan;
pub(crate) mod scene_render;
pub(crate) mod scene_write_camera;
pub(crate) mod settings;
pub(crate) mod shape;
pub(crate) mod signature;
pub(crate) mod synchronise;
pub(crate) mod tokens;
