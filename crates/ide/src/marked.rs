//! Documents for tests: a text in which `$0` marks the cursor.

use scenec_text::SourceFile;

use crate::Document;

/// The document of a text without its mark, and where that stood; the start of the text if there is none.
pub(crate) fn marked(text: &str) -> (Document, u32) {
    let at = text.find("$0");
    let source = SourceFile::new("t.scene", text.replacen("$0", "", 1)).unwrap();
    (Document::new(source), u32::try_from(at.unwrap_or(0)).unwrap())
}
