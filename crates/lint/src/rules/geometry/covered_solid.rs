//! Solids inside others that they are united with.

use scenec_text::{Code, Diagnostic};

use super::{leave_out, made, names};
use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A solid that lies inside another one of its union adds nothing to it, and can't be seen.
    ///
    /// A union has no surfaces inside: what is within it is one solid, whatever its parts are made of, and this is so
    /// for glass too. A fish in a pond has to be cut out of the water, not joined to it.
    ///
    /// The finding shows the figures. A ball lies in a ball if its radius and the distance of the centres add up to less
    /// than the other radius; an ellipsoid is measured in the coordinates of the other one, or along a half-space's normal.
    /// What touches the outer surface, or comes so near to it that rounding could tell otherwise, is not reported.
    /// In a scene of very many solids that overlap without holding each other, the search ends before it has seen all.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !stone := sphere
    /// !stone *= 0.5 0.5 0.5
    /// !stone += 0.2 0 0
    /// !water := sphere
    /// !pond := water | stone
    /// !pond <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !stone := sphere
    /// !stone *= 0.5 0.5 0.5
    /// !stone += 0.2 0 0
    /// !water := sphere
    /// !pond := water - stone
    /// !pond <=
    /// ```
    CoveredSolid, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    for covered in &geometry.covered {
        let Some(proof) = covered.proof else { continue };
        let [inner, outer] = names(context, scene, covered);
        let finding = Diagnostic::new(
            Code::CoveredSolid,
            format!("{inner} lies inside {outer} and adds nothing to their union"),
            scene.solid(covered.inner.solid).span,
            proof.to_string(),
        );
        let finding = made(finding, scene.solid(covered.outer.solid).span, "this holds all of it");
        let finding = made(finding, scene.solid(covered.inner.taker).span, "united here");
        let mut finding = finding.help("remove it, move it out, or subtract it from what holds it");
        finding.fix = leave_out(context, scene, covered.inner);
        findings.push(finding);
    }
}
