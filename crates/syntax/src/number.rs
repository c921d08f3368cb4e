//! From the text of a number to its value.

use scenec_text::{Code, Diagnostic, Span};

use crate::quote;

/// Reads a number token: the nearest double, and what is wrong with it, if anything is. The value is usable unless the
/// finding is an error.
pub(crate) fn read(word: &str, span: Span) -> (f64, Option<Diagnostic>) {
    if let Some(value) = short(word) {
        return (value, None);
    }
    let Ok(value) = word.parse::<f64>() else {
        return (0.0, Some(malformed(word, span)));
    };
    if value.is_infinite() {
        let finding = Diagnostic::new(
            Code::NumberOverflow,
            format!("the number {} is too large", quote(word)),
            span,
            "larger than a double can hold",
        )
        .help("the largest number is about 1.797e308");
        return (0.0, Some(finding));
    }
    if value == 0.0 && has_digits(word) {
        let finding = Diagnostic::new(
            Code::NumberUnderflow,
            format!("the number {} is so small that it reads as 0", quote(word)),
            span,
            "reads as 0",
        )
        .help("the smallest number above 0 is about 4.9e-324");
        return (value, Some(finding));
    }
    (value, None)
}

/// The powers of ten by which the digits of a short number may be divided.
const TENS: [f64; DIGITS + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
];

/// So many digits are a whole number that a double holds.
const DIGITS: usize = 15;

/// The value of a number of few digits without an exponent, which most are; `None` for any other word. Digits and power of ten
/// are doubles without any rounding, so that their quotient, rounded once, is the nearest one (Clinger 1990).
fn short(word: &str) -> Option<f64> {
    let (mut digits, mut value, mut decimals, mut point) = (0, 0_i64, 0, false);
    for byte in word.bytes() {
        match byte {
            b'0'..=b'9' if digits < DIGITS => {
                digits += 1;
                value = value * 10 + i64::from(byte - b'0');
                decimals += usize::from(point);
            }
            b'.' if !point => point = true,
            _ => return None,
        }
    }
    let scale = TENS.get(decimals).filter(|_| digits > 0)?;
    Some(value as f64 / scale)
}

/// Whether the digits before the exponent say anything but zero.
fn has_digits(word: &str) -> bool {
    word.bytes()
        .take_while(|byte| !matches!(byte, b'e' | b'E'))
        .any(|byte| matches!(byte, b'1'..=b'9'))
}

fn malformed(word: &str, span: Span) -> Diagnostic {
    let (mantissa, exponent) = match word.find(['e', 'E']) {
        Some(at) => (word.get(..at).unwrap_or_default(), word.get(at + 1..)),
        None => (word, None),
    };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let plain = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    let (label, help) = if !plain(mantissa) {
        (
            "a number is digits with at most one point and one exponent",
            "a name begins with a letter or `_`, and white space separates values",
        )
    } else if mantissa.matches('.').count() > 1 {
        ("more than one point", "white space separates values, as in `1.2 .3`")
    } else if !mantissa.bytes().any(|byte| byte.is_ascii_digit()) {
        ("a point without digits", "write `0.5` or `.5` or `2.`")
    } else if exponent.is_some_and(|text| !digits(text.trim_start_matches(['+', '-']))) {
        (
            "the exponent is no whole number",
            "an exponent is `e` and digits, as in `6.02e23` or `1e-3`",
        )
    } else {
        ("not a number", "a number looks like `-1`, `.5`, `2.` or `6.02e23`")
    };
    Diagnostic::new(
        Code::MalformedNumber,
        format!("malformed number {}", quote(word)),
        span,
        label,
    )
    .help(help)
}

#[cfg(test)]
mod tests {
    use scenec_text::{Code, Span};

    use super::read;

    fn check(word: &str, value: f64, code: Option<Code>) {
        let (found, finding) = read(word, Span::default());
        assert_eq!((found, finding.map(|finding| finding.code)), (value, code), "{word}");
    }

    #[test]
    fn short_numbers_are_the_nearest_double_too() {
        let mut digits = 1_u64;
        for length in (1..=17).cycle().take(5000) {
            // Knuth's generator (1997).
            digits = digits
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let mut word = format!("{digits:020}");
            word.truncate(length);
            for point in 0..=length {
                let mut word = word.clone();
                word.insert(point, '.');
                check(&word, word.parse().unwrap(), None);
            }
            check(&word, word.parse().unwrap(), None);
        }
    }

    #[test]
    fn numbers_are_read_as_the_nearest_double() {
        check("2.", 2.0, None);
        check(".5", 0.5, None);
        check("1.e2", 100.0, None);
        check("6.02E+23", 6.02e23, None);
        check("0.000e-999", 0.0, None);
        check("000000000000000000000.5", 0.5, None);
        check("4.9e-324", 5e-324, None);
        check("1e-400", 0.0, Some(Code::NumberUnderflow));
        check("1e309", 0.0, Some(Code::NumberOverflow));
        for word in [
            "1.2.3", "2e", "3abc", ".", "1e5.5", "1_000", "0x10", "2e+", "1e--", ".e5", "3é",
        ] {
            check(word, 0.0, Some(Code::MalformedNumber));
        }
    }
}
