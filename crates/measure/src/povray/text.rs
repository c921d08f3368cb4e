//! A scene as POV-Ray reads it.

use std::fmt::Write;

use scenec_picture::NOTHING;
use scenec_scene::{Base, DVec3, Leaf, Op, Scene, SolidId, SolidKind, View, view};

/// The most objects that POV-Ray is asked about: in a merge or a difference it tests a hit on each in all others, so that tens
/// of thousands take longer than anybody waits. A shared operand is written out, and counted, wherever it is used.
const MOST: usize = 2048;

/// The colour of nothing; a leaf's colour is its number, so this one stays free.
const WHITE: u32 = 0x00ff_ffff;

/// The scene in POV-Ray's language, each leaf in the flat colour of its number and the sky white.
///
/// The same numbers are written without turning any axis: POV-Ray's axes are left-handed only in how it makes a camera and a
/// rotation, and both are written as vectors here.
///
/// # Errors
/// A few words: there are too many objects, or there is no camera.
pub fn text(scene: &Scene) -> Result<String, String> {
    let (View::Clear(camera) | View::AlongUp(camera)) = view(&scene.settings) else {
        return Err("not asked: there is no view".to_owned());
    };
    if scene.solids.len() >= WHITE as usize {
        return Err("not asked: there are more objects than colours".to_owned());
    }
    let mut out = String::from(
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 1 }\n\
         #default { finish { ambient 1 diffuse 0 } }\n",
    );
    let _ = writeln!(
        out,
        "camera {{ perspective location {} direction {} right {} up {} }}",
        vector(camera.eye),
        vector(camera.forward),
        vector(camera.right * 2.0),
        vector(camera.up * 2.0)
    );
    let (mut waiting, mut written) = (vec![Part::Solid(scene.root)], 0);
    while let Some(part) = waiting.pop() {
        match part {
            Part::End => out.push_str("}\n"),
            Part::Solid(id) => {
                written += usize::from(matches!(scene.solid(id).kind, SolidKind::Leaf(_)));
                solid(scene, id, &mut out, &mut waiting);
            }
        }
        // Each solid that waits holds an object at least, and to each end that waits belongs one, written or waiting.
        if written > MOST || waiting.len() > 2 * MOST + 1 {
            return Err(format!("not asked: more than {MOST} objects"));
        }
    }
    Ok(out)
}

/// The leaf of a colour.
pub(super) fn leaf([r, g, b]: [u8; 3]) -> u32 {
    match u32::from_be_bytes([0, r, g, b]) {
        WHITE => NOTHING,
        number => number,
    }
}

/// What is still to be written.
enum Part {
    Solid(SolidId),
    /// A combination ends.
    End,
}

fn solid(scene: &Scene, id: SolidId, out: &mut String, waiting: &mut Vec<Part>) {
    match &scene.solid(id).kind {
        SolidKind::Leaf(leaf) => base(scene, id, leaf, out),
        // Colours tell leaves apart here, and not what they are made of.
        SolidKind::Paint { inside, .. } => waiting.push(Part::Solid(*inside)),
        SolidKind::Combine { op, .. } => {
            out.push_str(match op {
                // Its union keeps the surfaces inside; a merge is without them.
                Op::Union => "merge {\n",
                Op::Intersection => "intersection {\n",
                Op::Subtraction => "difference {\n",
            });
            waiting.push(Part::End);
            operands(scene, id, *op, waiting);
        }
    }
}

/// The operands, so that the leftmost is the next to be written. A chain to the left under one operator becomes one list: POV-Ray
/// reads its language by recursion, and a deep tree would end it.
fn operands(scene: &Scene, id: SolidId, chained: Op, waiting: &mut Vec<Part>) {
    let mut here = id;
    loop {
        match &scene.solid(here).kind {
            SolidKind::Combine { op, left, right } if *op == chained => {
                waiting.push(Part::Solid(*right));
                here = *left;
            }
            SolidKind::Paint { inside, .. } => here = *inside,
            _ => break waiting.push(Part::Solid(here)),
        }
    }
}

fn base(scene: &Scene, id: SolidId, leaf: &Leaf, out: &mut String) {
    let to = scene.transform(leaf);
    let shape = match leaf.base {
        Base::Sphere => "sphere { 0, 1",
        Base::HalfSpace => "plane { y, 0",
    };
    let [x, y, z] = [to.linear.x_axis, to.linear.y_axis, to.linear.z_axis];
    let rows = [x, y, z, to.centre].map(|row| format!("{:e},{:e},{:e}", row.x, row.y, row.z));
    let [_, r, g, b] = id.0.to_be_bytes();
    let _ = writeln!(
        out,
        "{shape} matrix <{}> pigment {{ rgb <{r},{g},{b}>/255 }} }}",
        rows.join(",")
    );
}

fn vector(v: DVec3) -> String {
    format!("<{:e},{:e},{:e}>", v.x, v.y, v.z)
}

#[cfg(test)]
mod tests {
    use scenec_picture::NOTHING;

    use super::leaf;

    #[test]
    fn a_colour_is_a_number() {
        assert_eq!(leaf([0, 1, 2]), 258);
        assert_eq!(leaf([255; 3]), NOTHING);
    }
}
