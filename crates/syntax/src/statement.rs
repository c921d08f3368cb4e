//! What a line says, as plain data: spans instead of words, so that a large file stays small in memory.

use scenec_text::Span;

use crate::{Form, Space};

/// A line that is not blank.
#[derive(Clone, PartialEq, Debug)]
pub struct Line {
    /// From the first token to the last, without the comment; empty, at the comment's start, where there is no other.
    pub span: Span,
    /// What it says.
    pub content: Content,
    /// The comment from its slash to the last character of the line, if there is one.
    pub comment: Option<Span>,
}

impl Line {
    /// The same line so many bytes further on, or, counted modulo 2^32, further back.
    #[must_use]
    pub(crate) fn moved(&self, by: u32) -> Self {
        let mut moved = self.clone();
        let shift = |span: &mut Span| *span = span.moved(by);
        shift(&mut moved.span);
        moved.comment.iter_mut().for_each(shift);
        match &mut moved.content {
            Content::Comment => {}
            Content::Statement(statement) => statement.spans(shift),
            Content::Broken(broken) => broken.name.iter_mut().chain(&mut broken.mentions).for_each(shift),
        }
        moved
    }
}

/// What a line says.
#[derive(Clone, PartialEq, Debug)]
pub enum Content {
    /// Nothing: it holds a comment alone.
    Comment,
    /// A statement.
    Statement(Statement),
    /// Something that fits no statement, which has been reported.
    Broken(Box<Broken>),
}

/// What could be made out of a line that fits no statement.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Broken {
    /// The name space of the name that it begins with.
    pub space: Option<Space>,
    /// The name that it begins with, without the sigil.
    pub name: Option<Span>,
    /// The kind of statement, where its operator was there; [`Form::Object`] for a definition whose right side is bad.
    pub form: Option<Form>,
    /// Every other name on the line: it may have meant to use them.
    pub mentions: Vec<Span>,
}

/// A statement. Every name's span is the word without its sigil.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// `x := v`
    Variable {
        /// The variable.
        name: Span,
        /// What it is bound to.
        value: Value,
    },
    /// `!x := sphere`
    Object {
        /// The new object.
        name: Span,
        /// The word for the base object, not yet known to be one.
        base: Span,
    },
    /// `!z := x | y`
    Combination {
        /// The new object.
        name: Span,
        /// How the two combine.
        operator: Operator,
        /// The first operand.
        left: Span,
        /// The second operand.
        right: Span,
    },
    /// `!x ?= m`
    MaterialSet {
        /// The object.
        name: Span,
        /// The material.
        material: Span,
    },
    /// `!x *= a b c`
    Scale {
        /// The object.
        name: Span,
        /// The factors along x, y, z.
        by: [Value; 3],
    },
    /// `!x #y= v`
    Rotate {
        /// The object.
        name: Span,
        /// About which axis.
        axis: Axis,
        /// The angle in radians.
        angle: Value,
    },
    /// `!x += a b c`
    Translate {
        /// The object.
        name: Span,
        /// How far along x, y, z.
        by: [Value; 3],
    },
    /// `!x <=`
    Submit {
        /// The object.
        name: Span,
    },
    /// `*x := a b c r g b`
    Light {
        /// The light.
        name: Span,
        /// Place and colour.
        values: Box<[Value; 6]>,
    },
    /// `?x := ambref diffref specref rflec rfrac rfracind shiny r g b`
    Material {
        /// The material.
        name: Span,
        /// The ten values in the order of the form.
        values: Box<[Value; 10]>,
    },
}

impl Statement {
    /// Which kind of statement it is.
    #[must_use]
    pub const fn form(&self) -> Form {
        match self {
            Self::Variable { .. } => Form::Variable,
            Self::Object { .. } => Form::Object,
            Self::Combination { .. } => Form::Combination,
            Self::MaterialSet { .. } => Form::MaterialSet,
            Self::Scale { .. } => Form::Scale,
            Self::Rotate { .. } => Form::Rotate,
            Self::Translate { .. } => Form::Translate,
            Self::Submit { .. } => Form::Submit,
            Self::Light { .. } => Form::Light,
            Self::Material { .. } => Form::Material,
        }
    }

    /// The name that it begins with, without the sigil.
    #[must_use]
    pub const fn name(&self) -> Span {
        match self {
            Self::Variable { name, .. }
            | Self::Object { name, .. }
            | Self::Combination { name, .. }
            | Self::MaterialSet { name, .. }
            | Self::Scale { name, .. }
            | Self::Rotate { name, .. }
            | Self::Translate { name, .. }
            | Self::Submit { name }
            | Self::Light { name, .. }
            | Self::Material { name, .. } => *name,
        }
    }

    /// Calls `visit` with every place in it.
    fn spans(&mut self, mut visit: impl FnMut(&mut Span)) {
        let (names, values): ([Option<&mut Span>; 3], &mut [Value]) = match self {
            Self::Variable { name, value } => ([Some(name), None, None], std::slice::from_mut(value)),
            Self::Rotate { name, angle, .. } => ([Some(name), None, None], std::slice::from_mut(angle)),
            Self::Scale { name, by } | Self::Translate { name, by } => ([Some(name), None, None], by),
            Self::Light { name, values } => ([Some(name), None, None], values.as_mut_slice()),
            Self::Material { name, values } => ([Some(name), None, None], values.as_mut_slice()),
            Self::Object { name, base } => ([Some(name), Some(base), None], &mut []),
            Self::MaterialSet { name, material } => ([Some(name), Some(material), None], &mut []),
            Self::Combination { name, left, right, .. } => ([Some(name), Some(left), Some(right)], &mut []),
            Self::Submit { name } => ([Some(name), None, None], &mut []),
        };
        names.into_iter().flatten().for_each(&mut visit);
        for value in values {
            visit(&mut value.span);
            if let ValueKind::Name(name) = &mut value.kind {
                visit(name);
            }
        }
    }

    /// Its values, in order; empty where it takes names instead.
    #[must_use]
    pub fn values(&self) -> &[Value] {
        match self {
            Self::Variable { value, .. } | Self::Rotate { angle: value, .. } => std::slice::from_ref(value),
            Self::Scale { by, .. } | Self::Translate { by, .. } => by.as_slice(),
            Self::Light { values, .. } => values.as_slice(),
            Self::Material { values, .. } => values.as_slice(),
            Self::Object { .. } | Self::Combination { .. } | Self::MaterialSet { .. } | Self::Submit { .. } => &[],
        }
    }
}

/// How two objects combine.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Operator {
    /// `|`
    Union,
    /// `&`
    Intersection,
    /// `-`
    Subtraction,
}

/// A world axis.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Axis {
    /// `#x=`
    X,
    /// `#y=`
    Y,
    /// `#z=`
    Z,
}

/// The sign in front of a value.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Sign {
    /// `+`
    Plus,
    /// `-`
    Minus,
}

/// A value: a number, `pi` or a variable, with or without a sign.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Value {
    /// The sign, if one is written.
    pub sign: Option<Sign>,
    /// What follows it.
    pub kind: ValueKind,
    /// The whole value, its sign included.
    pub span: Span,
}

/// What a value is, its sign left aside.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ValueKind {
    /// A number as written; finite.
    Number(f64),
    /// The constant.
    Pi,
    /// The name of a variable.
    Name(Span),
}

impl Value {
    /// In the place of one that has not been read.
    pub(crate) const NOTHING: Self = Self {
        sign: None,
        kind: ValueKind::Pi,
        span: Span::at(0),
    };

    /// `number` with this value's sign.
    #[must_use]
    pub fn signed(self, number: f64) -> f64 {
        if self.sign == Some(Sign::Minus) {
            -number
        } else {
            number
        }
    }
}
