//! Whether the shape of an iterated function system is in one piece.
mod connectedness;
mod decide;
mod exact;
mod frame;
mod graph;
mod grid;
mod outline;
mod proof;
mod search;
mod shared;

pub use connectedness::{Connectedness, Gap, Options, Verdict, connectedness};
pub use decide::{Sample, Scratch, State, decide};
pub use graph::{Components, OverlapGraph};
pub use grid::{Bounds, GridError, Locus, LocusGrid, Pass, Tile};
