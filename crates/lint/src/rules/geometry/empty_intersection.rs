//! Intersections of what never meets.

use scenec_text::{Code, Diagnostic, Edit, Fix, Span};

use super::{Written, made};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::Outcome;

rule! {
    /// An intersection of two solids that have no point in common is empty.
    ///
    /// If both were to be seen, a union was meant: `a | b`.
    ///
    /// The finding shows why they can't meet: the distance of two balls, a plane between them, or the boxes around them.
    /// Two solids that touch, or come so near that rounding could tell otherwise, are not reported.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball += 0 1.5 0
    /// !ground := hp
    /// !both := ball & ground
    /// !both <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball += 0 1.5 0
    /// !ground := hp
    /// !both := ball | ground
    /// !both <=
    /// ```
    EmptyIntersection, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    for verdict in &geometry.verdicts {
        let Outcome::Empty(proof) = verdict.outcome else {
            continue;
        };
        let Some(written) = Written::of(context, scene, verdict.node) else {
            continue;
        };
        let Written { statement, left, right } = written;
        let finding = Diagnostic::new(
            Code::EmptyIntersection,
            format!("{} and {} have nothing in common", left.name, right.name),
            statement,
            format!("this is empty: {proof}"),
        );
        let finding = made(finding, left.made, "the one");
        let finding = made(finding, right.made, "the other");
        let mut finding = finding.help("move them so that they meet, or write `|` for a union");
        let between = Span::new(left.place.end, right.place.start);
        if let Some(at) = between.of(context.text()).find('&') {
            let at = between.start + at as u32;
            finding = finding.fix(Fix {
                title: "write `|` for a union".to_owned(),
                edits: vec![Edit {
                    span: Span::new(at, at + 1),
                    text: "|".to_owned(),
                }],
                safe: false,
            });
        }
        findings.push(finding);
    }
}
