//! Each finding drawn with its lines.

use std::io::{self, Write};

use super::{Look, Printer};
use crate::finding::Checked;
use crate::report;

pub(super) struct Full(pub(super) Look);

impl Printer for Full {
    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        report::draw(out, &checked.source, &checked.findings, self.0.colour, self.0.most)
    }
}
