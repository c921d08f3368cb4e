//! Manual pages: the doc comment of a rule, taken over when it is compiled.

use scenec_text::Code;

use crate::pages::PAGES;
use crate::rules;

/// What the manual says about a code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Page {
    /// The code.
    pub code: Code,
    /// Markdown as the doc comment holds it: each line begins with the space after its slashes.
    raw: &'static str,
}

impl Page {
    pub(crate) const fn new(code: Code, raw: &'static str) -> Self {
        Self { code, raw }
    }

    /// The page's heading, such as `W012: unused-object`.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{}: {}", self.code.id(), self.name())
    }

    /// The code's name in words, such as `unused-object`.
    #[must_use]
    pub fn name(&self) -> String {
        let mut name = String::new();
        for letter in format!("{:?}", self.code).chars() {
            if letter.is_uppercase() && !name.is_empty() {
                name.push('-');
            }
            name.extend(letter.to_lowercase());
        }
        name
    }

    /// The name of the page as a file, such as `w012-unused-object.md`.
    #[must_use]
    pub fn file_name(&self) -> String {
        format!("{}-{}.md", self.code.id().to_lowercase(), self.name())
    }

    /// The whole page in Markdown: the heading, then [`Page::text`].
    #[must_use]
    pub fn whole(&self) -> String {
        format!("# {}\n\n{}", self.title(), self.text())
    }

    /// The page in Markdown, without its heading: what is found and why it matters, then `## Example` and `## Fixed`.
    #[must_use]
    pub fn text(&self) -> String {
        let lines: Vec<_> = self
            .raw
            .lines()
            .map(|line| line.strip_prefix(' ').unwrap_or(line))
            .collect();
        format!("{}\n", lines.join("\n").trim())
    }

    /// The fenced scene under a heading, `Example` or `Fixed`, as a whole file: where the page leaves out the settings,
    /// they are those of [`PRELUDE`].
    #[must_use]
    pub fn scene(&self, heading: &str) -> Option<String> {
        let text = self.text();
        let (_, section) = text.split_once(&format!("\n## {heading}\n"))?;
        let (_, block) = section.split_once("```scene")?;
        let (kind, block) = block.split_once('\n')?;
        let (scene, _) = block.split_once("```")?;
        Some(if kind.is_empty() {
            with_settings(scene)
        } else {
            scene.to_owned()
        })
    }
}

/// The settings that the examples of the pages leave out.
pub const PRELUDE: &str = "\
width := 60
height := 40
raydepth := 0
lookat_x := 0
lookat_y := 0
lookat_z := 0
eyepos_x := 0
eyepos_y := 1
eyepos_z := 5
ambient_r := 0.2
ambient_g := 0.3
ambient_b := 0.5
ambient_int_r := 1
ambient_int_g := 1
ambient_int_b := 1
";

/// A scene behind the settings that it does not give itself.
fn with_settings(scene: &str) -> String {
    let name = |line: &str| line.split_once(" :=").map(|(name, _)| name.to_owned());
    let own: Vec<_> = scene.lines().filter_map(name).collect();
    let missing = PRELUDE
        .lines()
        .filter(|line| name(line).is_none_or(|name| !own.contains(&name)));
    let mut whole: String = missing.flat_map(|line| [line, "\n"]).collect();
    whole.push_str(scene);
    whole
}

/// Every page, in the order of the table of codes.
#[must_use]
pub fn pages() -> Vec<Page> {
    Code::ALL.iter().filter_map(|code| page(*code)).collect()
}

/// The page of a code; every code has one.
#[must_use]
pub fn page(code: Code) -> Option<Page> {
    let rules = rules::all().map(|rule| &rule.page);
    let others = PAGES.iter().copied().flatten();
    rules.chain(others).find(|page| page.code == code).copied()
}

/// The page of a code that another stage reports: `page! { /// ... Code }`.
macro_rules! page {
    ($(#[doc = $doc:literal])+ $code:ident) => {
        $crate::page::Page::new(scenec_text::Code::$code, concat!($($doc, "\n",)+))
    };
}

/// A rule with its page: `rule! { /// ... Code, check }`.
macro_rules! rule {
    ($(#[doc = $doc:literal])+ $code:ident, $check:path) => {
        $(#[doc = $doc])+
        pub(crate) const RULE: $crate::rule::Rule = $crate::rule::Rule {
            page: page! { $(#[doc = $doc])+ $code },
            check: $check,
        };
    };
}
