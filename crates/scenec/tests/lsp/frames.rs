//! Messages that are none, and odd ones: whatever comes, the next good one is answered.

use serde_json::json;

use crate::client::Client;

/// Sends bytes, and sees whether the server still answers as if they had not come.
fn check(bytes: &[u8]) {
    let mut client = Client::greeted(json!({}));
    client.write(bytes);
    let unknown = client.request("nonsense", json!({})).unwrap_err();
    assert_eq!(unknown["code"], -32601, "{:?}", String::from_utf8_lossy(bytes));
    client.farewell();
}

fn frame(body: &[u8]) -> Vec<u8> {
    [format!("Content-Length: {}\r\n\r\n", body.len()).as_bytes(), body].concat()
}

#[test]
fn bodies_that_are_no_messages_are_dropped() {
    let bodies: [&[u8]; 12] = [
        b"",
        b"{",
        b"nonsense",
        b"[]",
        b"{}",
        b"\xFF\xFE",
        b"{\"jsonrpc\":\"2.0\",\"method\":\"\xED\xA0\x80\"}",
        br#"{"jsonrpc":"1.0","id":1,"method":"a"}"#,
        br#"{"jsonrpc":"2.0","id":1,"method":["a"]}"#,
        br#"{"jsonrpc":"2.0","id":77,"result":{}}"#,
        br#"{"jsonrpc":"2.0","id":null,"error":{"code":-1,"message":"late"}}"#,
        br#"{"jsonrpc":"2.0","method":"a","params":["\ud800"]}"#,
    ];
    check(&bodies.map(frame).concat());
    check(&frame(&b"[".repeat(1_000_000)));
}

#[test]
fn odd_headers_are_understood() {
    let body = r#"{"jsonrpc":"2.0","id":500,"method":"nonsense"}"#;
    let length = body.len();
    for header in [
        format!("content-length: {length}\r\n\r\n"),
        format!("CONTENT-LENGTH:{length}\n\n"),
        format!(
            "X-One: 1\r\nContent-Type: application/json; charset=latin1\r\nContent-Length: {length}\r\nX-Two: 2\r\n\r\n"
        ),
    ] {
        let mut client = Client::greeted(json!({}));
        client.write(format!("{header}{body}").as_bytes());
        assert_eq!(client.answer(500).unwrap_err()["code"], -32601, "{header:?}");
        client.farewell();
    }
}

#[test]
fn a_stream_that_goes_wrong_is_found_again() {
    check(b"garbage");
    check(b"garbage\r\n\r\n");
    check(b"Content-Length: twelve\r\n\r\n{}");
    check(b"Content-Length: 18446744073709551615\r\n\r\n{}");
    check(b"Content-Length: 99999999999999\r\n\r\n{}");
    check(b"Content-Length: 1\r\n\r\n{\"jsonrpc\":\"2.0\"}");
    check(&vec![b'x'; 1 << 20]);
}

#[test]
fn parameters_of_the_wrong_shape_are_an_error_of_one_request() {
    let mut client = Client::greeted(json!({}));
    for params in [json!(null), json!(3), json!([]), json!({"textDocument": 5})] {
        let refused = client.request("textDocument/diagnostic", params.clone());
        assert_eq!(refused.unwrap_err()["code"], -32602, "{params}");
    }
    client.farewell();
}

#[test]
fn before_the_greeting_requests_are_refused() {
    let mut client = Client::new();
    let params = json!({"textDocument": {"uri": "file:///a.scene"}});
    assert_eq!(
        client.request("textDocument/diagnostic", params).unwrap_err()["code"],
        -32002
    );
    client.greet(json!({"capabilities": {}}));
    let twice = client.request("initialize", json!({"capabilities": {}}));
    assert_eq!(twice.unwrap_err()["code"], -32600);
    client.farewell();
}
