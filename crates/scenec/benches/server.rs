//! How long an editor waits for `scenec lsp`, as a process over its pipes: `cargo bench -p scenec --bench server`.
//!
//! Arguments after `--`: `--sizes 1000,1000000` (bytes of the documents), `--rounds 200` (of each kind of request),
//! `--burst 20000` (edits sent in one go), `--soak 10` (seconds of typing, for the memory).

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a benchmark may stop at once, and prints"
)]

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

const SEED: &str = include_str!("../../../scenes/seed.scene");

fn main() {
    let options = Options::read();
    println!("| document | request | p50 | p99 | most |\n|---|---|---:|---:|---:|");
    for &size in &options.sizes {
        let mut session = Session::open(&scene(size), true);
        let rounds = if size > 5_000_000 {
            options.rounds.min(50)
        } else {
            options.rounds
        };
        let name = format!("{size} bytes");
        row(
            &name,
            "keystroke to findings",
            &session.many(rounds, Session::keystroke),
        );
        let mut patient = Session::open(&scene(size), false);
        row(
            &name,
            "keystroke to all findings",
            &patient.many(rounds, Session::keystroke),
        );
        drop(patient);
        row(&name, "hover", &session.many(rounds, Session::hover));
        row(&name, "completion", &session.many(rounds, Session::completion));
    }
    let mut session = Session::open(SEED, true);
    row(
        "seed.scene",
        "keystroke to first pixels",
        &session.many(options.rounds, Session::pixels),
    );
    let mut session = Session::open(&scene(1000), true);
    let time = session.burst(options.burst);
    println!(
        "\n{} edits in one go, then the findings: {:.0} ms",
        options.burst,
        time.as_secs_f64() * 1e3
    );
    soak(options.soak);
}

struct Options {
    sizes: Vec<usize>,
    rounds: usize,
    burst: usize,
    soak: u64,
}

impl Options {
    fn read() -> Self {
        let mut options = Self {
            sizes: vec![1_000, 1_000_000, 10_000_000],
            rounds: 200,
            burst: 20_000,
            soak: 10,
        };
        let arguments: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
        for pair in arguments.chunks(2) {
            let [name, value] = pair else {
                panic!("{} wants a value", pair[0]);
            };
            match name.as_str() {
                "--sizes" => options.sizes = value.split(',').map(|size| size.parse().unwrap()).collect(),
                "--rounds" => options.rounds = value.parse().unwrap(),
                "--burst" => options.burst = value.parse().unwrap(),
                "--soak" => options.soak = value.parse().unwrap(),
                other => panic!("{other} is unknown"),
            }
        }
        options
    }
}

/// Transformed spheres in a chain of unions; a little longer than `size`.
fn scene(size: usize) -> String {
    let settings = SEED.split("/ Object tree").next().unwrap();
    let mut text = format!("{settings}*lamp := 4 4 4 1 1 1\n!u0 := hp\n!u0 ?= red\n");
    let mut count = 0;
    while text.len() < size {
        let (x, z) = (count % 1000, count / 1000);
        write!(
            text,
            "!s{count} := sphere\n!s{count} ?= base\n!s{count} *= 1.{x} 0.5 0.25\n!s{count} += {x}.25 1 -{z}.5\n\
             !u{} := u{count} | s{count}\n",
            count + 1
        )
        .unwrap();
        count += 1;
    }
    writeln!(text, "!u{count} <=").unwrap();
    text
}

fn row(document: &str, what: &str, times: &[Duration]) {
    let mut times = times.to_vec();
    times.sort_unstable();
    let at = |part: f64| times[((times.len() - 1) as f64 * part).round() as usize].as_secs_f64() * 1e3;
    println!(
        "| {document} | {what} | {:.2} ms | {:.2} ms | {:.2} ms |",
        at(0.5),
        at(0.99),
        at(1.0)
    );
}

/// Types for some seconds; the memory should stay where it is after the first part.
fn soak(seconds: u64) {
    let mut session = Session::open(&scene(100_000), true);
    let parts = 5;
    for part in 0..=parts {
        println!(
            "memory after {:.0} s of typing: {}",
            part as f64 * seconds as f64 / f64::from(parts),
            session.memory()
        );
        let begin = Instant::now();
        while part < parts && begin.elapsed().as_secs_f64() < seconds as f64 / f64::from(parts) {
            session.keystroke();
            session.hover();
            session.completion();
        }
    }
}

/// A server with one open document.
struct Session {
    server: Child,
    input: ChildStdin,
    messages: Receiver<Value>,
    requests: i64,
    version: i64,
    line: u64,
}

impl Session {
    /// With a client that can be told to ask for findings again, or one that can't, which waits for all of them.
    fn open(text: &str, asks_again: bool) -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_scenec"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (input, output) = (server.stdin.take().unwrap(), server.stdout.take().unwrap());
        let (sender, messages) = mpsc::channel();
        std::thread::spawn(move || {
            let mut output = BufReader::new(output);
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    break;
                }
            }
        });
        let mut session = Self {
            server,
            input,
            messages,
            requests: 0,
            version: 1,
            line: text.lines().count() as u64 / 2,
        };
        let capabilities = json!({"textDocument": {"diagnostic": {}, "hover": {"contentFormat": ["markdown"]}},
            "workspace": {"diagnostics": {"refreshSupport": asks_again}}});
        session.ask(
            "initialize",
            json!({"processId": null, "rootUri": null, "capabilities": capabilities}),
        );
        session.tell("initialized", json!({}));
        let document = json!({"uri": URI, "languageId": "scene", "version": 1, "text": text});
        session.tell("textDocument/didOpen", json!({"textDocument": document}));
        // What is drawn and analysed once is not what is measured.
        session.findings();
        session.hover();
        session
    }

    /// The times of so many, with a pause before each: nobody types faster.
    fn many(&mut self, rounds: usize, what: impl Fn(&mut Self)) -> Vec<Duration> {
        let once = |_| {
            std::thread::sleep(PAUSE);
            let begin = Instant::now();
            what(self);
            begin.elapsed()
        };
        (0..rounds.max(1)).map(once).collect()
    }

    /// One letter of a comment at the end of a line, and the findings after it.
    fn keystroke(&mut self) {
        self.edit();
        self.findings();
    }

    fn edit(&mut self) {
        self.version += 1;
        // The letter comes and goes, so that the text stays as long as it is.
        let at = |character: u64| json!({"line": self.line, "character": character});
        let (range, text) = match self.version % 2 {
            0 => (json!({"start": at(0), "end": at(0)}), " "),
            _ => (json!({"start": at(0), "end": at(1)}), ""),
        };
        let document = json!({"uri": URI, "version": self.version});
        let change = json!({"range": range, "text": text});
        self.tell(
            "textDocument/didChange",
            json!({"textDocument": document, "contentChanges": [change]}),
        );
    }

    fn findings(&mut self) {
        self.ask("textDocument/diagnostic", json!({"textDocument": {"uri": URI}}));
    }

    fn hover(&mut self) {
        self.ask("textDocument/hover", self.place(2));
    }

    fn completion(&mut self) {
        self.ask("textDocument/completion", self.place(1));
    }

    fn place(&self, character: u64) -> Value {
        json!({"textDocument": {"uri": URI}, "position": {"line": self.line, "character": character}})
    }

    /// A keystroke, and the first picture after it; the rest of the refinement is not waited for.
    fn pixels(&mut self) {
        self.edit();
        let wish =
            json!({"textDocument": {"uri": URI}, "id": self.version, "size": null, "camera": null, "quality": "full"});
        let request = self.request("scene/render", wish);
        loop {
            let message = self.messages.recv_timeout(PATIENCE).unwrap();
            assert!(message["id"] != json!(request), "a picture without a frame: {message}");
            if message["method"] == "scene/frame" && message["params"]["id"] == json!(self.version) {
                break;
            }
        }
    }

    fn burst(&mut self, edits: usize) -> Duration {
        let begin = Instant::now();
        (0..edits).for_each(|_| self.edit());
        self.findings();
        begin.elapsed()
    }

    fn ask(&mut self, method: &str, params: Value) {
        let request = self.request(method, params);
        loop {
            let message = self.messages.recv_timeout(PATIENCE).unwrap();
            if message["id"] == json!(request) && message.get("method").is_none() {
                assert!(message.get("error").is_none(), "{method}: {message}");
                break;
            }
        }
    }

    fn request(&mut self, method: &str, params: Value) -> i64 {
        self.requests += 1;
        let request = self.requests;
        self.send(&json!({"jsonrpc": "2.0", "id": request, "method": method, "params": params}));
        request
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}));
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.input.flush().unwrap();
    }

    /// Of the server alone, where the system tells.
    fn memory(&self) -> String {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.server.id())).unwrap_or_default();
        let row = status.lines().find(|line| line.starts_with("VmRSS:"));
        row.map_or("unknown".to_owned(), |row| {
            row.trim_start_matches("VmRSS:").trim().to_owned()
        })
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.server.kill().unwrap();
        self.server.wait().unwrap();
    }
}

const URI: &str = "file:///bench.scene";
const PAUSE: Duration = Duration::from_millis(30);
const PATIENCE: Duration = Duration::from_secs(120);

fn read(from: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if from.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim() {
            "" => break,
            line => {
                length = line
                    .strip_prefix("Content-Length: ")
                    .map_or(length, |words| words.parse().unwrap())
            }
        }
    }
    let mut body = vec![0; length];
    from.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}
