//! The slow oracle: a scene traced in f64 by brute force, straight from its tree.
//!
//! It exists to catch the fast tracers, so it shares no intersection, tree, camera or shading code with them and must
//! not know plans or devices. Where a choice was between fast and plain, it is plain: every ray meets every solid, and
//! every node of the tree has its list of intervals along the whole line (Roth, "Ray Casting for Modeling Solids", 1982).

mod bound;
mod camera;
mod hash;
mod list;
mod reference;
mod refine;
mod shade;
mod shape;
mod tally;
mod tree;
mod twins;

#[cfg(test)]
mod tests;

pub use reference::Reference;
