//! A line against the whole tree of solids.

use std::mem;

use scenec_scene::{DVec3, MaterialId, Op, Scene, SolidId, SolidKind};

use crate::list::{Edge, List, Spot};
use crate::shape::{Line, Shape};
use crate::twins::Families;

/// The solids that the submitted one is made of, operands first. Operands are named by their index here.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    nodes: Vec<Node>,
    /// For each node the last one that takes it as an operand: its list is of no use after that.
    last_use: Vec<usize>,
    /// For each light the families that it is on, and where.
    lights_on: Vec<Vec<(u32, DVec3)>>,
}

#[derive(Clone, Debug)]
enum Node {
    Leaf {
        leaf: SolidId,
        family: u32,
        shape: Shape,
        material: MaterialId,
    },
    Combine {
        op: Op,
        left: usize,
        right: usize,
    },
    Paint {
        inside: usize,
        material: MaterialId,
    },
}

impl Tree {
    /// The solids of a scene that its submitted one reaches, each once.
    pub(crate) fn new(scene: &Scene) -> Self {
        let reached = reached(scene);
        let mut families = Families::default();
        let mut index = vec![0; reached.len()];
        let (mut nodes, mut last_use) = (Vec::new(), Vec::new());
        for (number, solid) in scene.solids.iter().enumerate().take(reached.len()) {
            if !reached[number] {
                continue;
            }
            let here = nodes.len();
            index[number] = here;
            last_use.push(here);
            let mut operand = |id: SolidId| {
                let operand = index[id.index()];
                last_use[operand] = here;
                operand
            };
            nodes.push(match &solid.kind {
                SolidKind::Leaf(leaf) => {
                    let (family, shape) = families.place(leaf.base, &scene.transform(leaf));
                    Node::Leaf {
                        leaf: SolidId(number as u32),
                        family,
                        shape,
                        material: leaf.material,
                    }
                }
                &SolidKind::Combine { op, left, right } => Node::Combine {
                    op,
                    left: operand(left),
                    right: operand(right),
                },
                &SolidKind::Paint { inside, material } => Node::Paint {
                    inside: operand(inside),
                    material,
                },
            });
        }
        let lights_on = scene.lights.iter().map(|light| on(&nodes, light.position)).collect();
        Self {
            nodes,
            last_use,
            lights_on,
        }
    }

    /// The materials that leaves and paints name.
    pub(crate) fn materials(&self) -> impl Iterator<Item = MaterialId> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Leaf { material, .. } | Node::Paint { material, .. } => Some(*material),
            Node::Combine { .. } => None,
        })
    }

    /// The spot on a surface that a world point is; the first of several.
    pub(crate) fn spot(&self, point: DVec3) -> Option<Spot> {
        let (family, place) = *on(&self.nodes, point).first()?;
        Some(Spot { family, place, point })
    }

    /// What the line sees of the submitted solid.
    pub(crate) fn along(&self, line: &Line) -> List {
        let ends: &[_] = line.light.map_or(&[], |light| &self.lights_on[light]);
        let mut lists: Vec<List> = Vec::with_capacity(self.nodes.len());
        for (here, node) in self.nodes.iter().enumerate() {
            let list = match node {
                Node::Leaf {
                    leaf,
                    family,
                    shape,
                    material,
                } => leaf_list(*leaf, *family, shape, *material, line, ends),
                Node::Combine { op, left, right } => {
                    let list = List::combine(*op, &lists[*left], &lists[*right]);
                    self.forget(&mut lists, *left, here);
                    self.forget(&mut lists, *right, here);
                    list
                }
                // An outer paint comes later and overrides an inner one.
                Node::Paint { inside, material } => {
                    let list = lists[*inside].clone().painted(*material);
                    self.forget(&mut lists, *inside, here);
                    list
                }
            };
            lists.push(list);
        }
        lists.pop().unwrap_or_default()
    }

    /// Lets go of an operand's list if this was its last use, so that deep trees hold few lists at a time.
    fn forget(&self, lists: &mut [List], operand: usize, here: usize) {
        if self.last_use[operand] == here {
            mem::take(&mut lists[operand]);
        }
    }
}

/// Which of the solids up to the submitted one it is made of. Operands stand before what takes them, so one backward
/// pass finds them all.
fn reached(scene: &Scene) -> Vec<bool> {
    let mut reached = vec![false; scene.root.index() + 1];
    reached[scene.root.index()] = true;
    for number in (0..reached.len()).rev() {
        if !reached[number] {
            continue;
        }
        match scene.solids[number].kind {
            SolidKind::Leaf(_) => {}
            SolidKind::Combine { left, right, .. } => {
                reached[left.index()] = true;
                reached[right.index()] = true;
            }
            SolidKind::Paint { inside, .. } => reached[inside.index()] = true,
        }
    }
    reached
}

/// The families whose surface a point is on, each once, with its place there.
fn on(nodes: &[Node], point: DVec3) -> Vec<(u32, DVec3)> {
    let mut families: Vec<(u32, DVec3)> = Vec::new();
    for node in nodes {
        if let Node::Leaf { family, shape, .. } = node
            && let Some(place) = shape.place(point)
            && families.iter().all(|(known, _)| known != family)
        {
            families.push((*family, place));
        }
    }
    families
}

fn leaf_list(
    leaf: SolidId,
    family: u32,
    shape: &Shape,
    material: MaterialId,
    line: &Line,
    ends: &[(u32, DVec3)],
) -> List {
    let start = line.start.filter(|start| start.family == family);
    let end = ends.iter().find(|(on, _)| *on == family).map(|(_, place)| *place);
    let (before, crossings) = shape.cross(line, start.map(|start| start.place), end);
    let edge = |(t, place)| Edge {
        t,
        leaf,
        material,
        normal: shape.normal(place),
        spot: Spot {
            family,
            place,
            point: shape.point(place),
        },
    };
    let edges: Vec<_> = crossings.into_iter().map(edge).collect();
    let behind = edges.iter().rfind(|edge| edge.t <= 0.0 && start.is_none());
    List {
        before,
        behind: behind.copied(),
        edges,
    }
}
