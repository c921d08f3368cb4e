//! Work that does nothing.

pub(super) mod idle_transform;
pub(super) mod unused_material;
