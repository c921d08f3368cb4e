//! Random solids: a family draws each of its scenes by lot, from a number.

use std::fmt::Write;

use serde::Deserialize;

use crate::numbers::Numbers;

/// The most leaves and the most scenes; a case is a file, and a file may say anything.
const MOST: u32 = 1 << 16;

/// A solid that is another one in each scene of the family.
#[derive(Clone, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Tree {
    /// The word that stands for its statements. They call it `t`, and place the eye, in one of four scenes amid the leaves.
    pub(super) word: String,
    /// The least and the most leaves, in words, so that a run can fill them in; as many trees have 2 to 4 as 20 to 40.
    leaves: [String; 2],
    /// How many of a hundred leaves are half-spaces, in words.
    planes: String,
    /// How many scenes a run has: some of them for a quick look, and all.
    scenes: [u32; 2],
}

impl Tree {
    /// How many scenes a run has.
    pub(super) fn scenes(&self, all: bool) -> u32 {
        self.scenes[usize::from(all)].min(MOST)
    }

    /// The statements of one scene; `words` fills in what the run says.
    pub(super) fn text(&self, scene: u32, words: impl Fn(&str) -> String) -> String {
        let number = |text: &String| words(text).parse::<u32>().unwrap_or(0).min(MOST);
        let ([least, most], planes) = (self.leaves.each_ref().map(number), number(&self.planes));
        // Each run draws others.
        let mut numbers = Numbers::new(u64::from(least) << 48 | u64::from(planes) << 32 | u64::from(scene));
        let leaves = numbers.between(f64::from(least).ln(), f64::from(most + 1).ln()).exp();
        let leaves = (leaves as u64).max(2);
        let mut text = String::new();
        let far = if numbers.below(4) == 0 { 0.5 } else { 3.0 };
        for axis in ["x", "y", "z"] {
            let _ = writeln!(text, "eyepos_{axis} := {}", numbers.between(-far, far));
        }
        // So that neither a few leaves are lost in the picture nor many fill each other.
        let radius = (3.2 / (leaves as f64).cbrt()).min(1.0);
        for i in 0..leaves {
            let plane = numbers.below(100) < u64::from(planes);
            leaf(&mut text, &mut numbers, i, (!plane).then_some(radius));
        }
        join(&mut text, &mut numbers, leaves);
        text
    }
}

/// A leaf anywhere: an ellipsoid or ball of at most this radius, or a half-space.
fn leaf(text: &mut String, numbers: &mut Numbers, i: u64, radius: Option<f64>) {
    let _ = writeln!(text, "!o{i} := {}", if radius.is_some() { "sphere" } else { "hp" });
    if let Some(radius) = radius {
        let [a, b, c] = match numbers.below(3) {
            0 => [(); 3].map(|()| radius * numbers.between(0.2, 1.0)),
            _ => [radius * numbers.between(0.2, 1.0); 3],
        };
        let _ = writeln!(text, "!o{i} *= {a} {b} {c}");
    }
    for axis in ["x", "z"] {
        let _ = writeln!(text, "!o{i} #{axis}= {}", numbers.between(-3.2, 3.2));
    }
    let [x, y, z] = [(); 3].map(|()| numbers.between(-1.0, 1.0));
    let _ = writeln!(text, "!o{i} += {x} {y} {z}");
}

/// Joins any two of what is left until one is left.
fn join(text: &mut String, numbers: &mut Numbers, leaves: u64) {
    let mut open: Vec<String> = (0..leaves).map(|i| format!("o{i}")).collect();
    for joined in 0.. {
        let count = open.len() as u64;
        let mut draw = || open.swap_remove(numbers.below(open.len() as u64) as usize);
        let (a, b) = (draw(), draw());
        // What is joined last is united, so that there is something to see.
        let kinds = if count < 5 { 3 } else { 6 };
        let op = ["|", "|", "|", "&", "-", "-"][numbers.below(kinds) as usize];
        let name = if count > 2 {
            format!("j{joined}")
        } else {
            "t".to_owned()
        };
        let _ = writeln!(text, "!{name} := {a} {op} {b}");
        if count <= 2 {
            return;
        }
        open.push(name);
    }
}

#[cfg(test)]
mod tests {
    use super::Tree;

    fn check(least: &str, most: &str, planes: &str) {
        let tree = Tree {
            word: "tree".to_owned(),
            leaves: [least.to_owned(), most.to_owned()],
            planes: planes.to_owned(),
            scenes: [2, 20],
        };
        let mut seen = std::collections::HashSet::new();
        for scene in 0..tree.scenes(true) {
            let text = tree.text(scene, str::to_owned);
            let count = |what: &str| text.lines().filter(|line| line.ends_with(what)).count();
            let (balls, flat) = (count(" sphere"), count(" hp"));
            let (least, most) = (least.parse().unwrap(), most.parse().unwrap());
            assert!((least..=most).contains(&(balls + flat)), "{text}");
            assert!(planes != "0" || flat == 0, "{text}");
            assert!(planes != "100" || balls == 0, "{text}");
            assert_eq!(
                text.lines().filter(|line| line.starts_with("!t := ")).count(),
                1,
                "{text}"
            );
            assert!(seen.insert(text));
        }
        assert!(tree.scenes(false) < tree.scenes(true));
    }

    #[test]
    fn trees_are_as_large_as_asked_for_and_no_two_alike() {
        check("2", "3", "0");
        check("2", "15", "30");
        check("16", "255", "100");
        check("256", "300", "30");
    }
}
