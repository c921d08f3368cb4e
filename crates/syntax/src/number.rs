//! From the text of a number to its value.

use scenec_text::{Code, Diagnostic, Span};

use crate::quote;

/// Reads a number token: the nearest double, and what is wrong with it, if anything is. The value is usable unless the
/// finding is an error.
pub(crate) fn read(word: &str, span: Span) -> (f64, Option<Diagnostic>) {
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
    fn numbers_are_read_as_the_nearest_double() {
        check("2.", 2.0, None);
        check(".5", 0.5, None);
        check("1.e2", 100.0, None);
        check("6.02E+23", 6.02e23, None);
        check("0.000e-999", 0.0, None);
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
