//! Asks the process that draws, and watches over it: one that ends, falls silent or stands still is replaced.
//!
//! All state is on one thread of its own, which waits for nobody but its events. Whoever asks waits for nothing either.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use tokio::sync::mpsc as answers;

use super::hands::{Hands, Said};
use super::health::Health;
use super::wire::PROTOCOL;
use super::words::{Answer, Look, News, Order, Task};

/// When patience ends.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// How often a busy process is asked for a sign of life.
    pub ping: Duration,
    /// How long it may be silent then.
    pub silence: Duration,
    /// How long it may stand still, besides a second for each megabyte of text.
    pub stall: Duration,
    /// The wait before the first new start; each further one without a picture between is twice as long.
    pub first_wait: Duration,
    /// The longest such wait.
    pub longest_wait: Duration,
}

impl Limits {
    /// What suits people.
    pub const DEFAULT: Self = Self {
        ping: Duration::from_secs(1),
        silence: Duration::from_secs(10),
        stall: Duration::from_secs(20),
        first_wait: Duration::from_millis(200),
        longest_wait: Duration::from_secs(30),
    };
}

/// How the process fares.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// It takes orders.
    Ready,
    /// It is being started for the first time.
    Starting,
    /// It ended, and is or will soon be started again.
    Restarting,
    /// It can't be started, or ends again and again.
    Down,
}

/// What people may want to know without having asked.
#[derive(Clone, PartialEq, Debug)]
pub enum Report {
    /// How the process fares.
    Status {
        /// How.
        state: State,
        /// What is to be said about it.
        message: Option<String>,
    },
    /// What the process said on its standard error.
    Line(String),
}

/// The door to the process that draws. It is started when something is first asked of it, and ends with this.
#[derive(Debug)]
pub struct Preview {
    events: Sender<Event>,
    jobs: AtomicU64,
}

/// A job that was asked for. Dropping it cancels the job.
#[derive(Debug)]
pub struct Asked {
    job: u64,
    news: answers::UnboundedReceiver<(News, Vec<u8>)>,
    events: Sender<Event>,
}

#[derive(Debug)]
enum Event {
    Ask(u64, Pending),
    Cancel(u64),
    Forgive,
    Said(u64, Said),
    Close,
}

#[derive(Debug)]
struct Pending {
    look: Look,
    task: Task,
    text: Arc<str>,
    news: answers::UnboundedSender<(News, Vec<u8>)>,
    sent: bool,
}

impl Preview {
    /// A door to processes that are started as `program arguments`. `report` is called on a thread of its own.
    ///
    /// Where there is no thread to be had, every job ends without news.
    #[must_use]
    pub fn new(
        program: PathBuf,
        arguments: Vec<String>,
        limits: Limits,
        report: impl FnMut(Report) + Send + 'static,
    ) -> Self {
        let (events, inbox) = mpsc::channel();
        let supervisor = Supervisor {
            program,
            arguments,
            report: Box::new(report),
            events: events.clone(),
            hands: None,
            generation: 0,
            jobs: BTreeMap::new(),
            health: Health::new(limits, Instant::now()),
        };
        let thread = thread::Builder::new().name("preview".to_owned());
        // A thread that runs needs no handle; one that doesn't took the other end of `events` with it.
        let _ = thread.spawn(move || supervisor.run(&inbox));
        Self {
            events,
            jobs: AtomicU64::new(1),
        }
    }

    /// Asks for a job on a text.
    pub fn ask(&self, look: Look, task: Task, text: Arc<str>) -> Asked {
        let job = self.jobs.fetch_add(1, Ordering::Relaxed);
        let (sender, news) = answers::unbounded_channel();
        let pending = Pending {
            look,
            task,
            text,
            news: sender,
            sent: false,
        };
        // The thread outlives its door.
        self.events.send(Event::Ask(job, pending)).unwrap_or_default();
        Asked {
            job,
            news,
            events: self.events.clone(),
        }
    }

    /// Forgets what went wrong: devices that crashed are tried again. For when the settings change.
    pub fn forgive(&self) {
        self.events.send(Event::Forgive).unwrap_or_default();
    }
}

impl Drop for Preview {
    fn drop(&mut self) {
        self.events.send(Event::Close).unwrap_or_default();
    }
}

impl Asked {
    /// The next news with its payload; `None` after the last.
    pub async fn next(&mut self) -> Option<(News, Vec<u8>)> {
        self.news.recv().await
    }

    /// As [`Asked::next`], for a thread that may wait.
    pub fn wait(&mut self) -> Option<(News, Vec<u8>)> {
        self.news.blocking_recv()
    }
}

impl Drop for Asked {
    fn drop(&mut self) {
        self.events.send(Event::Cancel(self.job)).unwrap_or_default();
    }
}

struct Supervisor {
    program: PathBuf,
    arguments: Vec<String>,
    report: Box<dyn FnMut(Report) + Send>,
    events: Sender<Event>,
    hands: Option<Hands>,
    /// Which of the processes so far `hands` is: a word of an earlier one comes too late.
    generation: u64,
    jobs: BTreeMap<u64, Pending>,
    health: Health,
}

impl Supervisor {
    fn run(mut self, inbox: &Receiver<Event>) {
        loop {
            match inbox.recv_timeout(self.health.wait(self.hands.is_some(), Instant::now())) {
                Ok(Event::Close) | Err(RecvTimeoutError::Disconnected) => return,
                Ok(Event::Ask(job, pending)) => self.take(job, pending),
                Ok(Event::Cancel(job)) => self.cancel(job),
                Ok(Event::Forgive) => self.health.forgive(),
                Ok(Event::Said(generation, said)) if generation == self.generation => self.hear(said),
                Ok(Event::Said(..)) | Err(RecvTimeoutError::Timeout) => {}
            }
            self.look_after();
        }
    }

    fn take(&mut self, job: u64, pending: Pending) {
        if let Some(message) = self.health.refusal(Instant::now()) {
            pending.say(News::Failed { message }, Vec::new());
            return;
        }
        self.jobs.insert(job, pending);
    }

    fn cancel(&mut self, job: u64) {
        if let Some(pending) = self.jobs.remove(&job) {
            if let (true, Some(hands)) = (pending.sent, &self.hands) {
                hands.order(Order::Cancel { job }, Arc::from(""));
                self.health.abandon(job, Instant::now());
            }
            pending.say(News::Cancelled, Vec::new());
        }
    }

    fn hear(&mut self, said: Said) {
        match said {
            Said::Line(line) => (self.report)(Report::Line(line)),
            Said::End(why) => {
                let how = self.hands.as_mut().and_then(Hands::ended);
                let how = how.or(why).unwrap_or_else(|| "it closed the line".to_owned());
                self.lost(&format!("the drawing process ended ({how})"));
            }
            Said::Answer(Answer::Hello { protocol: PROTOCOL }, _) => self.status(State::Ready, None),
            Said::Answer(Answer::Hello { .. }, _) => {
                self.lost("the drawing process is of another version: restart the server");
            }
            Said::Answer(Answer::Pong { beat }, _) => self.health.pong(beat, Instant::now()),
            Said::Answer(Answer::Job { job, news }, payload) => self.news(job, news, payload),
        }
    }

    fn news(&mut self, job: u64, news: News, payload: Vec<u8>) {
        self.health.moved(Instant::now());
        if news.ends() {
            self.health.ended(job);
        }
        let Some(pending) = self.jobs.get_mut(&job) else {
            return;
        };
        match news {
            News::Pass(pass) => pending.say(News::Pass(pass), payload),
            News::Drawn { camera, remark } => {
                let Some(pending) = self.jobs.remove(&job) else {
                    return;
                };
                let remark = self.health.drawn(&pending.task).or(remark);
                pending.say(News::Drawn { camera, remark }, payload);
            }
            other => {
                if let Some(pending) = self.jobs.remove(&job) {
                    pending.say(other, payload);
                }
            }
        }
    }

    /// Starts what has to be started, sends what has to be sent, and ends what gives no hope.
    fn look_after(&mut self) {
        let now = Instant::now();
        let waiting = self.jobs.values().any(|pending| !pending.sent);
        if self.hands.is_none() && self.health.may_start(waiting, now) {
            self.start();
        }
        let Some(hands) = &self.hands else {
            return;
        };
        for (&job, pending) in self.jobs.iter_mut().filter(|(_, pending)| !pending.sent) {
            pending.sent = true;
            let task = self.health.allowed(&pending.task);
            self.health.sent(pending.text.len(), now);
            let look = pending.look.clone();
            hands.order(Order::Job { job, look, task }, Arc::clone(&pending.text));
        }
        let busy = !self.jobs.is_empty();
        if self.health.ask_for_life(busy, now) {
            hands.order(Order::Ping, Arc::from(""));
        }
        if let Some(why) = self.health.hopeless(busy, now) {
            self.lost(why);
        }
    }

    fn start(&mut self) {
        self.generation += 1;
        let (generation, events) = (self.generation, self.events.clone());
        let state = self.health.starting();
        self.status(state, None);
        let hear = move |said| events.send(Event::Said(generation, said)).unwrap_or_default();
        match Hands::start(&self.program, &self.arguments, hear) {
            Ok(hands) => self.hands = Some(hands),
            Err(error) => self.lost(&format!(
                "the drawing process can't be started from {}: {error}",
                self.program.display()
            )),
        }
    }

    /// The process is gone, or has to go.
    fn lost(&mut self, why: &str) {
        self.hands = None;
        self.generation += 1;
        let sent: Vec<u64> = self
            .jobs
            .iter()
            .filter(|(_, job)| job.sent)
            .map(|(job, _)| *job)
            .collect();
        let failed: Vec<Pending> = sent.iter().filter_map(|job| self.jobs.remove(job)).collect();
        let state = self
            .health
            .lost(why, failed.iter().map(|pending| &pending.task), Instant::now());
        let trouble = self.health.trouble();
        let given_up = if state == State::Down {
            std::mem::take(&mut self.jobs)
        } else {
            BTreeMap::new()
        };
        for pending in failed.into_iter().chain(given_up.into_values()) {
            let message = trouble.clone();
            pending.say(News::Failed { message }, Vec::new());
        }
        self.status(state, Some(trouble));
    }

    fn status(&mut self, state: State, message: Option<String>) {
        (self.report)(Report::Status { state, message });
    }
}

impl Pending {
    fn say(&self, news: News, payload: Vec<u8>) {
        // Whoever asked may have gone.
        self.news.send((news, payload)).unwrap_or_default();
    }
}
