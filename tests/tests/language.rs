//! The scenes in the project's own pages: complete ones are scenes without a finding and render; fragments are at least
//! lines of the language.
//!
//! A fenced block says what it is in its first line: `scene complete`, `scene`, or `scene broken` for one that shows an
//! error.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_cpu::Cpu;
use scenec_interpret::analyse;
use scenec_picture::{Layers, Limits, Request, Tracer, Watch, Window};
use scenec_plan::plan;
use scenec_syntax::parse;
use scenec_tests::root;
use scenec_text::{Severity, SourceFile};

const PAGES: [&str; 2] = ["docs/language.md", "README.md"];

/// A fenced block: the words after its fence, its lines, and where it is for messages.
struct Block {
    words: Vec<String>,
    text: String,
    place: String,
}

fn blocks(page: &str) -> Vec<Block> {
    let text = std::fs::read_to_string(root().join(page)).unwrap_or_else(|error| panic!("{page}: {error}"));
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for (number, line) in text.lines().enumerate() {
        let fence = line.trim_start().strip_prefix("```");
        open = match (open.take(), fence) {
            (None, None) => None,
            (None, Some(words)) => Some(Block {
                words: words.split_whitespace().map(str::to_owned).collect(),
                text: String::new(),
                place: format!("{page}:{}", number + 1),
            }),
            (Some(block), Some(_)) => {
                blocks.push(block);
                None
            }
            (Some(mut block), None) => {
                block.text += line;
                block.text.push('\n');
                Some(block)
            }
        };
    }
    assert!(open.is_none(), "{page}: a block without an end");
    blocks
}

fn scenes() -> impl Iterator<Item = Block> {
    let scene = |block: &Block| block.words.first().is_some_and(|word| word == "scene");
    PAGES.into_iter().flat_map(blocks).filter(scene)
}

fn is(block: &Block, word: &str) -> bool {
    block.words.iter().skip(1).any(|other| other == word)
}

#[test]
fn complete_scenes_have_no_findings_and_render() {
    let mut count = 0;
    for block in scenes().filter(|block| is(block, "complete")) {
        count += 1;
        let source = SourceFile::new(&block.place, &*block.text).unwrap();
        let (interpretation, findings) = analyse(&source);
        assert!(findings.is_empty(), "{}: {findings:#?}", block.place);
        let mut scene = interpretation.scene.unwrap();
        (scene.settings.width, scene.settings.height) = (48, 36);
        let watch = Watch::new();
        let request = Request {
            window: Window::whole(48, 36),
            limits: Limits::DEFAULT,
            layers: Layers::default(),
            watch: &watch,
        };
        let mut tracer = Cpu::<f32>::new(&plan(&scene).unwrap(), 2).unwrap();
        let frame = tracer.trace(&request).unwrap();
        assert_eq!(frame.picture.non_finite(), 0, "{}", block.place);
        let first = frame.picture.pixels()[0];
        assert!(
            frame.picture.pixels().iter().any(|pixel| *pixel != first),
            "{}",
            block.place
        );
    }
    assert!(count > 0, "no complete scene in {PAGES:?}");
}

#[test]
fn fragments_are_lines_of_the_language() {
    let mut count = 0;
    for block in scenes().filter(|block| !is(block, "complete")) {
        count += 1;
        let source = SourceFile::new(&block.place, &*block.text).unwrap();
        let (_, findings) = parse(&source);
        let errors = findings
            .iter()
            .filter(|finding| finding.severity() == Severity::Error)
            .count();
        // What is shown as broken has to be.
        assert_eq!(errors > 0, is(&block, "broken"), "{}: {findings:#?}", block.place);
    }
    assert!(count > 0, "no fragment in {PAGES:?}");
}

#[test]
fn every_block_says_what_it_is() {
    for block in PAGES.into_iter().flat_map(blocks) {
        assert!(!block.words.is_empty(), "{}: a block without a language", block.place);
        let known = ["complete", "broken"];
        let known = block.words.iter().skip(1).all(|word| known.contains(&word.as_str()));
        assert!(block.words[0] != "scene" || known, "{}: {:?}", block.place, block.words);
    }
}
