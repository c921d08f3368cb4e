//! The formats that findings can be written in: one file each, and the table of them.
//!
//! They own how findings look to a program or a person. They must not know how a finding came about.

mod concise;
mod full;
mod github;
mod gitlab;
mod json;
mod json_lines;
mod junit;
mod sarif;
mod statistics;

use std::io::{self, Write};

use scenec_text::SourceFile;

use crate::finding::Checked;
pub(crate) use statistics::Statistics;

/// The formats, in the order of the manual.
#[derive(clap::ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum OutputFormat {
    /// For people: each finding with the lines that it is about
    Full,
    /// For people and simple tools: one line a finding
    Concise,
    /// One JSON array of all findings
    Json,
    /// One JSON object a line, each a finding
    JsonLines,
    /// SARIF 2.1.0, as code scanning services read it
    Sarif,
    /// Annotations, as GitHub's workflows read them
    Github,
    /// A code quality report, as GitLab reads it
    Gitlab,
    /// JUnit's XML, as most build servers read it
    Junit,
}

/// What the formats for people leave open.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Look {
    pub(crate) colour: bool,
    /// Whether repairs that may change the picture count as repairs.
    pub(crate) unsafe_fixes: bool,
    /// The most findings of one file.
    pub(crate) most: usize,
}

/// Writes findings, a file at a time.
pub(crate) trait Printer {
    /// What stands before the first file.
    fn begin(&mut self, _out: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }

    /// The findings of one file, which may be none.
    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()>;

    /// What stands after the last file. `failures` tells of the files that could not be checked.
    fn end(&mut self, _out: &mut dyn Write, _failures: &[String]) -> io::Result<()> {
        Ok(())
    }
}

impl OutputFormat {
    /// Whether it is for people, who also like to be told how it went.
    pub(crate) const fn is_prose(self) -> bool {
        matches!(self, Self::Full | Self::Concise)
    }

    /// What writes it.
    pub(crate) fn printer(self, look: Look) -> Box<dyn Printer> {
        match self {
            Self::Full => Box::new(full::Full(look)),
            Self::Concise => Box::new(concise::Concise(look)),
            Self::Json => Box::new(json::Json::default()),
            Self::JsonLines => Box::new(json_lines::JsonLines),
            Self::Sarif => Box::new(sarif::Sarif::default()),
            Self::Github => Box::new(github::Github),
            Self::Gitlab => Box::new(gitlab::Gitlab::default()),
            Self::Junit => Box::new(junit::Junit),
        }
    }
}

/// A place as programs count it: line and column from 1, the column in Unicode characters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Place {
    line: u32,
    column: u32,
}

impl Place {
    fn of(source: &SourceFile, offset: u32) -> Self {
        let position = source.position(offset);
        Self {
            line: position.line + 1,
            column: position.chars + 1,
        }
    }
}

/// A path as programs on every system write it.
fn slashes(name: &str) -> String {
    if cfg!(windows) {
        name.replace('\\', "/")
    } else {
        name.to_owned()
    }
}
