//! Repairs keep their promises: each removes its finding and causes none, and one that calls itself safe leaves the scene
//! without errors as it was.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use scenec_lint::{check, pages};
use scenec_tests::{mended, root};
use scenec_text::{Code, Diagnostic, SourceFile};

/// How often each code with its message is found.
type Counts = BTreeMap<(&'static str, String), usize>;

/// The codes that have a repair, each of which some fixture or page must show.
const MENDED: &[Code] = &[
    Code::NumberUnderflow,
    Code::UnknownObject,
    Code::UnknownMaterial,
    Code::UnknownVariable,
    Code::AfterSubmission,
    Code::MaterialRedefined,
    Code::OperandEdited,
    Code::OverwrittenUnused,
    Code::UnusedVariable,
    Code::UnusedObject,
    Code::UnusedMaterial,
    Code::IdleTransform,
    Code::EffectlessTransform,
    Code::MaterialReplaced,
    Code::LikelyDegrees,
    Code::DarkLight,
    Code::CoveredSolid,
    Code::EmptySubtraction,
    Code::EmptyIntersection,
    Code::CoincidentOperands,
    Code::UselessAllow,
    Code::IdleDepth,
];

fn findings(text: &str) -> Vec<Diagnostic> {
    check(&SourceFile::new("t", text).unwrap()).diagnostics
}

fn counts(findings: &[Diagnostic]) -> Counts {
    let mut counts = Counts::new();
    for finding in findings {
        *counts.entry((finding.code.id(), finding.message.clone())).or_default() += 1;
    }
    counts
}

/// What is wrong with the repairs of a file.
fn broken_promises(name: &str, text: &str) -> Vec<String> {
    let before = findings(text);
    let had = counts(&before);
    let mut wrong = Vec::new();
    for finding in &before {
        let Some(fix) = &finding.fix else { continue };
        let after = mended(text, fix);
        let has = counts(&findings(&after));
        let key = (finding.code.id(), finding.message.clone());
        if has.get(&key).copied().unwrap_or_default() >= had[&key] {
            wrong.push(format!("{name}: {key:?} stays after {:?}", fix.title));
        }
        // A name that means something again may be found at fault for more than it was.
        for (new, count) in has.iter().filter(|_| fix.safe) {
            if *count > had.get(new).copied().unwrap_or_default() {
                wrong.push(format!("{name}: {:?} for {key:?} causes {new:?}", fix.title));
            }
        }
    }
    wrong
}

#[test]
fn a_repair_removes_its_finding_and_causes_none() {
    let mut wrong = Vec::new();
    let mut repaired = BTreeSet::new();
    let mut look = |name: &str, text: &str| {
        let fixed = findings(text).into_iter().filter(|finding| finding.fix.is_some());
        repaired.extend(fixed.map(|finding| finding.code));
        wrong.extend(broken_promises(name, text));
    };
    for folder in ["tests/fixtures", "scenes"] {
        for entry in fs::read_dir(root().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            // Those that are not UTF-8 can't be taken for text.
            if let (Some("scene"), Ok(text)) = (
                path.extension().and_then(|extension| extension.to_str()),
                fs::read_to_string(&path),
            ) {
                look(&path.file_name().unwrap().to_string_lossy(), &text);
            }
        }
    }
    for page in pages() {
        look(&page.title(), &page.scene("Example").unwrap());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(repaired, MENDED.iter().copied().collect());
}

#[test]
fn a_safe_repair_leaves_what_is_rendered() {
    use scenec_scene::{Scene, SolidKind};
    use scenec_text::Span;

    /// The submitted object with what it is made of, and what else counts, without places and numbers.
    fn seen(scene: &Scene) -> String {
        let mut settings = scene.settings.clone();
        // Without mirrors and glass the depth shows nowhere, and only then is it repaired.
        settings.raydepth = 0;
        let mut words = vec![format!("{settings:?}")];
        let mut open = vec![scene.root];
        while let Some(id) = open.pop() {
            words.push(match &scene.solid(id).kind {
                SolidKind::Leaf(leaf) => {
                    let mut material = *scene.material(leaf.material);
                    material.span = None;
                    format!("{:?} {:?} {material:?}", leaf.base, scene.transform(leaf))
                }
                SolidKind::Combine { op, left, right } => {
                    open.extend([*right, *left]);
                    format!("{op:?}")
                }
                SolidKind::Paint { inside, material } => {
                    open.push(*inside);
                    let mut material = *scene.material(*material);
                    material.span = None;
                    format!("{material:?}")
                }
            });
        }
        for light in scene.lights.iter().filter(|light| light.colour.length() > 0.0) {
            let mut light = *light;
            light.span = Span::default();
            words.push(format!("{light:?}"));
        }
        words.join("\n")
    }
    let scene = |text: &str| check(&SourceFile::new("t", text).unwrap()).interpretation.scene;
    let mut tried = 0;
    for entry in fs::read_dir(root().join("tests/fixtures")).unwrap() {
        let path = entry.unwrap().path();
        let Ok(text) = fs::read_to_string(&path) else { continue };
        let Some(before) = scene(&text) else { continue };
        for finding in findings(&text) {
            if let Some(fix) = finding.fix.filter(|fix| fix.safe) {
                let after = scene(&mended(&text, &fix)).unwrap();
                assert_eq!(seen(&before), seen(&after), "{}: {}", path.display(), fix.title);
                tried += 1;
            }
        }
    }
    assert!(tried > 20, "only {tried} safe repairs were tried");
}
