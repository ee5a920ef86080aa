//! How good a matching is: its path.

use std::cmp::Ordering;

use frond_core::Morph;

use crate::grid::{Bounds, Locus, LocusGrid};
use crate::path::plan::{PathError, PathPlan, field_of};
use crate::path::repair::improve;

/// How closely to look at a matching.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateOptions {
    /// Samples along a side of the locus; rounded up to 3 k + 1, which holds both ends.
    pub size: usize,
    /// Relative to the diameter of the attractor: gaps up to it count as none.
    pub epsilon: f64,
}

impl Default for RateOptions {
    fn default() -> Self {
        Self { size: 49, epsilon: 1.0 / 600.0 }
    }
}

/// What [`rate`] found.
#[derive(Clone, Debug, PartialEq)]
pub struct Rated {
    /// The best path in this locus, judged between its samples, too.
    pub plan: PathPlan,
    /// The share of the samples that hold together.
    pub share: f64,
    /// The locus over [-1, 2] x [-1, 2].
    pub locus: Locus,
}

impl Rated {
    /// The order of matchings, the best first: by the gap of the path, then by its clearance, in steps of a
    /// sixteenth, then by its length.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let steps = |plan: &PathPlan| (16.0 * plan.clearance).round();
        let by_gap = self.plan.gap.total_cmp(&other.plan.gap);
        by_gap
            .then_with(|| steps(&other.plan).total_cmp(&steps(&self.plan)))
            .then_with(|| self.plan.length().total_cmp(&other.plan.length()))
    }
}

/// Parameters decided along the path.
const LEAST_CHECKS: usize = 400;
/// How often the path is mended.
const MOST_REPAIRS: usize = 3;

/// Rates a matching: a small locus, and the path through it. Quicker and coarser than
/// [`find_path`](crate::find_path), for choosing from a list.
///
/// # Errors
/// [`PathError::Grid`] for a size out of range.
pub fn rate(morph: &Morph, options: &RateOptions) -> Result<Rated, PathError> {
    let RateOptions { size, epsilon } = *options;
    let side = size.saturating_sub(1).div_ceil(3).max(1).saturating_mul(3).saturating_add(1);
    let locus = LocusGrid::new(Bounds::default(), side, side)?.locus(morph, epsilon);
    let mut field = field_of(&locus, epsilon)?;
    let plan = improve(morph, &mut field, epsilon, LEAST_CHECKS.max(8 * side), MOST_REPAIRS).plan;
    let held = locus.state().iter().filter(|&&code| code <= 1).count();
    let share = held as f64 / locus.state().len() as f64;
    Ok(Rated { plan, share, locus })
}
