//! A client that says just what a test wants said, and never waits for long.

use std::collections::VecDeque;
use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

/// How long anything may take before it counts as a hang.
const PATIENCE: Duration = Duration::from_secs(60);

/// The server as a process.
pub(crate) struct Client {
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    /// What came while something else was waited for.
    kept: VecDeque<Value>,
    ended: Receiver<Option<i32>>,
    process: u32,
    requests: i64,
}

impl Client {
    /// Starts a server that leaves nothing behind, and says nothing yet.
    pub(crate) fn new() -> Self {
        Self::keeping("off")
    }

    /// Starts a server with a place for what it wants to keep.
    pub(crate) fn keeping(cache: impl AsRef<OsStr>) -> Self {
        Self::with(Command::new(env!("CARGO_BIN_EXE_scenec")).env("SCENEC_CACHE_DIR", cache))
    }

    /// Starts a server by a command that lacks only its arguments.
    pub(crate) fn with(command: &mut Command) -> Self {
        let command = command.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let process = child.id();
        let input = child.stdin.take();
        let output = BufReader::new(child.stdout.take().unwrap());
        let (send, messages) = channel();
        thread::spawn(move || read(output, &send));
        let (send, ended) = channel();
        thread::spawn(move || send.send(wait(&mut child)));
        Self {
            input,
            messages,
            kept: VecDeque::new(),
            ended,
            process,
            requests: 0,
        }
    }

    /// A server that has been greeted by a client of these capabilities.
    pub(crate) fn greeted(capabilities: Value) -> Self {
        let mut client = Self::new();
        client.greet(json!({"processId": null, "rootUri": null, "capabilities": capabilities}));
        client
    }

    /// The number of the server's process.
    pub(crate) fn process(&self) -> u32 {
        self.process
    }

    /// Greets the server; gives what it offers.
    pub(crate) fn greet(&mut self, params: Value) -> Value {
        let offered = self.request("initialize", params).unwrap();
        self.notify("initialized", json!({}));
        offered
    }

    /// Writes bytes as they are.
    pub(crate) fn write(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().unwrap();
        input.write_all(bytes).unwrap();
        input.flush().unwrap();
    }

    /// Sends a body in a frame.
    pub(crate) fn frame(&mut self, body: impl AsRef<[u8]>) {
        let body = body.as_ref();
        let mut frame = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
        frame.extend_from_slice(body);
        self.write(&frame);
    }

    pub(crate) fn notify(&mut self, method: &str, params: Value) {
        self.frame(json!({"jsonrpc": "2.0", "method": method, "params": params}).to_string());
    }

    /// Sends a request; its number is for [`Client::answer`].
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> i64 {
        self.requests += 1;
        let id = self.requests;
        self.frame(json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params}).to_string());
        id
    }

    /// The answer to a request, or its error.
    pub(crate) fn answer(&mut self, id: i64) -> Result<Value, Value> {
        let mut answer = self.message(|message| message["id"] == id && message.get("method").is_none());
        match answer.get_mut("error") {
            Some(error) => Err(error.take()),
            None => Ok(answer["result"].take()),
        }
    }

    pub(crate) fn request(&mut self, method: &str, params: Value) -> Result<Value, Value> {
        let id = self.ask(method, params);
        self.answer(id)
    }

    /// The parameters of the next notification of a kind.
    pub(crate) fn notification(&mut self, method: &str) -> Value {
        self.message(|message| message["method"] == method)["params"].take()
    }

    /// The next question of a kind that the server has, whole.
    pub(crate) fn question(&mut self, method: &str) -> Value {
        self.message(|message| message["method"] == method && message.get("id").is_some())
    }

    /// Answers a question.
    pub(crate) fn reply(&mut self, question: &Value, result: Value) {
        self.frame(json!({"jsonrpc": "2.0", "id": question["id"], "result": result}).to_string());
    }

    /// What came and was not asked for, until now.
    pub(crate) fn rest(&mut self) -> Vec<Value> {
        self.kept.extend(self.messages.try_iter());
        self.kept.drain(..).collect()
    }

    fn message(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.kept.iter().position(&wanted) {
            return self.kept.remove(at).unwrap();
        }
        loop {
            let message = self.messages.recv_timeout(PATIENCE).expect("the server stays silent");
            if wanted(&message) {
                return message;
            }
            self.kept.push_back(message);
        }
    }

    pub(crate) fn open(&mut self, uri: &str, text: &str) {
        let document = json!({"uri": uri, "languageId": "scene", "version": 1, "text": text});
        self.notify("textDocument/didOpen", json!({"textDocument": document}));
    }

    pub(crate) fn change(&mut self, uri: &str, version: i32, changes: Value) {
        let document = json!({"uri": uri, "version": version});
        self.notify(
            "textDocument/didChange",
            json!({"textDocument": document, "contentChanges": changes}),
        );
    }

    pub(crate) fn close(&mut self, uri: &str) {
        self.notify("textDocument/didClose", json!({"textDocument": {"uri": uri}}));
    }

    /// The findings of a document, of a client that asks for them.
    pub(crate) fn findings(&mut self, uri: &str) -> Value {
        let params = json!({"textDocument": {"uri": uri}});
        self.request("textDocument/diagnostic", params).unwrap()["items"].take()
    }

    /// Closes the server's input.
    pub(crate) fn hang_up(&mut self) {
        self.input = None;
    }

    /// The exit code, once there is one.
    pub(crate) fn exit_code(&mut self) -> Option<i32> {
        self.ended.recv_timeout(PATIENCE).expect("the server does not end")
    }

    /// Ends the server in due form.
    pub(crate) fn farewell(mut self) {
        assert_eq!(self.request("shutdown", json!(null)), Ok(json!(null)));
        self.frame(r#"{"jsonrpc":"2.0","method":"exit"}"#);
        assert_eq!(self.exit_code(), Some(0));
    }
}

fn wait(child: &mut Child) -> Option<i32> {
    child.wait().unwrap().code()
}

/// Reads frames, strictly: whatever else came would be a mistake of the server's.
fn read(mut output: BufReader<ChildStdout>, send: &std::sync::mpsc::Sender<Value>) {
    loop {
        let mut header = String::new();
        if output.read_line(&mut header).unwrap() == 0 {
            return;
        }
        let length = header.strip_prefix("Content-Length: ").expect("a header");
        let mut body = vec![0; length.trim_end().parse().unwrap()];
        let mut blank = [0; 2];
        output.read_exact(&mut blank).unwrap();
        assert_eq!(&blank, b"\r\n");
        output.read_exact(&mut body).unwrap();
        if send.send(serde_json::from_slice(&body).unwrap()).is_err() {
            return;
        }
    }
}
