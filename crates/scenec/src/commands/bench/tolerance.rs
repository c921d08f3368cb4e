//! `scenec bench --tolerance`

use std::io::{self, Write};

use scenec_measure::{Tolerance, worth, worth_table};
use scenec_scene::Scene;

use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;

/// Renders each scene to a tolerance and prints the table, a scene at a time.
pub(super) fn run(scenes: &[(String, Scene)], tolerance: f64) -> Result<Exit, Failure> {
    let mut rows = Vec::with_capacity(scenes.len());
    for (name, scene) in scenes {
        let wish = Tolerance::of(scene, tolerance, interrupt::watch());
        rows.push((name.clone(), worth(&wish)?));
    }
    // A reader that has gone away has read enough.
    io::stdout()
        .lock()
        .write_all(worth_table(&rows).as_bytes())
        .unwrap_or_default();
    let good = rows.iter().all(|(_, row)| row.defects == 0 && row.achieved.missed == 0);
    Ok(if good { Exit::Clean } else { Exit::Errors })
}
