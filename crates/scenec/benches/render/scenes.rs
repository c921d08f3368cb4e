//! The scenes of the benchmark: what they hold, nothing about how it is written or traced.

/// A solid, made of few kinds of parts so that every peer can be told it in its own words.
#[derive(Clone, Debug)]
pub(crate) enum Solid {
    /// Centre, radius, number of the material.
    Ball([f64; 3], f64, usize),
    /// What lies behind a plane: the axis of its outward normal, the normal's sign, where it cuts the axis, the material.
    Side(usize, f64, f64, usize),
    Union(Vec<Solid>),
    Intersection(Vec<Solid>),
    /// The first without all others.
    Difference(Vec<Solid>),
}

/// A picture to be made.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    pub(crate) size: (u32, u32),
    pub(crate) depth: u32,
    pub(crate) eye: [f64; 3],
    pub(crate) look_at: [f64; 3],
    pub(crate) solid: Solid,
    /// Whether it is nothing but balls over a plane, which Embree can be told.
    pub(crate) balls: bool,
    /// Whether every round measures the slow peers too, or the first alone.
    pub(crate) quick: bool,
}

/// Two lights for all, positions and colours.
pub(crate) const LIGHTS: [([f64; 3], [f64; 3]); 2] = [([8.0, 30.0, 25.0], [0.7; 3]), ([-25.0, 20.0, 10.0], [0.4; 3])];

/// Ambient light for all.
pub(crate) const AMBIENT: [f64; 3] = [0.2, 0.3, 0.5];

/// Materials for all: the ten values of the language.
pub(crate) const MATERIALS: [[f64; 10]; 3] = [
    [0.3, 0.7, 0.0, 0.0, 0.0, 1.0, 1.0, 0.6, 0.6, 0.5],
    [0.2, 0.6, 0.3, 0.0, 0.0, 1.0, 20.0, 0.9, 0.4, 0.3],
    [0.1, 0.4, 0.4, 0.4, 0.0, 1.0, 40.0, 0.5, 0.6, 0.9],
];

const GROUND: Solid = Solid::Side(1, 1.0, 0.0, 0);

/// The scenes by their names. The seed scene is a file; see `main.rs`.
pub(crate) const NAMES: [&str; 11] = [
    "balls-1e3",
    "balls-1e5",
    "balls-1e6",
    "flake-7k",
    "flake-60k",
    "lens",
    "dice",
    "cheese",
    "tree-64",
    "tree-1e4",
    "brute-64",
];

/// The scene of a name.
pub(crate) fn model(name: &str) -> Model {
    let field = Model {
        size: (1280, 720),
        depth: 4,
        eye: [0.0, 8.0, 24.0],
        look_at: [0.0, 4.0, 0.0],
        solid: GROUND,
        balls: true,
        quick: true,
    };
    let close = Model {
        size: (640, 360),
        eye: [1.5, 1.5, 3.0],
        look_at: [0.0; 3],
        balls: false,
        ..field.clone()
    };
    match name {
        "balls-1e3" => Model {
            solid: balls(1_000),
            ..field
        },
        "balls-1e5" => Model {
            solid: balls(100_000),
            ..field
        },
        "balls-1e6" => Model {
            solid: balls(1_000_000),
            quick: false,
            ..field
        },
        "brute-64" => Model {
            solid: balls(64),
            ..field
        },
        "flake-7k" => Model {
            solid: flake(4),
            eye: [3.0, 4.5, 5.0],
            look_at: [0.0, 2.0, 0.0],
            ..field
        },
        "flake-60k" => Model {
            solid: flake(5),
            eye: [3.0, 4.5, 5.0],
            look_at: [0.0, 2.0, 0.0],
            ..field
        },
        "lens" => Model { solid: lens(), ..close },
        "dice" => Model { solid: dice(), ..close },
        "cheese" => Model {
            solid: cheese(),
            size: (320, 180),
            ..close
        },
        "tree-64" => Model {
            solid: tree(64, 3, 1),
            eye: [0.0, 3.0, 9.0],
            ..close
        },
        "tree-1e4" => Model {
            solid: tree(10_000, 17, 1),
            size: (320, 180),
            eye: [0.0, 12.0, 30.0],
            ..close
        },
        other => panic!("{other} is no scene of the benchmark"),
    }
}

/// Numbers that look random and are the same on every machine (SplitMix64, Steele, Lea and Flood 2014).
struct Dice(u64);

impl Dice {
    /// From 0 up to 1.
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }
}

/// Balls that fill a tenth of a room over the ground, whatever their number.
fn balls(count: usize) -> Solid {
    let mut dice = Dice(count as u64);
    let volume = 24.0 * 10.0 * 24.0;
    let radius = (0.1 * volume / (count as f64 * 4.19)).cbrt();
    let mut parts = vec![GROUND];
    parts.extend((0..count).map(|i| {
        let centre = [
            dice.between(-12.0, 12.0),
            dice.between(0.5, 10.5),
            dice.between(-12.0, 12.0),
        ];
        Solid::Ball(centre, radius * dice.between(0.6, 1.3), i % 3)
    }));
    Solid::Union(parts)
}

/// A ball that carries nine smaller ones, and so on: six around its waist and three on top, seen from its parent.
fn flake(levels: u32) -> Solid {
    let mut parts = vec![GROUND];
    let mut open = vec![([0.0, 2.0, 0.0], 1.0, [0.0, 1.0, 0.0], 0)];
    while let Some((centre, radius, up, level)) = open.pop() {
        parts.push(Solid::Ball(centre, radius, 1 + level as usize % 2));
        if level == levels {
            continue;
        }
        let (right, ahead) = frame(up);
        for k in 0..9 {
            let (turn, rise) = if k < 6 {
                (f64::from(k) / 6.0, 0.0)
            } else {
                (f64::from(k) / 3.0 + 1.0 / 12.0, 0.94)
            };
            let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
            let (height, waist) = (f64::sin(rise), f64::cos(rise));
            let way: [f64; 3] = std::array::from_fn(|i| (right[i] * cos + ahead[i] * sin) * waist + up[i] * height);
            let small = radius / 3.0;
            open.push((
                std::array::from_fn(|i| centre[i] + way[i] * (radius + small)),
                small,
                way,
                level + 1,
            ));
        }
    }
    Solid::Union(parts)
}

/// Two directions square to a unit vector and to one another (Duff and others 2017).
fn frame([x, y, z]: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    ([1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y])
}

fn lens() -> Solid {
    let ball = |x| Solid::Ball([x, 0.0, 0.0], 1.6, 2);
    Solid::Union(vec![
        Solid::Intersection(vec![ball(-0.9), ball(0.9)]),
        Solid::Side(1, 1.0, -1.5, 0),
    ])
}

fn cube(half: f64, material: usize) -> Vec<Solid> {
    let side = |i: usize| {
        let sign = if i < 3 { 1.0 } else { -1.0 };
        Solid::Side(i % 3, sign, sign * half, material)
    };
    (0..6).map(side).collect()
}

fn dice() -> Solid {
    let mut sides = cube(1.0, 1);
    sides.push(Solid::Ball([0.0; 3], 1.45, 1));
    let mut parts = vec![Solid::Intersection(sides)];
    let pip = |x, y, z| Solid::Ball([x, y, z], 0.2, 0);
    parts.push(pip(0.0, 0.0, 1.05));
    for s in [-0.45, 0.45] {
        parts.extend([pip(s, 1.05, s), pip(s, 1.05, -s), pip(1.05, s, s)]);
    }
    Solid::Union(vec![Solid::Difference(parts), Solid::Side(1, 1.0, -1.0, 0)])
}

/// A box without a thousand balls.
fn cheese() -> Solid {
    let mut dice = Dice(7);
    let mut parts = vec![Solid::Intersection(cube(1.0, 1))];
    parts.extend((0..1000).map(|_| {
        let centre = std::array::from_fn(|_| dice.between(-1.0, 1.0));
        Solid::Ball(centre, dice.between(0.02, 0.12), 2)
    }));
    Solid::Union(vec![Solid::Difference(parts), Solid::Side(1, 1.0, -1.0, 0)])
}

/// A random tree over balls that stand in order along a path through a cube, so that neighbours in the tree overlap.
fn tree(leaves: usize, side: usize, seed: u64) -> Solid {
    let mut dice = Dice(seed);
    let place = |i: usize| {
        let (x, y, z) = (i % side, i / side % side, i / side / side);
        [x, y, z].map(|k| k as f64 * 1.2 - side as f64 * 0.6)
    };
    let mut parts: Vec<_> = (0..leaves)
        .map(|i| {
            let centre = place(i / 2).map(|x| x + dice.between(-0.5, 0.5));
            Solid::Ball(centre, dice.between(0.5, 0.9), i % 3)
        })
        .collect();
    while parts.len() > 1 {
        let mut pairs = parts.into_iter();
        let mut joined = Vec::new();
        while let Some(first) = pairs.next() {
            let Some(second) = pairs.next() else {
                joined.push(first);
                break;
            };
            let both = vec![first, second];
            joined.push(match dice.roll() {
                x if x < 0.15 => Solid::Intersection(both),
                x if x < 0.4 => Solid::Difference(both),
                _ => Solid::Union(both),
            });
        }
        parts = joined;
    }
    Solid::Union(parts)
}
