//! Work that the interpreter sees come to nothing.

use crate::page::Page;

pub(super) const PAGES: &[Page] = &[
    page! {
        /// A statement about objects comes after the submission and is ignored.
        ///
        /// The first `<=` of an existing object decides what is rendered, as that object stands on that line. Variables,
        /// materials and lights still count after it. Move the submission to the end of the file.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball <=
        /// !ball += 0 1 0
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 0 1 0
        /// !ball <=
        /// ```
        AfterSubmission
    },
    page! {
        /// A material is defined again after an object took it, and no object takes the new one.
        ///
        /// An object takes a material as it stands on that line. What the name means later does not reach the object.
        ///
        /// ## Example
        ///
        /// ```scene
        /// ?red := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
        /// !ball := sphere
        /// !ball ?= red
        /// ?red := 0.2 0.7 0 0 0 1 1 1 0 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// ?red := 0.2 0.7 0 0 0 1 1 1 0 0
        /// !ball := sphere
        /// !ball ?= red
        /// !ball <=
        /// ```
        MaterialRedefined
    },
    page! {
        /// An object is edited after a combination took it, and nothing takes it again.
        ///
        /// A combination takes its parts as they stand on that line. Later edits change the part alone, not the
        /// combination.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ground := hp
        /// !both := ball | ground
        /// !ball += 0 1 0
        /// !both <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 0 1 0
        /// !ground := hp
        /// !both := ball | ground
        /// !both <=
        /// ```
        OperandEdited
    },
    page! {
        /// A name is bound again before anything used what it was bound to.
        ///
        /// The first statement does nothing. Often the second one was meant to have another name.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball := sphere
        /// !ball += 0 2 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !second := sphere
        /// !second += 0 2 0
        /// !both := ball | second
        /// !both <=
        /// ```
        OverwrittenUnused
    },
    page! {
        /// A variable that is no setting, and that no statement reads after it is set.
        ///
        /// A misspelt setting is the usual cause; where a setting has a name much like it, the help names it.
        ///
        /// ## Example
        ///
        /// ```scene
        /// sample := 4
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// samples := 4
        /// !ball := sphere
        /// !ball <=
        /// ```
        UnusedVariable
    },
];
