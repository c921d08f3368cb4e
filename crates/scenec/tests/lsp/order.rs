//! Many messages at once: order is kept, nothing queues up, and nobody waits for ever.

use serde_json::json;

use crate::client::Client;

const URI: &str = "file:///a.scene";

#[test]
fn a_burst_of_edits_is_taken_over_in_order() {
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}}}));
    client.open(URI, "/ \n");
    for number in 0..3000 {
        let place = json!({"line": 0, "character": 2});
        let text = char::from(b'a' + (number % 26) as u8).to_string();
        client.change(
            URI,
            number + 2,
            json!([{"range": {"start": place, "end": place}, "text": text}]),
        );
    }
    let line =
        |from: u32, to: u32| json!({"start": {"line": 0, "character": from}, "end": {"line": 0, "character": to}});
    // What was typed last stands first: ...dcba. What is left of it after this is an error at a known place.
    client.change(
        URI,
        4000,
        json!([{"range": line(3, 3002), "text": ""}, {"range": line(0, 2), "text": ""}]),
    );
    let found = client.findings(URI);
    assert_eq!(found[0]["range"]["start"], json!({"line": 0, "character": 0}));
    client.farewell();
}

#[test]
fn what_is_sent_last_is_of_the_last_edit() {
    let mut client = Client::greeted(json!({}));
    client.open(URI, "");
    for version in 2..500 {
        let text = if version % 2 == 0 { "5\n" } else { "/\n" };
        client.change(URI, version, json!([{"text": text}]));
    }
    let mut last = 0;
    while last < 499 {
        let sent = client.notification("textDocument/publishDiagnostics");
        let version = sent["version"].as_i64().unwrap();
        assert!(version >= last, "{version} after {last}");
        let broken = sent["diagnostics"]
            .as_array()
            .unwrap()
            .iter()
            .any(|one| one["code"] == "E005");
        assert_eq!(broken, version % 2 == 0, "version {version}");
        last = version;
    }
    client.farewell();
}

#[test]
fn many_questions_with_edits_between_are_all_answered() {
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}}, "workspace": {"configuration": true}}));
    client.open(URI, "");
    // The client answers none of the server's questions: nothing may wait for them.
    let mut asked = Vec::new();
    for version in 2..400 {
        client.change(URI, version, json!([{"text": "5\n".repeat(version as usize)}]));
        client.notify("workspace/didChangeConfiguration", json!({"settings": null}));
        asked.push(client.ask("textDocument/diagnostic", json!({"textDocument": {"uri": URI}})));
    }
    for id in asked {
        assert!(client.answer(id).is_ok());
    }
    assert_eq!(
        client
            .findings(URI)
            .as_array()
            .unwrap()
            .iter()
            .filter(|one| one["code"] == "E005")
            .count(),
        399
    );
    client.farewell();
}

#[test]
fn a_cancelled_request_is_answered_as_such_or_as_asked() {
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}}}));
    client.open(URI, &"?m := 1 2 3\n".repeat(40_000));
    let asked = client.ask("textDocument/diagnostic", json!({"textDocument": {"uri": URI}}));
    client.notify("$/cancelRequest", json!({"id": asked}));
    let refused = client.answer(asked).unwrap_err();
    assert_eq!(refused["code"], -32800);
    client.notify("$/cancelRequest", json!({"id": asked}));
    client.notify("$/cancelRequest", json!({"id": "never asked"}));
    client.notify("$/unheardOf", json!({}));
    assert!(!client.findings(URI).as_array().unwrap().is_empty());
    client.farewell();
}
