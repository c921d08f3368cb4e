//! Texts about things, as Markdown where the client shows it.

use tower_lsp::lsp_types::{Documentation, MarkupContent, MarkupKind};

/// A text for a client that shows Markdown or doesn't.
pub(crate) fn markup(markdown: &str, shown: bool) -> MarkupContent {
    if shown {
        return MarkupContent {
            kind: MarkupKind::Markdown,
            value: markdown.to_owned(),
        };
    }
    MarkupContent {
        kind: MarkupKind::PlainText,
        value: plain(markdown),
    }
}

/// Documentation of a part of something; `None` if there is nothing to say.
pub(crate) fn documentation(markdown: &str, shown: bool) -> Option<Documentation> {
    (!markdown.is_empty()).then(|| Documentation::MarkupContent(markup(markdown, shown)))
}

/// The words without the signs; the language itself has no use for either of them.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```"));
    let lines: Vec<String> = lines.map(|line| line.replace("**", "").replace('`', "")).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::markup;

    #[test]
    fn plain_text_has_no_signs() {
        let markdown = "**`a`** is\n\n```scene\n!a *= 1 2 3\n```";
        assert_eq!(markup(markdown, true).value, markdown);
        assert_eq!(markup(markdown, false).value, "a is\n\n!a *= 1 2 3");
    }
}
