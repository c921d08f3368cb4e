//! The editor's generated files: the TextMate grammar, the snippets and the list of picture formats of the VS Code
//! extension say what the project's tables say. `SCENEC_BLESS=1` writes them anew.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::fs;

use scenec_picture::Format;
use scenec_scene::{Base, SETTINGS};
use scenec_syntax::{FORMS, Form, FormInfo, Space};
use scenec_tests::root;
use serde_json::{Map, Value, json};

/// A name, in the words of the regular expressions of TextMate.
const NAME: &str = r"[\p{XID_Start}_]\p{XID_Continue}*";
/// What may not follow a word.
const END: &str = r"(?!\p{XID_Continue})";

/// The words that may stand where a form's example has this one: those which the form's meaning lists beside it.
fn alternatives(row: &FormInfo, word: &'static str) -> Vec<&'static str> {
    let listed: Vec<_> = row.meaning.split('`').skip(1).step_by(2).collect();
    if listed.contains(&word) { listed } else { vec![word] }
}

/// One of these words, as a regular expression.
fn any_of<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let escape = |word: &str| -> String {
        let special = |c: char| "|*+?.^$()[]{}\\".contains(c);
        word.chars()
            .flat_map(|c| special(c).then_some('\\').into_iter().chain([c]))
            .collect()
    };
    let words: Vec<_> = words.into_iter().map(escape).collect();
    format!("(?:{})", words.join("|"))
}

/// The name of a form in scopes and snippets: `material-set`.
fn slug(form: Form) -> String {
    form.name().replace(' ', "-")
}

/// The words of a form's example behind its name and its operator.
fn tail(row: &FormInfo) -> impl Iterator<Item = &'static str> {
    row.text.split(' ').skip(2)
}

fn operator(row: &FormInfo) -> &'static str {
    row.text.split(' ').nth(1).unwrap()
}

/// What colours the words behind the operator.
fn tail_patterns(row: &FormInfo) -> Vec<Value> {
    if !row.fields.is_empty() {
        return vec![json!({"include": "#values"})];
    }
    let mut patterns = Vec::new();
    for word in tail(row) {
        let choices = alternatives(row, word);
        if Base::ALL.iter().any(|(_, base)| *base == word) {
            patterns.push(json!({"include": "#bases"}));
        } else if choices.len() > 1 {
            patterns.push(json!({
                "name": format!("keyword.operator.{}.scene", slug(row.form)),
                "match": any_of(choices),
            }));
        } else {
            let space = if row.form == Form::MaterialSet {
                Space::Material
            } else {
                Space::Object
            };
            let pattern = json!({"include": format!("#{}", space.noun())});
            if !patterns.contains(&pattern) {
                patterns.push(pattern);
            }
        }
    }
    patterns
}

/// A rule for the statements with this name space and operator.
fn statement(rows: &[&FormInfo]) -> Value {
    let row = rows[0];
    let sigil = row.space.sigil();
    let operators = any_of(alternatives(row, operator(row)));
    let head = format!(r"^\s*({})\s*({NAME})\s*({operators})", any_of([sigil]));
    let mut patterns: Vec<_> = rows.iter().flat_map(|row| tail_patterns(row)).collect();
    patterns.push(json!({"name": "invalid.illegal.scene", "match": r"[^\s/]"}));
    json!({
        "name": format!("meta.statement.{}.scene", slug(row.form)),
        "begin": head,
        "beginCaptures": {
            "1": {"name": format!("punctuation.definition.{}.scene", row.space.noun())},
            "2": {"patterns": [{"include": format!("#{}", row.space.noun())}]},
            "3": {"name": format!("keyword.operator.{}.scene", slug(row.form))},
        },
        "end": "(?=/)|$",
        "patterns": patterns,
    })
}

/// The statements, those that begin alike in one rule.
fn statements() -> Vec<Value> {
    let mut groups: Vec<Vec<&FormInfo>> = Vec::new();
    for row in FORMS {
        let alike = |group: &&mut Vec<&FormInfo>| group[0].space == row.space && operator(group[0]) == operator(row);
        match groups.iter_mut().find(alike) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    groups.iter().map(|group| statement(group)).collect()
}

/// How a name of this space is called in TextMate's customary scopes: those that editors give to the kinds of words that
/// the server names, so that nothing changes its colour when the server is there.
const fn scope(space: Space) -> &'static str {
    match space {
        Space::Variable => "variable.other.scene",
        Space::Object => "entity.name.type.class.object.scene",
        Space::Material => "variable.other.enummember.material.scene",
        Space::Light => "entity.name.function.light.scene",
    }
}

fn named(name: &str, pattern: &str) -> Value {
    json!({"name": name, "match": pattern})
}

fn grammar() -> Value {
    let mut repository = Map::new();
    repository.insert("comment".into(), named("comment.line.slash.scene", "/.*$"));
    for space in Space::ALL {
        let pattern = if space == Space::Variable {
            let names = SETTINGS.iter().flat_map(|row| [Some(row.name), row.alias]).flatten();
            let settings = named("variable.other.property.setting.scene", &(any_of(names) + END));
            json!({"patterns": [{"include": "#constant"}, settings, named(scope(space), NAME)]})
        } else {
            named(scope(space), NAME)
        };
        repository.insert(space.noun().into(), pattern);
    }
    let bases = any_of(Base::ALL.iter().map(|(_, word)| *word));
    repository.insert("bases".into(), named("keyword.control.base.scene", &(bases + END)));
    repository.insert(
        "constant".into(),
        named("constant.language.pi.scene", &format!("pi{END}")),
    );
    repository.insert(
        "values".into(),
        json!({"patterns": [
            named(
                "constant.numeric.scene",
                r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![.\p{XID_Continue}])",
            ),
            named("invalid.illegal.number.scene", r"[0-9.](?:[eE][+-]|[.\p{XID_Continue}])*"),
            named("keyword.operator.sign.scene", "[+-]"),
            {"include": "#variable"},
        ]}),
    );
    let mut patterns = vec![json!({"include": "#comment"})];
    patterns.extend(statements());
    json!({
        "name": "Scene",
        "scopeName": "source.scene",
        "patterns": patterns,
        "repository": repository,
    })
}

/// The example of a form with a stop at each of its parts.
fn body(row: &FormInfo) -> String {
    let mut stops = 0..;
    let mut stop = |choices: &[&str], word: &str| {
        let number = stops.next().unwrap() + 1;
        if choices.len() > 1 {
            let choices: Vec<_> = choices.iter().map(|word| word.replace('|', "\\|")).collect();
            format!("${{{number}|{}|}}", choices.join(","))
        } else {
            format!("${{{number}:{word}}}")
        }
    };
    let words = row.text.split(' ').enumerate().map(|(index, word)| {
        let choices = alternatives(row, word);
        match index {
            0 => format!(
                "{}{}",
                row.space.sigil(),
                stop(&[], word.trim_start_matches(row.space.sigil()))
            ),
            1 if choices.len() == 1 => word.to_owned(),
            _ => stop(&choices, word),
        }
    });
    words.collect::<Vec<_>>().join(" ")
}

/// The settings that have no default, with a stop at each value.
fn settings_body() -> Vec<String> {
    let required = SETTINGS.iter().filter(|row| row.default.is_none());
    let lines = required.enumerate();
    lines
        .map(|(index, row)| format!("{} := ${{{}:{}}}", row.name, index + 1, row.usual))
        .collect()
}

fn snippets() -> Value {
    let mut snippets = Map::new();
    for row in FORMS {
        snippets.insert(
            row.form.name().to_owned(),
            json!({"prefix": slug(row.form), "body": body(row), "description": row.meaning.replace('`', "")}),
        );
    }
    snippets.insert(
        "settings".into(),
        json!({
            "prefix": "settings",
            "body": settings_body(),
            "description": "the settings that every file has to have",
        }),
    );
    Value::Object(snippets)
}

/// What a dialogue for saving a picture offers: formats by name, each with its extensions.
fn formats() -> Value {
    let rows = Format::all().map(|format| (format.name().to_uppercase(), json!(format.extensions())));
    Value::Object(rows.collect())
}

/// Holds a generated file to its content.
fn check(path: &str, content: &Value) {
    let path = root().join("editors/vscode").join(path);
    let expect = format!("{}\n", serde_json::to_string_pretty(content).unwrap());
    if std::env::var_os("SCENEC_BLESS").is_some() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, &expect).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == expect,
        "{} is stale: run this test with SCENEC_BLESS=1",
        path.display()
    );
}

#[test]
fn the_grammar_is_fresh() {
    check("syntaxes/scene.tmLanguage.json", &grammar());
}

#[test]
fn the_snippets_are_fresh() {
    check("snippets/scene.json", &snippets());
}

#[test]
fn the_formats_are_fresh() {
    check("src/commands/formats.json", &formats());
}
