//! Every feature once over one scene, as the protocol has it.

use serde_json::{Value, json};

use crate::client::Client;

const URI: &str = "file:///scenes/ball.scene";

/// A client of every ability, unless a test says otherwise.
fn able() -> Value {
    json!({
        "textDocument": {
            "diagnostic": {},
            "hover": {"contentFormat": ["markdown", "plaintext"]},
            "completion": {"completionItem": {"snippetSupport": true, "documentationFormat": ["markdown"]}},
            "signatureHelp": {"signatureInformation": {"parameterInformation": {"labelOffsetSupport": true}}},
            "definition": {"linkSupport": true},
            "documentSymbol": {"hierarchicalDocumentSymbolSupport": true},
            "codeAction": {"codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix"]}}},
            "rename": {"prepareSupport": true},
        },
        "workspace": {"workspaceEdit": {"documentChanges": true}},
        "experimental": {"scenec": {"commands": true}},
    })
}

/// An open scene and its client. Places are named by the words that stand there.
struct Scene {
    client: Client,
    text: String,
}

impl Scene {
    fn new(capabilities: Value) -> Self {
        let text = "\
/ A ball on a plate 😀
/ in red light
width := 60\nheight := 40\nraydepth := 2
eyepos_x := 0\neyepos_y := 1\neyepos_z := 5
lookat_x := 0\nlookat_y := 1\nlookat_z := 0
ambient_r := 0.2\nambient_g := 0.3\nambient_b := 0.5
ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1

?red := 0.1 0.7 0.2 0 0 1 16 0.8 0.2 0.4
*lamp := 5 5 5 1 0 0
!ball := sphere
!ball #x= 1.5707963267948966
!ball += 0 1   0
!plate := hp
!all := ball | plate
!all ?= red
!all <=
!ball += 1 0 0
";
        let mut client = Client::greeted(capabilities);
        client.open(URI, text);
        Self {
            client,
            text: text.to_owned(),
        }
    }

    /// Where some words stand.
    fn place(&self, words: &str) -> Value {
        let at = self.text.find(words).expect("the words are in the text");
        let before = &self.text[..at];
        let column = before
            .chars()
            .rev()
            .take_while(|one| *one != '\n')
            .map(char::len_utf16)
            .sum::<usize>();
        json!({"line": before.matches('\n').count(), "character": column})
    }

    /// The words in a range.
    fn words(&self, range: &Value) -> &str {
        let [from, to] = ["start", "end"].map(|end| {
            let number = |key: &str| range[end][key].as_u64().unwrap() as usize;
            let line = self
                .text
                .split_inclusive('\n')
                .take(number("line"))
                .map(str::len)
                .sum::<usize>();
            let units: Vec<u16> = self.text[line..].encode_utf16().take(number("character")).collect();
            line + String::from_utf16(&units).unwrap().len()
        });
        &self.text[from..to]
    }

    /// What a feature of the whole document says.
    fn whole(&mut self, method: &str, more: Value) -> Value {
        let mut params = json!({"textDocument": {"uri": URI}});
        params
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        self.client.request(&format!("textDocument/{method}"), params).unwrap()
    }

    /// What a feature says at the first letter of some words.
    fn at(&mut self, method: &str, words: &str, more: Value) -> Value {
        let mut params = json!({"position": self.place(words)});
        params
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        self.whole(method, params)
    }
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().expect("a list").iter()
}

#[test]
fn hover() {
    let mut scene = Scene::new(able());
    let found = scene.at("hover", "red\n!all <=", json!({}));
    assert_eq!(scene.words(&found["range"]), "red");
    assert_eq!(found["contents"]["kind"], "markdown");
    assert!(
        found["contents"]["value"].as_str().unwrap().contains("`?red`"),
        "{found}"
    );
    assert_eq!(scene.at("hover", "A ball", json!({})), json!(null));
    let mut plain = Scene::new(json!({}));
    let found = plain.at("hover", "red\n!all <=", json!({}));
    assert_eq!(found["contents"]["kind"], "plaintext");
    assert!(!found["contents"]["value"].as_str().unwrap().contains('`'), "{found}");
}

#[test]
fn completion() {
    let mut scene = Scene::new(able());
    let found = scene.at("completion", "d\n!all <=", json!({}));
    let red = list(&found)
        .find(|item| item["label"].as_str().unwrap().contains("red"))
        .expect("the material");
    assert_eq!(scene.words(&red["textEdit"]["range"]), "red");
    let snippets = |scene: &mut Scene| {
        let found = scene.at("completion", "\n?red", json!({}));
        let snippets = list(&found).filter(|item| item["insertTextFormat"] == 2).count();
        assert!(list(&found).count() > 5);
        let marked = |item: &&Value| item["textEdit"]["newText"].as_str().unwrap().contains('$');
        (
            snippets > 0,
            list(&found)
                .filter(|item| item["insertTextFormat"] != 2)
                .filter(marked)
                .count(),
        )
    };
    assert_eq!(snippets(&mut scene), (true, 0));
    assert_eq!(snippets(&mut Scene::new(json!({}))), (false, 0));
}

#[test]
fn signature_help() {
    let mut scene = Scene::new(able());
    let found = scene.at("signatureHelp", "0.8 0.2 0.4", json!({}));
    assert_eq!(found["activeParameter"], 7);
    let signature = &found["signatures"][0];
    let label = signature["label"].as_str().unwrap();
    let place = &signature["parameters"][7]["label"];
    let part = |label: &str| label[place[0].as_u64().unwrap() as usize..place[1].as_u64().unwrap() as usize].to_owned();
    let named = Scene::new(json!({})).at("signatureHelp", "0.8 0.2 0.4", json!({}));
    assert_eq!(named["signatures"][0]["parameters"][7]["label"], part(label));
}

#[test]
fn inlay_hints() {
    let mut scene = Scene::new(able());
    let range = json!({"range": {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}});
    let found = scene.whole("inlayHint", range.clone());
    let all = list(&found).count();
    assert!(
        list(&found).any(|hint| hint["position"] == scene.place("0.8 0.2 0.4")),
        "{found}"
    );
    scene.client.notify(
        "workspace/didChangeConfiguration",
        json!({"settings": {"scenec": {"hints": {"fields": false}}}}),
    );
    let found = scene.whole("inlayHint", range);
    assert!(
        list(&found).count() < all && list(&found).all(|hint| hint["kind"] != 2),
        "{found}"
    );
}

#[test]
fn colours() {
    let mut scene = Scene::new(able());
    let found = scene.whole("documentColor", json!({}));
    let words: Vec<_> = list(&found).map(|swatch| scene.words(&swatch["range"])).collect();
    assert_eq!(words, ["0.2", "0.8 0.2 0.4", "1 0 0"]);
    let picked = json!({"red": 1.0, "green": 0.0, "blue": 0.4, "alpha": 1.0});
    let offered = scene.whole(
        "colorPresentation",
        json!({"color": picked, "range": found[1]["range"]}),
    );
    assert_eq!(offered[0]["textEdit"]["newText"], "1 0 0.4");
    let offered = scene.whole(
        "colorPresentation",
        json!({"color": picked, "range": found[0]["range"]}),
    );
    assert_eq!(list(&offered[0]["additionalTextEdits"]).count(), 2);
}
