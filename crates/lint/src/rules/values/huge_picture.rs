//! Pictures that take a great deal of memory.

use scenec_scene::setting;
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A picture of so many pixels that it takes more than 3 GiB of memory.
    ///
    /// A pixel is three 32-bit numbers, 12 bytes, so the limit is met at 268 million pixels, or 16,384 by 16,384.
    /// `scenec render` holds no more at once. The number of samples does not matter: they are added up in place.
    ///
    /// ## Example
    ///
    /// ```scene
    /// width := 60000
    /// height := 40000
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// width := 6000
    /// height := 4000
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// A part of a large picture takes the memory of that part: `scenec render --crop`.
    HugePicture, check
}

/// Three 32-bit numbers.
const BYTES_PER_PIXEL: u64 = 12;

/// 3 GiB.
const MOST_BYTES: u64 = 3 << 30;

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some(settings) = context.settings() else {
        return;
    };
    let bytes = u64::from(settings.width) * u64::from(settings.height) * BYTES_PER_PIXEL;
    let [width, height] = ["width", "height"].map(|name| setting(name).and_then(|row| context.setting(row)));
    if let (true, Some((_, width)), Some((_, height))) = (bytes > MOST_BYTES, width, height) {
        findings.push(
            Diagnostic::new(
                Code::HugePicture,
                format!(
                    "a picture of {} x {} takes {:.1} GiB of memory",
                    settings.width,
                    settings.height,
                    bytes as f64 / f64::from(1 << 30)
                ),
                width,
                "pixel columns",
            )
            .label(height, "pixel rows")
            .help("at most 3 GiB are held at once: make it smaller, or render it in parts with `--crop`"),
        );
    }
}
