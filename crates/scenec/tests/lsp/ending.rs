//! How a server ends.

use std::process::{Command, Stdio};

use serde_json::json;

use crate::client::Client;

const EXIT: &str = r#"{"jsonrpc":"2.0","method":"exit"}"#;

#[test]
fn exit_after_shutdown_ends_with_0_while_the_client_keeps_the_stream() {
    Client::greeted(json!({})).farewell();
}

#[test]
fn exit_without_shutdown_ends_with_1() {
    let mut client = Client::greeted(json!({}));
    client.frame(EXIT);
    assert_eq!(client.exit_code(), Some(1));
    let mut unmet = Client::new();
    unmet.frame(r#"{"jsonrpc":"2.0","method":"exit","params":null}"#);
    assert_eq!(unmet.exit_code(), Some(1));
}

#[test]
fn what_follows_exit_does_not_matter() {
    let mut client = Client::greeted(json!({}));
    client.request("shutdown", json!({})).unwrap_or_default();
    let ask = r#"{"jsonrpc":"2.0","id":9,"method":"textDocument/hover","params":{}}"#;
    let frame = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
    client.write([frame(EXIT), frame(ask), frame(EXIT)].concat().as_bytes());
    assert_eq!(client.exit_code(), Some(0));
}

#[test]
fn shutdown_needs_no_parameters() {
    for params in ["", r#","params":null"#] {
        let mut client = Client::greeted(json!({}));
        client.frame(format!(r#"{{"jsonrpc":"2.0","id":1000,"method":"shutdown"{params}}}"#));
        assert_eq!(client.answer(1000), Ok(json!(null)));
        client.frame(EXIT);
        assert_eq!(client.exit_code(), Some(0));
    }
}

#[test]
fn after_shutdown_requests_are_refused() {
    let mut client = Client::greeted(json!({}));
    client.request("shutdown", json!(null)).unwrap();
    let refused = client.request(
        "textDocument/diagnostic",
        json!({"textDocument": {"uri": "file:///a.scene"}}),
    );
    assert_eq!(refused.unwrap_err()["code"], -32600);
    client.frame(EXIT);
    assert_eq!(client.exit_code(), Some(0));
}

#[test]
fn a_stream_that_ends_ends_the_server() {
    let mut client = Client::greeted(json!({}));
    client.hang_up();
    assert_eq!(client.exit_code(), Some(1));
    let mut client = Client::greeted(json!({}));
    client.request("shutdown", json!(null)).unwrap();
    client.hang_up();
    assert_eq!(client.exit_code(), Some(0));
}

/// The editor is a process that waits for its input to end; its stream to the server stays open when it dies.
#[cfg(unix)]
#[test]
fn a_client_that_dies_without_a_word_is_noticed() {
    let mut editor = Command::new("cat")
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let mut client = Client::new();
    client.greet(json!({"processId": editor.id(), "capabilities": {}}));
    assert_eq!(client.request("nonsense", json!({})).unwrap_err()["code"], -32601);
    drop(editor.stdin.take());
    editor.wait().unwrap();
    assert_eq!(client.exit_code(), Some(1));
}

/// Only programs that are built with debug assertions can be asked to panic; nothing else makes a handler do so.
#[cfg(debug_assertions)]
#[test]
fn a_panic_costs_one_request() {
    const URI: &str = "file:///a.scene";
    let mut client = Client::greeted(json!({"textDocument": {"diagnostic": {}}}));
    client.open(URI, "!s := sphere\n");
    for _ in 0..3 {
        for place in [json!({}), json!({"textDocument": {"uri": URI}})] {
            let asked = client.ask("scene/panic", place.clone());
            // One that waits already is not taken along.
            let beside = client.ask("textDocument/foldingRange", json!({"textDocument": {"uri": URI}}));
            let error = client.answer(asked).unwrap_err();
            assert_eq!(error["code"], -32603, "{place}");
            assert_eq!(error["message"], "the server failed at this request", "{place}");
            assert!(client.answer(beside).is_ok());
        }
        client.notify("scene/panicUnasked", json!({}));
        assert_eq!(client.findings(URI)[0]["code"], "E014");
    }
    client.change(URI, 2, json!([{"text": "5\n"}]));
    assert_eq!(client.findings(URI)[0]["code"], "E005");
    client.farewell();
}

#[test]
fn a_client_whose_number_means_nothing_here_is_served() {
    let mut client = Client::new();
    client.greet(json!({"processId": 4_000_000_000_u32, "capabilities": {}}));
    client.farewell();
}
