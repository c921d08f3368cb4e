//! Promises of all features, held to files of the project and to texts made up at random.

mod made_up;

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use scenec_syntax::Content;
use scenec_text::{Code, Edit, SourceFile, Span, apply};

use crate::{ActionKind, CameraChange, Document, FormatStyle};
use made_up::{any_text, statements};

const STYLES: [FormatStyle; 2] = [FormatStyle { align: false }, FormatStyle { align: true }];

const CAMERA: CameraChange = CameraChange {
    eye: [1.0, 2.5, -3.0],
    lookat: [0.0, 1e-7, 0.1],
    up: Some([0.0, -1.0, 0.25]),
    fov: Some(1.25),
};

pub(crate) fn document(text: &str) -> Document {
    Document::new(SourceFile::new("t.scene", text).unwrap())
}

/// Every scene and every fixture of the project that is UTF-8.
fn files() -> Vec<String> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = ["scenes", "tests/fixtures"].map(|folder| fs::read_dir(top.join(folder)).unwrap());
    let paths = folders.into_iter().flatten().map(|entry| entry.unwrap().path());
    let scenes = paths.filter(|path| path.extension().is_some_and(|extension| extension == "scene"));
    scenes.filter_map(|path| fs::read_to_string(path).ok()).collect()
}

/// Holds one text to every promise.
fn check(text: &str) {
    let document = document(text);
    check_everywhere(&document);
    check_formatting(&document);
    check_actions(&document);
    check_renaming(&document);
    check_camera(&document);
}

/// Every feature answers at every offset.
fn check_everywhere(document: &Document) {
    let length = u32::try_from(document.text().len()).unwrap();
    let all = crate::tokens(document, Span::new(0, length));
    assert!(all.windows(2).all(|pair| pair[0].span.end <= pair[1].span.start));
    let _ = (crate::outline(document), crate::symbols(document, "s"));
    let _ = (crate::folds(document), crate::lenses(document));
    for offset in 0..length + 2 {
        let at = Span::at(offset);
        let line = document.source().line_of(offset);
        let here = crate::tokens(document, at);
        assert!(here.iter().all(|token| all.contains(token)));
        assert_eq!(
            crate::highlights(document, offset).len(),
            crate::references(document, offset, true).len()
        );
        let _ = crate::definition(document, offset);
        let solid = crate::object_at(document, offset);
        assert!(solid.is_none_or(|solid| crate::statement_of(document, solid).is_some()));
        let around = crate::selections(document, offset);
        assert!(
            around
                .windows(2)
                .all(|pair| pair[0].to(pair[1]) == pair[1] && pair[0] != pair[1])
        );
        let _ = edited(document, &crate::format_line(document, line, STYLES[1]));
    }
}

/// The document after edits, which must lie in it, in order and apart.
fn edited(document: &Document, edits: &[Edit]) -> Document {
    let text = document.text();
    let mut at = 0;
    for edit in edits {
        assert!(
            at <= edit.span.start && edit.span.start <= edit.span.end,
            "{edits:?} in {text:?}"
        );
        assert!(text.get(edit.span.range()).is_some(), "{edits:?} in {text:?}");
        at = edit.span.end;
    }
    self::document(&apply(text, edits))
}

/// The edits give what the formatter writes, and a line that has its form is left alone.
fn check_formatting(document: &Document) {
    for style in STYLES {
        let Ok(written) = scenec_syntax::format(document.source(), document.lines(), style) else {
            let after = edited(document, &crate::format_lines(document, 0, u32::MAX, style));
            assert_eq!(
                crate::format_lines(&after, 0, u32::MAX, style),
                [],
                "{:?}",
                document.text()
            );
            continue;
        };
        let after = edited(document, &crate::format(document, style).unwrap());
        assert_eq!(after.text(), written);
        assert_eq!(crate::format(&after, style), Ok(Vec::new()));
        assert_eq!(crate::format_lines(&after, 0, u32::MAX, style), []);
        let lines = edited(document, &crate::format_lines(document, 0, u32::MAX, style));
        // A line with nothing but white space is no line that could have a form.
        let white = |one: char| one.is_whitespace() || one == '\u{FEFF}';
        let words = |text: &str| text.trim_matches(white).to_owned();
        assert_eq!(words(lines.text()), words(&written));
    }
}

/// How often a finding was made, by its code and message.
fn count(document: &Document, code: Code, message: &str) -> usize {
    let all = document.diagnostics().iter();
    all.filter(|finding| finding.code == code && finding.message == message)
        .count()
}

/// Everything that is offered about a finding makes it go away; all safe repairs leave none.
fn check_actions(document: &Document) {
    let length = u32::try_from(document.text().len()).unwrap();
    for action in crate::actions(document, Span::new(0, length)) {
        let after = edited(document, &action.edits);
        if action.kind == ActionKind::FixAll {
            continue;
        }
        for index in &action.fixes {
            let finding = &document.diagnostics()[*index];
            // The repairs of the rules are held to their own promises.
            if finding.fix.as_ref().is_some_and(|fix| fix.title == action.title) {
                continue;
            }
            let (before, after_) = (
                count(document, finding.code, &finding.message),
                count(&after, finding.code, &finding.message),
            );
            let texts = (document.text(), after.text());
            assert!(after_ < before, "{action:?}\n{}\n->\n{}", texts.0, texts.1);
        }
    }
    let mended = edited(document, &crate::fix_all(document));
    assert_eq!(
        crate::fix_all(&mended),
        [],
        "{}\n->\n{}",
        document.text(),
        mended.text()
    );
}

/// The same findings at the same places, whatever the names in them.
fn check_renaming(document: &Document) {
    let shape = |document: &Document| -> Vec<(Code, u32)> {
        let line = |span: Span| document.source().line_of(span.start);
        let all = document.diagnostics().iter();
        all.map(|finding| (finding.code, line(finding.span()))).collect()
    };
    for symbol in document.interpretation().symbols.symbols() {
        let offset = symbol.name.start;
        let Ok(edits) = crate::rename(document, offset, "zz_quite_another") else {
            continue;
        };
        let after = edited(document, &edits);
        // Which names a line that fits no statement means is a guess.
        if document
            .lines()
            .iter()
            .any(|line| matches!(line.content, Content::Broken(_)))
        {
            continue;
        }
        assert_eq!(
            shape(&after),
            shape(document),
            "{}\n->\n{}",
            document.text(),
            after.text()
        );
        assert_eq!(after.scene().is_some(), document.scene().is_some());
    }
}

/// The file has the camera that was written, and what else it has is the same.
fn check_camera(document: &Document) {
    let after = edited(document, &crate::camera_edits(document, &CAMERA));
    assert_eq!(
        crate::camera_edits(&after, &CAMERA),
        [],
        "{}\n->\n{}",
        document.text(),
        after.text()
    );
    if let (Some(before), Some(after)) = (document.scene(), after.scene()) {
        let mut expect = before.settings.clone();
        (expect.eyepos, expect.lookat) = (CAMERA.eye.into(), CAMERA.lookat.into());
        (expect.up, expect.fov) = (CAMERA.up.unwrap().into(), CAMERA.fov.unwrap());
        assert_eq!(after.settings, expect);
        let lights = |scene: &scenec_scene::Scene| -> Vec<_> {
            let lights = scene.lights.iter();
            lights.map(|light| (light.position, light.colour)).collect()
        };
        assert_eq!(lights(before), lights(after));
        assert_eq!(before.steps.len(), after.steps.len());
    }
}

#[test]
fn files_of_the_project_keep_the_promises() {
    let files = files();
    assert!(files.len() > 50);
    for text in &files {
        // At every offset only where that is quick.
        if text.len() < 1000 {
            check(text);
        } else {
            let document = document(text);
            check_formatting(&document);
            check_camera(&document);
        }
    }
}

#[test]
fn strange_texts_keep_the_promises() {
    for text in [
        "",
        "\u{FEFF}",
        "\t",
        "\u{FEFF}a := 1\r\n!s := sphere\r\n!s += 1 2 3  \r\n\r\n\r\n!t := s | s / c \r\n!t *= 1 1 a\r\n!t <=\r\n!t += 1 1 1\r\n",
        "!é := sph𝄞 | ??\n!s := shpere / c\n?m := 1 2\n*l := 1 2 3 4 5 6\n!s ?= m\n!s <=\n!s <=",
        "width := pi\nwidht := -width\n/ scenec: allow W099\n/\n/\n!a := b - c\n#",
        "a:=1\rb:=2\r",
    ] {
        check(text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_text_keeps_the_promises(text in any_text()) {
        check(&text);
    }

    #[test]
    fn any_statements_keep_the_promises(text in statements()) {
        check(&text);
    }
}
