//! The same scene in the words of each peer: the language itself, POV-Ray's, and plain numbers for Embree.

use std::fmt::Write;

use crate::scenes::{AMBIENT, LIGHTS, MATERIALS, Model, Solid};

/// As a scene file.
pub(crate) fn scene(model: &Model) -> String {
    let mut text = String::new();
    let (width, height) = model.size;
    writeln!(
        text,
        "width := {width}\nheight := {height}\nraydepth := {}",
        model.depth
    )
    .unwrap();
    for (prefix, values, suffix) in [
        ("lookat", model.look_at, ["x", "y", "z"]),
        ("eyepos", model.eye, ["x", "y", "z"]),
        ("ambient", AMBIENT, ["r", "g", "b"]),
        ("ambient_int", [1.0; 3], ["r", "g", "b"]),
    ] {
        for (value, suffix) in values.iter().zip(suffix) {
            writeln!(text, "{prefix}_{suffix} := {value}").unwrap();
        }
    }
    for (i, material) in MATERIALS.iter().enumerate() {
        writeln!(text, "?m{i} := {}", material.map(|x| x.to_string()).join(" ")).unwrap();
    }
    for (i, ([x, y, z], [r, g, b])) in LIGHTS.iter().enumerate() {
        writeln!(text, "*l{i} := {x} {y} {z} {r} {g} {b}").unwrap();
    }
    let top = scene_solid(&mut text, &model.solid, &mut 0);
    writeln!(text, "!{top} <=").unwrap();
    text
}

/// Writes a solid and returns its name. The trees here are shallow, chains aside, which are no recursion.
fn scene_solid(text: &mut String, solid: &Solid, count: &mut usize) -> String {
    let (parts, operator) = match solid {
        Solid::Ball([x, y, z], radius, material) => {
            let name = next(count);
            writeln!(text, "!{name} := sphere\n!{name} ?= m{material}").unwrap();
            writeln!(text, "!{name} *= {radius} {radius} {radius}\n!{name} += {x} {y} {z}").unwrap();
            return name;
        }
        Solid::Side(axis, sign, at, material) => {
            let name = next(count);
            writeln!(text, "!{name} := hp\n!{name} ?= m{material}").unwrap();
            let turn = match (axis, *sign > 0.0) {
                (1, true) => None,
                (1, false) => Some(("x", std::f64::consts::PI)),
                (0, up) => Some(("z", std::f64::consts::FRAC_PI_2 * if up { -1.0 } else { 1.0 })),
                (_, up) => Some(("x", std::f64::consts::FRAC_PI_2 * if up { 1.0 } else { -1.0 })),
            };
            if let Some((about, angle)) = turn {
                writeln!(text, "!{name} #{about}= {angle}").unwrap();
            }
            let mut place = [0.0; 3];
            place[*axis] = *at;
            writeln!(text, "!{name} += {} {} {}", place[0], place[1], place[2]).unwrap();
            return name;
        }
        Solid::Union(parts) => (parts, '|'),
        Solid::Intersection(parts) => (parts, '&'),
        Solid::Difference(parts) => (parts, '-'),
    };
    let mut names = parts.iter();
    let mut left = names
        .next()
        .map_or_else(String::new, |part| scene_solid(text, part, count));
    for part in names {
        let right = scene_solid(text, part, count);
        let name = next(count);
        writeln!(text, "!{name} := {left} {operator} {right}").unwrap();
        left = name;
    }
    left
}

fn next(count: &mut usize) -> String {
    *count += 1;
    format!("o{count}")
}

/// As a POV-Ray file. Its axes are left-handed, so z changes its sign.
pub(crate) fn pov(model: &Model) -> String {
    let mut text = String::from("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level ");
    writeln!(text, "{} ambient_light rgb <{}> }}", model.depth + 1, list(AMBIENT)).unwrap();
    writeln!(
        text,
        "camera {{ location <{}> angle 90 right x*{}/{} look_at <{}> }}",
        list(flipped(model.eye)),
        model.size.0,
        model.size.1,
        list(flipped(model.look_at))
    )
    .unwrap();
    writeln!(text, "background {{ rgb <0.6,0.65,0.75> }}").unwrap();
    for (position, colour) in LIGHTS {
        writeln!(
            text,
            "light_source {{ <{}> rgb <{}> }}",
            list(flipped(position)),
            list(colour)
        )
        .unwrap();
    }
    for (i, [ka, kd, ks, kr, _, _, shiny, r, g, b]) in MATERIALS.iter().enumerate() {
        writeln!(
            text,
            "#declare M{i} = texture {{ pigment {{ rgb <{r},{g},{b}> }} finish {{ ambient {ka} diffuse {kd} phong {ks} \
             phong_size {shiny} reflection {kr} }} }}"
        )
        .unwrap();
    }
    match &model.solid {
        // Objects of their own, which POV-Ray puts into its hierarchy.
        Solid::Union(parts) => parts.iter().for_each(|part| pov_solid(&mut text, part)),
        solid => pov_solid(&mut text, solid),
    }
    text
}

fn pov_solid(text: &mut String, solid: &Solid) {
    let (word, parts) = match solid {
        Solid::Ball(centre, radius, material) => {
            let centre = list(flipped(*centre));
            writeln!(text, "sphere {{ <{centre}>, {radius} texture {{ M{material} }} }}").unwrap();
            return;
        }
        Solid::Side(axis, sign, at, material) => {
            let mut normal = [0.0; 3];
            normal[*axis] = *sign;
            let normal = list(flipped(normal));
            writeln!(text, "plane {{ <{normal}>, {} texture {{ M{material} }} }}", at * sign).unwrap();
            return;
        }
        Solid::Union(parts) => ("union", parts),
        Solid::Intersection(parts) => ("intersection", parts),
        Solid::Difference(parts) => ("difference", parts),
    };
    writeln!(text, "{word} {{").unwrap();
    parts.iter().for_each(|part| pov_solid(text, part));
    writeln!(text, "}}").unwrap();
}

/// As lines of numbers: camera, lights, materials, balls. The ground at y = 0 is the reader's own.
pub(crate) fn numbers(model: &Model) -> String {
    let mut text = format!("{} {} {}\n", model.size.0, model.size.1, model.depth);
    let words = |values: &[f64]| values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    writeln!(
        text,
        "{}\n{}\n{}",
        words(&model.eye),
        words(&model.look_at),
        words(&AMBIENT)
    )
    .unwrap();
    writeln!(text, "{}", LIGHTS.len()).unwrap();
    for (position, colour) in LIGHTS {
        writeln!(text, "{} {}", words(&position), words(&colour)).unwrap();
    }
    writeln!(text, "{}", MATERIALS.len()).unwrap();
    for material in MATERIALS {
        writeln!(text, "{}", words(&material)).unwrap();
    }
    let Solid::Union(parts) = &model.solid else {
        return text;
    };
    let balls = parts.iter().filter_map(|part| match part {
        Solid::Ball(centre, radius, material) => Some((centre, radius, material)),
        _ => None,
    });
    writeln!(text, "{}", balls.clone().count()).unwrap();
    for (centre, radius, material) in balls {
        writeln!(text, "{} {radius} {material}", words(centre)).unwrap();
    }
    text
}

fn flipped([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, y, -z]
}

fn list(values: [f64; 3]) -> String {
    values.map(|x| x.to_string()).join(",")
}
