//! One member of a case through every tracer, and what comes of it.

use scenec_picture::Watch;
use scenec_scene::Scene;

use super::case::{Case, Filled, Oracle, Run};
use super::machines::{Machines, Shot};
use super::off::Off;
use super::verdict::{Outcome, Verdict};
use super::work::{Work, said};
use super::{CaseError, Reader};
use crate::povray;

/// Judges one member of a case.
///
/// # Errors
/// If the case itself is wrong: its scene has errors that nothing expects, or can't be traced at all.
pub fn judge(case: &Case, run: &Run, read: Reader<'_>, machines: &Machines<'_>) -> Result<Verdict, CaseError> {
    let filled = case.filled(run, 0);
    let mut found: Option<Findings> = None;
    let going = |_: &u32| !machines.watch.is_some_and(Watch::stopped);
    for scene in (0..case.scenes(machines.all)).take_while(going) {
        let one = findings(&case.filled(run, scene), read, machines).map_err(|message| CaseError {
            name: format!("{} {}", case.name, run.name).trim().to_owned(),
            message,
        })?;
        found = Some(match found {
            Some(found) => found.and(one),
            None => one,
        });
    }
    let found = found.unwrap_or_default();
    let worst = |single: bool, threshold: f64| {
        let of = found.errors.iter();
        let of = of.filter(|one| one.single.is_none_or(|it| it == single));
        of.max_by(|a, b| a.error.total_cmp(&b.error)).map(|one| Outcome {
            error: one.error,
            tracer: one.tracer.clone(),
            threshold,
        })
    };
    Ok(Verdict {
        case: case.name.clone(),
        title: case.title.clone(),
        run: run.name.clone(),
        condition: run.condition,
        single: worst(true, filled.single),
        double: worst(false, filled.double),
        beyond_single: run.beyond_single.clone(),
        wider: found.wider,
        not_run: found.not_run,
        povray: found.povray,
    })
}

/// What is found of a member.
#[derive(Default)]
struct Findings {
    errors: Vec<Off>,
    wider: Option<String>,
    not_run: Option<&'static str>,
    povray: Option<Result<f64, String>>,
}

impl Findings {
    /// What is found of this and another scene of the member.
    fn and(mut self, other: Self) -> Self {
        self.errors.extend(other.errors);
        self.wider = self.wider.filter(|_| other.wider.is_some());
        self.not_run = self.not_run.or(other.not_run);
        self.povray = match (self.povray, other.povray) {
            (Some(Ok(a)), Some(Ok(b))) => Some(Ok(a.max(b))),
            (Some(Err(_)) | None, Some(seen)) => Some(seen),
            (seen, _) => seen,
        };
        self
    }
}

fn findings(filled: &Filled, read: Reader<'_>, machines: &Machines<'_>) -> Result<Findings, String> {
    if let Oracle::Refused { code } = &filled.oracle {
        let refused = matches!(read(&filled.scene), Err(codes) if codes.contains(code));
        let error = Off {
            tracer: "interpreter".to_owned(),
            single: None,
            error: if refused { 0.0 } else { 1.0 },
        };
        return Ok(Findings {
            errors: vec![error],
            ..Findings::default()
        });
    }
    let work = Work {
        read,
        machines,
        besides: filled.device,
    };
    let scene = work.scene(&filled.scene)?;
    let wider = Machines::beyond_single(&scene).map_err(said)?;
    let reference = machines.reference(&scene).map_err(said)?;
    Ok(Findings {
        wider: wider.map(|reason| reason.to_string()),
        not_run: filled.device.and_then(|how| machines.lack(how)),
        povray: machines.povray.then(|| second_opinion(&scene, &reference)),
        errors: work.errors(&filled.oracle, &scene, reference)?,
    })
}

fn second_opinion(scene: &Scene, reference: &Shot) -> Result<f64, String> {
    let ids = reference.frame.ids.as_deref().unwrap_or_default();
    let seen = povray::leaves(scene)?;
    Ok(povray::astray(&seen, ids, scene.settings.width as usize))
}
