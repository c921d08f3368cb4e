//! Words of the command line into values, with a sentence where they don't fit.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use scenec_picture::Window;
use scenec_scene::{SettingRange, setting};

/// One of a table's names.
pub(crate) fn named<T: Copy + Send + Sync + 'static>(
    table: &'static [(T, &'static str)],
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(table.iter().map(|(_, name)| *name)).try_map(move |word| {
        let row = table.iter().find(|(_, name)| *name == word);
        row.map(|(value, _)| *value)
            .ok_or_else(|| format!("`{word}` is unknown"))
    })
}

/// Columns and rows, as in `600x400`.
pub(crate) fn size(text: &str) -> Result<(u32, u32), String> {
    let (width, height) = text
        .split_once(['x', 'X'])
        .ok_or("a size is written as 600x400, columns before rows")?;
    Ok((whole("width", width)?, whole("height", height)?))
}

pub(crate) fn samples(text: &str) -> Result<u32, String> {
    whole("samples", text)
}

pub(crate) fn raydepth(text: &str) -> Result<u32, String> {
    whole("raydepth", text)
}

/// A whole number that the setting of this name may hold.
fn whole(name: &str, text: &str) -> Result<u32, String> {
    let range = setting(name).map_or(SettingRange::Any, |row| row.range);
    match number(text) {
        // In the range of a setting that counts, hence exact.
        Some(value) if range.holds(value) => Ok(value as u32),
        _ => Err(format!("`{name}` must be {}", range.words())),
    }
}

/// Column and row of the corner, columns and rows, as in `100,50,320,200`.
pub(crate) fn window(text: &str) -> Result<Window, String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|word| word.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some([_, _, 0, _] | [_, _, _, 0]) => Err("a crop has at least one pixel".to_owned()),
        Some(&[x, y, width, height]) => Ok(Window { x, y, width, height }),
        _ => Err("a crop is written as X,Y,W,H: the column and row of its corner, its columns and rows".to_owned()),
    }
}

/// A cut-off, as a number or a fraction.
pub(crate) fn cutoff(text: &str) -> Result<f64, String> {
    fraction(text).ok_or_else(|| "a cut-off is a number of at least 0, or a fraction such as 1/4096".to_owned())
}

/// A difference that is still allowed, as a number or a fraction.
pub(crate) fn limit(text: &str) -> Result<f64, String> {
    fraction(text).ok_or_else(|| "a limit is a number of at least 0, or a fraction such as 1/255".to_owned())
}

/// How far a component may be off, as a number, a fraction or in hundredths.
pub(crate) fn tolerance(text: &str) -> Result<f64, String> {
    let value = match text.trim().strip_suffix('%') {
        Some(hundredths) => fraction(hundredths).map(|value| value / 100.0),
        None => fraction(text),
    };
    let value = value.filter(|value| *value > 0.0);
    value.ok_or_else(|| "a tolerance is a number above 0, a fraction such as 1/255, or as in 0.4%".to_owned())
}

/// A number of at least 0, written as one or as a fraction: `0.001`, `1/4096`.
fn fraction(text: &str) -> Option<f64> {
    let value = match text.split_once('/') {
        Some((above, below)) => number(above).zip(number(below)).map(|(above, below)| above / below),
        None => number(text),
    };
    value.filter(|value| value.is_finite() && *value >= 0.0)
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use std::fmt::Debug;

    use super::{cutoff, samples, size, tolerance, window};

    /// `expect` is the value as it is debugged, or a part of the error.
    fn check<T: Debug>(parse: fn(&str) -> Result<T, String>, text: &str, expect: &str) {
        let got = match parse(text) {
            Ok(value) => format!("{value:?}"),
            Err(message) => message,
        };
        assert!(got.contains(expect), "{text}: {got}");
    }

    #[test]
    fn sizes_are_in_the_range_of_the_settings() {
        check(size, "600x400", "(600, 400)");
        check(size, "600.0X1", "(600, 1)");
        check(size, "0x400", "`width` must be a whole number from 1 to 65535");
        check(size, "1x65536", "`height` must be a whole number from 1 to 65535");
        check(size, "1x1x1", "`height` must be");
        check(size, "600", "written as 600x400");
        check(samples, "4096", "4096");
        check(samples, "4097", "`samples` must be a whole number from 1 to 4096");
        check(samples, "nan", "`samples` must be");
        check(samples, "1.5", "`samples` must be");
    }

    #[test]
    fn crops_have_four_numbers_and_a_pixel() {
        check(window, "1, 2,3,4", "x: 1, y: 2, width: 3, height: 4");
        check(window, "1,2,0,4", "at least one pixel");
        check(window, "1,2,3", "X,Y,W,H");
        check(window, "-1,2,3,4", "X,Y,W,H");
        check(window, "1,2,3,4294967296", "X,Y,W,H");
    }

    #[test]
    fn tolerances_are_above_nothing() {
        check(tolerance, "1/256", "0.00390625");
        check(tolerance, "0.5%", "0.005");
        check(tolerance, " 2 ", "2.0");
        for refused in ["0", "0%", "-1", "1/0", "%", "inf", "nan", ""] {
            check(tolerance, refused, "a tolerance is");
        }
    }

    #[test]
    fn cutoffs_are_numbers_or_fractions() {
        check(cutoff, "1/4096", "0.000244140625");
        check(cutoff, "0", "0.0");
        check(cutoff, "1e-3", "0.001");
        for refused in ["-1", "1/0", "0/0", "inf", "1/2/3", ""] {
            check(cutoff, refused, "a cut-off is");
        }
    }
}
