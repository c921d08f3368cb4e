//! Promises that hold for every feature, whatever the text.

use scenec_text::{SourceFile, Span, apply};

use crate::{CameraChange, Document, FormatStyle};

pub(crate) fn document(text: &str) -> Document {
    Document::new(SourceFile::new("t.scene", text).unwrap())
}

/// Calls every feature at every offset.
fn check(text: &str) {
    let document = document(text);
    let length = u32::try_from(text.len()).unwrap();
    let whole = Span::new(0, length);
    let _ = crate::tokens(&document, whole);
    let _ = crate::outline(&document);
    let _ = crate::symbols(&document, "s");
    let _ = crate::folds(&document);
    let _ = crate::lenses(&document);
    for edits in [
        crate::fix_all(&document),
        crate::format(&document, FormatStyle { align: true }).unwrap_or_default(),
        crate::format_lines(&document, 0, u32::MAX, FormatStyle { align: true }),
        crate::camera_edits(&document, &CAMERA),
    ] {
        check_edits(text, &edits);
    }
    for offset in 0..length + 2 {
        let _ = crate::tokens(&document, Span::at(offset));
        let _ = crate::highlights(&document, offset);
        let _ = crate::definition(&document, offset);
        let _ = crate::references(&document, offset, true);
        let _ = crate::selections(&document, offset);
        let solid = crate::object_at(&document, offset);
        let _ = solid.and_then(|solid| crate::statement_of(&document, solid));
        check_edits(text, &crate::rename(&document, offset, "other").unwrap_or_default());
        for action in crate::actions(&document, Span::at(offset)) {
            check_edits(text, &action.edits);
        }
        let line = document.source().line_of(offset);
        check_edits(text, &crate::format_line(&document, line, FormatStyle::default()));
    }
}

const CAMERA: CameraChange = CameraChange {
    eye: [1.0, 2.5, -3.0],
    lookat: [0.0; 3],
    up: Some([0.0, 1.0, 0.0]),
    fov: Some(1.25),
};

/// Edits lie in the text, in its order, and don't overlap.
fn check_edits(text: &str, edits: &[scenec_text::Edit]) {
    let mut at = 0;
    for edit in edits {
        assert!(
            edit.span.start >= at && edit.span.start <= edit.span.end,
            "{edits:?} in {text:?}"
        );
        assert!(text.get(edit.span.range()).is_some(), "{edits:?} in {text:?}");
        at = edit.span.end;
    }
    apply(text, edits);
}

#[test]
fn no_place_of_any_text_is_too_strange() {
    for text in [
        "",
        "\u{FEFF}",
        "\u{FEFF}a := 1\r\n!s := sphere\r\n!s += 1 2 3  \r\n\r\n\r\n!t := s | s / c \r\n!t *= 1 1 a\r\n!t <=\r\n!t += 1 1 1\r\n",
        "!é := sph𝄞 | ??\n!s := shpere / c\n?m := 1 2\n*l := 1 2 3 4 5 6\n!s ?= m\n!s <=\n!s <=",
        "width := pi\nwidht := -width\n/ scenec: allow W099\n/\n/\n!a := b - c\n#",
    ] {
        check(text);
    }
}
