//! How statements are written.

use crate::page::Page;

pub(super) const PAGES: &[Page] = &[
    page! {
        /// A line that fits no statement: a word stands where another kind of word is expected.
        ///
        /// The report names what would fit and the form of the statement that the line comes nearest to. The rest of the
        /// file is checked as if the line had been right.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += one two | three
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1 2 3
        /// !ball <=
        /// ```
        UnexpectedToken
    },
    page! {
        /// A statement that ends before all its values are given.
        ///
        /// A scale and a translation take three values, a rotation one, a light six and a material ten. The report names
        /// those that are missing.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball *= 2
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball *= 2 2 2
        /// !ball <=
        /// ```
        TooFewValues
    },
    page! {
        /// A statement with words left over after its last value.
        ///
        /// Each statement stands on a line of its own, and what is no part of it belongs behind a `/`.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 0 1 0 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 0 1 0
        /// !ball <=
        /// ```
        TooManyValues
    },
    page! {
        /// A base object other than the two that exist: `sphere`, the unit ball at the origin, and `hp`, the half-space
        /// below the plane y = 0.
        ///
        /// Other shapes are made by combining these. To copy an object, combine it with itself: `!copy := ball | ball`.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := shpere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball <=
        /// ```
        UnknownBase
    },
    page! {
        /// An assignment to `pi`, which is a constant.
        ///
        /// ## Example
        ///
        /// ```scene
        /// pi := 3.14
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// turn := 3.14
        /// !ball := sphere
        /// !ball *= 1 2 1
        /// !ball #z= turn
        /// !ball <=
        /// ```
        AssignedConstant
    },
];
