//! The locus of a morph in space, and the way through it.

use std::ops::Range;

use frond_core::{Affine3, Morph3};
use glam::DVec3;

use crate::grid::{Bounds, GridError, Locus, LocusGrid, Tile};
use crate::path::check::{Parameters, PathCheck, judge};
use crate::path::plan::{PathError, PathPlan, field_of};
use crate::path::repair::{LEAST_CHECKS, MOST_REPAIRS, improve};
use crate::path::search::PathOptions;
use crate::space::decide::{Scratch3, decide3};
use crate::verdict::Sample;

impl Parameters for Morph3 {
    type Memory = (Scratch3, Vec<Affine3>);

    fn sample(&self, at: DVec3, epsilon: f64, (scratch, maps): &mut Self::Memory) -> Sample {
        self.fill3(at.x, at.y, at.z, maps);
        decide3(maps, epsilon, LocusGrid::budget(maps.len()), scratch)
    }
}

/// Decides every `stride`th sample of the rows of a range that are a multiple of it, in the plane of (u, v). `epsilon`
/// is relative to the diameter of the attractor.
#[must_use]
pub fn tile3(
    grid: &LocusGrid,
    morph: &Morph3,
    epsilon: f64,
    rows: Range<usize>,
    stride: usize,
    scratch: &mut Scratch3,
) -> Tile {
    let stride = stride.max(1);
    let budget = LocusGrid::budget(morph.len());
    let (mut state, mut gap, mut maps) = (Vec::new(), Vec::new(), Vec::new());
    for row in (rows.start..rows.end.min(grid.height())).filter(|row| row.is_multiple_of(stride)) {
        for column in (0..grid.width()).step_by(stride) {
            morph.fill3(grid.u(column), grid.v(row), 0.0, &mut maps);
            let sample = decide3(&maps, epsilon, budget, scratch);
            state.push(sample.state as u8);
            gap.push(sample.gap);
        }
    }
    Tile { state, gap }
}

/// Samples the connectedness locus of a morph in space over a rectangle of (u, v), as [`LocusGrid::locus`] does in
/// the plane. `epsilon` is relative to the diameter of the attractor.
///
/// # Errors
/// None but those of [`Locus::from_parts`], which do not occur.
pub fn locus3(grid: &LocusGrid, morph: &Morph3, epsilon: f64) -> Result<Locus, GridError> {
    let Tile { state, gap } = tile3(grid, morph, epsilon, 0..grid.height(), 1, &mut Scratch3::default());
    Locus::from_parts(*grid, state, gap)
}

/// Plans a path from the first shape of a morph in space to the last, in the plane of (u, v), and checks it between
/// the samples of the locus: what [`find_path`](crate::find_path) does in the plane, with the same planner. The third
/// axis of the options is not looked along.
///
/// # Errors
/// [`PathError::Grid`] for a size out of range.
pub fn find_path3(morph: &Morph3, options: &PathOptions) -> Result<PathPlan, PathError> {
    let PathOptions { epsilon, size, .. } = *options;
    let mut best: Option<PathPlan> = None;
    // A side of 3 k + 1 samples holds both ends.
    let thirds = size.saturating_sub(1).div_ceil(3).max(1);
    for refinement in [1, 2] {
        let side = (3 * thirds).saturating_mul(refinement).saturating_add(1);
        let grid = match LocusGrid::new(Bounds::default(), side, side) {
            Ok(grid) => grid,
            Err(error) if best.is_none() => return Err(error.into()),
            Err(_) => break,
        };
        let mut field = field_of(&locus3(&grid, morph, epsilon)?, epsilon)?;
        let tried = improve(morph, &mut field, epsilon, (LEAST_CHECKS / 4).max(8 * side), MOST_REPAIRS);
        let done = tried.plan.holds || tried.final_word;
        if best.as_ref().is_none_or(|best| tried.plan.gap < best.gap) {
            best = Some(tried.plan);
        }
        if done {
            break;
        }
    }
    best.ok_or(PathError::Outside)
}

/// Decides `samples` parameters (u, v, w) spread evenly along a path of a morph in space, both ends included, and
/// reports where it breaks.
#[must_use]
pub fn check_path3(morph: &Morph3, points: &[DVec3], epsilon: f64, samples: usize) -> PathCheck {
    judge(morph, points, epsilon, samples, |_| ())
}
