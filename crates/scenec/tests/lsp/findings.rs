//! Findings, asked for and sent.

use serde_json::{Value, json};

use crate::client::Client;

const URI: &str = "file:///no/such/folder/a.scene";

/// What a finding says, in short.
fn short(findings: &Value) -> Vec<String> {
    let findings = findings.as_array().unwrap().iter();
    let short = findings.map(|one| format!("{} {}", one["range"]["start"]["line"], one["code"].as_str().unwrap()));
    short.collect()
}

#[test]
fn a_client_that_asks_is_sent_nothing() {
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}}}));
    client.open(URI, "5\n");
    let params = json!({"textDocument": {"uri": URI}});
    let full = client.request("textDocument/diagnostic", params).unwrap();
    assert_eq!(full["kind"], "full");
    assert_eq!(short(&full["items"])[0], "0 E005");
    let params = json!({"textDocument": {"uri": URI}, "previousResultId": full["resultId"]});
    let same = client.request("textDocument/diagnostic", params.clone()).unwrap();
    assert_eq!(same, json!({"kind": "unchanged", "resultId": full["resultId"]}));
    client.change(URI, 2, json!([{"text": "/\n5\n"}]));
    let other = client.request("textDocument/diagnostic", params).unwrap();
    assert_eq!(short(&other["items"])[0], "1 E005");
    client.close(URI);
    client.request("shutdown", json!(null)).unwrap();
    assert_eq!(client.rest(), Vec::<Value>::new());
}

#[test]
fn a_client_that_does_not_ask_is_sent_them() {
    let mut client = Client::greeted(json!({}));
    client.open(URI, "5\n");
    let sent = client.notification("textDocument/publishDiagnostics");
    assert_eq!((&sent["uri"], &sent["version"]), (&json!(URI), &json!(1)));
    assert_eq!(short(&sent["diagnostics"])[0], "0 E005");
    client.change(URI, 2, json!([{"text": "/\n5\n"}]));
    let sent = client.notification("textDocument/publishDiagnostics");
    assert_eq!(sent["version"], 2);
    assert_eq!(short(&sent["diagnostics"])[0], "1 E005");
    client.close(URI);
    let sent = client.notification("textDocument/publishDiagnostics");
    assert_eq!(sent["diagnostics"], json!([]));
    client.farewell();
}

#[test]
fn a_finding_tells_what_the_client_can_show() {
    let text = "!s := sphere\n!s <=\n!s += 1 0 0\n";
    let code = |client: &mut Client| {
        let found = client.findings(URI);
        found
            .as_array()
            .unwrap()
            .iter()
            .find(|one| one["code"] == "W005")
            .unwrap()
            .clone()
    };
    let publish = json!({"relatedInformation": true, "tagSupport": {"valueSet": [1, 2]}});
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}, "publishDiagnostics": publish}}));
    client.open(URI, text);
    let found = code(&mut client);
    assert_eq!(found["source"], "scenec");
    assert_eq!(found["severity"], 2);
    assert_eq!(found["range"]["start"], json!({"line": 2, "character": 0}));
    assert_eq!(found["tags"], json!([1]));
    let related = &found["relatedInformation"][0]["location"];
    assert_eq!(
        (&related["uri"], &related["range"]["start"]["line"]),
        (&json!(URI), &json!(1))
    );
    client.farewell();
    let mut plain = Client::greeted(json!({"textDocument": {"diagnostic": {}}}));
    plain.open(URI, text);
    let found = code(&mut plain);
    assert_eq!(
        (&found["tags"], &found["relatedInformation"]),
        (&json!(null), &json!(null))
    );
    plain.farewell();
}

/// The link of the only finding of a text, for a client of these capabilities.
fn link(mut client: Client, text_document: Value) -> Option<String> {
    client.greet(json!({"capabilities": {"textDocument": text_document}}));
    client.open(URI, "!s := cube\n!s <=\n");
    let found = if text_document["diagnostic"].is_object() {
        client.findings(URI)
    } else {
        client.notification("textDocument/publishDiagnostics")["diagnostics"].take()
    };
    client.farewell();
    let found = found.as_array().unwrap().iter().find(|one| one["code"] == "E008");
    Some(found.unwrap()["codeDescription"]["href"].as_str()?.to_owned())
}

#[test]
fn a_code_is_a_link_to_its_page_where_the_client_can_follow_it() {
    let folder = tempfile::tempdir().unwrap();
    // Whatever is odd in the name of a folder is odd in the address of a file.
    let cache = folder.path().join("für Seiten, 100% #2");
    let wanted = json!({"codeDescriptionSupport": true});
    for ability in [
        json!({"publishDiagnostics": wanted}),
        json!({"publishDiagnostics": wanted, "diagnostic": {}}),
        json!({"diagnostic": wanted}),
    ] {
        let href = link(Client::keeping(&cache), ability).unwrap();
        let (rest, name) = href.rsplit_once('/').unwrap();
        let (rest, version) = rest.rsplit_once('/').unwrap();
        assert_eq!(
            (name, version),
            ("e008-unknown-base.md", env!("CARGO_PKG_VERSION")),
            "{href}"
        );
        assert!(rest.starts_with("file:///"), "{href}");
        assert!(rest.ends_with("/f%C3%BCr%20Seiten,%20100%25%20%232/rules"), "{href}");
        let page = std::fs::read_to_string(cache.join("rules").join(version).join(name)).unwrap();
        let explained = std::process::Command::new(env!("CARGO_BIN_EXE_scenec"))
            .args(["explain", "E008"])
            .output()
            .unwrap();
        assert_eq!(page.as_bytes(), explained.stdout);
    }
}

#[test]
fn a_code_is_no_link_where_nobody_could_follow_it() {
    let folder = tempfile::tempdir().unwrap();
    let cache = folder.path().join("cache");
    for ability in [
        json!({}),
        json!({"diagnostic": {}, "publishDiagnostics": {"codeDescriptionSupport": false}}),
    ] {
        assert_eq!(link(Client::keeping(&cache), ability), None);
    }
    assert!(!cache.exists(), "pages were written that nobody is sent to");
    let wanted = json!({"diagnostic": {}, "publishDiagnostics": {"codeDescriptionSupport": true}});
    assert_eq!(link(Client::keeping("off"), wanted.clone()), None);
    // Nothing can be put into a file, whoever asks.
    std::fs::write(&cache, "").unwrap();
    assert_eq!(link(Client::keeping(&cache), wanted), None);
}

#[test]
fn what_does_nothing_is_faded() {
    let publish = json!({"tagSupport": {"valueSet": [1, 2]}});
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}, "publishDiagnostics": publish}}));
    let text = "\
sample := 4\nt := 0.5
!s := sphere\n!s #x= t\n!s += 0 1 0\n!s ?= red\n!s += 0 far 0
?m := 0.1 0.7 0 0 0 1 1 1 0 0\n?n := 0.1 0.7 0 0 0 1 1 1 1 0\n!s ?= m\n!s ?= n
!s <=\n!s += 1 0 0\nwidth := 0\n";
    client.open(URI, text);
    let found = client.findings(URI);
    let faded = found.as_array().unwrap().iter();
    let faded = faded.map(|one| (one["code"].as_str().unwrap(), one["tags"] == json!([1])));
    let codes = |wanted: bool| {
        faded
            .clone()
            .filter(|one| one.1 == wanted)
            .map(|one| one.0)
            .collect::<Vec<_>>()
    };
    assert_eq!(codes(true), ["W009", "W015", "W003", "W004", "W016", "W005"]);
    assert_eq!(codes(false), ["E011", "E014"]);
    client.farewell();
}

#[test]
fn a_configuration_counts_and_is_watched() {
    let folder = tempfile::tempdir().unwrap();
    let configuration = folder.path().join("scenec.toml");
    std::fs::write(&configuration, "[lint]\nallow = ['W005']\n").unwrap();
    let uri = format!("file://{}/a.scene", folder.path().display());
    let mut client = Client::greeted(json!({
        "textDocument": {"diagnostic": {}},
        "workspace": {"didChangeWatchedFiles": {"dynamicRegistration": true}, "diagnostics": {"refreshSupport": true}},
    }));
    let wish = client.question("client/registerCapability");
    let watchers = &wish["params"]["registrations"][0]["registerOptions"]["watchers"];
    assert_eq!(watchers, &json!([{"globPattern": "**/scenec.toml"}]));
    client.reply(&wish, json!(null));
    client.open(&uri, "!s := sphere\n!s <=\n!s += 1 0 0\n");
    let counts = |client: &mut Client| {
        let found = client.findings(&uri);
        found
            .as_array()
            .unwrap()
            .iter()
            .find(|one| one["code"] == "W005")
            .map(|one| one["severity"].clone())
    };
    assert_eq!(counts(&mut client), None);
    std::fs::write(&configuration, "[lint]\ndeny = ['W005']\n").unwrap();
    client.notify(
        "workspace/didChangeWatchedFiles",
        json!({"changes": [{"uri": "file:///scenec.toml", "type": 2}]}),
    );
    let refresh = client.question("workspace/diagnostic/refresh");
    client.reply(&refresh, json!(null));
    assert_eq!(counts(&mut client), Some(json!(1)));
    std::fs::write(&configuration, "[lint]\ndeny = 3\n").unwrap();
    assert_eq!(counts(&mut client), Some(json!(2)));
    let told = client.notification("window/showMessage")["message"].take();
    assert!(told.as_str().unwrap().contains("scenec.toml:2:8: "), "{told}");
    client.farewell();
}

#[test]
fn more_than_anybody_reads_is_not_sent() {
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}}}));
    client.open(URI, &"x := 1 1\n".repeat(1500));
    let found = client.findings(URI);
    let found = found.as_array().unwrap();
    assert_eq!(found.len(), 1001);
    assert!(found[..1000].iter().all(|one| one["severity"] == 1));
    assert!(
        found[1000]["message"]
            .as_str()
            .unwrap()
            .ends_with("more findings are not shown")
    );
    client.farewell();
}

/// A large document in which a ball covers another one, and the line on which the first of the two is made.
fn large() -> (String, usize) {
    let comments = "/ a comment\n".repeat(10_000);
    let solids = "!a := sphere\n!b := sphere\n!b *= 0.5 0.5 0.5\n!u := a | b\n!u <=\n";
    let text = format!("{}{comments}{solids}", scenec_lint::PRELUDE);
    let first = text.lines().count() - 5;
    (text, first)
}

#[test]
fn a_client_that_asks_about_a_large_document_is_told_to_ask_again() {
    let (text, first) = large();
    let document = json!({"diagnostic": {}});
    let workspace = json!({"diagnostics": {"refreshSupport": true}});
    let mut client = Client::greeted(json!({"textDocument": document, "workspace": workspace}));
    client.open(URI, &text);
    assert_eq!(short(&client.findings(URI)), Vec::<String>::new());
    let refresh = client.question("workspace/diagnostic/refresh");
    client.reply(&refresh, json!(null));
    let covered = [format!("{} W040", first + 1)];
    assert_eq!(short(&client.findings(URI)), covered);
    client.farewell();
    // One that can't be told waits.
    let mut client = Client::greeted(json!({"textDocument": document}));
    client.open(URI, &text);
    assert_eq!(short(&client.findings(URI)), covered);
    client.farewell();
}

#[test]
fn of_a_large_document_what_takes_long_is_sent_last() {
    let (text, first) = large();
    let mut client = Client::greeted(json!({}));
    let sent = |client: &mut Client, version: i32| {
        let sent = client.notification("textDocument/publishDiagnostics");
        assert_eq!(sent["version"], version);
        short(&sent["diagnostics"])
    };
    let covered = |line: usize| vec![format!("{line} W040")];
    client.open(URI, &text);
    assert_eq!(sent(&mut client, 1), Vec::<String>::new());
    assert_eq!(sent(&mut client, 1), covered(first + 1));
    // What was known moves with its words. It is right, and so it is not sent twice.
    let top = json!({"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}});
    client.change(URI, 2, json!([{"range": top, "text": "/\n"}]));
    assert_eq!(sent(&mut client, 2), covered(first + 2));
    // Now the other ball is the larger one, and what is wrong with a statement is told at once.
    let line = first + 3;
    let scale = json!({"start": {"line": line, "character": 0}, "end": {"line": line, "character": 17}});
    client.change(URI, 3, json!([{"range": scale, "text": "!b *= 2 2 2\n!b += 0 0 0"}]));
    let idle = format!("{} W014", line + 1);
    assert_eq!(sent(&mut client, 3), [covered(first + 2)[0].clone(), idle.clone()]);
    assert_eq!(sent(&mut client, 3), [covered(first + 1)[0].clone(), idle]);
    client.farewell();
}
