//! How far two frames of one scene are apart, away from silhouettes.

use scenec_measure::stability::apart;
use scenec_picture::Frame;

/// Which pixels count: those whose whole neighbourhood of 3 by 3 took the same ways through the scene, so that nothing
/// changes within a pixel of them.
#[derive(Clone, Debug)]
pub struct Mask {
    calm: Vec<bool>,
    width: usize,
}

/// What two frames differ by on the pixels of a mask.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Disagreement {
    /// Pixels that count.
    pub compared: usize,
    /// Pixels whose leaf differs.
    pub leaves: usize,
    /// The largest difference of a colour's component.
    pub colour: f64,
    /// Where that is: column and row.
    pub at: (usize, usize),
}

impl Mask {
    /// The calm pixels of a reference frame.
    ///
    /// # Panics
    /// If the frame has no layer of paths.
    #[must_use]
    pub fn of(reference: &Frame) -> Self {
        let Some(calm) = reference.calm() else {
            panic!("the reference was not asked for paths");
        };
        let width = reference.picture.width() as usize;
        Self { calm, width }
    }

    /// The share of all pixels that count.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.calm.iter().filter(|calm| **calm).count() as f64 / self.calm.len() as f64
    }
}

/// Compares a frame with the reference's on the mask's pixels; in f64 where both have it.
///
/// # Panics
/// If a frame has no layer of leaves.
#[must_use]
pub fn compare(reference: &Frame, frame: &Frame, mask: &Mask) -> Disagreement {
    let (Some(expect), Some(ids)) = (&reference.ids, &frame.ids) else {
        panic!("both frames must be asked for leaves");
    };
    let mut found = Disagreement {
        compared: 0,
        leaves: 0,
        colour: 0.0,
        at: (0, 0),
    };
    for i in (0..ids.len()).filter(|i| mask.calm[*i]) {
        found.compared += 1;
        found.leaves += usize::from(ids[i] != expect[i]);
        let apart = match (&reference.exact, &frame.exact) {
            (Some(a), Some(b)) => apart(a[i], b[i]),
            _ => apart(
                reference.picture.pixels()[i].map(f64::from),
                frame.picture.pixels()[i].map(f64::from),
            ),
        };
        if apart > found.colour {
            (found.colour, found.at) = (apart, (i % mask.width, i / mask.width));
        }
    }
    found
}
