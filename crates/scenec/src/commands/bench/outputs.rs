//! The files of a bench: each whole, and none before all is measured.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use scenec_measure::{Report, csv, page, png, svg};
use scenec_picture::{Encoding, Format, heat, save, write_whole};

use crate::failure::Failure;
use crate::interrupt::while_writing;

/// The folder.
pub(super) struct Outputs {
    folder: PathBuf,
}

impl Outputs {
    /// A folder, there already or made now, that files can be made in.
    pub(super) fn at(folder: &Path) -> Result<Self, Failure> {
        // Making a file tells more than asking for permissions.
        let made = fs::create_dir_all(folder).and_then(|()| tempfile::tempfile_in(folder));
        made.map_err(|error| cannot_write(folder, &error))?;
        Ok(Self {
            folder: folder.to_owned(),
        })
    }

    /// Writes everything; returns the names.
    pub(super) fn write(&self, reports: &[(String, Report)], heats: bool) -> Result<Vec<String>, Failure> {
        while_writing(|| {
            let mut names = Vec::new();
            for (index, (name, report)) in reports.iter().enumerate() {
                let stem = stem(index, reports.len());
                let drawing = svg(name, report).map_err(Failure::Unusable)?;
                names.push(self.text(&format!("{stem}.svg"), &drawing)?);
                let picture = png(name, report).map_err(Failure::Unusable)?;
                names.push(self.picture(&format!("{stem}.png"), &picture)?);
                if heats {
                    self.heats(index, report)?;
                }
            }
            names.push(self.text("report.csv", &csv(reports))?);
            let diagram = |index| format!("{}.svg", stem(index, reports.len()));
            names.push(self.text("report.md", &page(reports, diagram))?);
            Ok(names)
        })
    }

    /// The differences of each row from the reference, numbered as the rows are.
    fn heats(&self, scene: usize, report: &Report) -> Result<(), Failure> {
        let truth = report.truth.picture()?;
        for (number, row) in report.rows.iter().enumerate() {
            let map = heat(&truth, &row.picture).map_err(Failure::unusable)?;
            self.picture(&format!("heat-{}-{}.png", scene + 1, number + 1), &map)?;
        }
        Ok(())
    }

    fn text(&self, name: &str, text: &str) -> Result<String, Failure> {
        let path = self.folder.join(name);
        let written = write_whole(&path, |out| out.write_all(text.as_bytes()));
        written.map_err(|error: io::Error| cannot_write(&path, &error))?;
        Ok(path.display().to_string())
    }

    fn picture(&self, name: &str, picture: &scenec_picture::Picture) -> Result<String, Failure> {
        let path = self.folder.join(name);
        save(picture, &path, &Encoding::of(Format::PNG)).map_err(Failure::unusable)?;
        Ok(path.display().to_string())
    }
}

/// `wp` for the only scene, `wp-1`, `wp-2` for several.
fn stem(index: usize, of: usize) -> String {
    match of {
        1 => "wp".to_owned(),
        _ => format!("wp-{}", index + 1),
    }
}

fn cannot_write(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::Unusable(format!("cannot write {}: {error}", path.display()))
}
