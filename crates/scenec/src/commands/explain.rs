//! `scenec explain`

use std::io::{self, ErrorKind, Write};

use clap::{Args, ValueEnum};
use scenec_lint::{Page, pages};
use scenec_text::{Severity, closest};
use serde_json::{Value, json};

use crate::exit::Exit;
use crate::report;

/// Print the manual page of a finding: what it means, why it matters, an example and its repair
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  scenec explain W012\n  scenec explain unused-object\n  \
                        scenec explain --all --output-format json\n\n\
                        Exit codes:\n  0  the page is printed\n  2  there is no such code")]
pub(crate) struct Explain {
    /// Codes such as `W012`, or their names such as `unused-object`
    #[arg(required_unless_present = "all", value_name = "CODE")]
    codes: Vec<String>,
    /// Print every page
    #[arg(long, conflicts_with = "codes")]
    all: bool,
    /// How the pages are written
    #[arg(long, value_enum, default_value_t = Format::Text, value_name = "FORMAT")]
    output_format: Format,
}

/// How pages are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Format {
    /// Markdown
    Text,
    /// A list of objects
    Json,
}

impl Explain {
    pub(crate) fn run(&self) -> Exit {
        match self.pages() {
            Ok(pages) => print(&written(&pages, self.output_format)),
            Err(message) => {
                // With standard error gone there is nobody left to tell.
                report::failure(&mut io::stderr().lock(), &message).unwrap_or_default();
                Exit::Unusable
            }
        }
    }

    fn pages(&self) -> Result<Vec<Page>, String> {
        if self.all {
            return Ok(pages());
        }
        self.codes.iter().map(|code| find(code)).collect()
    }
}

fn find(word: &str) -> Result<Page, String> {
    let pages = pages();
    let is = |page: &&Page| page.code.id().eq_ignore_ascii_case(word) || page.name().eq_ignore_ascii_case(word);
    if let Some(page) = pages.iter().find(is) {
        return Ok(*page);
    }
    let names: Vec<_> = pages.iter().map(Page::name).collect();
    let known = pages
        .iter()
        .map(|page| page.code.id())
        .chain(names.iter().map(String::as_str));
    let hint = match closest(word, known) {
        Some(near) => format!("did you mean {near}?"),
        None => "`scenec explain --all` prints every page".to_owned(),
    };
    Err(format!("there is no code {}; {hint}", scenec_syntax::quote(word)))
}

fn written(pages: &[Page], format: Format) -> String {
    match format {
        Format::Text => {
            let pages: Vec<_> = pages.iter().map(Page::whole).collect();
            pages.join("\n")
        }
        Format::Json => {
            let pages: Value = pages.iter().map(object).collect();
            format!("{pages:#}\n")
        }
    }
}

fn object(page: &Page) -> Value {
    json!({
        "code": page.code.id(),
        "name": page.name(),
        "severity": match page.code.severity() {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Hint => "hint",
        },
        "summary": page.code.summary(),
        "text": page.text(),
        "example": page.scene("Example"),
        "fixed": page.scene("Fixed"),
    })
}

fn print(text: &str) -> Exit {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Exit::Clean,
        // Whoever read the pages has seen enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Exit::Clean,
        Err(error) => {
            let message = format!("cannot write <stdout>: {error}");
            report::failure(&mut io::stderr().lock(), &message).unwrap_or_default();
            Exit::Unusable
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::{Format, find, pages, written};

    #[test]
    fn a_code_is_found_by_its_number_or_its_name() {
        for word in ["W012", "w012", "unused-object"] {
            assert_eq!(find(word).unwrap().code.id(), "W012");
        }
        let message = find("unusedobject").unwrap_err();
        assert_eq!(message, "there is no code `unusedobject`; did you mean unused-object?");
        assert!(find("rainbow").unwrap_err().contains("--all"));
    }

    #[test]
    fn json_holds_what_the_pages_say() {
        let all: Value = serde_json::from_str(&written(&pages(), Format::Json)).unwrap();
        let list = all.as_array().unwrap();
        assert_eq!(list.len(), pages().len());
        for (value, page) in list.iter().zip(pages()) {
            assert_eq!(value["code"], page.code.id());
            assert_eq!(value["text"], page.text());
            assert!(value["example"].is_string() && value["fixed"].is_string());
        }
    }
}
