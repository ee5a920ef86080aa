//! Self-affinity found by voting (Cochran, Hart & Flynn, section 3.1).
//!
//! Every domain triple of a coarse feature set is laid on every range of a fine one; each pairing votes for one affine
//! map [a 0; b c] + [d e]. Maps that the graph is made of get many votes. Five dimensions of bins would not fit in
//! memory: a first pass counts (a, b, c) only, a second one counts (d, e) for the cells that did best.

mod assemble;
mod cluster;
mod echo;
mod features;
mod frame;
mod pairing;
mod pass;
mod picked;
mod polish;
mod refine;
mod share;
mod space;

pub use assemble::{Assembly, Model, assemble};
pub use cluster::{Cluster, Found, Kind, name_clusters, refine_map};
pub use echo::Letter;
pub use features::{Features, MAX_FEATURES};
pub use pass::{FirstPass, HoughProgress, SecondPass};
pub use picked::{Pick, assemble_picked};
pub use refine::Candidate;
pub use share::{gather, share_cells};
pub use space::{Components, in_range};

use std::sync::Arc;

use thiserror::Error;

use pairing::Pairing;

/// Bins of a, b and c each.
pub const BINS: usize = 128;

/// Bins of d and e each, in the second pass.
pub const PLANE: usize = 256;

/// The most cells whose (d, e) are counted: 200 planes take 50 MiB.
pub const MAX_CELLS: usize = 200;

/// What is counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoughOptions {
    /// Whether mirrored maps (a < 0) are tried, too; it takes twice as long.
    pub reflected: bool,
    /// Maps with a smaller |a| are clutter: almost everything looks alike when it is small. They are not counted.
    pub least_a: f64,
    /// Maps with a smaller |c| are clutter: they flatten everything. They get no cell in the second pass.
    pub least_c: f64,
    /// How many (a, b, c) cells the second pass looks at, at most [`MAX_CELLS`].
    pub cells: usize,
    /// The largest |b|, in heights for a length of the interval.
    pub most_b: f64,
}

impl Default for HoughOptions {
    fn default() -> Self {
        Self { reflected: true, least_a: 0.15, least_c: 0.15, cells: 100, most_b: 3.0 }
    }
}

/// Why nothing is counted.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum HoughError {
    /// Fewer than three feature points.
    #[error("There are {count} feature points, and three are the least. Take more.")]
    TooFewFeatures {
        /// How many there are.
        count: usize,
    },
    /// More than [`MAX_FEATURES`].
    #[error("There are {count} feature points, and the most is 1025. Take fewer.")]
    TooManyFeatures {
        /// How many there are.
        count: usize,
    },
    /// A series of more than [`MAX_POINTS`](crate::MAX_POINTS) points.
    #[error("There are {count} points, and the most is 1048576. Take every second one, or fewer.")]
    TooManyPoints {
        /// How many there are.
        count: usize,
    },
    /// A number is NaN, infinite or beyond 1e100.
    #[error("Feature point {} holds a number that is not finite or is too large. Mend it or leave it out.", .index + 1)]
    NotFinite {
        /// Index of the point.
        index: usize,
    },
    /// The parameters do not increase.
    #[error("Feature point {} does not lie to the right of the one before it. Sort the points, and keep one of equals.", .index + 1)]
    NotIncreasing {
        /// Index of the second of the two.
        index: usize,
    },
}

impl HoughError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooFewFeatures { .. } => "too-few-features",
            Self::TooManyFeatures { .. } => "too-many-features",
            Self::TooManyPoints { .. } => "too-many-points",
            Self::NotFinite { .. } => "not-finite",
            Self::NotIncreasing { .. } => "not-increasing",
        }
    }
}

#[derive(Clone, Debug)]
enum Pass {
    First(FirstPass),
    Second(SecondPass),
    Done(Vec<Cluster>),
}

/// Both passes, one short step after the other.
///
/// Between steps the work may be dropped at any time. Where two workers share it, they run a [`FirstPass`] and a
/// [`SecondPass`] each instead, and their counts are added.
#[derive(Clone, Debug)]
pub struct Hough {
    pairing: Arc<Pairing>,
    pass: Pass,
    votes: u64,
}

impl Hough {
    /// Begins with domains from `coarse` and ranges from `fine`.
    #[must_use]
    pub fn new(coarse: &Features, fine: &Features, options: HoughOptions) -> Self {
        let first = FirstPass::new(coarse, fine, options, (0, 1));
        Self { pairing: first.pairing().clone(), pass: Pass::First(first), votes: 0 }
    }

    /// Goes one step on, of some milliseconds.
    pub fn step(&mut self) -> HoughProgress {
        match &mut self.pass {
            Pass::First(first) => {
                let progress = first.step();
                if first.is_done() {
                    let cells = first.promising();
                    let second = SecondPass::of(self.pairing.clone(), &cells, (0, 1));
                    self.pass = Pass::Second(second);
                }
                self.votes = progress.votes;
                HoughProgress { share: 0.5 * progress.share, ..progress }
            }
            Pass::Second(second) => {
                let progress = second.step();
                if second.is_done() {
                    let clusters = second.clusters();
                    self.pass = Pass::Done(clusters);
                }
                HoughProgress { share: 0.5 + 0.5 * progress.share, votes: self.votes }
            }
            Pass::Done(_) => HoughProgress { share: 1.0, votes: self.votes },
        }
    }

    /// Whether all is counted.
    #[must_use]
    pub fn is_done(&self) -> bool {
        matches!(self.pass, Pass::Done(_))
    }

    /// The clusters, those with most hits first; empty until all is counted.
    #[must_use]
    pub fn clusters(&self) -> &[Cluster] {
        if let Pass::Done(clusters) = &self.pass { clusters } else { &[] }
    }

    /// Steps to the end.
    #[must_use]
    pub fn finish(mut self) -> Vec<Cluster> {
        while !self.is_done() {
            self.step();
        }
        if let Pass::Done(clusters) = self.pass { clusters } else { Vec::new() }
    }
}
