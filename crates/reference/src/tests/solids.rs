//! Which surface a ray meets.

use scenec_scene::{Axis, Base, DVec3, MaterialId, Op, Transform};

use super::{Build, check, glow, look, scene};

const PLAIN: MaterialId = MaterialId::DEFAULT;
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];
const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];

#[test]
fn a_sphere_ends_where_the_tangent_does() {
    let mut scene = scene();
    let ball = scene.ball([0.0; 3], 1.0);
    for distance in [1.5, 10.0, 1e3, 1e5, 1e7_f64] {
        let edge = 1.0 / (distance * distance - 1.0).sqrt();
        for (turn, hit) in [(1.0 - 1e-7, true), (1.0 + 1e-7, false)] {
            for (x, y) in [(edge, 0.0), (0.0, -edge), (edge * 0.6, edge * 0.8)] {
                let (sight, _) = look(&scene, [0.0, 0.0, distance], [x * turn, y * turn, -1.0]);
                assert_eq!(sight.leaf == ball.0, hit, "{distance} {turn}");
            }
        }
    }
}

#[test]
fn a_solid_minus_itself_leaves_nothing() {
    let turned = Transform::IDENTITY.rotated(Axis::X, 0.7).rotated(Axis::Z, 2.0);
    for twin in [Transform::IDENTITY, turned] {
        let mut scene = scene();
        let a = scene.ball([0.0; 3], 1.0);
        let b = scene.leaf(Base::Sphere, twin, PLAIN);
        scene.combine(Op::Subtraction, a, b);
        for step in 0..200 {
            let x = f64::from(step) / 100.0 - 1.0;
            let direction = [x / 4.0, x * x / 5.0, -1.0];
            check(&scene, [0.0, 0.0, 5.0], direction, None, super::sky(direction));
        }
    }
}

#[test]
fn where_surfaces_coincide_the_left_one_shows() {
    let up = Transform::IDENTITY.rotated(Axis::Y, 1.0);
    for op in [Op::Union, Op::Intersection] {
        for swap in [false, true] {
            let mut scene = scene();
            let (one, two) = (glow(&mut scene, 1.0), glow(&mut scene, 2.0));
            let a = scene.leaf(Base::HalfSpace, Transform::IDENTITY, one);
            let b = scene.leaf(Base::HalfSpace, up.scaled(DVec3::splat(3.0)), two);
            let (left, right) = if swap { (b, a) } else { (a, b) };
            scene.combine(op, left, right);
            let red = if swap { 2.0 } else { 1.0 };
            check(&scene, [0.3, 1.0, 0.1], [0.1, -1.0, 0.2], Some(left), red);
        }
    }
}

#[test]
fn the_two_sides_of_a_plane_meet_without_a_seam() {
    let over = Transform::IDENTITY
        .rotated(Axis::X, std::f64::consts::PI)
        .scaled(DVec3::splat(3.0));
    for (op, direction) in [
        (Op::Union, DOWN),
        (Op::Union, AHEAD),
        (Op::Intersection, DOWN),
        (Op::Intersection, AHEAD),
    ] {
        let mut scene = scene();
        let below = scene.leaf(Base::HalfSpace, Transform::IDENTITY, PLAIN);
        let above = scene.leaf(Base::HalfSpace, over, PLAIN);
        scene.combine(op, below, above);
        check(&scene, [0.3, 0.7, 0.1], direction, None, super::sky(direction));
    }
}

#[test]
fn a_hole_shows_what_cut_it() {
    let mut scene = scene();
    let (one, two) = (glow(&mut scene, 1.0), glow(&mut scene, 2.0));
    let ground = scene.leaf(Base::HalfSpace, Transform::IDENTITY, one);
    let ball = scene.leaf(Base::Sphere, Transform::IDENTITY, two);
    scene.combine(Op::Subtraction, ground, ball);
    scene.light([0.0, 0.5, 0.0], 1.0);
    check(&scene, [0.5, 3.0, 0.0], DOWN, Some(ball), 2.0);
    check(&scene, [1.5, 3.0, 0.0], DOWN, Some(ground), 1.0);
    check(&scene, [0.0, 3.0, 0.0], [0.0, 1.0, 0.0], None, 1.0);
    // From under the ground, the crater's wall is met from inside the solid.
    check(&scene, [0.0, -3.0, 0.0], [0.0, 1.0, 0.0], Some(ball), 2.0);
}

#[test]
fn the_eye_may_be_inside() {
    let mut scene = scene();
    let one = glow(&mut scene, 1.0);
    let ball = scene.leaf(Base::Sphere, Transform::IDENTITY, one);
    check(&scene, [0.0; 3], AHEAD, Some(ball), 1.0);
    check(&scene, [0.5, 0.5, 0.5], [1.0, 1.0, 1.0], Some(ball), 1.0);
    // Two pieces of one union around the eye, and a third beyond a gap: the exit is the second piece's.
    let far = scene.ball([0.0, 0.0, -4.0], 1.0);
    let mid = scene.ball([0.0, 0.0, -1.5], 2.5);
    let union = scene.combine(Op::Union, ball, far);
    scene.combine(Op::Union, union, mid);
    let (sight, _) = look(&scene, [0.0; 3], AHEAD);
    assert_eq!(sight.leaf, far.0);
}

#[test]
fn the_outermost_paint_wins_and_reaches_only_its_own_copy() {
    let mut scene = scene();
    let [one, two, three] = [1.0, 2.0, 3.0].map(|red| glow(&mut scene, red));
    let ball = scene.leaf(Base::Sphere, Transform::IDENTITY, one);
    let hole = scene.ball([0.0, 0.0, 1.0], 0.5);
    let inner = scene.paint(ball, two);
    let cut = scene.combine(Op::Subtraction, inner, hole);
    scene.paint(cut, three);
    check(&scene, [0.0, 0.0, 5.0], AHEAD, Some(hole), 3.0);
    check(&scene, [0.8, 0.0, 5.0], AHEAD, Some(ball), 3.0);
    // The same leaf unpainted on the left, painted on the right: where they coincide, the left one shows.
    scene.combine(Op::Union, ball, inner);
    check(&scene, [0.8, 0.0, 5.0], AHEAD, Some(ball), 1.0);
    scene.combine(Op::Union, inner, ball);
    check(&scene, [0.8, 0.0, 5.0], AHEAD, Some(ball), 2.0);
}

#[test]
fn mirrored_and_flat_solids_keep_their_outside_outside() {
    for by in [[-1.0, 1.0, 1.0], [-2.0, -1.0, -1e-6], [1.0, 1.0, -1.0]] {
        let mut scene = scene();
        let transform = Transform::IDENTITY.scaled(by.into());
        let ball = scene.leaf(Base::Sphere, transform, PLAIN);
        scene.light([0.0, 0.0, 9.0], 1.0);
        let lit = 0.7 * 0.8 + 0.2;
        check(&scene, [0.0, 0.0, 9.0], AHEAD, Some(ball), lit);
    }
}

#[test]
fn a_tree_may_be_a_chain() {
    let mut scene = scene();
    let first = scene.ball([0.0; 3], 1.0);
    let mut union = first;
    for number in 1..20_000 {
        let ball = scene.ball([0.0, f64::from(number) * 3.0, 0.0], 1.0);
        union = scene.combine(Op::Union, union, ball);
    }
    let (sight, _) = look(&scene, [0.0, 0.0, 5.0], AHEAD);
    assert_eq!(sight.leaf, first.0);
}
