//! The process that draws dies, and takes no word of the editor with it.

use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::client::Client;
use crate::preview::{SEED, URI, drawing, long, slow, wish};

/// A server whose process that draws has drawn a picture.
fn drawn() -> Client {
    let mut client = drawing(SEED);
    check_draws(&mut client, 1);
    client
}

fn check_draws(client: &mut Client, number: i64) {
    let answer = client.request("scene/render", wish(number, "draft")).unwrap();
    assert_eq!(answer["outcome"], "done", "{answer}");
}

/// Kills the process that draws for a server.
fn kill(client: &Client) {
    let listed = Command::new("ps")
        .args(["-o", "pid=,args=", "--ppid", &client.process().to_string()])
        .output();
    let listed = String::from_utf8(listed.unwrap().stdout).unwrap();
    let worker = listed.lines().find(|line| line.contains("preview-worker")).unwrap();
    let number = worker.split_whitespace().next().unwrap();
    assert!(Command::new("kill").args(["-KILL", number]).status().unwrap().success());
}

/// Waits for word that the process fares so; what is said after a picture is not meant.
fn fares(client: &mut Client, state: &str) -> Value {
    loop {
        let status = client.notification("scene/status");
        if status["state"] == state && status["device"].is_null() {
            return status;
        }
    }
}

fn check_words(client: &mut Client) {
    assert_eq!(client.findings(URI), json!([]));
    let line = SEED.lines().position(|line| line == "!plane := hp").unwrap();
    let place = json!({"textDocument": {"uri": URI}, "position": {"line": line, "character": 2}});
    let hover = client.request("textDocument/hover", place).unwrap();
    assert!(hover["contents"].to_string().contains("plane"), "{hover}");
}

#[test]
fn the_process_that_draws_may_die() {
    let mut client = drawing(&slow());
    let picture = client.ask("scene/render", long(1));
    client.notification("scene/frame");
    kill(&client);
    let answer = client.answer(picture).unwrap();
    assert_eq!(answer["outcome"], "failed");
    let why = answer["error"]["message"].as_str().unwrap();
    assert!(why.contains("signal: 9"), "{answer}");
    fares(&mut client, "restarting");
    client.change(URI, 2, json!([{"text": SEED}]));
    let answer = client.request("scene/render", wish(2, "full")).unwrap();
    assert_eq!(answer["outcome"], "done");
    client.farewell();
}

#[test]
fn one_that_dies_again_and_again_is_given_up_until_something_changes() {
    let mut client = drawn();
    fares(&mut client, "ready");
    for wait in [200, 400, 800, 1600] {
        let begin = Instant::now();
        kill(&client);
        let status = fares(&mut client, "restarting");
        assert!(status["message"].to_string().contains("signal: 9"), "{status}");
        check_words(&mut client);
        fares(&mut client, "ready");
        assert!(
            begin.elapsed() >= Duration::from_millis(wait),
            "it came back before {wait} ms were over"
        );
    }
    kill(&client);
    let status = fares(&mut client, "down");
    let message = status["message"].as_str().unwrap();
    assert!(
        message.contains("signal: 9") && message.ends_with(", 5 times in a row"),
        "{status}"
    );
    let answer = client.request("scene/render", wish(2, "draft")).unwrap();
    assert_eq!(answer["outcome"], "failed", "{answer}");
    let why = answer["error"]["message"].as_str().unwrap();
    assert!(why.contains(", 5 times in a row; it is tried again in "), "{answer}");
    check_words(&mut client);
    // Another setting is another chance, at once.
    let settings = json!({"settings": {"scenec": {"device": "cpu", "lens": false}}});
    client.notify("workspace/didChangeConfiguration", settings);
    check_draws(&mut client, 3);
    client.farewell();
}

#[test]
fn one_that_was_given_up_is_tried_again_after_a_while() {
    let mut client = drawn();
    for _ in 0..5 {
        fares(&mut client, "ready");
        kill(&client);
    }
    fares(&mut client, "down");
    let mut refused = 0;
    while client.request("scene/render", wish(2 + refused, "draft")).unwrap()["outcome"] == "failed" {
        refused += 1;
        std::thread::sleep(Duration::from_millis(100));
    }
    assert!(refused > 0);
    client.farewell();
}
