//! The table of statement forms: one list for the parser's help, the manual and the editor.

/// A name space. Names in different ones never meet.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Space {
    /// Plain names: numbers.
    Variable,
    /// Names after `!`.
    Object,
    /// Names after `?`.
    Material,
    /// Names after `*`.
    Light,
}

impl Space {
    /// Every name space.
    pub const ALL: [Self; 4] = [Self::Variable, Self::Object, Self::Material, Self::Light];

    /// What stands before a name where a statement begins with it; empty for a variable.
    #[must_use]
    pub const fn sigil(self) -> &'static str {
        match self {
            Self::Variable => "",
            Self::Object => "!",
            Self::Material => "?",
            Self::Light => "*",
        }
    }

    /// What such a name stands for, in one word.
    #[must_use]
    pub const fn noun(self) -> &'static str {
        match self {
            Self::Variable => "variable",
            Self::Object => "object",
            Self::Material => "material",
            Self::Light => "light",
        }
    }
}

/// A kind of statement.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Form {
    /// `x := v`
    Variable,
    /// `!x := sphere`
    Object,
    /// `!z := x | y`
    Combination,
    /// `!x ?= m`
    MaterialSet,
    /// `!x *= a b c`
    Scale,
    /// `!x #y= v`
    Rotate,
    /// `!x += a b c`
    Translate,
    /// `!x <=`
    Submit,
    /// `*x := a b c r g b`
    Light,
    /// `?x := ambref diffref ...`
    Material,
}

/// A row of the table of forms.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FormInfo {
    /// Which kind of statement.
    pub form: Form,
    /// An example with the format's own names for the parts.
    pub text: &'static str,
    /// What it does, in one phrase.
    pub meaning: &'static str,
    /// The names of its values, in order; empty where it takes names instead.
    pub fields: &'static [&'static str],
    /// The name space of the name that it begins with.
    pub space: Space,
}

const fn row(
    form: Form,
    space: Space,
    text: &'static str,
    fields: &'static [&'static str],
    meaning: &'static str,
) -> FormInfo {
    FormInfo {
        form,
        text,
        meaning,
        fields,
        space,
    }
}

/// Every form, in the order of the manual.
pub const FORMS: &[FormInfo] = &[
    row(
        Form::Variable,
        Space::Variable,
        "x := v",
        &["v"],
        "gives a variable its value",
    ),
    row(
        Form::Object,
        Space::Object,
        "!x := sphere",
        &[],
        "makes a base object: `sphere` or `hp`, the half-space under y = 0",
    ),
    row(
        Form::Combination,
        Space::Object,
        "!z := x | y",
        &[],
        "makes the union `|`, intersection `&` or subtraction `-` of two objects",
    ),
    row(
        Form::MaterialSet,
        Space::Object,
        "!x ?= m",
        &[],
        "gives an object its material",
    ),
    row(
        Form::Scale,
        Space::Object,
        "!x *= a b c",
        &["a", "b", "c"],
        "scales an object along x, y and z",
    ),
    row(
        Form::Rotate,
        Space::Object,
        "!x #y= v",
        &["v"],
        "rotates an object about an axis (`#x=`, `#y=` or `#z=`) by v radians",
    ),
    row(
        Form::Translate,
        Space::Object,
        "!x += a b c",
        &["a", "b", "c"],
        "moves an object along x, y and z",
    ),
    row(
        Form::Submit,
        Space::Object,
        "!x <=",
        &[],
        "makes an object the one that is rendered",
    ),
    row(
        Form::Light,
        Space::Light,
        "*x := a b c r g b",
        &["a", "b", "c", "r", "g", "b"],
        "places a point light at (a, b, c) with colour (r, g, b)",
    ),
    row(
        Form::Material,
        Space::Material,
        "?x := ambref diffref specref rflec rfrac rfracind shiny r g b",
        &[
            "ambref", "diffref", "specref", "rflec", "rfrac", "rfracind", "shiny", "r", "g", "b",
        ],
        "defines a material",
    ),
];

impl Form {
    /// The row of this form.
    #[must_use]
    pub const fn info(self) -> &'static FormInfo {
        // The table stands in the order of the enum; a test holds it to that.
        &FORMS[self as usize]
    }

    /// What such a statement is called, in a word or two.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Variable => "variable",
            Self::Object => "object",
            Self::Combination => "combination",
            Self::MaterialSet => "material set",
            Self::Scale => "scale",
            Self::Rotate => "rotate",
            Self::Translate => "translate",
            Self::Submit => "submit",
            Self::Light => "light",
            Self::Material => "material",
        }
    }
}

/// The forms of statements that begin with a name of this space, for a help line.
pub(crate) fn forms_of(space: Space) -> String {
    let forms: Vec<_> = FORMS
        .iter()
        .filter(|row| row.space == space)
        .map(|row| format!("`{}`", row.text))
        .collect();
    forms.join(", ")
}

#[cfg(test)]
mod tests {
    use super::FORMS;

    #[test]
    fn the_table_stands_in_the_order_of_the_enum() {
        for row in FORMS {
            assert_eq!(row.form.info(), row);
            assert!(row.text.starts_with(row.space.sigil()), "{}", row.text);
            let tail: Vec<_> = row.text.split(' ').collect();
            let tail = &tail[tail.len() - row.fields.len()..];
            assert_eq!(tail, row.fields, "{}", row.text);
        }
    }
}
