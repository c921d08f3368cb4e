//! Values: what each is called and means where it stands, and variables with the settings among them.

use std::fmt::Write;

use scenec_interpret::DefinitionId;
use scenec_scene::{SettingInfo, SettingRange, setting};
use scenec_syntax::{Form, Token};
use scenec_text::Span;

use super::{Place, Said, material};
use crate::Document;
use crate::colour::ambient_with;
use crate::fields::meaning;
use crate::look::{Shape, Spot};
use crate::settings::spoken;
use crate::words::{angle, code, degrees, figure, hex, triple};

impl Place<'_> {
    /// The value that the token is part of.
    pub(super) fn value(&self, shape: &Shape<'_>) -> Option<(Span, Said)> {
        let form = shape.form()?;
        let mut spots = shape.values().into_iter().enumerate();
        let inside = |spot: &Spot| spot.span.start <= self.piece.span.start && self.piece.span.end <= spot.span.end;
        let (number, spot) = spots.find(|(_, spot)| inside(spot))?;
        let field = form.info().fields.get(number)?;
        let is_name = spot.piece.token == Token::Name && self.document.words(spot.piece.span) != "pi";
        let value = self.amount(number, &spot);
        let mut markdown = match shape.name.filter(|_| form == Form::Variable) {
            Some(variable) => self.title(self.document.words(variable), value),
            None => format!("**{}**{}: {}", code(field), equals(value), meaning(form, number)),
        };
        if form == Form::Rotate || self.is_angle(shape) {
            markdown.push_str(&value.map_or(String::new(), in_degrees));
        }
        if is_name {
            let id = self.bound(spot.piece.span);
            let _ = write!(markdown, "\n\n{}", self.variable(spot.piece.span, id));
        }
        let mut said = Said::from(markdown);
        if form == Form::Material
            && let Some(whole) = self.own_material()
        {
            let _ = write!(said.markdown, "\n\n---\n\n{}", material::table(&whole));
            said.ball = Some(whole);
        }
        Some((spot.span, said))
    }

    /// What a value is bound to by its line, or what it is by itself where the line fits no statement.
    fn amount(&self, number: usize, spot: &Spot) -> Option<f64> {
        let statement = self.document.statement_at(self.piece.span.start);
        if let Some((statement, _)) = statement {
            return self.document.number(statement.values().get(number)?);
        }
        let word = self.document.words(spot.piece.span);
        let size = match spot.piece.token {
            Token::Number => word.parse().ok().filter(|value: &f64| value.is_finite())?,
            Token::Name if word == "pi" => std::f64::consts::PI,
            Token::Name => self.document.facts().value(self.bound(spot.piece.span)?)?,
            _ => return None,
        };
        let minus = self.document.words(spot.span).starts_with('-');
        Some(if minus { -size } else { size })
    }

    /// What the variable at a name is bound to.
    fn bound(&self, word: Span) -> Option<DefinitionId> {
        let document = self.document;
        if let Some(place) = document.occurrence(word) {
            return place.definition;
        }
        let symbol = document.symbol(scenec_syntax::Space::Variable, document.words(word))?;
        document.binding(symbol, self.look.line.start)
    }

    fn own_material(&self) -> Option<scenec_scene::Material> {
        let (_, line) = self.document.statement_at(self.piece.span.start)?;
        self.document.material(self.document.defined_by(line)?)
    }

    fn is_angle(&self, shape: &Shape<'_>) -> bool {
        let row = shape.name.and_then(|name| setting(self.document.words(name)));
        shape.form() == Some(Form::Variable) && row.is_some_and(|row| row.range == SettingRange::Angle)
    }

    /// A variable by its name.
    pub(super) fn variable(&self, name: Span, id: Option<DefinitionId>) -> String {
        let word = self.document.words(name);
        if word == "pi" {
            return "**constant** `pi` = 3.141592653589793, half a turn".to_owned();
        }
        let value = id.and_then(|id| self.document.facts().value(id));
        let mut text = self.title(word, value);
        let given = id.and_then(|id| self.document.definition_of(id));
        match given.map(|given| given.line) {
            Some(line) if self.document.source().line_of(line.start) == self.line() => {}
            Some(line) => {
                let number = self.document.line_number(line.start);
                let _ = write!(text, "\n\n{} on line {number}", code(self.document.words(line)));
            }
            None => text.push_str("\n\nNothing gives this name a value before this line."),
        }
        if let Some((id, value)) = id.zip(value)
            && setting(word).is_none()
            && self.turns(id)
        {
            text.push_str(&in_degrees(value));
        }
        text
    }

    fn line(&self) -> u32 {
        self.document.source().line_of(self.piece.span.start)
    }

    /// What a variable is and holds.
    fn title(&self, word: &str, value: Option<f64>) -> String {
        match setting(word) {
            Some(row) => described(self.document, row, word, value),
            None => format!("**variable** {}{}", code(word), equals(value)),
        }
    }

    /// Whether a rotation reads this definition.
    fn turns(&self, id: DefinitionId) -> bool {
        let uses = self.document.facts().uses(self.document, id).take(16);
        let mut forms = uses.filter_map(|place| self.document.statement_at(place.span.start));
        forms.any(|(statement, _)| statement.form() == Form::Rotate)
    }
}

/// A setting: its meaning, what it may hold, its default and its value.
fn described(document: &Document, row: &SettingInfo, word: &str, value: Option<f64>) -> String {
    let given = match row.default {
        Some(default) => format!("default {}", spoken(row, default)),
        None => "every file must give it".to_owned(),
    };
    let alias = row.alias.map_or(String::new(), |alias| {
        let other = if alias == word { row.name } else { alias };
        format!("; also written `{other}`")
    });
    let ambient = ambient_with(document, word).map_or(String::new(), |colour| {
        format!("\n\nThe ambient light is {} (`{}`).", triple(colour), hex(colour))
    });
    format!(
        "**setting** {}{}: {}\n\nHolds {}; {given}{alias}.",
        code(word),
        equals(value),
        row.meaning,
        row.range.words()
    ) + &ambient
}

fn equals(value: Option<f64>) -> String {
    value.map_or(String::new(), |value| format!(" = {}", figure(value)))
}

fn in_degrees(radians: f64) -> String {
    let (multiple, degrees) = (angle(radians), degrees(radians));
    if multiple == degrees {
        format!("\n\n{} radians = {degrees}", figure(radians))
    } else {
        format!("\n\n{} radians = {multiple} = {degrees}", figure(radians))
    }
}
