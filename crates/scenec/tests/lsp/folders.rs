//! What lies in the folders of the client.

use serde_json::{Value, json};

use crate::client::Client;

#[test]
fn symbols_of_files_that_are_not_open() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::create_dir(at("deep")).unwrap();
    for (name, text) in [
        ("deep/a b.scene", "!ball_there := sphere\n"),
        ("open.scene", "!ball_on_disk := sphere\n"),
        ("other.txt", "!ball_elsewhere := sphere\n"),
    ] {
        std::fs::write(at(name), text).unwrap();
    }
    std::fs::write(at("broken.scene"), b"!ball_\xFF := sphere\n").unwrap();
    let uri = |name: &str| format!("file://{}/{name}", folder.path().display());
    let folders = json!([{"uri": uri(""), "name": "scenes"}]);
    let found = |client: &mut Client| {
        let found = client.request("workspace/symbol", json!({"query": "ball_"})).unwrap();
        let place = |one: &Value| format!("{} {}", one["name"], one["location"]["uri"]);
        found.as_array().unwrap().iter().map(place).collect::<Vec<_>>()
    };
    let typed = format!("\"!ball_typed\" \"{}\"", uri("open.scene"));
    let there = format!("\"!ball_there\" \"{}\"", uri("deep/a%20b.scene"));
    for greeting in [json!({"workspaceFolders": folders}), json!({"rootUri": uri("")})] {
        let mut client = Client::new();
        let mut whole = json!({"capabilities": {}});
        whole
            .as_object_mut()
            .unwrap()
            .extend(greeting.as_object().unwrap().clone());
        client.greet(whole);
        client.open(&uri("open.scene"), "!ball_typed := sphere\n");
        assert_eq!(found(&mut client), [typed.clone(), there.clone()], "{greeting}");
        let gone = json!({"event": {"added": [], "removed": folders}});
        client.notify("workspace/didChangeWorkspaceFolders", gone);
        assert_eq!(found(&mut client), std::slice::from_ref(&typed));
        client.notify(
            "workspace/didChangeWorkspaceFolders",
            json!({"event": {"added": folders, "removed": []}}),
        );
        assert_eq!(found(&mut client), [typed.clone(), there.clone()]);
        client.farewell();
    }
}
