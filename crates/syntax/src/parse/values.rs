//! The values at the end of a statement, and what to say when there are too few or too many.

use scenec_text::{Code, Diagnostic};

use super::line::{LineParser, Parsed, article, form_help};
use crate::token::Token;
use crate::{Form, Sign, Value, ValueKind};

impl LineParser<'_> {
    /// The N values of the form just recognised, and the end of the line.
    pub(super) fn values<const N: usize>(&mut self) -> Parsed<[Value; N]> {
        let form = self.form.unwrap_or(Form::Variable);
        let mut values = [Value::NOTHING; N];
        let mut count = 0;
        while self.cursor.peek().is_some() {
            let value = self.value(form)?;
            let Some(place) = values.get_mut(count) else {
                return Err(self.one_too_many(form, &values, value));
            };
            *place = value;
            count += 1;
        }
        match values.get(..count).filter(|found| found.len() < N) {
            Some(found) => Err(self.miscounted(form, found).into()),
            None => Ok(values),
        }
    }

    /// What to say of a line on which another value follows the last one that it takes.
    #[cold]
    fn one_too_many(&mut self, form: Form, values: &[Value], next: Value) -> Box<Diagnostic> {
        let mut found = values.to_vec();
        found.push(next);
        while self.cursor.peek().is_some() {
            match self.value(form) {
                Ok(value) => found.push(value),
                Err(finding) => return finding,
            }
        }
        self.miscounted(form, &found).into()
    }

    fn value(&mut self, form: Form) -> Parsed<Value> {
        let start = self.cursor.peek();
        let sign = match start.map(|word| word.token) {
            Some(Token::Plus) => Some(Sign::Plus),
            Some(Token::Minus) => Some(Sign::Minus),
            _ => None,
        };
        if sign.is_some() {
            self.cursor.advance();
        }
        let kind = match self.cursor.peek() {
            Some(word) if word.token == Token::Number => ValueKind::Number(word.number),
            Some(word) if word.token == Token::Name && self.cursor.word(word.span) == "pi" => ValueKind::Pi,
            Some(word) if word.token == Token::Name => ValueKind::Name(word.span),
            _ => {
                return Err(self.cursor.unexpected("a number, `pi` or a variable", form_help(form)));
            }
        };
        self.cursor.advance();
        let end = self.cursor.before();
        Ok(Value {
            sign,
            kind,
            span: start.map_or(end, |word| word.span.to(end)),
        })
    }

    fn miscounted(&self, form: Form, found: &[Value]) -> Diagnostic {
        let fields = form.info().fields;
        let counts = format!(
            "{} {} takes {} {}, found {}",
            article(form.info().space),
            noun(form),
            fields.len(),
            if fields.len() == 1 { "value" } else { "values" },
            found.len()
        );
        if let Some(missing) = fields.get(found.len()..).filter(|missing| !missing.is_empty()) {
            let missing = missing.join(" ");
            let label = format!("missing after this: {missing}");
            return Diagnostic::new(Code::TooFewValues, counts, self.cursor.before(), label).help(form_help(form));
        }
        let extra = found.get(fields.len()..).unwrap_or_default();
        let span = match (extra.first(), extra.last()) {
            (Some(first), Some(last)) => first.span.to(last.span),
            _ => self.cursor.before(),
        };
        let mut help = form_help(form);
        if extra.iter().any(|value| value.sign.is_some()) {
            help.push_str("; there is no arithmetic: a sign begins the next value");
        }
        Diagnostic::new(Code::TooManyValues, counts, span, "left over").help(help)
    }
}

const fn noun(form: Form) -> &'static str {
    match form {
        Form::Variable => "variable",
        Form::Light => "light",
        Form::Material => "material",
        Form::Scale => "object's scale",
        Form::Rotate => "object's rotation",
        Form::Translate => "object's translation",
        _ => "object",
    }
}
