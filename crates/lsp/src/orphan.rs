//! Notices that the client is gone without a word.

use std::time::Duration;

/// How often it is asked after.
const PAUSE: Duration = Duration::from_secs(1);

/// Ends when the client's process does; never where that can't be told. A client in another container gives a number
/// that means nothing here, so one that is not to be found at the start is not waited for.
pub(crate) async fn orphaned(client: Option<u32>) {
    let Some(client) = client.filter(|client| alive(*client)) else {
        return std::future::pending().await;
    };
    while alive(client) {
        tokio::time::sleep(PAUSE).await;
    }
}

/// Whether there is a process of this number.
#[cfg(unix)]
fn alive(process: u32) -> bool {
    use rustix::process::{Pid, test_kill_process};

    let process = i32::try_from(process).ok().and_then(Pid::from_raw);
    // A process of another user is there all the same.
    process.is_some_and(|process| test_kill_process(process) != Err(rustix::io::Errno::SRCH))
}

/// Elsewhere the end of the client's stream has to do.
#[cfg(not(unix))]
fn alive(_process: u32) -> bool {
    false
}
