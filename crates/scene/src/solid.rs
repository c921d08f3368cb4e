//! The tree of solids, flat in an arena.

use scenec_text::Span;

use crate::StepId;

macro_rules! id {
    ($(#[$doc:meta])+ $name:ident) => {
        $(#[$doc])+
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);

        impl $name {
            /// The number as an index.
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id! {
    /// Number of a solid in its scene.
    SolidId
}
id! {
    /// Number of a material in its scene.
    MaterialId
}

impl MaterialId {
    /// The default material.
    pub const DEFAULT: Self = Self(0);
}

/// A node: what it is and the statement that made it.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// What it is.
    pub kind: SolidKind,
    /// The statement that made it: the base object's or the combination's.
    pub span: Span,
}

/// What a node of the tree is. Operands may be shared: binding is by value, and a value never changes.
#[derive(Clone, Copy, Debug)]
pub enum SolidKind {
    /// A transformed base object.
    Leaf(Leaf),
    /// Two solids under an operator.
    Combine {
        /// Which one.
        op: Op,
        /// The operand written first: its material shows where surfaces coincide.
        left: SolidId,
        /// The operand written second.
        right: SolidId,
    },
    /// A solid whose leaves all have this material, whatever they or paints further in say.
    Paint {
        /// The solid.
        inside: SolidId,
        /// Its material.
        material: MaterialId,
    },
}

/// A base object, transformed.
#[derive(Clone, Copy, Debug)]
pub struct Leaf {
    /// The base object.
    pub base: Base,
    /// The last of its transforms, which tells what all of them come to; none where it stands as it was made.
    pub steps: Option<StepId>,
    /// What it is made of.
    pub material: MaterialId,
}

/// A base object.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Base {
    /// The points at most 1 from the origin.
    Sphere,
    /// The points with y at most 0; the outward normal of its surface is +y.
    HalfSpace,
}

impl Base {
    /// Every base object with its word in the language.
    pub const ALL: &[(Self, &'static str)] = &[(Self::Sphere, "sphere"), (Self::HalfSpace, "hp")];
}

/// How two solids combine.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    /// In either.
    Union,
    /// In both.
    Intersection,
    /// In the left and not in the right.
    Subtraction,
}

#[cfg(test)]
mod tests {
    use super::Solid;

    #[test]
    fn a_solid_is_small() {
        assert!(size_of::<Solid>() <= 24);
    }
}
