//! The client's text and the server's stay the same, whatever the edits.

use proptest::collection;
use proptest::prelude::{Just, ProptestConfig, Strategy, any, prop_oneof};
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

use crate::client::Client;

const URI: &str = "file:///edited.scene";
const FRESH: &str = "file:///fresh.scene";

fn pulling(encodings: Value) -> Client {
    Client::greeted(json!({"textDocument": {"diagnostic": {}}, "general": {"positionEncodings": encodings}}))
}

/// Where the one broken line of a text is found after an edit of it.
fn check(text: &str, change: Value, expect: &str) {
    for encodings in [json!(["utf-16"]), json!(["utf-8"])] {
        let mut client = pulling(encodings);
        client.open(URI, text);
        client.change(URI, 2, json!([change]));
        client.open(FRESH, expect);
        assert_eq!(client.findings(URI), client.findings(FRESH), "{text:?} {change}");
        client.farewell();
    }
}

fn range(start: (u32, u32), end: (u32, u32), text: &str) -> Value {
    let place = |(line, character)| json!({"line": line, "character": character});
    json!({"range": {"start": place(start), "end": place(end)}, "text": text})
}

#[test]
fn places_outside_the_text_are_brought_back() {
    check("x\n5", range((9, 9), (99, 0), "\n6"), "x\n5\n6");
    check("x\n5", range((0, 99), (0, 4_294_967_295), "y"), "xy\n5");
    check("x\r\n5", range((0, 99), (0, 99), "y"), "xy\r\n5");
    check("x\n5", range((1, 1), (0, 0), ""), "");
    check("", range((0, 0), (7, 7), "5"), "5");
}

#[test]
fn halves_of_characters_keep_the_places_after_them() {
    let mut client = pulling(json!(["utf-16"]));
    client.open(URI, "/ \n5");
    let place = r#"{"line":0,"character":2}"#;
    let body = format!(
        r#"{{"jsonrpc":"2.0","method":"textDocument/didChange","params":{{"textDocument":{{"uri":"{URI}","version":2}},"contentChanges":[{{"range":{{"start":{place},"end":{place}}},"text":"\ud83d"}}]}}}}"#
    );
    client.frame(body);
    // The rest of the line goes behind the half: the 5 of the next one stands in its place.
    client.change(URI, 3, json!([range((0, 0), (0, 3), "")]));
    client.open(FRESH, "\n5");
    assert_eq!(client.findings(URI), client.findings(FRESH));
    client.change(
        URI,
        4,
        json!([{"text": "/ 😀\n5"}, range((0, 3), (0, 4), ""), range((0, 0), (0, 3), "")]),
    );
    assert_eq!(client.findings(URI), client.findings(FRESH));
    client.farewell();
}

#[test]
fn documents_that_were_never_opened_harm_nobody() {
    let mut client = pulling(json!(null));
    let unknown = "file:///unknown.scene";
    client.change(unknown, 2, json!([{"text": "5"}]));
    client.close(unknown);
    assert_eq!(client.findings(unknown), json!([]));
    for strange in [
        "untitled:Untitled-1",
        "git:/a.scene?ref",
        "data:,5",
        "file:///a%20b%F0%9F%98%80.scene",
    ] {
        client.open(strange, "5");
        assert_eq!(client.findings(strange)[0]["code"], "E005", "{strange}");
    }
    let refused = client.request(
        "textDocument/diagnostic",
        json!({"textDocument": {"uri": "no address"}}),
    );
    assert_eq!(refused.unwrap_err()["code"], -32602);
    client.farewell();
}

#[test]
fn opening_and_closing_twice_is_survived() {
    let mut client = pulling(json!(null));
    client.open(URI, "5");
    client.open(URI, "\n5");
    assert_eq!(client.findings(URI)[0]["range"]["start"]["line"], 1);
    client.close(URI);
    client.close(URI);
    assert_eq!(client.findings(URI), json!([]));
    client.open(URI, "5");
    assert_eq!(client.findings(URI)[0]["range"]["start"]["line"], 0);
    client.farewell();
}

/// A text as JavaScript has it.
fn splice(text: &str, from: u32, to: u32, with: &str) -> String {
    let mut units: Vec<u16> = text.encode_utf16().collect();
    units.splice(from as usize..to as usize, with.encode_utf16());
    String::from_utf16_lossy(&units)
}

/// The place of a code unit.
fn place(text: &str, unit: u32) -> (u32, u32) {
    let units: Vec<u16> = text.encode_utf16().take(unit as usize).collect();
    let line = units.iter().filter(|unit| **unit == 10).count();
    let column = units.iter().rev().take_while(|unit| **unit != 10).count();
    (line as u32, column as u32)
}

fn words() -> impl Strategy<Value = &'static str> {
    prop_oneof![
        Just(""),
        Just("\n"),
        Just("\r\n"),
        Just("x := 1"),
        Just("/ é😀"),
        Just("😀"),
        Just("!s := sphere\r\n!s <=\n"),
        Just("y := z"),
    ]
}

#[test]
fn edited_is_the_same_as_opened_anew() {
    let mut runner = TestRunner::new(ProptestConfig::with_cases(40));
    let edits = collection::vec((any::<u32>(), any::<u32>(), words()), 1..30);
    let client = std::cell::RefCell::new(pulling(json!(["utf-16"])));
    let property = |(start, edits): (Vec<&str>, Vec<(u32, u32, &str)>)| {
        let mut client = client.borrow_mut();
        let mut text = start.concat();
        client.open(URI, &text);
        for (number, (from, to, with)) in edits.into_iter().enumerate() {
            let length = text.encode_utf16().count() as u32 + 1;
            let (from, to) = ((from % length).min(to % length), (from % length).max(to % length));
            client.change(
                URI,
                number as i32 + 2,
                json!([range(place(&text, from), place(&text, to), with)]),
            );
            text = splice(&text, from, to, with);
        }
        client.open(FRESH, &text);
        let (edited, fresh) = (client.findings(URI), client.findings(FRESH));
        // Findings name the document where they name a related place; nothing else may differ.
        proptest::prop_assert_eq!(edited, fresh);
        Ok(())
    };
    runner.run(&(collection::vec(words(), 0..10), edits), property).unwrap();
    client.into_inner().farewell();
}
