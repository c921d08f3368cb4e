//! What may reach a terminal: nothing that moves the cursor, hides text or reorders it.

/// The text with every control and invisible character replaced by a visible one of as many bytes, so that offsets stay
/// true. Line feeds, tabs and the carriage return of a CRLF stay.
pub(crate) fn sanitise(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let harmless = match character {
            '\n' | '\t' => true,
            '\r' => characters.peek() == Some(&'\n'),
            _ => !is_unsafe(character),
        };
        if harmless {
            clean.push(character);
        } else {
            clean.push_str(match character.len_utf8() {
                1 => "?",
                2 => "¿",
                3 => "\u{FFFD}",
                _ => "\u{10102}",
            });
        }
    }
    clean
}

/// Control characters; marks that change the direction of text; characters of no width; other ends of line.
fn is_unsafe(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{AD}' | '\u{61C}' | '\u{180E}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}'
            | '\u{2060}'..='\u{206F}' | '\u{FEFF}' | '\u{FFF9}'..='\u{FFFB}' | '\u{E0000}'..='\u{E007F}')
}

#[cfg(test)]
mod tests {
    use super::sanitise;

    fn check(text: &str, expect: &str) {
        let clean = sanitise(text);
        assert_eq!(clean, expect);
        assert_eq!(clean.len(), text.len());
    }

    #[test]
    fn nothing_reaches_a_terminal_that_moves_hides_or_reorders() {
        check("a\u{1b}[2Jb", "a?[2Jb");
        check("a\r\nb\rc\t\0", "a\r\nb?c\t?");
        check("x\u{85}\u{202E}y\u{E0041}é", "x¿\u{FFFD}y\u{10102}é");
    }
}
