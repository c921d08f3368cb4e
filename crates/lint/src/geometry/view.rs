//! What the camera can't see.

use scenec_scene::{Camera, DVec3, Op, Scene, Settings, SolidKind, View, view};

use super::shape::{Ball, Half, SLACK, Shape};

/// What the camera sees: all points p with w.(p - eye) at most 0 for each of the inward walls w. It is a little wider
/// than the picture.
pub(crate) struct Frustum {
    eye: DVec3,
    /// Unit normals of the walls, each leaving the view; the last is the one behind the eye.
    walls: [DVec3; 5],
    /// The directions of the picture's corners, unit vectors.
    corners: [DVec3; 4],
}

impl Frustum {
    /// `None` where there is no view.
    pub(crate) fn of(settings: &Settings) -> Option<Self> {
        let (View::Clear(camera) | View::AlongUp(camera)) = view(settings) else {
            return None;
        };
        let Camera {
            eye,
            forward,
            right,
            up,
        } = camera;
        let wall = |side: DVec3| {
            let width = side.length();
            (side / width - forward * width).try_normalize()
        };
        let corner = |x: f64, y: f64| (forward + right * x + up * y).try_normalize();
        Some(Self {
            eye,
            walls: [wall(right)?, wall(-right)?, wall(up)?, wall(-up)?, -forward],
            corners: [
                corner(1.0, 1.0)?,
                corner(1.0, -1.0)?,
                corner(-1.0, 1.0)?,
                corner(-1.0, -1.0)?,
            ],
        })
    }

    /// Whether it is certain that no ray of the camera meets the submitted solid. Operands stand before combinations, so
    /// one pass over them suffices.
    pub(crate) fn misses(&self, scene: &Scene) -> bool {
        if self.may_meet_a_member(scene) {
            return false;
        }
        let mut missed: Vec<bool> = Vec::with_capacity(scene.root.index() + 1);
        for solid in scene.solids.iter().take(scene.root.index() + 1) {
            let at = |id: scenec_scene::SolidId| missed.get(id.index()).copied().unwrap_or_default();
            let here = match &solid.kind {
                SolidKind::Leaf(_) => Shape::of(scene, solid).is_some_and(|shape| self.misses_shape(&shape)),
                SolidKind::Paint { inside, .. } => at(*inside),
                SolidKind::Combine { op, left, right } => match op {
                    Op::Union => at(*left) && at(*right),
                    Op::Intersection => at(*left) || at(*right),
                    Op::Subtraction => at(*left),
                },
            };
            missed.push(here);
        }
        missed.last().copied().unwrap_or_default()
    }

    /// Whether one of the leaves that the submitted solid is a union of may be met. Mostly the first one that is looked at is,
    /// and nothing else has to be; where unions share members, looking ends after as many steps as there are solids.
    fn may_meet_a_member(&self, scene: &Scene) -> bool {
        let mut open = vec![scene.root];
        for _ in &scene.solids {
            let Some(id) = open.pop() else { return false };
            let solid = scene.solid(id);
            match &solid.kind {
                SolidKind::Leaf(_) => {
                    if Shape::of(scene, solid).is_none_or(|shape| !self.misses_shape(&shape)) {
                        return true;
                    }
                }
                SolidKind::Paint { inside, .. } => open.push(*inside),
                SolidKind::Combine {
                    op: Op::Union,
                    left,
                    right,
                } => open.extend([*left, *right]),
                SolidKind::Combine { .. } => {}
            }
        }
        false
    }

    fn misses_shape(&self, shape: &Shape) -> bool {
        match shape {
            Shape::Ball(ball) => self.walls.iter().any(|wall| self.is_beyond(*wall, ball)),
            Shape::Half(half) => self.looks_away(half),
        }
    }

    fn is_beyond(&self, wall: DVec3, ball: &Ball) -> bool {
        let offset = ball.centre - self.eye;
        let reach = ball.reach(wall);
        wall.dot(offset) - reach > SLACK * (offset.length() + reach)
    }

    /// From outside, a half-space is seen only by a ray that comes nearer to its plane. Every ray of the picture is a sum of
    /// its corners' with positive weights, so it is enough to look at those.
    fn looks_away(&self, half: &Half) -> bool {
        let height = half.height(self.eye);
        let outside = height > SLACK * (self.eye - half.point).length();
        outside && self.corners.iter().all(|corner| half.normal.dot(*corner) > SLACK)
    }
}
