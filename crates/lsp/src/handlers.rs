//! One file a feature: from the protocol's parameters to the feature and back to the protocol's answer.

pub(crate) mod diagnostics;
pub(crate) mod greeting;
pub(crate) mod settings;
pub(crate) mod synchronise;
