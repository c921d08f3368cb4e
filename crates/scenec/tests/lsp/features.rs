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

    fn edited(&self, edits: &Value) -> String {
        let mut text = self.text.clone();
        let mut edits: Vec<_> = edits.as_array().unwrap().iter().collect();
        edits.sort_by_key(|edit| self.words(&edit["range"]).as_ptr() as usize);
        for edit in edits.into_iter().rev() {
            let words = self.words(&edit["range"]);
            let start = words.as_ptr() as usize - self.text.as_ptr() as usize;
            text.replace_range(start..start + words.len(), edit["newText"].as_str().unwrap());
        }
        text
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

#[test]
fn semantic_tokens() {
    let mut scene = Scene::new(able());
    let full = scene.whole("semanticTokens/full", json!({}));
    let numbers = list(&full["data"]).count();
    assert!(numbers > 100 && numbers.is_multiple_of(5));
    let line = scene.place("!ball := sphere")["line"].as_u64().unwrap();
    let range = json!({"range": {"start": {"line": line, "character": 0}, "end": {"line": line, "character": 3}}});
    let part = scene.whole("semanticTokens/range", range);
    assert_eq!(part["data"][0], line);
    let place = json!({"line": 2, "character": 0});
    scene.client.change(
        URI,
        2,
        json!([{"range": {"start": place, "end": place}, "text": "/ more\n"}]),
    );
    let delta = scene.whole(
        "semanticTokens/full/delta",
        json!({"previousResultId": full["resultId"]}),
    );
    let edit = &delta["edits"][0];
    assert!(list(&edit["data"]).count() < 20, "{edit}");
    let renewed = scene.whole("semanticTokens/full", json!({}));
    let mut patched: Vec<Value> = list(&full["data"]).cloned().collect();
    let start = edit["start"].as_u64().unwrap() as usize;
    patched.splice(
        start..start + edit["deleteCount"].as_u64().unwrap() as usize,
        list(&edit["data"]).cloned(),
    );
    assert_eq!(json!(patched), renewed["data"]);
    let unknown = scene.whole("semanticTokens/full/delta", json!({"previousResultId": "?"}));
    assert_eq!(unknown["data"], renewed["data"]);
}

#[test]
fn names() {
    let mut scene = Scene::new(able());
    let found = scene.at("documentHighlight", "ball += 0", json!({}));
    assert!(list(&found).all(|place| scene.words(&place["range"]) == "ball"));
    assert!(list(&found).any(|place| place["kind"] == 2) && list(&found).any(|place| place["kind"] == 3));
    let found = scene.at("definition", "ball | plate", json!({}));
    assert_eq!(scene.words(&found[0]["targetRange"]), "!ball := sphere");
    assert_eq!(scene.words(&found[0]["targetSelectionRange"]), "ball");
    assert_eq!(scene.words(&found[0]["originSelectionRange"]), "ball");
    let plain = Scene::new(json!({})).at("definition", "ball | plate", json!({}));
    assert_eq!(plain, json!({"uri": URI, "range": found[0]["targetSelectionRange"]}));
    let count = |scene: &mut Scene, own: bool| {
        let found = scene.at("references", "red\n", json!({"context": {"includeDeclaration": own}}));
        list(&found)
            .map(|place| scene.words(&place["range"]).to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!((count(&mut scene, true).len(), count(&mut scene, false).len()), (2, 1));
}

#[test]
fn rename() {
    let mut scene = Scene::new(able());
    let found = scene.at("prepareRename", "ball | plate", json!({}));
    assert_eq!(
        (scene.words(&found["range"]), &found["placeholder"]),
        ("ball", &json!("ball"))
    );
    let found = scene.at("rename", "ball | plate", json!({"newName": "globe"}));
    let document = &found["documentChanges"][0];
    assert_eq!(document["textDocument"], json!({"uri": URI, "version": 1}));
    let edited = scene.edited(&document["edits"]);
    assert!(
        !edited.contains("!ball") && edited.contains("!all := globe | plate"),
        "{edited}"
    );
    let params = json!({"textDocument": {"uri": URI}, "position": scene.place("ball | plate"), "newName": "1st"});
    let refused = scene.client.request("textDocument/rename", params).unwrap_err();
    assert_eq!(refused["code"], -32803);
    assert!(refused["message"].as_str().unwrap().contains("`1st`"), "{refused}");
    let params = json!({"textDocument": {"uri": URI}, "position": scene.place("width")});
    let refused = scene.client.request("textDocument/prepareRename", params).unwrap_err();
    assert!(refused["message"].as_str().unwrap().contains("`width`"), "{refused}");
    let found = Scene::new(json!({})).at("rename", "ball | plate", json!({"newName": "globe"}));
    assert!(found["changes"][URI].is_array(), "{found}");
}

#[test]
fn symbols() {
    let mut scene = Scene::new(able());
    let tree = scene.whole("documentSymbol", json!({}));
    assert_eq!(tree[0]["name"], "!all");
    let children: Vec<_> = list(&tree[0]["children"])
        .map(|child| child["name"].as_str().unwrap())
        .collect();
    assert_eq!(children, ["!ball", "!plate"]);
    let mut plain = Scene::new(json!({}));
    let flat = plain.whole("documentSymbol", json!({}));
    let ball = list(&flat).find(|symbol| symbol["name"] == "!ball").unwrap();
    assert_eq!(
        (&ball["containerName"], &ball["location"]["uri"]),
        (&json!("!all"), &json!(URI))
    );
    let found = scene
        .client
        .request("workspace/symbol", json!({"query": "BAL"}))
        .unwrap();
    assert_eq!(found[0]["name"], "!ball");
    assert_eq!(scene.words(&found[0]["location"]["range"]), "ball");
}

#[test]
fn folds_and_selections() {
    let mut scene = Scene::new(able());
    let found = scene.whole("foldingRange", json!({}));
    assert_eq!(found[0], json!({"startLine": 0, "endLine": 1, "kind": "comment"}));
    let places = json!({"positions": [scene.place("0.7 0.2"), scene.place("width")]});
    let found = scene.whole("selectionRange", places);
    assert_eq!(list(&found).count(), 2);
    let mut range = &found[0];
    let mut before = 0;
    while range.is_object() {
        assert!(scene.words(&range["range"]).len() >= before);
        before = scene.words(&range["range"]).len();
        range = &range["parent"];
    }
    assert_eq!(before, scene.text.len());
}

#[test]
fn code_actions() {
    let mut scene = Scene::new(able());
    let place = scene.place("!ball += 1");
    let range = json!({"start": place, "end": place});
    let ask =
        |scene: &mut Scene, context: Value| scene.whole("codeAction", json!({"range": range, "context": context}));
    let found = ask(&mut scene, json!({"diagnostics": []}));
    let removal = &found[0];
    assert_eq!(
        (&removal["kind"], &removal["isPreferred"]),
        (&json!("quickfix"), &json!(true))
    );
    assert_eq!(removal["diagnostics"][0]["code"], "W005");
    let edited = scene.edited(&removal["edit"]["documentChanges"][0]["edits"]);
    assert!(!edited.contains("!ball += 1"), "{edited}");
    let found = ask(&mut scene, json!({"diagnostics": [], "only": ["source.fixAll"]}));
    assert_eq!(found[0]["kind"], "source.fixAll.scenec");
    let edited = scene.edited(&found[0]["edit"]["documentChanges"][0]["edits"]);
    assert!(!edited.contains("!ball += 1"), "{edited}");
    let found = ask(&mut scene, json!({"diagnostics": [], "only": ["refactor.extract"]}));
    assert_eq!(found, json!([]));
    let range = range.clone();
    let found = Scene::new(json!({})).whole("codeAction", json!({"range": range, "context": {"diagnostics": []}}));
    assert_eq!(found, json!([]));
}

#[test]
fn lenses() {
    let mut scene = Scene::new(able());
    let found = scene.whole("codeLens", json!({}));
    let titles = |found: &Value| {
        list(found)
            .map(|lens| lens["command"]["title"].clone())
            .collect::<Vec<_>>()
    };
    let preview = list(&found).find(|lens| lens["command"]["title"] == "preview").unwrap();
    assert_eq!(
        preview["command"],
        json!({"title": "preview", "command": "scenec.preview", "arguments": [URI]})
    );
    let uses = list(&found)
        .find(|lens| lens["command"]["title"] == "1 use")
        .expect("the use of a material");
    assert_eq!(uses["command"]["arguments"][2][0]["uri"], URI);
    let plain = Scene::new(json!({})).whole("codeLens", json!({}));
    assert!(!titles(&plain).contains(&json!("preview")) && titles(&plain).contains(&json!("1 use")));
    scene.client.notify(
        "workspace/didChangeConfiguration",
        json!({"settings": {"scenec": {"lens": false}}}),
    );
    assert_eq!(scene.whole("codeLens", json!({})), json!([]));
}

#[test]
fn formatting() {
    let options = json!({"options": {"tabSize": 4, "insertSpaces": true}});
    let mut scene = Scene::new(able());
    let found = scene.whole("formatting", options.clone());
    let edited = scene.edited(&found);
    assert!(edited.contains("!ball += 0 1 0\n"), "{edited}");
    let line = scene.place("!ball += 0")["line"].as_u64().unwrap();
    let range =
        |from: u64, to: u64| json!({"start": {"line": from, "character": 0}, "end": {"line": to, "character": 0}});
    let mut some = options.clone();
    some["range"] = range(line, line + 1);
    let found = scene.whole("rangeFormatting", some.clone());
    assert!(scene.edited(&found).contains("!ball += 0 1 0\n"));
    some["range"] = range(0, 2);
    assert_eq!(scene.whole("rangeFormatting", some), json!([]));
    let mut typed = options.clone();
    typed["ch"] = json!("\n");
    typed["position"] = json!({"line": line + 1, "character": 0});
    let found = scene.whole("onTypeFormatting", typed.clone());
    assert!(scene.edited(&found).contains("!ball += 0 1 0\n"));
    typed["position"] = json!({"line": 0, "character": 0});
    assert_eq!(scene.whole("onTypeFormatting", typed), json!(null));
    scene.client.change(URI, 2, json!([{"text": "width := 5\n6\n"}]));
    let mut params = options;
    params["textDocument"] = json!({"uri": URI});
    let refused = scene.client.request("textDocument/formatting", params).unwrap_err();
    assert_eq!(refused["message"], "line 2 fits no statement, so nothing is formatted");
}

#[test]
fn documents_that_are_not_open_have_nothing() {
    let mut client = Client::greeted(able());
    let document = json!({"uri": "file:///none.scene"});
    let place = json!({"line": 3, "character": 4_294_967_295_u32});
    for method in [
        "hover",
        "completion",
        "signatureHelp",
        "documentHighlight",
        "definition",
        "prepareRename",
    ] {
        let params = json!({"textDocument": document, "position": place});
        assert_eq!(
            client.request(&format!("textDocument/{method}"), params),
            Ok(json!(null)),
            "{method}"
        );
    }
    for method in ["documentSymbol", "foldingRange", "codeLens", "semanticTokens/full"] {
        let params = json!({"textDocument": document});
        assert_eq!(
            client.request(&format!("textDocument/{method}"), params),
            Ok(json!(null)),
            "{method}"
        );
    }
    client.farewell();
}

#[test]
fn places_outside_a_document_are_survived() {
    let mut scene = Scene::new(able());
    for place in [
        json!({"line": 4_000_000, "character": 0}),
        json!({"line": 0, "character": 4_294_967_295_u32}),
    ] {
        for method in [
            "hover",
            "completion",
            "signatureHelp",
            "documentHighlight",
            "definition",
        ] {
            scene.whole(method, json!({"position": place}));
        }
        let range = json!({"range": {"start": place, "end": {"line": 0, "character": 0}}});
        scene.whole("inlayHint", range.clone());
        scene.whole("semanticTokens/range", range);
    }
    scene.client.farewell();
}
