//! The end of the file: what is missing, what was never used, and the scene if nothing is wrong.

mod camera;
mod settings;
mod submission;
mod unknown;
mod unused;

use scenec_scene::Scene;
use scenec_text::{Diagnostic, Span};

use crate::state::State;
use crate::suggest::Suggestions;
use crate::{Fragments, Interpretation};

/// Judges the whole file and builds the scene. `last` is the last line that isn't blank.
pub(crate) fn finish(mut state: State<'_>, last: Option<Span>) -> (Interpretation, Vec<Diagnostic>) {
    let end = u32::try_from(state.text.len()).unwrap_or(u32::MAX);
    let last = Span::at(last.map_or(end, |line| line.end));
    let mut suggestions = Suggestions::new();
    unknown::report(&mut state, &mut suggestions);
    unused::report(&mut state, &mut suggestions);
    let (settings, complete) = settings::gather(&mut state, last);
    let root = submission::check(&mut state, last);
    camera::check(&mut state, &settings);
    let settings = complete.then_some(settings);
    let mut diagnostics = state.diagnostics;
    diagnostics.sort_by_key(|finding| finding.span().start);
    let mut fragments = Fragments::default();
    let scene = match (settings, root) {
        (Some(settings), Some(root)) if !state.failed => Some(Scene {
            settings,
            materials: state.materials,
            lights: state.lights,
            solids: state.solids,
            steps: state.steps,
            root,
        }),
        (settings, _) => {
            fragments = Fragments {
                settings,
                materials: state.materials,
                lights: state.lights,
                steps: state.steps,
            };
            None
        }
    };
    let interpretation = Interpretation {
        scene,
        fragments,
        symbols: state.symbols,
    };
    (interpretation, diagnostics)
}
