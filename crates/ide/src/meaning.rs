//! The scene of a text and nothing besides, for who only wants to draw it.

use scenec_interpret::analyse;
use scenec_scene::Scene;
use scenec_text::SourceFile;

/// What a text means; `None` if it has an error. No rule is applied, so it is there sooner than a
/// [`Document`](crate::Document), and it is the same scene: a solid has the same number in both.
#[must_use]
pub fn meaning(source: &SourceFile) -> Option<Scene> {
    analyse(source).0.scene
}

#[cfg(test)]
mod tests {
    use scenec_text::SourceFile;

    use super::meaning;
    use crate::Document;

    fn check(text: &str) {
        let source = SourceFile::new("t", text).unwrap();
        let document = Document::new(source.clone());
        let (scene, expect) = (meaning(&source), document.scene());
        assert_eq!(format!("{scene:?}"), format!("{:?}", expect.cloned()), "{text}");
    }

    #[test]
    fn it_is_the_scene_of_the_document() {
        check(include_str!("../../../scenes/seed.scene"));
        check(include_str!("../../../scenes/boolean.scene"));
        check(include_str!("../../../scenes/broken.scene"));
        check("");
    }
}
