//! Materials and lights.

use scenec_text::Span;

use crate::DVec3;

/// How a surface answers to light: Whitted's model (1980) over Phong's (1975).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Material {
    /// Share of the ambient light, ka.
    pub ambient: f64,
    /// Share of the diffuse light, kd.
    pub diffuse: f64,
    /// Share of the highlight, ks.
    pub specular: f64,
    /// Weight of the reflected ray, kr.
    pub reflect: f64,
    /// Weight of the refracted ray, kt.
    pub refract: f64,
    /// Index of refraction relative to the outside, n.
    pub index: f64,
    /// Exponent of the highlight, s; 0 or more.
    pub shiny: f64,
    /// Colour of the surface, C.
    pub colour: DVec3,
    /// The statement that defines it; `None` for the default material.
    pub span: Option<Span>,
}

/// What an object without a material is made of.
pub const DEFAULT_MATERIAL: Material = Material {
    ambient: 0.1,
    diffuse: 0.7,
    specular: 0.2,
    reflect: 0.0,
    refract: 0.0,
    index: 1.0,
    shiny: 16.0,
    colour: DVec3::splat(0.8),
    span: None,
};

/// A row of the table of material values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MaterialField {
    /// The name that the format's note gives the value.
    pub name: &'static str,
    /// What it means, in one phrase.
    pub meaning: &'static str,
}

const fn field(name: &'static str, meaning: &'static str) -> MaterialField {
    MaterialField { name, meaning }
}

/// The ten values of a material statement, in order.
pub const MATERIAL_FIELDS: [MaterialField; 10] = [
    field("ambref", "share of the ambient light"),
    field("diffref", "share of the diffuse light"),
    field("specref", "share of the highlight"),
    field("rflec", "weight of the reflection"),
    field("rfrac", "weight of the refraction"),
    field("rfracind", "index of refraction, 1 = air"),
    field("shiny", "exponent of the highlight"),
    field("r", "red"),
    field("g", "green"),
    field("b", "blue"),
];

impl Material {
    /// The material of the ten values of a statement, in the order of [`MATERIAL_FIELDS`].
    #[must_use]
    pub const fn from_values(values: [f64; 10], span: Span) -> Self {
        let [ambient, diffuse, specular, reflect, refract, index, shiny, r, g, b] = values;
        let colour = DVec3::new(r, g, b);
        Self {
            ambient,
            diffuse,
            specular,
            reflect,
            refract,
            index,
            shiny,
            colour,
            span: Some(span),
        }
    }

    /// The ten values of a statement that makes this material: what [`Material::from_values`] takes.
    #[must_use]
    pub const fn values(&self) -> [f64; 10] {
        let DVec3 { x: r, y: g, z: b } = self.colour;
        [
            self.ambient,
            self.diffuse,
            self.specular,
            self.reflect,
            self.refract,
            self.index,
            self.shiny,
            r,
            g,
            b,
        ]
    }
}

/// A point light; its strength does not fall with distance.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Light {
    /// Where it stands, world units.
    pub position: DVec3,
    /// Its colour, I.
    pub colour: DVec3,
    /// The statement that placed it.
    pub span: Span,
}
