//! Objects as they stand at a place of the file: what they are made from, where they went, what they are made of.

use scenec_interpret::DefinitionId;
use scenec_scene::{Axis, Base, DVec3, StepKind, Transform};
use scenec_syntax::Statement;
use scenec_text::Span;

use crate::Document;

/// An object as it stands at a place.
pub(crate) struct Standing<'d> {
    /// What makes it.
    pub(crate) made: Made,
    /// The transforms that had an effect, as they were written.
    pub(crate) steps: Vec<(Span, StepKind)>,
    /// All of them together.
    pub(crate) transform: Transform,
    /// The last material set that had an effect: its place, and the material.
    pub(crate) paint: Option<(Span, DefinitionId)>,
    document: &'d Document,
}

/// What makes an object.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Made {
    /// A base object.
    Base(Base),
    /// A combination.
    Combination,
}

/// Where a base object is.
pub(crate) enum Shape {
    /// An ellipsoid: its centre, and how far it reaches along each axis.
    Ball { centre: DVec3, reach: DVec3 },
    /// All behind a plane: a point on it and its outward normal.
    Half { point: DVec3, normal: DVec3 },
}

impl<'d> Standing<'d> {
    /// The object that a definition made, with the edits before an offset.
    pub(crate) fn of(document: &'d Document, id: DefinitionId, before: u32) -> Option<Self> {
        let line = document.definition_of(id)?.line;
        let made = match document.statement_at(line.start)?.0 {
            Statement::Object { base, .. } => Made::Base(base_of(document.words(*base))?),
            Statement::Combination { .. } => Made::Combination,
            _ => return None,
        };
        let mut standing = Self {
            made,
            steps: Vec::new(),
            transform: Transform::IDENTITY,
            paint: None,
            document,
        };
        let edits = document.facts().edits(document, id);
        for edit in edits.take_while(|edit| edit.span.start < before) {
            if let Some((statement, line)) = document.statement_at(edit.span.start) {
                standing.edit(statement, line);
            }
        }
        Some(standing)
    }

    /// Notes an edit, unless it comes too late or can have no effect.
    fn edit(&mut self, statement: &Statement, line: Span) {
        if self.document.facts().is_late(line) {
            return;
        }
        if matches!(statement, Statement::MaterialSet { .. }) {
            self.paint = self.document.used_on(line).map(|paint| (line, paint)).or(self.paint);
            return;
        }
        let step = step_of(self.document, statement).filter(|_| self.made != Made::Combination);
        let moved = step.map(|step| (step, step.after(self.transform)));
        if let Some((step, transform)) = moved.filter(|(_, transform)| transform.is_finite()) {
            self.steps.push((line, step));
            self.transform = transform;
        }
    }

    /// Where it is; `None` for a combination.
    pub(crate) fn shape(&self) -> Option<Shape> {
        let Made::Base(base) = self.made else {
            return None;
        };
        Some(match base {
            Base::Sphere => {
                let rows = self.transform.linear.transpose();
                Shape::Ball {
                    centre: self.transform.centre,
                    reach: DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length()),
                }
            }
            Base::HalfSpace => Shape::Half {
                point: self.transform.centre,
                // Normals go by the inverse transpose, of which this is the column of the object's y axis.
                normal: self.transform.inverse.row(1).normalize_or_zero(),
            },
        })
    }
}

/// The base object that a word stands for.
pub(crate) fn base_of(word: &str) -> Option<Base> {
    let row = Base::ALL.iter().find(|(_, known)| *known == word);
    row.map(|(base, _)| *base)
}

/// What a transform does; `None` for another statement, for one that names nothing, and for a scale by 0.
pub(crate) fn step_of(document: &Document, statement: &Statement) -> Option<StepKind> {
    match statement {
        Statement::Scale { by, .. } => {
            let factors = document.numbers::<3>(by.as_slice())?;
            let vanishes = factors.contains(&0.0);
            (!vanishes).then(|| StepKind::Scale(DVec3::from_array(factors)))
        }
        Statement::Translate { by, .. } => {
            let by = document.numbers::<3>(by.as_slice())?;
            Some(StepKind::Translate(DVec3::from_array(by)))
        }
        Statement::Rotate { axis, angle, .. } => {
            let axis = match axis {
                scenec_syntax::Axis::X => Axis::X,
                scenec_syntax::Axis::Y => Axis::Y,
                scenec_syntax::Axis::Z => Axis::Z,
            };
            Some(StepKind::Rotate(axis, document.number(angle)?))
        }
        _ => None,
    }
}
