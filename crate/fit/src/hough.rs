//! Self-affinity found by voting (Cochran, Hart & Flynn, section 3.1).
//!
//! Every domain triple of a coarse feature set is laid on every range of a fine one; each pairing votes for one affine
//! map [a 0; b c] + [d e]. Maps that the graph is made of get many votes. Five dimensions of bins would not fit in
//! memory: a first pass counts (a, b, c) only, a second one counts (d, e) for the cells that did best.

mod assemble;
mod cluster;
mod echo;
mod error;
mod features;
mod frame;
mod options;
mod pairing;
mod pass;
mod picked;
mod polish;
mod refine;
mod share;
mod space;
mod transform;

pub use assemble::{Assembly, Model, Within, assemble, assemble_within};
pub use cluster::{Cluster, Found, Kind, name_clusters, refine_map};
pub use echo::Letter;
pub use error::HoughError;
pub use features::{Features, MAX_FEATURES};
pub use options::{BINS, HoughOptions, MAX_CELLS, PLANE};
pub use pass::{FirstPass, HoughProgress, SecondPass};
pub use picked::{Pick, assemble_picked};
pub use refine::Candidate;
pub use share::{gather, share_cells};
pub use space::{Components, in_range};
pub use transform::Hough;
