//! A worker to talk to, and the hand that leads one.

use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};

use scenec_lsp::preview::{
    Answer, Limits, Look, News, Order, PROTOCOL, Pass, Preview, Quality, Report, Task, receive, send,
};
use scenec_picture::{Picture, load};

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_scenec");
pub(crate) const SEED: &str = include_str!("../../../../scenes/seed.scene");
/// Longer than anything takes, for a machine under load.
pub(crate) const LONG: Duration = Duration::from_secs(60);

/// The seed scene with so much to do that a test can step in.
pub(crate) fn slow() -> String {
    format!("{SEED}\nsamples := 4096\nwidth := 2000\nheight := 1500\n")
}

pub(crate) fn look(size: Option<(u32, u32)>) -> Look {
    Look {
        name: "seed".to_owned(),
        size,
        camera: None,
        ignore_operators: false,
    }
}

pub(crate) fn draw(quality: Quality, device: &str) -> Task {
    Task::Draw {
        quality,
        device: device.to_owned(),
    }
}

/// A worker, spoken to without a hand between.
pub(crate) struct Worker {
    child: Child,
    orders: Option<ChildStdin>,
    answers: ChildStdout,
}

impl Worker {
    pub(crate) fn start() -> Self {
        let mut child = Command::new(PROGRAM)
            .arg("preview-worker")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (orders, answers) = (child.stdin.take(), child.stdout.take().unwrap());
        let mut worker = Self { child, orders, answers };
        assert_eq!(worker.hear().0, Answer::Hello { protocol: PROTOCOL });
        worker
    }

    pub(crate) fn order(&mut self, order: &Order, text: &str) {
        send(self.orders.as_mut().unwrap(), order, text.as_bytes()).unwrap();
    }

    pub(crate) fn job(&mut self, job: u64, look: Look, task: Task, text: &str) {
        self.order(&Order::Job { job, look, task }, text);
    }

    pub(crate) fn hear(&mut self) -> (Answer, Vec<u8>) {
        receive(&mut self.answers).unwrap().expect("an answer")
    }

    /// All news about one job, the others' left out.
    pub(crate) fn news(&mut self, wanted: u64) -> Vec<(News, Vec<u8>)> {
        let mut all = Vec::new();
        loop {
            if let (Answer::Job { job, news }, payload) = self.hear()
                && job == wanted
            {
                let ends = news.ends();
                all.push((news, payload));
                if ends {
                    return all;
                }
            }
        }
    }

    /// Closes the line, and waits for the end.
    pub(crate) fn end(mut self, rest: &[u8]) -> Option<i32> {
        use std::io::Write;
        let mut orders = self.orders.take().unwrap();
        orders.write_all(rest).unwrap();
        drop(orders);
        let begin = Instant::now();
        while begin.elapsed() < LONG {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        panic!("it goes on and on");
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.child.kill().unwrap_or_default();
        self.child.wait().unwrap();
    }
}

/// The passes among the news, and the pixels of the last one.
pub(crate) fn passes(news: &[(News, Vec<u8>)]) -> (Vec<Pass>, Picture) {
    let passes = news.iter().filter_map(|(news, png)| match news {
        News::Pass(pass) => Some((pass.clone(), png)),
        _ => None,
    });
    let (passes, pngs): (Vec<_>, Vec<_>) = passes.unzip();
    (passes, picture(pngs.last().unwrap()))
}

pub(crate) fn picture(png: &[u8]) -> Picture {
    let place = tempfile::Builder::new().suffix(".png").tempfile().unwrap();
    std::fs::write(place.path(), png).unwrap();
    load(place.path()).unwrap()
}

/// What `scenec render` makes of a text.
pub(crate) fn rendered(text: &str, arguments: &[&str]) -> Picture {
    let folder = tempfile::tempdir().unwrap();
    let (scene, target) = (folder.path().join("a.scene"), folder.path().join("a.png"));
    std::fs::write(&scene, text).unwrap();
    let status = Command::new(PROGRAM)
        .args(["render", "--quiet", "--device", "cpu"])
        .args(arguments)
        .arg(&scene)
        .arg("-o")
        .arg(&target)
        .status()
        .unwrap();
    assert!(status.success());
    load(&target).unwrap()
}

/// The hand that leads a worker, started through `shell` if there is one; its reports.
pub(crate) fn led(pid_file: Option<&Path>, limits: Limits) -> (Preview, Receiver<Report>) {
    let (program, arguments) = match pid_file {
        Some(file) => {
            let words = format!("echo $$ > '{}'; exec '{PROGRAM}' preview-worker", file.display());
            ("/bin/sh".into(), vec!["-c".to_owned(), words])
        }
        None => (PROGRAM.into(), vec!["preview-worker".to_owned()]),
    };
    let (sender, told) = mpsc::channel();
    let report = move |report| sender.send(report).unwrap_or_default();
    (Preview::new(program, arguments, limits, report), told)
}
