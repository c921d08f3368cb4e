//! What the names of each space are bound to.

use scenec_scene::{MaterialId, SolidId};
use scenec_text::Span;

/// What a variable is bound to.
pub(crate) struct Variable {
    pub(crate) value: f64,
    /// The value as written.
    pub(crate) written: Span,
    /// The statement.
    pub(crate) line: Span,
    /// Whether anything read this value.
    pub(crate) used: bool,
    /// The last reading of this or an earlier value of the name.
    pub(crate) last_read: Option<Span>,
}

/// What an object's name is bound to.
pub(crate) struct Object {
    pub(crate) solid: SolidId,
    /// Whether a combination refers to `solid`, so that an edit must change a copy.
    pub(crate) frozen: bool,
    pub(crate) used: bool,
    /// The last combination that took it.
    pub(crate) taken: Option<Span>,
}

impl Object {
    pub(crate) const fn new(solid: SolidId) -> Self {
        Self {
            solid,
            frozen: false,
            used: false,
            taken: None,
        }
    }
}

/// What a material's name is bound to.
pub(crate) struct Paint {
    pub(crate) id: MaterialId,
    /// The statement.
    pub(crate) line: Span,
    pub(crate) used: bool,
    /// The last statement that gave this or an earlier material of the name to an object.
    pub(crate) taken: Option<Span>,
}

/// What a light's name is bound to.
pub(crate) struct Lamp {
    pub(crate) index: usize,
    /// The statement.
    pub(crate) line: Span,
}
