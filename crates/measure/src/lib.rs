//! Error against run time: what a picture costs at each setting, how wrong it is, and how wrong it says it may be.
//!
//! Each scene is traced at a ladder of settings and held against a reference that another tracer made in f64 at many
//! samples. What comes of it is a table, a page and a diagram of work and precision. And a render to a tolerance goes the other
//! way: it is told how wrong a picture may be, and finds the samples that each pixel needs. This must not know how scenes are
//! written, nor terminals: it takes a scene and gives back texts and pictures.

mod bound;
mod csv;
mod diagram;
mod discrepancy;
mod doubt;
mod edges;
mod effort;
mod fit;
mod hidden;
mod ladder;
mod numbers;
mod page;
mod pareto;
mod points;
pub mod povray;
mod run;
mod setting;
mod specks;
pub mod stability;
mod timing;
mod tolerance;
mod trial;
mod truth;
mod worth;

pub use bound::Bound;
pub use csv::csv;
pub use diagram::{png, svg};
pub use doubt::{Doubt, doubts};
pub use effort::Effort;
pub use numbers::Numbers;
pub use page::page;
pub use run::{Bench, Process, Report, Row, Start};
pub use setting::{Machine, Program, Setting};
pub use timing::Times;
pub use tolerance::{Achieved, Sampler, Tolerance};
pub use truth::Truth;
pub use worth::{Worth, worth, worth_table};
