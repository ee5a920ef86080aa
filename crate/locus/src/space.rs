//! The same questions in space: whether a shape is in one piece, over which parameters of a morph it is, and a way
//! through them.
//!
//! The gap is the widest edge of the minimum spanning tree of the distances between pieces, as in the plane: Hata's
//! theorem knows no dimension, and balls, support functions and the tree do not either.

mod bracket;
mod connectedness;
mod decide;
mod frame;
mod locus;
mod rational;
mod reason;
mod shared_points;

pub use connectedness::{Connectedness3, connectedness3};
pub use decide::{Scratch3, decide3};
pub use locus::{check_path3, find_path3, locus3, tile3};
pub use reason::{Reason3, Reason3Kind, Shared3};
