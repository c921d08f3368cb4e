//! The first words: recorded ones of real editors, and what is made of them.

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
