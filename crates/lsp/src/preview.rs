//! The live preview: pictures of a scene as it is written.
//!
//! What traces is another process, so that a driver that crashes or hangs takes no word of the editor with it. This holds
//! both sides and what they say to each other: [`work`] is what runs in that process, [`Preview`] starts it, watches over
//! it and asks it. Neither knows documents or the editor's protocol.

mod draw;
mod hands;
mod health;
mod machine;
mod outline;
mod passes;
mod processor;
mod stock;
mod supervisor;
mod view;
mod wire;
mod words;
mod worker;

pub use supervisor::{Asked, Limits, Preview, Report, State};
pub use wire::{MAX_PAYLOAD, PROTOCOL, WireError, receive, send};
pub use words::{Answer, CameraUsed, CameraWish, Look, News, Order, Pass, Quality, Task};
pub use worker::work;
