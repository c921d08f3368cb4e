//! The settings and the camera.

use crate::page::Page;

pub(super) const PAGES: &[Page] = &[
    page! {
        /// A setting holds a value that it can't have.
        ///
        /// Sizes, depths and sample counts are whole numbers within limits; the field of view lies between 0 and pi. The
        /// report names the range. What counts is the last value that the file gives.
        ///
        /// ## Example
        ///
        /// ```scene
        /// width := 600.5
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// width := 600
        /// !ball := sphere
        /// !ball <=
        /// ```
        SettingOutOfRange
    },
    page! {
        /// Settings that every file has to give are missing: the size of the picture, the camera, the ambient light and
        /// `raydepth`.
        ///
        /// All of them are listed in one report, with lines to copy. The field of view, the up direction and the number
        /// of samples may be left out.
        ///
        /// ## Example
        ///
        /// ```scene whole
        /// width := 600
        /// height := 400
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene whole
        /// width := 600
        /// height := 400
        /// lookat_x := 0
        /// lookat_y := 0
        /// lookat_z := 0
        /// eyepos_x := 0
        /// eyepos_y := 1
        /// eyepos_z := 5
        /// ambient_r := 0.2
        /// ambient_g := 0.3
        /// ambient_b := 0.5
        /// ambient_int_r := 1
        /// ambient_int_g := 1
        /// ambient_int_b := 1
        /// raydepth := 0
        /// !ball := sphere
        /// !ball <=
        /// ```
        MissingSettings
    },
    page! {
        /// `raydepth` and `max_reflections` are two names of one setting, and the file sets both.
        ///
        /// ## Example
        ///
        /// ```scene
        /// raydepth := 4
        /// max_reflections := 6
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// raydepth := 0
        /// !ball := sphere
        /// !ball <=
        /// ```
        SettingTwice
    },
    page! {
        /// The camera stands at the very point that it looks at, so it has no direction.
        ///
        /// ## Example
        ///
        /// ```scene
        /// eyepos_x := 0
        /// eyepos_y := 1
        /// eyepos_z := 5
        /// lookat_x := 0
        /// lookat_y := 1
        /// lookat_z := 5
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// eyepos_x := 0
        /// eyepos_y := 1
        /// eyepos_z := 5
        /// lookat_x := 0
        /// lookat_y := 0
        /// lookat_z := 0
        /// !ball := sphere
        /// !ball <=
        /// ```
        EyeAtLookat
    },
    page! {
        /// `up_x`, `up_y` and `up_z` are all 0, so no direction is up.
        ///
        /// ## Example
        ///
        /// ```scene
        /// up_x := 0
        /// up_y := 0
        /// up_z := 0
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// up_x := 0
        /// up_y := 1
        /// up_z := 0
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// Or leave the three out: y points up then.
        ZeroUp
    },
    page! {
        /// The camera looks along its own up direction, which then says nothing about how the picture is turned.
        ///
        /// The axis of the world that lies least along the view serves as up instead. Set an up direction across the view
        /// to choose for yourself.
        ///
        /// ## Example
        ///
        /// ```scene
        /// eyepos_x := 0
        /// eyepos_y := 5
        /// eyepos_z := 0
        /// lookat_x := 0
        /// lookat_y := 0
        /// lookat_z := 0
        /// !ball := sphere
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// eyepos_x := 0
        /// eyepos_y := 5
        /// eyepos_z := 0
        /// lookat_x := 0
        /// lookat_y := 0
        /// lookat_z := 0
        /// up_x := 0
        /// up_y := 0
        /// up_z := -1
        /// !ball := sphere
        /// !ball <=
        /// ```
        UpAlongView
    },
];
