//! What stands between the client's stream and the protocol library: only whole messages pass, and `exit` is the last.
//!
//! It must not know documents or features.

use std::io::BufRead;

use crate::frames::{read_frame, write_frame};
use crate::log::Log;
use crate::mend::mend;

/// How the client's stream came to its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Last {
    /// Whether `shutdown` was asked for before.
    pub(crate) shut_down: bool,
}

/// Passes frames on until `exit`, the end of the stream, or somebody downstream who takes no more.
pub(crate) fn pump(stream: &mut impl BufRead, log: Log, mut pass: impl FnMut(&[u8]) -> bool) -> Last {
    let mut last = Last { shut_down: false };
    loop {
        let body = match read_frame(stream) {
            Ok(Some(body)) => body,
            Ok(None) => return last,
            Err(error) => {
                log.say(format_args!("cannot read: {error}"));
                return last;
            }
        };
        let length = body.len();
        match mend(body) {
            Ok(message) => {
                log.say(format_args!("<- {} ({length} bytes)", name(&message.method)));
                last.shut_down |= message.method == "shutdown";
                if !pass(&write_frame(&message.body)) || message.method == "exit" {
                    return last;
                }
            }
            Err(error) => log.say(format_args!("dropped a message of {length} bytes: {error}")),
        }
    }
}

fn name(method: &str) -> &str {
    if method.is_empty() { "response" } else { method }
}

#[cfg(test)]
mod tests {
    use super::{Last, pump};
    use crate::frames::write_frame;
    use crate::log::Log;

    fn check(bodies: &[&str], passed: usize, shut_down: bool) {
        let stream: Vec<u8> = bodies.iter().flat_map(|body| write_frame(body.as_bytes())).collect();
        let mut frames = 0;
        let last = pump(&mut stream.as_slice(), Log::default(), |_| {
            frames += 1;
            true
        });
        assert_eq!((frames, last), (passed, Last { shut_down }), "{bodies:?}");
    }

    #[test]
    fn exit_is_the_last_message_and_bad_ones_are_dropped() {
        let exit = r#"{"jsonrpc":"2.0","method":"exit"}"#;
        let shutdown = r#"{"jsonrpc":"2.0","id":1,"method":"shutdown"}"#;
        check(&[exit, shutdown], 1, false);
        check(&[shutdown, exit, "{}"], 2, true);
        check(&["{}", "x", shutdown, "[]"], 1, true);
        check(&[], 0, false);
    }

    #[test]
    fn nothing_more_is_read_once_nobody_takes_it() {
        let stream = write_frame(br#"{"jsonrpc":"2.0","method":"a"}"#).repeat(3);
        let mut frames = 0;
        pump(&mut stream.as_slice(), Log::default(), |_| {
            frames += 1;
            false
        });
        assert_eq!(frames, 1);
    }
}
