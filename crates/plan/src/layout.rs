//! What the structs that tracers share look like to the kernels' side.

use crate::wide::Child;

/// What a field is made of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FieldKind {
    /// The number that the tracer computes in: 4 or 8 bytes.
    Real,
    /// A single, whatever the tracer computes in.
    Float,
    /// 32 bits without a sign.
    Uint,
}

impl FieldKind {
    /// Bytes of one, given the bytes of the tracer's number.
    #[must_use]
    pub const fn bytes(self, real: usize) -> usize {
        match self {
            Self::Real => real,
            Self::Float | Self::Uint => 4,
        }
    }
}

/// A field: `count` of one kind, one after another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Field {
    /// Its name on both sides.
    pub name: &'static str,
    /// What it is made of.
    pub kind: FieldKind,
    /// How many; `None` for a single one that is no array.
    pub count: Option<usize>,
}

/// A struct as both sides see it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Layout {
    /// Its name on both sides.
    pub name: &'static str,
    /// Its fields in order, without padding.
    pub fields: &'static [Field],
}

impl Layout {
    /// Bytes of the struct, given the bytes of the tracer's number.
    #[must_use]
    pub const fn bytes(&self, real: usize) -> usize {
        let (mut sum, mut i) = (0, 0);
        while i < self.fields.len() {
            let field = &self.fields[i];
            let count = match field.count {
                Some(count) => count,
                None => 1,
            };
            sum += field.kind.bytes(real) * count;
            i += 1;
        }
        sum
    }
}

/// How a field's type is described.
pub(crate) trait Describe {
    const KIND: FieldKind;
    const COUNT: Option<usize> = None;
}

/// Stands for the tracer's number in a description.
pub(crate) struct Number;

impl Describe for Number {
    const KIND: FieldKind = FieldKind::Real;
}

impl Describe for f32 {
    const KIND: FieldKind = FieldKind::Float;
}

impl Describe for u32 {
    const KIND: FieldKind = FieldKind::Uint;
}

impl Describe for Child {
    const KIND: FieldKind = FieldKind::Uint;
}

impl<T: Describe, const N: usize> Describe for [T; N] {
    const KIND: FieldKind = T::KIND;
    const COUNT: Option<usize> = Some(match T::COUNT {
        Some(count) => N * count,
        None => N,
    });
}
