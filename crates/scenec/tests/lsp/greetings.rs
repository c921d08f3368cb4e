//! The first words: recorded ones of real editors, and what is made of them. `editors/e2e/record.ts` records them.

use serde_json::{Value, json};

use crate::client::Client;

fn offered(capabilities: Value) -> Value {
    let mut client = Client::new();
    let offered = client.greet(json!({"capabilities": capabilities}))["capabilities"].take();
    client.farewell();
    offered
}

#[test]
fn columns_are_counted_in_bytes_where_that_is_offered() {
    for (encodings, expect) in [
        (json!(null), "utf-16"),
        (json!([]), "utf-16"),
        (json!(["utf-16"]), "utf-16"),
        (json!(["utf-32", "utf-16"]), "utf-16"),
        (json!(["utf-16", "utf-8"]), "utf-8"),
        (json!(["utf-8", "utf-16", "utf-32"]), "utf-8"),
    ] {
        let offered = offered(json!({"general": {"positionEncodings": encodings}}));
        assert_eq!(offered["positionEncoding"], expect, "{encodings}");
    }
}

#[test]
fn asking_for_findings_is_offered_to_those_who_can_ask() {
    assert_eq!(offered(json!({}))["diagnosticProvider"], json!(null));
    assert!(offered(json!({"textDocument": {"diagnostic": {}}}))["diagnosticProvider"].is_object());
}

/// Replays a recorded first message, and goes once around with the editor that sent it.
fn replay(recorded: &str) -> Value {
    let mut client = Client::new();
    client.frame(recorded);
    let greeting: Value = serde_json::from_str(recorded).unwrap();
    let offered = client.answer(greeting["id"].as_i64().unwrap()).unwrap()["capabilities"].take();
    client.notify("initialized", json!({}));
    let uri = "file:///home/me/scenes/a.scene";
    client.open(uri, "!s := sphere\n!s <=\n");
    let findings = if offered["diagnosticProvider"].is_object() {
        client.findings(uri)
    } else {
        client.notification("textDocument/publishDiagnostics")["diagnostics"].take()
    };
    assert_eq!(findings[0]["code"], "E014");
    client.farewell();
    offered
}

#[test]
fn a_new_neovim_asks_for_findings_and_counts_bytes() {
    let offered = replay(include_str!("recorded/neovim-0.11.json"));
    assert_eq!(offered["positionEncoding"], "utf-8");
    assert_eq!(offered["diagnosticProvider"]["interFileDependencies"], false);
}

#[test]
fn an_old_neovim_is_sent_findings() {
    let offered = replay(include_str!("recorded/neovim-0.7.json"));
    assert_eq!(offered["diagnosticProvider"], json!(null));
    assert_eq!(offered["positionEncoding"], "utf-16");
    assert_eq!(offered["renameProvider"], json!({"prepareProvider": true}));
}

#[test]
fn visual_studio_code_asks_for_findings() {
    let offered = replay(include_str!("recorded/visual-studio-code.json"));
    assert_eq!(offered["positionEncoding"], "utf-16");
    assert_eq!(offered["diagnosticProvider"]["interFileDependencies"], false);
    insta::assert_snapshot!(serde_json::to_string_pretty(&offered).unwrap());
}

/// Whether lenses are shown.
fn lenses(client: &mut Client) -> bool {
    let uri = "file:///a.scene";
    client.open(uri, "!s := sphere\n!s <=\n");
    let found = client
        .request("textDocument/codeLens", json!({"textDocument": {"uri": uri}}))
        .unwrap();
    !found.as_array().unwrap().is_empty()
}

#[test]
fn settings_come_with_the_greeting_by_notification_and_as_an_answer() {
    let mut client = Client::new();
    let capabilities = json!({
        "workspace": {"configuration": true, "codeLens": {"refreshSupport": true}},
        "experimental": {"scenec": {"commands": true}},
    });
    client.greet(json!({"capabilities": capabilities, "initializationOptions": {"lens": false, "ball": "yes"}}));
    assert!(!lenses(&mut client));
    let question = client.question("workspace/configuration");
    assert_eq!(question["params"]["items"][0]["section"], "scenec");
    client.reply(&question, json!([{"lens": true}]));
    let refresh = client.question("workspace/codeLens/refresh");
    assert!(lenses(&mut client));
    client.notify(
        "workspace/didChangeConfiguration",
        json!({"settings": {"scenec": {"lens": false}}}),
    );
    assert!(!lenses(&mut client));
    client.notify("workspace/didChangeConfiguration", json!({"settings": null}));
    let question = client.question("workspace/configuration");
    client.reply(&refresh, json!(null));
    client.reply(&question, json!([{}]));
    // The answer to the first refresh came late; the second one is asked for all the same.
    client.question("workspace/codeLens/refresh");
    client.question("workspace/codeLens/refresh");
    assert!(lenses(&mut client));
    client.farewell();
}
