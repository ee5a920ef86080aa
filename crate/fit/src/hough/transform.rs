//! Both passes, one after the other.

use std::sync::Arc;

use super::cluster::Cluster;
use super::features::Features;
use super::options::HoughOptions;
use super::pairing::Pairing;
use super::pass::{FirstPass, HoughProgress, SecondPass};

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
