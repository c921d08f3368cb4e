//! Pictures, asked for by an editor.

use serde_json::{Value, json};

use crate::client::Client;

pub(crate) const URI: &str = "file:///seed.scene";
pub(crate) const SEED: &str = include_str!("../../../../scenes/seed.scene");

/// A server with a document, which draws on the processor alone.
pub(crate) fn drawing(text: &str) -> Client {
    let mut client = Client::new();
    let greeting = json!({"processId": null, "rootUri": null, "capabilities": {},
        "initializationOptions": {"device": "cpu"}});
    client.greet(greeting);
    client.open(URI, text);
    client
}

pub(crate) fn wish(number: i64, quality: &str) -> Value {
    json!({"textDocument": {"uri": URI}, "id": number, "size": {"width": 90, "height": 90}, "camera": null,
        "quality": quality})
}

/// So much to do that a test can step in.
pub(crate) fn slow() -> String {
    let large = SEED.replace("600.0", "2000").replace("400.0", "1500");
    format!("{large}\nsamples := 4096\n")
}

pub(crate) fn long(number: i64) -> Value {
    json!({"textDocument": {"uri": URI}, "id": number, "size": null, "camera": null, "quality": "full"})
}

#[test]
fn a_picture_comes_in_frames_and_with_an_answer() {
    let mut client = drawing(SEED);
    let answer = client.request("scene/render", wish(7, "full")).unwrap();
    assert_eq!(answer["outcome"], "done", "{answer}");
    assert_eq!(
        (&answer["width"], &answer["height"], &answer["version"]),
        (&json!(90), &json!(60), &json!(1))
    );
    assert_eq!(answer["camera"]["eye"], json!([4.0, 1.0, 0.5]));
    assert!(
        answer["device"]
            .as_str()
            .is_some_and(|device| device.starts_with("cpu"))
    );
    let frames: Vec<Value> = client
        .rest()
        .into_iter()
        .filter(|one| one["method"] == "scene/frame")
        .collect();
    let last = &frames.last().expect("a frame")["params"];
    assert_eq!(
        (&last["final"], &last["id"], &last["uri"], &last["width"]),
        (&json!(true), &json!(7), &json!(URI), &json!(90))
    );
    assert!(
        last["png"].as_str().is_some_and(|png| png.starts_with("iVBORw0KGgo")),
        "{last}"
    );
    let moved = json!({"eye": [0.0, 3.0, 5.0], "lookat": [0.0, 0.0, 0.0]});
    let mut other = wish(8, "draft");
    other["camera"] = moved.clone();
    let answer = client.request("scene/render", other).unwrap();
    assert_eq!(
        (&answer["outcome"], &answer["camera"]["eye"]),
        (&json!("done"), &moved["eye"]),
        "{answer}"
    );
    client.farewell();
}

#[test]
fn no_answer_overtakes_its_last_frame() {
    let mut client = drawing(SEED);
    for number in 0..100 {
        let answer = client.request("scene/render", wish(number, "draft")).unwrap();
        assert_eq!(answer["outcome"], "done", "{answer}");
        let last = |one: &Value| one["params"]["id"] == number && one["params"]["final"] == true;
        assert!(client.rest().iter().any(last), "the answer to {number} came first");
    }
    client.farewell();
}

#[test]
fn a_broken_text_is_told_with_its_first_error() {
    let mut client = drawing("!a := sphere\n!b := ball\n");
    let answer = client.request("scene/render", wish(1, "draft")).unwrap();
    assert_eq!(
        (&answer["outcome"], &answer["error"]["code"]),
        (&json!("broken"), &json!("E008")),
        "{answer}"
    );
    assert_eq!(answer["error"]["range"]["start"]["line"], 1);
    let mut elsewhere = wish(2, "draft");
    elsewhere["textDocument"]["uri"] = json!("file:///unknown.scene");
    let answer = client.request("scene/render", elsewhere).unwrap();
    assert_eq!(answer["outcome"], "failed", "{answer}");
    client.farewell();
}

#[test]
fn the_newest_request_and_the_newest_text_win() {
    let mut client = drawing(&slow());
    let first = client.ask("scene/render", long(1));
    client.notification("scene/frame");
    let second = client.ask("scene/render", long(2));
    assert_eq!(client.answer(first).unwrap()["outcome"], "cancelled");
    while client.notification("scene/frame")["id"] != 2 {}
    client.change(URI, 2, json!([{"text": SEED}]));
    assert_eq!(client.answer(second).unwrap()["outcome"], "cancelled");
    let third = client.ask("scene/render", wish(3, "full"));
    let answer = client.answer(third).unwrap();
    assert_eq!(
        (&answer["outcome"], &answer["version"]),
        (&json!("done"), &json!(2)),
        "{answer}"
    );
    client.change(URI, 3, json!([{"text": slow()}]));
    let fourth = client.ask("scene/render", long(4));
    while client.notification("scene/frame")["id"] != 4 {}
    client.notify("$/cancelRequest", json!({"id": fourth}));
    assert_eq!(client.answer(fourth).unwrap_err()["code"], -32800);
    client.farewell();
}

#[test]
fn a_picture_may_be_drawn_to_its_end_despite_edits() {
    let mut client = drawing(&slow());
    let mut wish = long(1);
    wish["despiteEdits"] = json!(true);
    let picture = client.ask("scene/render", wish);
    client.notification("scene/frame");
    client.change(URI, 2, json!([{"text": SEED}]));
    // Another one would have been cancelled by now: the server takes its messages in order.
    let plan = json!({"textDocument": {"uri": URI}});
    client.request("scene/plan", plan).unwrap();
    let frame = client.notification("scene/frame");
    assert_eq!((&frame["id"], &frame["version"]), (&json!(1), &json!(1)), "{frame}");
    client.close(URI);
    assert_eq!(client.answer(picture).unwrap()["outcome"], "cancelled");
    client.farewell();
}

#[test]
fn a_plan_tells_what_draws_it() {
    let mut client = drawing(SEED);
    let mut tracer = |version: i32, text: &str| {
        client.change(URI, version, json!([{"text": text}]));
        let plan = client.request("scene/plan", json!({"textDocument": {"uri": URI}}));
        plan.unwrap()["tracer"].take()
    };
    assert_eq!(tracer(2, SEED), "the built-in tracer, on the processor, in f32");
    let far = tracer(3, &SEED.replace("!sph += 0.0", "!sph += 1000000.0"));
    assert!(
        far.as_str().is_some_and(|far| far.contains("in f64, since f32 could")),
        "{far}"
    );
    assert_eq!(tracer(4, "!"), json!(null));
    client.farewell();
}

#[test]
fn pictures_on_their_way_keep_nothing_waiting() {
    let mut client = drawing(&slow());
    let picture = client.ask("scene/render", long(1));
    client.notification("scene/frame");
    let plan = client
        .request("scene/plan", json!({"textDocument": {"uri": URI}}))
        .unwrap();
    assert_eq!(plan["kept"]["baseObjects"], 2, "{plan}");
    assert!(
        plan["markdown"]
            .as_str()
            .is_some_and(|text| text.contains("Every statement counts.")),
        "{plan}"
    );
    client.close(URI);
    assert_eq!(client.answer(picture).unwrap()["outcome"], "cancelled");
    client.farewell();
}

#[test]
fn a_plan_names_what_comes_to_nothing() {
    let text = format!("{SEED}\n!sph += 0 1 0\n");
    let mut client = drawing(&text);
    let plan = client
        .request("scene/plan", json!({"textDocument": {"uri": URI}}))
        .unwrap();
    let dropped = plan["dropped"].as_array().unwrap();
    assert!(
        dropped
            .iter()
            .any(|one| one["why"].as_str().is_some_and(|why| why.contains("(W005)"))),
        "{plan}"
    );
    assert!(
        plan["features"]
            .as_array()
            .unwrap()
            .contains(&json!({"name": "half spaces", "on": true})),
        "{plan}"
    );
    client.change(URI, 2, json!([{"text": "!"}]));
    let plan = client
        .request("scene/plan", json!({"textDocument": {"uri": URI}}))
        .unwrap();
    assert_eq!((&plan["kept"], &plan["features"]), (&json!(null), &json!([])), "{plan}");
    client.farewell();
}

#[test]
fn a_click_finds_the_statement_and_the_cursor_the_object() {
    let mut client = drawing(SEED);
    let document = json!({"uri": URI});
    let click = json!({"textDocument": document, "x": 0.5, "y": 0.95, "camera": null});
    let picked = client.request("scene/pick", click).unwrap();
    let line = |words: &str| SEED.lines().position(|line| line == words).unwrap();
    assert_eq!(
        (&picked["name"], &picked["uri"]),
        (&json!("plane"), &json!(URI)),
        "{picked}"
    );
    assert_eq!(picked["range"]["start"]["line"], line("!plane := hp"));
    assert_eq!(picked["selectionRange"]["start"]["character"], 1);
    let sky = json!({"textDocument": document, "x": 0.02, "y": 0.02, "camera": null});
    assert_eq!(client.request("scene/pick", sky).unwrap(), json!(null));

    let outline = |line: usize| {
        json!({"textDocument": {"uri": URI}, "position": {"line": line, "character": 1},
            "size": {"width": 90, "height": 90}, "camera": null})
    };
    let drawn = client
        .request("scene/outline", outline(line("!sph += 0.0 1.75 0.0")))
        .unwrap();
    assert_eq!(
        (&drawn["name"], &drawn["width"], &drawn["height"]),
        (&json!("sph"), &json!(90), &json!(60))
    );
    assert!(
        drawn["png"].as_str().is_some_and(|png| png.starts_with("iVBORw0KGgo")),
        "{drawn}"
    );
    assert_eq!(client.request("scene/outline", outline(0)).unwrap(), json!(null));
    client.farewell();
}

#[test]
fn a_camera_is_written_into_the_text() {
    let mut client = drawing(SEED);
    let camera = json!({"eye": [1.5, 2.0, 3.0], "lookat": [0.0, 0.0, 0.0]});
    let wish = json!({"textDocument": {"uri": URI}, "camera": camera});
    let edit = client.request("scene/writeCamera", wish).unwrap();
    let edits = edit["changes"][URI].as_array().unwrap();
    let texts: Vec<&str> = edits.iter().filter_map(|edit| edit["newText"].as_str()).collect();
    assert_eq!(texts, ["1.5", "2", "3"], "{edit}");
    client.farewell();
}
