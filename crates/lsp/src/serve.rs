//! From the first byte of the client to the last: the pump, the protocol library, and what ends them.

use std::io;
use std::time::Duration;

use tokio::io::{AsyncWriteExt, DuplexStream, duplex};
use tokio::runtime::{Builder, Handle};
use tokio::sync::{oneshot, watch};
use tokio::time::timeout;
use tower_lsp::{ClientSocket, LspService};

use crate::contain::Contained;
use crate::log::Log;
use crate::options::Options;
use crate::orphan::orphaned;
use crate::pump::{Last, pump};
use crate::server::Server;

/// How many requests may wait for their answers at a time. The library's own small number would let slow ones, such as
/// pictures, keep everything else waiting.
const CONCURRENT: usize = 4096;
/// How much of a stream may be in flight between the pump and the library.
const IN_FLIGHT: usize = 1 << 18;
/// How long the last answers may take to be written.
const FAREWELL: Duration = Duration::from_secs(1);

/// The stack of each thread that works on a document, in bytes.
const STACK: usize = 8 << 20;

/// How the server came to its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ended {
    /// The client asked for it in due form.
    InForm,
    /// The client left without `shutdown`, or is gone.
    Abandoned,
}

/// Serves one client over standard input and output until it is done.
///
/// # Errors
/// If the threads can't be started.
pub fn serve(options: Options) -> io::Result<Ended> {
    let log = Log { on: options.log };
    log.catch_panics();
    let runtime = Builder::new_multi_thread()
        .worker_threads(2)
        .thread_stack_size(STACK)
        .enable_all()
        .build()?;
    let ended = runtime.block_on(talk(options, log))?;
    // Work that nobody waits for any more must not keep the process.
    runtime.shutdown_background();
    log.say(format_args!("ended: {ended:?}"));
    Ok(ended)
}

/// The server with every request that is not of the protocol's own.
fn service(options: Options, client: watch::Sender<Option<u32>>) -> (LspService<Server>, ClientSocket) {
    let service = LspService::build(|handle| Server::new(handle, options, client))
        .custom_method("scene/render", Server::scene_render)
        .custom_method("scene/pick", Server::scene_pick)
        .custom_method("scene/outline", Server::scene_outline)
        .custom_method("scene/writeCamera", Server::scene_write_camera)
        .custom_method("scene/plan", Server::scene_plan);
    // Tests see by these that a panic is contained.
    #[cfg(debug_assertions)]
    let service = service
        .custom_method("scene/panic", Server::scene_panic)
        .custom_method("scene/panicUnasked", Server::scene_panic_unasked);
    service.finish()
}

async fn talk(options: Options, log: Log) -> io::Result<Ended> {
    let (process, client) = watch::channel(None);
    let (service, socket) = service(options, process);
    let service = Contained { service, log };
    let (inlet, input) = duplex(IN_FLIGHT);
    let (output, mut outlet) = duplex(IN_FLIGHT);
    let mut read = read(inlet, log)?;
    let server = tower_lsp::Server::new(input, output, socket).concurrency_level(CONCURRENT);
    let mut served = tokio::spawn(server.serve(service));
    let mut written = tokio::spawn(async move { tokio::io::copy(&mut outlet, &mut tokio::io::stdout()).await });
    let ended = tokio::select! {
        // After a farewell the output ends as well, which then means nothing.
        biased;
        last = &mut read => match last {
            Ok(Last { shut_down: true }) => Ended::InForm,
            _ => Ended::Abandoned,
        },
        // Nobody reads any more.
        _ = &mut written => return Ok(Ended::Abandoned),
        () = gone(client) => return Ok(Ended::Abandoned),
    };
    let farewell = async {
        let served = (&mut served).await;
        let written = (&mut written).await;
        (served.is_ok(), written.is_ok())
    };
    if timeout(FAREWELL, farewell).await.is_err() {
        log.say("some answers were not written");
    }
    Ok(ended)
}

/// Starts the thread that reads, which hands over each frame and at last how it ended.
fn read(mut inlet: DuplexStream, log: Log) -> io::Result<oneshot::Receiver<Last>> {
    let runtime = Handle::current();
    let (done, read) = oneshot::channel();
    let work = move || {
        let pass = |frame: &[u8]| runtime.block_on(inlet.write_all(frame)).is_ok();
        let last = pump(&mut io::stdin().lock(), log, pass);
        // If nobody listens the process is at its end anyway.
        done.send(last).unwrap_or_default();
    };
    std::thread::Builder::new().name("reader".to_owned()).spawn(work)?;
    Ok(read)
}

/// Ends when the client's process does, once it has given its number.
async fn gone(mut client: watch::Receiver<Option<u32>>) {
    let process = client.wait_for(Option::is_some).await.ok().and_then(|process| *process);
    orphaned(process).await;
}
