//! A panic costs the request that it happens in, and nothing else: the protocol library would take the whole server down.
//!
//! Work on documents is contained by itself, on threads of its own; this is the net under everything besides. It must not
//! know what the requests are.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::Pin;
use std::task::{Context, Poll};

use tower_lsp::jsonrpc::{Id, Request, Response};
use tower_service::Service;

use crate::log::Log;
use crate::server::failed;

/// A service whose answers can't panic.
pub(crate) struct Contained<S> {
    pub(crate) service: S,
    pub(crate) log: Log,
}

/// An answer on its way.
type Answer<E> = Pin<Box<dyn Future<Output = Result<Option<Response>, E>> + Send>>;

/// An answer that becomes an error if it panics.
pub(crate) struct Guarded<E> {
    /// `None` once it is done, or broken.
    answer: Option<Answer<E>>,
    /// Whom to answer; a notification has nobody.
    asked: Option<Id>,
    log: Log,
}

impl<S> Service<Request> for Contained<S>
where
    S: Service<Request, Response = Option<Response>>,
    S::Future: Send + 'static,
    S::Error: 'static,
{
    type Response = Option<Response>;
    type Error = S::Error;
    type Future = Guarded<S::Error>;

    fn poll_ready(&mut self, context: &mut Context<'_>) -> Poll<Result<(), S::Error>> {
        self.service.poll_ready(context)
    }

    fn call(&mut self, request: Request) -> Self::Future {
        let asked = request.id().cloned();
        let call = AssertUnwindSafe(|| self.service.call(request));
        let answer = catch_unwind(call)
            .ok()
            .map(|answer| Box::pin(answer) as Answer<S::Error>);
        Guarded {
            answer,
            asked,
            log: self.log,
        }
    }
}

impl<E> Future for Guarded<E> {
    type Output = Result<Option<Response>, E>;

    fn poll(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Self::Output> {
        let polled = match &mut self.answer {
            Some(answer) => catch_unwind(AssertUnwindSafe(|| answer.as_mut().poll(context))).ok(),
            None => None,
        };
        if let Some(polled) = polled {
            return polled;
        }
        self.answer = None;
        self.log.say("a message failed");
        let asked = self.asked.take();
        Poll::Ready(Ok(asked.map(|id| Response::from_error(id, failed()))))
    }
}
