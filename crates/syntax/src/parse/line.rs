//! One line, one statement.

use scenec_text::{Code, Diagnostic, Span};

use super::cursor::Cursor;
use crate::forms::forms_of;
use crate::token::{Token, Word};
use crate::{Axis, Form, Operator, Space, Statement, quote};

/// Either way the parser remembers how far it came, for [`crate::Broken`].
pub(super) type Parsed<T> = Result<T, Box<Diagnostic>>;

/// The parser of one line; its fields tell what was recognised so far.
pub(crate) struct LineParser<'a> {
    pub(super) cursor: Cursor<'a>,
    pub(crate) space: Option<Space>,
    pub(crate) name: Option<Span>,
    pub(crate) form: Option<Form>,
}

impl<'a> LineParser<'a> {
    pub(crate) const fn new(text: &'a str, words: &'a [Word]) -> Self {
        Self {
            cursor: Cursor::new(text, words),
            space: None,
            name: None,
            form: None,
        }
    }

    /// The statement that the line holds, or the one report about why it holds none.
    pub(crate) fn statement(&mut self) -> Parsed<Statement> {
        let space = match self.cursor.peek().map(|word| word.token) {
            Some(Token::Name) => Space::Variable,
            Some(Token::Bang) => Space::Object,
            Some(Token::Star) => Space::Light,
            Some(Token::Question) => Space::Material,
            _ => {
                let help = "a line begins with a variable, `!` object, `?` material, `*` light or `/` comment";
                return Err(self.cursor.unexpected("a statement", help));
            }
        };
        self.space = Some(space);
        if space != Space::Variable {
            self.cursor.advance();
        }
        let name = self.subject(space)?;
        match space {
            Space::Variable => self.variable(name),
            Space::Object => self.object(name),
            Space::Light => self.light(name),
            Space::Material => self.material(name),
        }
    }

    fn subject(&mut self, space: Space) -> Parsed<Span> {
        let Some(name) = self.cursor.name() else {
            let expected = format!(
                "the name of {} {} after `{}`",
                article(space),
                space.noun(),
                space.sigil()
            );
            return Err(self.cursor.unexpected(&expected, forms_of(space)));
        };
        if space == Space::Variable && self.cursor.word(name) == "pi" {
            return Err(Diagnostic::new(
                Code::AssignedConstant,
                "`pi` is a constant and can't be assigned",
                name,
                "the constant 3.14159…",
            )
            .help("choose another name")
            .into());
        }
        self.name = Some(name);
        Ok(name)
    }

    fn variable(&mut self, name: Span) -> Parsed<Statement> {
        self.define(Form::Variable)?;
        let [value] = self.values()?;
        Ok(Statement::Variable { name, value })
    }

    fn light(&mut self, name: Span) -> Parsed<Statement> {
        self.define(Form::Light)?;
        let values = Box::new(self.values()?);
        Ok(Statement::Light { name, values })
    }

    fn material(&mut self, name: Span) -> Parsed<Statement> {
        self.define(Form::Material)?;
        let values = Box::new(self.values()?);
        Ok(Statement::Material { name, values })
    }

    fn define(&mut self, form: Form) -> Parsed<()> {
        if self.cursor.peek().map(|word| word.token) != Some(Token::Assign) {
            return Err(self.cursor.unexpected("`:=`", form_help(form)));
        }
        self.cursor.advance();
        self.form = Some(form);
        Ok(())
    }

    fn object(&mut self, name: Span) -> Parsed<Statement> {
        let form = match self.cursor.peek().map(|word| word.token) {
            Some(Token::Assign) => Form::Object,
            Some(Token::SetMaterial) => Form::MaterialSet,
            Some(Token::Scale) => Form::Scale,
            Some(Token::Translate) => Form::Translate,
            Some(Token::Submit) => Form::Submit,
            Some(Token::RotateX | Token::RotateY | Token::RotateZ) => Form::Rotate,
            _ => {
                let expected = "`:=`, `?=`, `*=`, `+=`, `#x=`, `#y=`, `#z=` or `<=`";
                return Err(self.cursor.unexpected(expected, forms_of(Space::Object)));
            }
        };
        let axis = match self.cursor.peek().map(|word| word.token) {
            Some(Token::RotateX) => Axis::X,
            Some(Token::RotateY) => Axis::Y,
            _ => Axis::Z,
        };
        self.cursor.advance();
        self.form = Some(form);
        match form {
            Form::MaterialSet => {
                let material = self.operand("the name of a material", form)?;
                self.end(form)?;
                Ok(Statement::MaterialSet { name, material })
            }
            Form::Scale => self.values().map(|by| Statement::Scale { name, by }),
            Form::Translate => self.values().map(|by| Statement::Translate { name, by }),
            Form::Rotate => self.values().map(|[angle]| Statement::Rotate { name, axis, angle }),
            Form::Submit => self.end(form).map(|()| Statement::Submit { name }),
            _ => self.definition(name),
        }
    }

    /// What follows `!x :=`.
    fn definition(&mut self, name: Span) -> Parsed<Statement> {
        let help = "`!x := sphere`, `!x := hp`, or `!z := x | y`, `!z := x & y`, `!z := x - y`";
        let Some(left) = self.cursor.name() else {
            return Err(self.cursor.unexpected("a base object or the name of an object", help));
        };
        let operator = match self.cursor.peek().map(|word| word.token) {
            None => return Ok(Statement::Object { name, base: left }),
            Some(Token::Or) => Operator::Union,
            Some(Token::And) => Operator::Intersection,
            Some(Token::Minus) => Operator::Subtraction,
            Some(_) => {
                let help = "a combination is a union `x | y`, an intersection `x & y` or a subtraction `x - y`";
                return Err(self.cursor.unexpected("`|`, `&` or `-`", help));
            }
        };
        self.cursor.advance();
        self.form = Some(Form::Combination);
        let right = self.operand("the name of an object", Form::Combination)?;
        self.end(Form::Combination)?;
        Ok(Statement::Combination {
            name,
            operator,
            left,
            right,
        })
    }

    fn operand(&mut self, expected: &str, form: Form) -> Parsed<Span> {
        match self.cursor.name() {
            Some(name) => Ok(name),
            None => Err(self.cursor.unexpected(expected, form_help(form))),
        }
    }

    fn end(&self, form: Form) -> Parsed<()> {
        let Some(rest) = self.cursor.rest() else {
            return Ok(());
        };
        let help = match form {
            Form::Combination => {
                "a combination takes two objects: combine the first two, then the result with the next".to_owned()
            }
            _ => form_help(form),
        };
        Err(Diagnostic::new(
            Code::TooManyValues,
            format!("the statement is complete before {}", quote(self.cursor.word(rest))),
            rest,
            "left over",
        )
        .help(help)
        .into())
    }
}

pub(super) fn form_help(form: Form) -> String {
    let info = form.info();
    format!("the form is `{}`: it {}", info.text, info.meaning)
}

pub(super) const fn article(space: Space) -> &'static str {
    match space {
        Space::Object => "an",
        _ => "a",
    }
}
