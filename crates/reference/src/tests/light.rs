//! What a surface sends back, and what passes it.

use scenec_scene::{Axis, Base, DVec3, Material, MaterialId, Op, Transform};

use super::{Build, CLEAR, check, glow, look, scene, sky};
use crate::shade::refracted;

const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];

/// Something through which all passes, of this index.
fn glass(index: f64) -> Material {
    Material {
        refract: 1.0,
        index,
        ..CLEAR
    }
}

#[test]
fn a_surface_answers_by_the_formula() {
    let mut scene = scene();
    scene.settings.ambient = DVec3::splat(0.5);
    scene.settings.ambient_int = DVec3::splat(0.25);
    let ball = scene.ball([0.0; 3], 1.0);
    let ambient = 0.1 * 0.8 * 0.5 * 0.25;
    for distance in [1.5, 5.0, 1e7] {
        check(&scene, [0.0, 0.0, distance], AHEAD, Some(ball), ambient);
    }
    // Straight on: both cosines are 1.
    scene.light([0.0, 0.0, 10.0], 2.0);
    let straight = ambient + 0.7 * 0.8 * 2.0 + 0.2 * 2.0;
    check(&scene, [0.0, 0.0, 5.0], AHEAD, Some(ball), straight);
    check(&scene, [0.0, 0.0, 1e7], AHEAD, Some(ball), straight);
    // 60 degrees off, to which the mirrored direction is 60 degrees off on the other side.
    scene.lights.clear();
    scene.light([3f64.sqrt(), 0.0, 2.0], 1.0);
    let slanted = ambient + 0.7 * 0.8 * 0.5 + 0.2 * 0.5f64.powi(16);
    check(&scene, [0.0, 0.0, 5.0], AHEAD, Some(ball), slanted);
    // In the surface, behind it, and in the very point: nothing.
    for position in [[5.0, 0.0, 1.0], [0.0, 0.0, 0.5], [0.0, 0.0, -9.0], [0.0, 0.0, 1.0]] {
        scene.lights.clear();
        scene.light(position, 1.0);
        check(&scene, [0.0, 0.0, 5.0], AHEAD, Some(ball), ambient);
    }
}

#[test]
fn an_exponent_of_zero_is_a_highlight_of_one() {
    let mut scene = scene();
    let material = scene.define(Material {
        specular: 0.5,
        shiny: 0.0,
        ..CLEAR
    });
    let ground = scene.leaf(Base::HalfSpace, Transform::IDENTITY, material);
    // The mirrored direction is opposite to the view, or across it: 0^0.
    for light in [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-3.0, 1e-3, 0.0]] {
        scene.lights.clear();
        scene.light(light, 1.0);
        check(&scene, [-1.0, 1.0, 0.0], [1.0, -1.0, 0.0], Some(ground), 0.5);
    }
}

#[test]
fn a_light_shows_where_nothing_stands_between() {
    let mut scene = scene();
    let ground = scene.leaf(Base::HalfSpace, Transform::IDENTITY, MaterialId::DEFAULT);
    let ball = scene.ball([0.0, 2.0, 0.0], 1.0);
    scene.combine(Op::Union, ground, ball);
    let eye = [3.0, 4.0, 0.0];
    let down = [-3.0, -4.0, 0.0];
    let lit = 0.7 * 0.8 + 0.2 * 0.8f64.powi(16);
    for (height, red) in [(9.0, 0.0), (3.5, 0.0), (1.9, 0.0), (0.9, lit)] {
        scene.lights.clear();
        scene.light([0.0, height, 0.0], 1.0);
        check(&scene, eye, down, Some(ground), red);
    }
    // A light in a closed shell lights the shell from inside and nothing outside.
    scene.lights.clear();
    scene.light([0.0, 2.0, 0.0], 1.0);
    check(&scene, [0.0, 2.0, 0.5], AHEAD, Some(ball), 0.7 * 0.8 + 0.2);
    check(&scene, [0.0, 2.0, 5.0], AHEAD, Some(ball), 0.0);
}

#[test]
fn parallel_mirrors_sum_a_geometric_series() {
    for depth in [0, 1, 2, 64, 1024] {
        let mut scene = scene();
        scene.settings.raydepth = depth;
        let dim = glow(&mut scene, 0.5);
        scene.materials[dim.index()].reflect = 0.9;
        let floor = scene.leaf(Base::HalfSpace, Transform::IDENTITY, dim);
        let over = Transform::IDENTITY
            .rotated(Axis::X, std::f64::consts::PI)
            .translated(DVec3::Y);
        let ceiling = scene.leaf(Base::HalfSpace, over, dim);
        scene.combine(Op::Union, floor, ceiling);
        let sum = 0.5 * (1.0 - 0.9f64.powi(depth as i32 + 1)) / (1.0 - 0.9);
        check(&scene, [0.0, 0.5, 0.0], [0.0, -1.0, 0.0], Some(floor), sum);
        check(&scene, [0.0, 0.5, 0.0], [0.0, 1.0, 1e-3], Some(ceiling), sum);
    }
}

#[test]
fn no_bounce_in_a_whispering_gallery_is_lost() {
    // At 50 from the origin a ball of this size has its surface to about 1e-11 of its radius; nearer is on it.
    for depth in [1e-1, 1e-3, 1e-6, 1e-9, 1e-10] {
        let mut scene = scene();
        scene.settings.raydepth = 1000;
        let bright = glow(&mut scene, 1.0);
        scene.materials[bright.index()].reflect = 1.0;
        let place = Transform::IDENTITY
            .scaled(DVec3::splat(0.01))
            .translated(DVec3::X * 50.0);
        let ball = scene.leaf(Base::Sphere, place, bright);
        check(
            &scene,
            [50.0 + 0.01 * (1.0 - depth), 0.0, 0.0],
            AHEAD,
            Some(ball),
            1001.0,
        );
    }
}

#[test]
fn a_glass_ball_turns_a_ray_by_twice_the_difference_of_the_angles() {
    for index in [0.5, 1.0, 1.5, 2.4] {
        let mut scene = scene();
        let glass = scene.define(glass(index));
        let ball = scene.leaf(Base::Sphere, Transform::IDENTITY, glass);
        for height in [0.0, 0.1, -0.5, 0.9, 0.9999_f64] {
            if height.abs() >= index {
                continue;
            }
            let turn = 2.0 * (height.asin() - (height / index).asin());
            let out = [0.0, -turn.sin(), -turn.cos()];
            check(&scene, [0.0, height, 7.0], AHEAD, Some(ball), sky(out));
            let (_, tally) = look(&scene, [0.0, height, 7.0], AHEAD);
            assert_eq!(tally.stats(1).refracted, 2);
        }
    }
}

#[test]
fn there_is_no_surface_inside_a_union() {
    let mut scene = scene();
    let glass = scene.define(glass(1.5));
    let ball = scene.leaf(Base::Sphere, Transform::IDENTITY, glass);
    let plane = scene.leaf(Base::HalfSpace, Transform::IDENTITY, glass);
    let low = scene.combine(Op::Intersection, ball, plane);
    let high = scene.combine(Op::Subtraction, ball, plane);
    scene.combine(Op::Union, low, high);
    let eye = [0.1, 5.0, 0.2];
    let (cut, tally) = look(&scene, eye, [0.0, -1.0, 0.0]);
    assert_eq!(tally.stats(1).refracted, 2);
    scene.root = ball;
    assert_eq!(cut.colour, look(&scene, eye, [0.0, -1.0, 0.0]).0.colour);
}

#[test]
fn a_prism_sends_back_what_it_cannot_let_through() {
    let mut scene = scene();
    let mut material = glass(1.5);
    material.reflect = 0.25;
    let glass = scene.define(material);
    let quarter = std::f64::consts::FRAC_PI_2;
    let id = Transform::IDENTITY;
    let [top, side, slope] = [0.0, -quarter, 1.5 * quarter].map(|angle| {
        let turned = id.rotated(Axis::Z, angle);
        let moved = if angle > quarter {
            turned.translated(DVec3::new(-1.0, -1.0, 0.0))
        } else {
            turned
        };
        scene.leaf(Base::HalfSpace, moved, glass)
    });
    let corner = scene.combine(Op::Intersection, top, side);
    scene.combine(Op::Intersection, corner, slope);
    // In through the slope, back from both faces with all of its weight, out through the slope: depth 4 and no more.
    scene.settings.raydepth = 4;
    let eye = [-3.2, -2.9, 0.0];
    let (sight, tally) = look(&scene, eye, [1.0, 1.0, 0.0]);
    let stats = tally.stats(1);
    // On the slope itself: reflected once outside, and a quarter of what comes back stays in.
    assert_eq!((sight.leaf, stats.refracted, stats.reflected), (slope.0, 2, 4));
    let back = sky([-1.0, -1.0, 0.0]);
    let red = 0.25 * back + 1.25 * 1.25 * back;
    assert!((sight.colour.x - red).abs() < 1e-12, "{} is not {red}", sight.colour.x);
}

#[test]
fn rays_bend_by_the_ratio_of_the_indices() {
    let at = |angle: f64| DVec3::new(angle.sin(), -angle.cos(), 0.0);
    let check = |angle: f64, entering: bool, index: f64, expect: Option<f64>| {
        let through = refracted(at(angle), DVec3::Y, entering, index);
        assert_eq!(through.is_some(), expect.is_some(), "{angle} {index}");
        if let (Some(through), Some(expect)) = (through, expect) {
            // Towards the critical angle the way out turns faster than the way in, without limit.
            let allowed = 1e-15 * index.abs().max(1.0) / expect.cos();
            assert!((through - at(expect)).length() < allowed, "{angle} {index}: {through}");
        }
    };
    let critical = (1.0 / 1.5_f64).asin();
    check(0.5, true, 1.5, Some((0.5f64.sin() / 1.5).asin()));
    check(0.5, false, 1.5, Some((0.5f64.sin() * 1.5).asin()));
    check(0.5, true, -1.5, Some(-(0.5f64.sin() / 1.5).asin()));
    check(1.2, true, 1.0, Some(1.2));
    check(
        critical - 1e-6,
        false,
        1.5,
        Some(((critical - 1e-6).sin() * 1.5).asin()),
    );
    check(critical + 1e-6, false, 1.5, None);
    check(0.0, true, 0.0, Some(0.0));
    check(1e-3, true, 0.0, None);
    check(1.0, false, 0.0, Some(0.0));
    check(1.0, false, 1e300, None);
    check(0.0, true, 1e300, Some(0.0));
}
