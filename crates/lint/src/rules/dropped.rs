//! Work that does nothing.

pub(super) mod effectless_transform;
pub(super) mod idle_transform;
pub(super) mod material_replaced;
pub(super) mod unused_material;
pub(super) mod unused_object;
