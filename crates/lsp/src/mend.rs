//! What becomes of one message before the protocol library sees it.
//!
//! The library ends for good at a body that it can't decode, so none reaches it. It must not know what a method does; the
//! greeting alone is told apart, since newer clients say more in it than the library reads.

use std::borrow::Cow;

use tower_lsp::jsonrpc::{Request, Response};

use crate::newer::say_again;

/// The method of the greeting.
const GREETING: &str = "initialize";

/// A message that can be decoded.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Message {
    /// The JSON text.
    pub(crate) body: Vec<u8>,
    /// What it asks for; empty for a response.
    pub(crate) method: String,
}

/// Makes sure that a body can be decoded. Parameters that are no structure, such as `null`, are left out, and halves of
/// surrogate pairs become U+FFFD: either is one UTF-16 code unit, so places in the text stay true.
///
/// # Errors
/// Why the body can't be used.
pub(crate) fn mend(body: Vec<u8>) -> Result<Message, String> {
    match decode(&body) {
        Ok(request) => finish(request, body),
        Err(error) => match whole_pairs(&body) {
            Cow::Borrowed(_) => Err(error.to_string()),
            Cow::Owned(mended) => {
                let request = decode(&mended).map_err(|error| error.to_string())?;
                finish(request, mended)
            }
        },
    }
}

/// Every message decodes as a request, a response as one without a method.
fn decode(body: &[u8]) -> serde_json::Result<Request> {
    serde_json::from_slice(body)
}

fn finish(request: Request, body: Vec<u8>) -> Result<Message, String> {
    let method = request.method().to_owned();
    if method.is_empty() {
        return match serde_json::from_slice::<Response>(&body) {
            Ok(_) => Ok(Message { body, method }),
            Err(_) => Err("neither a request nor a response".to_owned()),
        };
    }
    let structured = |params: &serde_json::Value| params.is_object() || params.is_array();
    let whole = request.params().is_none_or(structured);
    if whole && method != GREETING {
        return Ok(Message { body, method });
    }
    let (_, id, params) = request.into_parts();
    let mut params = params.filter(structured);
    if whole && !params.as_mut().is_some_and(say_again) {
        return Ok(Message { body, method });
    }
    let mut mended = Request::build(method.clone());
    if let Some(id) = id {
        mended = mended.id(id);
    }
    if let Some(params) = params {
        mended = mended.params(params);
    }
    let body = serde_json::to_vec(&mended.finish()).map_err(|error| error.to_string())?;
    Ok(Message { body, method })
}

/// Replaces every escape of a lone surrogate.
fn whole_pairs(body: &[u8]) -> Cow<'_, [u8]> {
    let mut lone = Vec::new();
    let mut at = 0;
    while let Some(next) = position(body, at) {
        at = next + 2;
        let Some(unit) = escape(body, next) else {
            continue;
        };
        at = next + 6;
        match unit {
            0xD800..=0xDBFF if matches!(escape(body, at), Some(0xDC00..=0xDFFF)) => at += 6,
            0xD800..=0xDFFF => lone.push(next),
            _ => {}
        }
    }
    if lone.is_empty() {
        return Cow::Borrowed(body);
    }
    let mut body = body.to_vec();
    for at in lone {
        if let Some(escape) = body.get_mut(at..at + 6) {
            escape.copy_from_slice(b"\\ufffd");
        }
    }
    Cow::Owned(body)
}

/// Where the next backslash stands.
fn position(body: &[u8], from: usize) -> Option<usize> {
    let rest = body.get(from..)?;
    rest.iter().position(|byte| *byte == b'\\').map(|found| from + found)
}

/// The code unit that is escaped at a backslash.
fn escape(body: &[u8], at: usize) -> Option<u16> {
    let words = body.get(at..at + 6)?.strip_prefix(b"\\u")?;
    u16::from_str_radix(std::str::from_utf8(words).ok()?, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::mend;

    fn check(body: impl AsRef<[u8]>, expect: Result<(&str, &str), ()>) {
        let found = mend(body.as_ref().to_vec());
        let found = found.map(|message| (String::from_utf8(message.body).unwrap(), message.method));
        let expect = expect.map(|(body, method)| (body.to_owned(), method.to_owned()));
        assert_eq!(
            found.map_err(|_| ()),
            expect,
            "{:?}",
            String::from_utf8_lossy(body.as_ref())
        );
    }

    fn same(body: &str, method: &str) {
        check(body, Ok((body, method)));
    }

    #[test]
    fn what_is_whole_passes_as_it_is() {
        same(r#"{"jsonrpc":"2.0","method":"exit"}"#, "exit");
        same(r#"{"jsonrpc":"2.0", "id":1,"method":"a","params":{}}"#, "a");
        same(r#"{"jsonrpc":"2.0","id":"1","method":"a","params":[1],"more":2}"#, "a");
        same(r#"{"jsonrpc":"2.0","id":7,"result":null}"#, "");
        same(r#"{"jsonrpc":"2.0","id":7,"error":{"code":1,"message":"no"}}"#, "");
        same(
            r#"{"jsonrpc":"2.0","method":"a","params":["\ud83d\ude00 \\ud83d \uD83D\uDE00"]}"#,
            "a",
        );
    }

    #[test]
    fn parameters_that_are_no_structure_are_left_out() {
        let bare = r#"{"jsonrpc":"2.0","method":"shutdown","id":3}"#;
        for params in ["null", "3", "\"x\"", "false"] {
            let body = format!(r#"{{"jsonrpc":"2.0","id":3,"method":"shutdown","params":{params}}}"#);
            check(body, Ok((bare, "shutdown")));
        }
        check(
            r#"{"jsonrpc":"2.0","method":"exit","params":null}"#,
            Ok((r#"{"jsonrpc":"2.0","method":"exit"}"#, "exit")),
        );
    }

    #[test]
    fn a_greeting_of_a_newer_client_is_said_as_an_older_one_says_it() {
        let with = |more: &str| {
            let document = format!(r#"{{"diagnostic":{{"codeDescriptionSupport":true}}{more}}}"#);
            let params = format!(r#"{{"capabilities":{{"textDocument":{document}}}}}"#);
            format!(r#"{{"jsonrpc":"2.0","method":"initialize","params":{params},"id":1}}"#)
        };
        let whole = with(r#","publishDiagnostics":{"codeDescriptionSupport":true}"#);
        check(with(""), Ok((&whole, "initialize")));
        same(&whole, "initialize");
        same(
            r#"{"jsonrpc":"2.0", "id":1,"method":"initialize","params":{}}"#,
            "initialize",
        );
        same(r#"{"jsonrpc":"2.0","id":1,"method":"initialize"}"#, "initialize");
    }

    #[test]
    fn halves_of_pairs_become_replacement_characters() {
        let with = |text: &str| format!(r#"{{"jsonrpc":"2.0","method":"a","params":["{text}"]}}"#);
        for (broken, whole) in [
            (r"\ud83d", r"\ufffd"),
            (r"\uDE00", r"\ufffd"),
            (r"x\ud83d\ud83d\ude00y", r"x\ufffd\ud83d\ude00y"),
            (r"\ud83d\n\ude00", r"\ufffd\n\ufffd"),
            (r"\\\ud83d", r"\\\ufffd"),
        ] {
            check(with(broken), Ok((&with(whole), "a")));
        }
    }

    #[test]
    fn the_rest_is_refused() {
        check("", Err(()));
        check("{", Err(()));
        check("3", Err(()));
        check("[]", Err(()));
        check("{}", Err(()));
        check(r#"{"jsonrpc":"1.0","method":"a"}"#, Err(()));
        check(r#"{"jsonrpc":"2.0","method":5}"#, Err(()));
        check(r#"{"jsonrpc":"2.0","id":1}"#, Err(()));
        check(r#"{"jsonrpc":"2.0","id":1.5,"method":"a"}"#, Err(()));
        check(r#"{"jsonrpc":"2.0","method":"a","method":"b"}"#, Err(()));
        check(r#"{"jsonrpc":"2.0","method":"a","params":["\ud83"]}"#, Err(()));
        check(b"{\"jsonrpc\":\"2.0\",\"method\":\"\xFF\"}", Err(()));
        check(format!("{}{}", "[".repeat(100_000), "]".repeat(100_000)), Err(()));
    }
}
