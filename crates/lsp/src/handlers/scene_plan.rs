//! `scene/plan`: what a tracer keeps of a scene, what it leaves out, and which lines of the text come to nothing.

use std::fmt::Write;

use scenec_plan::{BeyondSingle, Features, Plan, plan};
use scenec_scene::{Scene, SolidKind};
use scenec_text::Code;
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{Range, TextDocumentIdentifier};

use crate::server::Server;
use crate::settings::Csg;
use crate::view::View;

/// Findings that say that a statement, or a part of the scene, adds nothing to the picture.
const DROPPING: &[Code] = &[
    Code::UnknownObject,
    Code::UnknownMaterial,
    Code::UnknownVariable,
    Code::AfterSubmission,
    Code::MaterialRedefined,
    Code::OperandEdited,
    Code::OverwrittenUnused,
    Code::UnusedVariable,
    Code::UnusedObject,
    Code::UnusedMaterial,
    Code::IdleTransform,
    Code::EffectlessTransform,
    Code::MaterialReplaced,
    Code::DarkLight,
    Code::CoveredSolid,
    Code::IdleSubtraction,
    Code::EmptySubtraction,
    Code::EmptyIntersection,
    Code::IdleIntersection,
    Code::CoincidentOperands,
];
/// The most characters of a statement that are shown as its name.
const NAME: usize = 40;

/// Of which document.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Params {
    text_document: TextDocumentIdentifier,
}

/// The plan in numbers and in words.
#[derive(Debug, Serialize)]
pub(crate) struct Summary {
    markdown: String,
    kept: Option<Kept>,
    dropped: Vec<Dropped>,
    features: Vec<Feature>,
    tracer: Option<String>,
}

/// Counts of what is traced, and of what the file has.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Kept {
    base_objects: usize,
    base_objects_in_file: usize,
    surfaces: usize,
    islands: usize,
    hierarchy_nodes: usize,
    materials: usize,
    lights: usize,
    lights_in_file: usize,
}

#[derive(Debug, Serialize)]
struct Dropped {
    range: Range,
    name: String,
    why: String,
}

#[derive(Debug, Serialize)]
struct Feature {
    name: String,
    on: bool,
}

impl Server {
    /// Answers `scene/plan`.
    pub(crate) async fn scene_plan(&self, params: Params) -> Result<Option<Summary>> {
        self.on(&params.text_document.uri, summary).await
    }
}

fn summary(view: &View) -> Summary {
    let dropped = dropped(view);
    let scene = view.document.scene().map(|scene| match view.settings.csg {
        Csg::Tree => scene.clone(),
        Csg::Ignore => scene.clone().ignoring_operators(),
    });
    let planned = match &scene {
        Some(scene) => plan(scene).map(|plan| (scene, plan)).map_err(|error| error.to_string()),
        None => Err("the text has errors, so nothing is drawn".to_owned()),
    };
    let device = &view.settings.device;
    match planned {
        Ok((scene, plan)) => {
            let (kept, features) = (kept(scene, &plan), features(&plan));
            let tracer = tracer(device, plan.beyond_single());
            Summary {
                markdown: markdown(&kept, &features, &dropped, &tracer),
                kept: Some(kept),
                dropped,
                features,
                tracer: Some(tracer),
            }
        }
        Err(why) => Summary {
            markdown: format!("# Plan\n\nThere is none: {why}.\n"),
            kept: None,
            dropped,
            features: Vec::new(),
            tracer: None,
        },
    }
}

fn kept(scene: &Scene, plan: &Plan) -> Kept {
    let leaves = scene
        .solids
        .iter()
        .filter(|solid| matches!(solid.kind, SolidKind::Leaf(_)));
    Kept {
        base_objects: plan.leaves.len(),
        base_objects_in_file: leaves.count(),
        surfaces: plan.shapes.len(),
        islands: plan.islands.len(),
        hierarchy_nodes: plan.nodes.len(),
        materials: plan.materials.len(),
        lights: plan.lights.len(),
        lights_in_file: scene.lights.len(),
    }
}

fn features(plan: &Plan) -> Vec<Feature> {
    let list = Features::of(plan).list();
    // Those that are sizes and not switches are always there.
    let switches = list
        .into_iter()
        .filter(|(name, _)| !matches!(*name, "WAITING" | "MEMBERS" | "HIERARCHY_DEPTH" | "CELLS_DEPTH"));
    let feature = |(name, value): (&str, u32)| Feature {
        name: name.to_lowercase().replace('_', " "),
        on: value != 0,
    };
    switches.map(feature).collect()
}

fn dropped(view: &View) -> Vec<Dropped> {
    let text = view.document.text();
    let found = view
        .document
        .diagnostics()
        .iter()
        .filter(|found| DROPPING.contains(&found.code));
    let line = |found: &scenec_text::Diagnostic| {
        let words = found.span().of(text);
        Dropped {
            range: view.range(found.span()),
            name: first_line(words),
            why: format!("{} ({})", found.message, found.code.id()),
        }
    };
    found.map(line).collect()
}

/// The first line of a finding's words, cut where it is long.
fn first_line(words: &str) -> String {
    let mut line = words.chars().take_while(|c| !c.is_control());
    let mut first: String = line.by_ref().take(NAME).collect();
    if line.next().is_some() {
        first.push('…');
    }
    first
}

/// What will draw, by the rules of the process that draws. Drivers are not asked: that is for that process.
fn tracer(device: &str, beyond_single: Option<BeyondSingle>) -> String {
    let (precision, able) = match beyond_single {
        Some(why) => (format!(" in f64, since {why}"), " that has f64"),
        None => (" in f32".to_owned(), ""),
    };
    match device {
        "cpu" => format!("the built-in tracer, on the processor,{precision}"),
        "auto" => format!(
            "the built-in tracer, on the processor,{precision}; passes over the whole picture that take it longer than a \
             blink go to the first OpenCL GPU{able}, if there is one"
        ),
        other => format!(
            "the OpenCL device `{}`{precision}, coarse passes by the built-in tracer; by that alone if there is no such \
             device",
            other.replace('`', "'")
        ),
    }
}

fn markdown(kept: &Kept, features: &[Feature], dropped: &[Dropped], tracer: &str) -> String {
    let found = if kept.hierarchy_nodes > 0 {
        format!("a hierarchy of {} nodes", kept.hierarchy_nodes)
    } else {
        "a list: there are too few for a hierarchy".to_owned()
    };
    let mut text = format!(
        "# Plan\n\n| | traced | in the file |\n|---|---:|---:|\n\
         | base objects | {} | {} |\n| distinct surfaces | {} | |\n| islands | {} | |\n| materials | {} | |\n\
         | lights | {} | {} |\n\nIslands are found through {found}.\n\nDrawn by {tracer}.\n",
        kept.base_objects,
        kept.base_objects_in_file,
        kept.surfaces,
        kept.islands,
        kept.materials,
        kept.lights,
        kept.lights_in_file
    );
    let names = |on: bool| {
        let names: Vec<&str> = features
            .iter()
            .filter(|one| one.on == on)
            .map(|one| one.name.as_str())
            .collect();
        if names.is_empty() {
            "nothing".to_owned()
        } else {
            names.join(", ")
        }
    };
    // Writing to a string can't fail.
    write!(
        text,
        "\nThe tracer needs: {}.\n\nLeft out of it: {}.\n",
        names(true),
        names(false)
    )
    .unwrap_or_default();
    if dropped.is_empty() {
        text.push_str("\nEvery statement counts.\n");
        return text;
    }
    text.push_str("\n## Lines that come to nothing\n\n");
    for one in dropped {
        let name = one.name.replace('`', "'");
        writeln!(text, "* line {}, `{name}`: {}", one.range.start.line + 1, one.why).unwrap_or_default();
    }
    text
}
