//! Objects, their transforms, and what does not exist.

use crate::page::Page;

pub(super) const PAGES: &[Page] = &[
    page! {
        /// A scale, rotation or translation of a combination.
        ///
        /// Base objects are transformed first and combined afterwards; a combination stays where its parts are. Transform
        /// the parts, on lines before the combination.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ground := hp
        /// !both := ball | ground
        /// !both += 0 1 0
        /// !both <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 0 1 0
        /// !ground := hp
        /// !ground += 0 1 0
        /// !both := ball | ground
        /// !both <=
        /// ```
        TransformedCombination
    },
    page! {
        /// A scale with a 0 among its three factors, or scales that multiply to 0: nothing would be left of the object.
        ///
        /// A factor of 1 leaves a direction as it is; a negative one mirrors it.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !disc := sphere
        /// !disc *= 1 0 1
        /// !disc <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !disc := sphere
        /// !disc *= 1 0.01 1
        /// !disc <=
        /// ```
        ZeroScale
    },
    page! {
        /// A material whose `shiny`, the exponent of the highlight, is negative.
        ///
        /// The larger the exponent, the smaller and sharper the highlight; 0 spreads it over the whole lit side.
        ///
        /// ## Example
        ///
        /// ```scene
        /// ?dull := 0.1 0.7 0 0 0 1 -2 1 0 0
        /// !ball := sphere
        /// !ball ?= dull
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// ?dull := 0.1 0.7 0 0 0 1 2 1 0 0
        /// !ball := sphere
        /// !ball ?= dull
        /// !ball <=
        /// ```
        NegativeShininess
    },
    page! {
        /// The file never submits an object, so there is nothing to render.
        ///
        /// The help names the object that is most likely meant: the last one that no combination took.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball <=
        /// ```
        MissingSubmission
    },
    page! {
        /// Transforms of one object that together leave the range of a double.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball *= 1e200 1e200 1e200
        /// !ball *= 1e200 1e200 1e200
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
        TransformOverflow
    },
    page! {
        /// A statement names an object that does not exist on that line, so the statement is ignored.
        ///
        /// A statement knows only what stands before it. Objects, materials, lights and variables have names of their
        /// own: `!x` and `?x` never meet. The help tells which line makes the object later, what stood in the way of the
        /// line that would have made it, which other kind of thing has that name, or which object has a name much like it.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !bal += 0 1 0
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
        UnknownObject
    },
    page! {
        /// A statement names a material that does not exist on that line, so the statement is ignored.
        ///
        /// The object keeps the material that it has; one that never got any has the default material. Only the name of a
        /// material fits here: a variable, an object or a light of the same name is something else.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball ?= red
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// ?red := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
        /// !ball := sphere
        /// !ball ?= red
        /// !ball <=
        /// ```
        UnknownMaterial
    },
    page! {
        /// A statement names a variable that does not exist on that line, so the whole statement is ignored.
        ///
        /// Where a value is expected, only a number, `pi` or the name of a variable fits. Objects can't be assigned to
        /// variables.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 0 height_of_ball 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// height_of_ball := 1
        /// !ball := sphere
        /// !ball += 0 height_of_ball 0
        /// !ball <=
        /// ```
        UnknownVariable
    },
    page! {
        /// A material refracts with an index that is 0 or negative.
        ///
        /// An index of 0 reflects all light on entry; a negative one bends it to the other side of the normal. Both are
        /// rendered as they are written, but no glass does either.
        ///
        /// ## Example
        ///
        /// ```scene
        /// raydepth := 4
        /// ?glass := 0 0 0 0.1 0.9 0 1 1 1 1
        /// !ball := sphere
        /// !ball ?= glass
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// raydepth := 4
        /// ?glass := 0 0 0 0.1 0.9 1.5 1 1 1 1
        /// !ball := sphere
        /// !ball ?= glass
        /// !ball <=
        /// ```
        StrangeIndex
    },
];
