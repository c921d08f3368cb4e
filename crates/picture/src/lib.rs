//! The picture: f32 RGB, what a tracer hands back, and (one file each) the formats it is written in.
//!
//! It must not know scenes, plans or devices: a picture is numbers in rows.

mod bands;
mod compare;
mod encode;
mod encode_error;
mod flip;
mod formats;
mod heat;
mod levels;
mod load;
mod overlay;
mod picture;
mod refine;
mod sampled;
mod save;
mod trace;

pub use bands::Bands;
pub use compare::{Figures, SizesDiffer, compare, compare_exact};
pub use encode::{Encoding, encode};
pub use encode_error::EncodeError;
pub use flip::{Flip, FlipError, flip};
pub use formats::{Depth, Format};
pub use heat::heat;
pub use levels::Transfer;
pub use load::{LoadError, load, load_raw};
pub use overlay::overlay;
pub use picture::{MAX_PIXELS, Picture, TooManyPixels};
pub use refine::{Refined, Refiner, SIDES, Task};
pub use sampled::Sampled;
pub use save::{SaveError, save, write_whole};
pub use trace::{Exact, Frame, Layers, Limits, NOTHING, Request, Spread, Stats, TraceError, Tracer, Watch, Window};
