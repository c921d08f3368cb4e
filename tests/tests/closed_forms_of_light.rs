//! What colour things have in pictures, against closed forms: refraction, mirrors, shadows and highlights at every pixel,
//! worked out here without any tracer's code.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_scene::DVec3;
use scenec_tests::{check_classes, check_colours, closed_stage as stage, meets};

/// A direction turned by an angle towards another, in their common plane.
fn turned(direction: DVec3, towards: DVec3, angle: f64) -> DVec3 {
    let across = (towards - towards.dot(direction) * direction).normalize_or_zero();
    direction * angle.cos() + across * angle.sin()
}

/// What a clear ball does to a ray at incidence i: it enters at r, and turns by i - r twice; or it mirrors.
fn through_a_ball(direction: DVec3, centre: DVec3, index: f64) -> Option<DVec3> {
    let distance = meets(DVec3::ZERO, direction, centre, 1.0)?;
    let normal = direction * distance - centre;
    let sine = direction.cross(centre).length();
    let incidence = sine.asin();
    if sine.abs() > index.abs() {
        return Some(direction - 2.0 * direction.dot(normal) * normal);
    }
    let deviation = 2.0 * (incidence - (sine / index).asin());
    Some(turned(direction, centre, deviation))
}

#[test]
fn a_clear_ball_turns_each_ray_by_twice_the_difference_of_its_angles() {
    for index in [1.0_f64, 1.000_1, 1.33, 1.5, 2.0, 10.0, 0.7, 0.99, 0.0, -1.0, -1.5] {
        let text = format!(
            "ambient_r := 0\nambient_g := .3\nwidth := 81\nheight := 81\nraydepth := 2\nfov := .8\n\
             ?m := 0 0 0 0 1 {index} 1 1 1 1\n!a := sphere\n!a += .2 -.1 -3\n!a ?= m\n!a <=\n"
        );
        let centre = DVec3::new(0.2, -0.1, -3.0);
        check_colours(&stage(&text), 3e-5, 1e-9, |d| {
            // Near the rim and the critical angle a rounding of the direction is worth its root.
            let sine = d.cross(centre).length();
            let calm = [1.0, index.abs()].iter().all(|edge| (sine - edge).abs() > 0.01);
            let out = through_a_ball(d, centre, index).unwrap_or(d);
            let t = (out.y + 1.0) / 2.0;
            calm.then_some([1.0 - t, (1.0 - t) + 0.3 * t, 1.0])
        });
    }
}

#[test]
fn out_of_index_0_every_ray_leaves_along_the_normal() {
    let text = "ambient_r := 0\nambient_g := .3\nraydepth := 1\nfov := 2\neyepos_z := .4\n\
                ?m := 0 0 0 0 1 0 1 1 1 1\n!a := sphere\n!a ?= m\n!a <=\n";
    let eye = DVec3::Z * 0.4;
    check_colours(&stage(text), 3e-6, 1e-12, |d| {
        let along = -eye.dot(d);
        let far = along + (1.0 - eye.length_squared() + along * along).sqrt();
        let t = ((eye + d * far).y + 1.0) / 2.0;
        Some([1.0 - t, (1.0 - t) + 0.3 * t, 1.0])
    });
}

#[test]
fn a_mirror_shows_what_is_before_it_as_far_behind() {
    // A red ball above a mirror in a white room; the mirror is the plane y = -1, turned by nothing.
    let text = "raydepth := 1\nfov := 1.4\n?mirror := 0 0 0 1 0 1 1 1 1 1\n?red := 1 0 0 0 0 1 1 1 0 0\n\
                !m := hp\n!m += 0 -1 0\n!m ?= mirror\n!b := sphere\n!b *= .5 .5 .5\n!b += .4 .3 -4\n!b ?= red\n\
                !s := m | b\n!s <=\n";
    let (ball, image) = (DVec3::new(0.4, 0.3, -4.0), DVec3::new(0.4, -2.3, -4.0));
    let red = |d| [ball, image].iter().any(|c| meets(DVec3::ZERO, d, *c, 0.5).is_some());
    check_classes(text, red, |shot, x, y| shot.colour(x, y)[1] < 0.5);
}

#[test]
fn a_shadow_ends_where_the_light_grazes_the_ball() {
    // From high above: a ball of 1 at (0, 2, 0), a lamp at (5, 9, 1), a white floor. In shadow is what the lamp sees
    // within the ball's cone.
    let text = "eyepos_x := -7\neyepos_y := 14\neyepos_z := 3\nlookat_z := 0\nfov := .9\n\
                ?white := 0 1 0 0 0 1 1 1 1 1\n!f := hp\n!f ?= white\n!b := sphere\n!b += 0 2 0\n!b ?= white\n\
                !s := f | b\n!s <=\n*l := 5 9 1 1 1 1\n";
    let (eye, ball, lamp) = (DVec3::new(-7.0, 14.0, 3.0), DVec3::Y * 2.0, DVec3::new(5.0, 9.0, 1.0));
    let expect = |d: DVec3| {
        if meets(eye, d, ball, 1.0).is_some() {
            return 'b';
        }
        let point = eye - d * (eye.y / d.y);
        let cone = meets(lamp, (point - lamp).normalize(), ball, 1.0);
        if cone.is_some() { 's' } else { 'f' }
    };
    check_classes(text, expect, |shot, x, y| {
        if shot.leaf(x, y) == shot.leaf(0, 0) {
            if shot.colour(x, y)[0] == 0.0 { 's' } else { 'f' }
        } else {
            'b'
        }
    });
}

/// A lit floor at y = -1 under a lamp, with a material and a colour of ambient light.
fn lit(point: DVec3, lamp: DVec3, d: DVec3, [kd, ks, shiny]: [f64; 3]) -> f64 {
    let normal = DVec3::Y;
    let l = (lamp - point).normalize();
    let mirrored = 2.0 * normal.dot(l) * normal - l;
    let highlight = mirrored.dot(-d).clamp(0.0, 1.0).powf(shiny);
    0.1 + 0.5 * kd * normal.dot(l).max(0.0) * 0.8 + ks * highlight * 0.8
}

#[test]
fn surfaces_are_lit_as_phong_wrote() {
    for shiny in [0.0, 0.5, 1.0, 16.0, 1e3, 1e5, 1e7] {
        // So that the highlight fills a good part of the picture, whatever its size.
        let fov = if shiny < 100.0 { 1.2 } else { 8.0 / f64::sqrt(shiny) };
        let text = format!(
            "eyepos_y := 1\neyepos_z := 2\nlookat_y := -1\nlookat_z := 0\nfov := {fov}\n*l := 0 1 -2 .8 .8 .8\n\
             ?m := .2 .6 .3 0 0 1 {shiny} .5 .5 .5\n!a := hp\n!a += 0 -1 0\n!a ?= m\n!a <=\n"
        );
        let (eye, lamp) = (DVec3::new(0.0, 1.0, 2.0), DVec3::new(0.0, 1.0, -2.0));
        let single = if shiny > 1e4 { 1.0 / 255.0 } else { 1e-5 };
        check_colours(&stage(&text), single, 1e-7, |d| {
            let point = eye - d * (2.0 / d.y);
            (d.y < -0.05).then(|| [lit(point, lamp, d, [0.6, 0.3, shiny]); 3])
        });
    }
}

#[test]
fn a_ball_is_lit_as_phong_wrote() {
    let text = "fov := .6\n*l := 4 5 1 .9 .6 .3\n?m := .1 .7 .4 0 0 1 20 .5 .8 1\n\
                !a := sphere\n!a += 0 0 -4\n!a ?= m\n!a <=\n";
    let (centre, lamp) = (DVec3::Z * -4.0, DVec3::new(4.0, 5.0, 1.0));
    check_colours(&stage(text), 1e-5, 1e-11, |d| {
        let point = d * meets(DVec3::ZERO, d, centre, 1.0)?;
        let normal = point - centre;
        let l = (lamp - point).normalize();
        let cosine = normal.dot(l);
        let mirrored = (2.0 * cosine * normal - l).dot(-d).max(0.0).powf(20.0);
        let far = d.cross(centre).length() < 0.99 && cosine.abs() > 1e-3;
        far.then(|| {
            let diffuse = [0.45, 0.48, 0.3];
            let ambient = [0.05, 0.08, 0.1];
            let lamp = [0.9, 0.6, 0.3];
            std::array::from_fn(|i| {
                let lit = 0.7 * cosine * diffuse[i] + 0.4 * lamp[i] * mirrored;
                ambient[i] + if cosine > 0.0 { lit } else { 0.0 }
            })
        })
    });
}

#[test]
fn mirrors_face_to_face_add_up_a_geometric_series() {
    for (kr, depth) in [
        (0.9, 0),
        (0.9, 1),
        (0.9, 7),
        (0.5, 64),
        (0.9, 64),
        (0.99, 1024),
        (1.0, 1024),
        (-0.5, 9),
    ] {
        let text = format!(
            "width := 9\nheight := 9\nraydepth := {depth}\nfov := 1\nlookat_y := -1\nlookat_z := -.3\n\
             ?m := .25 0 0 {kr} 0 1 1 1 1 1\n!a := hp\n!a += 0 -1 0\n!b := hp\n!b *= 1 -1 1\n!b += 0 2 0\n\
             !s := a | b\n!s ?= m\n!s <=\n"
        );
        let sum: f64 = (0..=depth).map(|i| 0.25 * f64::powi(kr, i)).sum();
        check_colours(&stage(&text), 2e-5 * sum.abs(), 1e-11 * sum.abs(), |d| {
            (d.y < -0.1).then_some([sum; 3])
        });
    }
}

#[test]
fn a_hollow_mirror_never_lets_a_ray_go() {
    // Each bounce adds the ambient share, so the sum counts them: a ray lost through the wall would see the white sky.
    for depth in [0, 1, 10, 200] {
        let text = format!(
            "raydepth := {depth}\nwidth := 15\nheight := 15\neyepos_z := .4\n?m := 1 0 0 1 0 1 1 .01 .02 .03\n\
             !a := sphere\n!a ?= m\n!a <=\n"
        );
        let bounces = f64::from(depth + 1);
        check_colours(&stage(&text), 1e-5 * bounces, 1e-12 * bounces, |_| {
            Some([0.01 * bounces, 0.02 * bounces, 0.03 * bounces])
        });
    }
}
