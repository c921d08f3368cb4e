//! Tokens and statements: how a scene is written.
//!
//! Owns the scanner, the parser, the formatter and the table of statement forms. It must not know what a name stands
//! for, which base objects exist, or what a material is.

mod characters;
mod format;
mod forms;
mod number;
mod parse;
mod quote;
mod statement;
mod token;

pub use format::{FormatStyle, Refused, format};
pub use forms::{FORMS, Form, FormInfo, Space};
pub use parse::{Lines, line, parse, parse_again, read_ahead};
pub use quote::quote;
pub use statement::{Axis, Broken, Content, Line, Operator, Sign, Statement, Value, ValueKind};
pub use token::{Token, scan};
