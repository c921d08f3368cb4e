//! Reports about characters that are no token.

use scenec_text::{Code, Diagnostic, SourceFile, Span};

use crate::token::{Token, Word};

/// How many runs of bad characters one line may report.
const MOST_PER_LINE: usize = 3;

/// Reports the runs of bad characters on a line, the first few of them. Bytes that were no UTF-8 are passed over: the
/// file's reader has reported them.
pub(crate) fn report(source: &SourceFile, words: &[Word], diagnostics: &mut Vec<Diagnostic>) {
    let runs: Vec<Span> = words
        .iter()
        .filter(|word| word.token == Token::Bad)
        .filter_map(|word| without_holes(source, word.span))
        .collect();
    for (index, run) in runs.iter().take(MOST_PER_LINE).enumerate() {
        let mut finding = describe(source.text(), *run);
        if index + 1 == MOST_PER_LINE && runs.len() > MOST_PER_LINE {
            let more = format!("there are {} more such places on this line", runs.len() - MOST_PER_LINE);
            finding.help = Some(match finding.help {
                Some(help) => format!("{help}; {more}"),
                None => more,
            });
        }
        diagnostics.push(finding);
    }
}

/// The part of a run from its first character that is no hole to its last such one.
fn without_holes(source: &SourceFile, run: Span) -> Option<Span> {
    if source.holes().is_empty() {
        return Some(run);
    }
    let seen = |at: &u32| !source.is_hole(*at);
    let start = (run.start..run.end).find(seen)?;
    let end = (run.start..run.end).rfind(seen)? + 1;
    Some(Span::new(start, end))
}

fn describe(text: &str, run: Span) -> Diagnostic {
    let words = run.of(text);
    let first = words.chars().next().unwrap_or('\u{FFFD}');
    let several = words.chars().nth(1).is_some();
    let message = if several {
        format!("unexpected characters, beginning with {}", name(first))
    } else {
        format!("unexpected character {}", name(first))
    };
    let finding = Diagnostic::new(Code::UnexpectedCharacter, message, run, "means nothing here");
    match advice(first) {
        Some(help) => finding.help(help),
        None => finding,
    }
}

/// A character for a message: itself if it can be seen, its number if not.
fn name(character: char) -> String {
    let number = format!("U+{:04X}", character as u32);
    if character.is_ascii_graphic() {
        format!("`{character}`")
    } else if character.is_ascii() || character.escape_debug().count() > 1 || character.is_whitespace() {
        number
    } else {
        format!("`{character}` ({number})")
    }
}

fn advice(first: char) -> Option<&'static str> {
    Some(match first {
        '=' | ':' => {
            "`:=` defines, `?=` gives a material, `*=` scales, `+=` moves and `<=` submits; each is written without a space inside"
        }
        '#' => "a rotation is written `#x=`, `#y=` or `#z=` without a space inside; a comment begins with `/`",
        '<' | '>' => "a submission is written `!x <=`",
        ',' | ';' | '(' | ')' | '[' | ']' | '{' | '}' => {
            "white space alone separates values, and the end of the line ends a statement"
        }
        '^' | '%' | '~' | '\\' => "objects combine with `|`, `&` and `-`; there is no arithmetic",
        '"' | '\'' | '`' | '“' | '”' | '‘' | '’' => "names stand without quotes",
        '\u{2212}' | '\u{2010}'..='\u{2015}' | '\u{FF0D}' => "the minus sign is the plain hyphen `-`",
        '\r' => {
            "a carriage return counts as the end of a line only before a line feed: save the file with LF or CRLF line ends"
        }
        '\u{FEFF}' => "a byte-order mark may stand only at the start of the file",
        '\0' => "the file may be UTF-16 or binary: save it as UTF-8 text",
        '\u{200B}'..='\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2060}'..='\u{2069}' => {
            "it can't be seen: delete it, or retype the line"
        }
        _ if first.is_alphanumeric() => "a name begins with a letter or `_`, and digits are 0 to 9",
        _ => return None,
    })
}
