//! `scenec bench --stability`

use std::io::{self, Write};

use scenec_device::DeviceInfo;
use scenec_measure::stability::{self, CaseError, Machines, Verdict};
use scenec_picture::Watch;
use scenec_scene::Scene;
use scenec_text::{Severity, SourceFile};

use crate::exit::Exit;
use crate::failure::Failure;
use crate::{interrupt, progress};

/// Runs every case and prints the table, with what POV-Ray makes of them if it is asked.
pub(super) fn run(device: Option<&DeviceInfo>, povray: bool) -> Result<Exit, Failure> {
    let broken = |error: CaseError| Failure::unusable(error.to_string());
    let machines = Machines { device, povray };
    let cases = stability::cases().map_err(broken)?;
    let runs: usize = cases.iter().map(|case| case.runs().len()).sum();
    let counter = Watch::new();
    let judged = progress::counted(&counter, runs as u64, "cases", || {
        let mut verdicts = Vec::with_capacity(runs);
        for (case, run) in cases
            .iter()
            .flat_map(|case| case.runs().iter().map(move |run| (case, run)))
        {
            if interrupt::watch().stopped() {
                return Err(Failure::Interrupted);
            }
            verdicts.push(stability::judge(case, run, &read, &machines).map_err(broken)?);
            counter.advance(1);
        }
        Ok(verdicts)
    })?;
    let table = stability::table(&judged);
    // A reader that has gone away has read enough.
    io::stdout().lock().write_all(table.as_bytes()).unwrap_or_default();
    Ok(if judged.iter().all(Verdict::holds) {
        Exit::Clean
    } else {
        Exit::Errors
    })
}

/// The scene of a text, or the codes of its errors.
fn read(text: &str) -> Result<Scene, Vec<String>> {
    let source = SourceFile::new("case", text).map_err(|_| Vec::new())?;
    let (interpretation, diagnostics) = scenec_interpret::analyse(&source);
    let errors = diagnostics.iter().filter(|one| one.severity() == Severity::Error);
    interpretation
        .scene
        .ok_or_else(|| errors.map(|one| one.code.id().to_owned()).collect())
}
