//! `scenec bench --stability`

use std::io::{self, Write};
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use scenec_device::DeviceInfo;
use scenec_interpret::scene_of;
use scenec_measure::povray as pov;
use scenec_measure::stability::{self, Case, CaseError, Machines, Run, Verdict};
use scenec_picture::Watch;

use crate::exit::Exit;
use crate::failure::Failure;
use crate::{interrupt, progress};

/// Runs every case and prints the table, with what POV-Ray makes of them if it is asked. If it is to be brief, there is a row
/// for each case, and of scenes that are drawn by lot some are traced.
pub(super) fn run(device: Option<&DeviceInfo>, povray: bool, brief: bool) -> Result<Exit, Failure> {
    if povray && !pov::is_there() {
        return Err(Failure::unusable(
            "--povray asks POV-Ray, and there is no `povray` on the path; in Debian and Ubuntu its package is povray",
        ));
    }
    let cases = stability::cases().map_err(broken)?;
    let members: Vec<_> = cases
        .iter()
        .flat_map(|case| case.runs().iter().map(move |run| (case, run)))
        .collect();
    let machines = Machines {
        device,
        povray,
        all: !brief,
        watch: Some(interrupt::watch()),
    };
    let counter = Watch::new();
    let judged = progress::counted(&counter, members.len() as u64, "cases", || {
        judge_all(&members, &machines, &counter)
    })?;
    let table = if brief {
        stability::summary(&judged)
    } else {
        stability::table(&judged)
    };
    // A reader that has gone away has read enough.
    io::stdout().lock().write_all(table.as_bytes()).unwrap_or_default();
    Ok(if judged.iter().all(Verdict::holds) {
        Exit::Clean
    } else {
        Exit::Errors
    })
}

/// POV-Ray mostly waits for itself, so that many of it run at once.
const BESIDE: usize = 8;

/// The verdicts, in the order of the members.
fn judge_all(members: &[(&Case, &Run)], machines: &Machines<'_>, counter: &Watch) -> Result<Vec<Verdict>, Failure> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut judged = Vec::new();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some((case, run)) = members.get(number) else {
                return Ok(judged);
            };
            let verdict = stability::judge(case, run, &scene_of, machines).map_err(broken);
            let verdict = if interrupt::watch().stopped() {
                Err(Failure::Interrupted)
            } else {
                verdict
            };
            // Whoever fails ends it for all.
            judged.push((
                number,
                verdict.inspect_err(|_| next.store(members.len(), Ordering::Relaxed))?,
            ));
            counter.advance(1);
        }
    };
    let workers = if machines.povray { BESIDE } else { 1 };
    let judged: Result<Vec<_>, Failure> = thread::scope(|scope| {
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        let ended = workers
            .into_iter()
            .map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        ended.collect()
    });
    let mut judged = judged?.concat();
    judged.sort_by_key(|(number, _)| *number);
    Ok(judged.into_iter().map(|(_, verdict)| verdict).collect())
}

fn broken(error: CaseError) -> Failure {
    Failure::unusable(error.to_string())
}
