//! The process that draws: orders come in on one thread and are worked on by two others, so that a word to stop is heard
//! while a picture is traced, and a click is answered while a long picture is refined.
//!
//! It ends when the line to the server does. It must not know the editor's protocol.

use std::any::Any;
use std::collections::{HashMap, HashSet};
use std::io::{Read, Write};
use std::panic::{self, AssertUnwindSafe};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use scenec_picture::{TraceError, Watch};
use scenec_plan::Plan;
use scenec_scene::SolidId;

use super::draw::{Drawing, Painter};
use super::stock::Stock;
use super::view::camera;
use super::wire::{PROTOCOL, WireError, receive, send};
use super::words::{Answer, Look, News, Order, Task};

/// How long work in progress may take to stop once the line is closed.
const FAREWELL: Duration = Duration::from_secs(2);

/// Works until `input` ends.
///
/// # Errors
/// What came is no order; the other side is another program, or another version of this one.
pub fn work(mut input: impl Read, output: impl Write + Send + 'static) -> Result<(), WireError> {
    let office = Arc::new(Office {
        out: Mutex::new(Box::new(output)),
        jobs: Mutex::default(),
        steps: AtomicU64::new(0),
        stock: Mutex::default(),
    });
    let (done, ended) = mpsc::channel();
    let pictures = lane(&office, done.clone())?;
    let looks = lane(&office, done)?;
    office.say(&Answer::Hello { protocol: PROTOCOL }, &[]);
    let outcome = loop {
        match receive::<Order>(&mut input) {
            Ok(Some((Order::Ping, _))) => office.say(&Answer::Pong { beat: office.beat() }, &[]),
            Ok(Some((Order::Cancel { job }, _))) => office.cancel(job),
            Ok(Some((Order::Job { job, look, task }, text))) => {
                let to = match task {
                    Task::Draw { .. } => &pictures,
                    Task::Pick { .. } | Task::Outline { .. } => &looks,
                };
                let watch = office.open(job);
                let work = Job {
                    job,
                    look,
                    task,
                    text,
                    watch,
                };
                // A lane ends only after this loop.
                to.send(work).unwrap_or_default();
            }
            Ok(None) => break Ok(()),
            Err(error) => break Err(error),
        }
    };
    // Some drivers do not bear a process that ends in the midst of their work.
    office.stop_all();
    drop((pictures, looks));
    let end = Instant::now() + FAREWELL;
    while ended
        .recv_timeout(end.saturating_duration_since(Instant::now()))
        .is_ok()
    {}
    outcome
}

struct Job {
    job: u64,
    look: Look,
    task: Task,
    text: Vec<u8>,
    watch: Arc<Watch>,
}

/// A thread that works on one job after another. `_done` is dropped when it ends.
fn lane(office: &Arc<Office>, done: Sender<()>) -> Result<Sender<Job>, WireError> {
    let (sender, jobs) = mpsc::channel();
    let office = Arc::clone(office);
    let run = move || {
        let _done = done;
        office.run(&jobs);
    };
    thread::Builder::new().name("preview".to_owned()).spawn(run)?;
    Ok(sender)
}

/// What the threads share.
struct Office {
    out: Mutex<Box<dyn Write + Send>>,
    /// Every job that has not ended.
    jobs: Mutex<HashMap<u64, Arc<Watch>>>,
    /// Counts what has no watch.
    steps: AtomicU64,
    stock: Mutex<Stock>,
}

/// A lock whose holder may have panicked: what it guards is whole at any time.
fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Office {
    fn say(&self, answer: &Answer, payload: &[u8]) {
        self.steps.fetch_add(1, Ordering::Relaxed);
        // With the line gone there is nobody to tell, and the orders end too.
        send(&mut *lock(&self.out), answer, payload).unwrap_or_default();
    }

    fn tell(&self, job: u64, news: News, payload: &[u8]) {
        self.say(&Answer::Job { job, news }, payload);
    }

    /// Changes whenever something moves.
    fn beat(&self) -> u64 {
        let pixels = lock(&self.jobs).values().map(|watch| watch.done()).sum::<u64>();
        self.steps.load(Ordering::Relaxed).wrapping_add(pixels)
    }

    fn open(&self, job: u64) -> Arc<Watch> {
        let watch = Arc::new(Watch::new());
        lock(&self.jobs).insert(job, Arc::clone(&watch));
        watch
    }

    fn cancel(&self, job: u64) {
        if let Some(watch) = lock(&self.jobs).get(&job) {
            watch.stop();
        }
    }

    fn stop_all(&self) {
        lock(&self.jobs).values().for_each(|watch| watch.stop());
    }

    fn run(&self, jobs: &Receiver<Job>) {
        let mut painter = Painter::default();
        for job in jobs {
            let number = job.job;
            let outcome = panic::catch_unwind(AssertUnwindSafe(|| self.job(job, &mut painter)));
            let (news, payload) = outcome.unwrap_or_else(|panic| {
                painter = Painter::default();
                lock(&self.stock).clear();
                (
                    News::Failed {
                        message: words(&*panic),
                    },
                    Vec::new(),
                )
            });
            lock(&self.jobs).remove(&number);
            self.tell(number, news, &payload);
        }
    }

    fn job(&self, job: Job, painter: &mut Painter) -> (News, Vec<u8>) {
        match self.attempt(job, painter) {
            Ok(outcome) => outcome,
            Err(TraceError::Cancelled) => (News::Cancelled, Vec::new()),
            Err(error) => {
                let message = error.to_string();
                (News::Failed { message }, Vec::new())
            }
        }
    }

    fn attempt(&self, job: Job, painter: &mut Painter) -> Result<(News, Vec<u8>), TraceError> {
        let begin = Instant::now();
        let watch = &job.watch;
        if watch.stopped() {
            return Err(TraceError::Cancelled);
        }
        let wanted = match job.task {
            Task::Outline { solid } => Some(SolidId(solid)),
            Task::Draw { .. } | Task::Pick { .. } => None,
        };
        let Prepared { plan, camera, leaves } = self.prepare(job.text, &job.look, wanted)?;
        self.steps.fetch_add(1, Ordering::Relaxed);
        if watch.stopped() {
            return Err(TraceError::Cancelled);
        }
        match job.task {
            Task::Draw { quality, device } => {
                let drawing = Drawing {
                    name: &job.look.name,
                    plan: &plan,
                    quality,
                    device: &device,
                    watch,
                    begin,
                };
                let remark = painter.draw(&drawing, |pass, png| self.tell(job.job, News::Pass(pass), png))?;
                Ok((News::Drawn { camera, remark }, Vec::new()))
            }
            Task::Pick { x, y } => {
                let solid = painter.pick(&plan, (x, y), watch)?;
                Ok((News::Picked { solid }, Vec::new()))
            }
            Task::Outline { .. } => {
                let png = painter.outline(&plan, &leaves, watch)?;
                let (width, height) = (plan.view.width, plan.view.height);
                Ok((News::Outlined { width, height }, png))
            }
        }
    }

    /// What is to be traced. Both lanes wait here for each other: what one of them reads, the other need not.
    fn prepare(&self, text: Vec<u8>, look: &Look, wanted: Option<SolidId>) -> Result<Prepared, TraceError> {
        let text = String::from_utf8(text).map_err(|_| TraceError::Failed("the text is not UTF-8".to_owned()))?;
        let mut stock = lock(&self.stock);
        let ready = stock.ready(text, look).map_err(TraceError::Failed)?;
        Ok(Prepared {
            camera: camera(&ready.scene.settings),
            leaves: wanted.map(|solid| ready.leaves_below(solid)).unwrap_or_default(),
            plan: ready.plan,
        })
    }
}

struct Prepared {
    plan: Arc<Plan>,
    camera: super::words::CameraUsed,
    leaves: HashSet<u32>,
}

/// What a panic said.
fn words(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or(panic.downcast_ref::<&str>().copied());
    format!("the program has a fault: {}", text.unwrap_or("no reason given"))
}
