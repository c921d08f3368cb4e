//! Every feature on every kind of text, at every place: broken scenes, and scenes broken at random.

#![allow(missing_docs, clippy::unwrap_used, reason = "a test may, in its helpers too")]

use std::path::Path;

use scenec_ide::{Document, colour_edits, colours, completions, hover, inlay_hints, signature};
use scenec_text::{Edit, SourceFile, Span};

/// A small generator of numbers, the same ones every time (Marsaglia 2003).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound.max(1) as u64) as usize
    }
}

/// What a slip of the finger may put into a text.
const SLIPS: &[&str] = &[
    "!", "?", "*", ":=", "?=", "#x=", "#", "<=", "|", "&", "-", "+", " ", "\n", "\r\n", "/", "pi", "sphere", "1",
    "1e9", ".5", "é", "𝄞", "\u{feff}", "\r", "\0", "name", "<b>", "](x)", "`", "$0", "}", "1e-320", "0",
];

fn scenes() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut paths: Vec<_> = std::fs::read_dir(root)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "scene"));
    paths.sort();
    assert!(paths.len() > 5);
    paths
        .iter()
        .map(|path| std::fs::read_to_string(path).unwrap())
        .collect()
}

/// A piece of a scene of at most some forty lines, with slips in it.
fn broken(scene: &str, random: &mut Random) -> String {
    let lines: Vec<&str> = scene.split_inclusive('\n').collect();
    let first = random.below(lines.len());
    let mut text: String = lines.iter().skip(first).take(40).copied().collect();
    for _ in 0..random.below(12) {
        let place = |text: &str, at: usize| (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap();
        let start = random.below(text.len() + 1);
        let start = place(&text, start);
        let end = place(&text, (start + random.below(6)).min(text.len()));
        let slip = SLIPS[random.below(SLIPS.len())];
        text.replace_range(start..end, slip);
    }
    text
}

fn within(span: Span, text: &str) {
    assert!(
        span.start <= span.end && text.get(span.range()).is_some(),
        "{span:?} in {text:?}"
    );
}

/// Everything that a cursor at an offset may ask for.
fn at(document: &Document, offset: u32) {
    let text = document.text();
    // An offset that no cursor can stand at is answered for the nearest before it that one can.
    let exact = document.source().line_span(document.source().line_of(offset)).unwrap();
    let exact = offset <= exact.end && offset >= exact.start && text.is_char_boundary(offset as usize);
    let holds = |span: Span| !exact || (span.start <= offset && offset <= span.end);
    if let Some(hover) = hover(document, offset) {
        within(hover.span, text);
        assert!(holds(hover.span), "{text:?} at {offset}");
        assert!(
            !hover.markdown.is_empty() && hover.markdown.len() < 10_000,
            "{}",
            hover.markdown
        );
        assert!(
            !hover.markdown.contains("](") && !hover.markdown.contains("<b>"),
            "{}",
            hover.markdown
        );
        assert_eq!(hover.markdown.matches('`').count() % 2, 0, "{}", hover.markdown);
    }
    for item in completions(document, offset) {
        within(item.replace, text);
        let line = |offset| document.source().line_of(offset);
        assert!(holds(item.replace), "{text:?} at {offset}: {item:?}");
        assert_eq!(line(item.replace.start), line(item.replace.end));
        assert!(!item.label.is_empty() && !item.insert.is_empty());
    }
    if let Some(signature) = signature(document, offset) {
        let (start, end) = signature.parameters[signature.active as usize].range;
        assert!(signature.label.get(start as usize..end as usize).is_some());
    }
}

fn apply(text: &str, edits: &[Edit]) -> String {
    let mut edits = edits.to_vec();
    edits.sort_by_key(|edit| edit.span.start);
    let mut text = text.to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.text);
    }
    text
}

/// Everything that is asked for a whole document.
fn whole(document: &Document, random: &mut Random) {
    let text = document.text();
    let hints = inlay_hints(document, Span::new(0, u32::MAX));
    assert!(hints.is_sorted_by_key(|hint| hint.offset), "{text:?}");
    assert!(
        hints
            .iter()
            .all(|hint| text.is_char_boundary(hint.offset as usize) && !hint.label.is_empty())
    );
    let swatches = colours(document);
    assert!(swatches.is_sorted_by_key(|swatch| swatch.span.start), "{text:?}");
    for (index, swatch) in swatches.iter().enumerate() {
        within(swatch.span, text);
        let byte = |part: f64| (part * 255.0).round();
        let wanted = [0; 3].map(|_| random.below(256) as f64 / 255.0);
        let Some(edits) = colour_edits(document, swatch.span, wanted) else {
            continue;
        };
        assert_eq!(edits.first().map(|edit| edit.span), Some(swatch.span), "{text:?}");
        let edited = Document::new(SourceFile::new("t", apply(text, &edits)).unwrap());
        let found = colours(&edited);
        assert_eq!(found.len(), swatches.len(), "{text:?}");
        assert_eq!(found[index].colour.map(byte), wanted.map(byte), "{text:?} {edits:?}");
    }
}

#[test]
fn every_place_of_every_broken_text_is_answered() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for scene in scenes() {
        for _ in 0..6 {
            let text = broken(&scene, &mut random);
            let document = Document::new(SourceFile::new("t", text.as_str()).unwrap());
            whole(&document, &mut random);
            let last = u32::try_from(text.len()).unwrap() + 2;
            (0..=last).for_each(|offset| at(&document, offset));
            at(&document, u32::MAX);
        }
    }
}

#[test]
fn every_place_of_the_shipped_scenes_is_answered() {
    let mut random = Random(1);
    for scene in scenes() {
        let document = Document::new(SourceFile::new("t", scene.as_str()).unwrap());
        whole(&document, &mut random);
        (0..u32::try_from(scene.len()).unwrap())
            .step_by(3)
            .for_each(|offset| at(&document, offset));
    }
}
