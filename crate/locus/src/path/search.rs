//! A path from the first shape of a morph to the last, looked for and mended.

use frond_core::{Mode, Morph};

use crate::decide::Scratch;
use crate::family::Slice;
use crate::grid::{Bounds, GridError, Locus, LocusGrid};
use crate::path::end_lines::by_end_lines;
use crate::path::plan::{PathError, PathPlan, field_of};
use crate::path::repair::{LEAST_CHECKS, MOST_REPAIRS, improve};
use crate::path::volume::VolumeSearch;

/// Which parameters a path may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axes {
    /// (u, v): stretch and turn go together, as in Burch & Hart's plane.
    #[default]
    Two,
    /// (u, v, w): the stretch may be ahead of the turn, or behind it.
    Three,
}

/// How to plan a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathOptions {
    /// Relative to the diameter of the attractor: gaps up to it count as none.
    pub epsilon: f64,
    /// Samples along a side of the first locus to look at; finer ones follow where it is too coarse.
    pub size: usize,
    /// The parameters to take. With three, a path in the plane w = 0 that holds is preferred.
    pub axes: Axes,
}

impl Default for PathOptions {
    fn default() -> Self {
        Self { epsilon: 1.0 / 600.0, size: 97, axes: Axes::Two }
    }
}

/// Plans a path from the first shape of a morph to the last and checks it between the samples of the locus,
/// on finer loci until it holds or is found not to.
///
/// # Errors
/// [`PathError::Grid`] for a size out of range.
pub fn find_path(morph: &Morph, options: &PathOptions) -> Result<PathPlan, PathError> {
    let mut search = PathSearch::new(morph.clone(), *options);
    loop {
        if let Some(plan) = search.step()? {
            return Ok(plan);
        }
    }
}

/// The same in parts, of about a second or less each: a search through three parameters may take many.
#[derive(Clone, Debug)]
pub struct PathSearch {
    morph: Morph,
    options: PathOptions,
    /// The path in the plane, where there is a third parameter to go on with.
    plane: Option<PathPlan>,
    volume: VolumeSearch,
}

/// Parameters decided in one part.
const DECISIONS_PER_STEP: usize = 1000;

impl PathSearch {
    /// Nothing is looked for yet.
    #[must_use]
    pub fn new(morph: Morph, options: PathOptions) -> Self {
        Self { morph, options, plane: None, volume: VolumeSearch::new() }
    }

    /// Does the next part. The plan comes with the last; what follows is without meaning.
    ///
    /// # Errors
    /// As [`find_path`].
    pub fn step(&mut self) -> Result<Option<PathPlan>, PathError> {
        let Self { morph, options, .. } = self;
        if options.axes == Axes::Two {
            return find_in_plane(morph, options, &[1, 2, 4]).map(Some);
        }
        let Some(plane) = &self.plane else {
            let plane = find_in_plane(morph, options, &[1])?;
            // A linear morph has no third parameter.
            if plane.holds || morph.mode() == Mode::Linear {
                return Ok(Some(plane));
            }
            self.plane = Some(plane);
            return Ok(None);
        };
        let found = self.volume.step(morph, options.epsilon, DECISIONS_PER_STEP);
        Ok(found.map(|space| if space.gap < plane.gap { space } else { plane.clone() }))
    }
}

fn find_in_plane(morph: &Morph, options: &PathOptions, refinements: &[usize]) -> Result<PathPlan, PathError> {
    let PathOptions { epsilon, size, .. } = *options;
    let mut best: Option<PathPlan> = None;
    // A side of 3 k + 1 samples holds both ends.
    let thirds = size.saturating_sub(1).div_ceil(3).max(1);
    for &refinement in refinements {
        let side = (3 * thirds).saturating_mul(refinement).saturating_add(1);
        let grid = match LocusGrid::new(Bounds::default(), side, side) {
            Ok(grid) => grid,
            Err(error) if best.is_none() => return Err(error.into()),
            Err(_) => break,
        };
        let mut field = field_of(&sampled(morph, &grid, epsilon, refinement > 1)?, epsilon)?;
        let checks = LEAST_CHECKS.max(8 * side);
        let mut tried = improve(morph, &mut field, epsilon, checks, MOST_REPAIRS);
        if tried.plan.holds {
            tried.plan = by_end_lines(morph, &field, tried.plan, epsilon, checks);
        }
        let done = tried.plan.holds || tried.final_word;
        let (apart, step) = (tried.plan.apart, tried.plan.step);
        if best.as_ref().is_none_or(|best| tried.plan.gap < best.gap) {
            best = Some(tried.plan);
        }
        // What the finest samples say of the components.
        best = best.map(|best| PathPlan { apart, step, ..best });
        if done {
            break;
        }
    }
    best.ok_or(PathError::Outside)
}

/// The whole locus; of a fine one, whole boxes at once, where gaps are a little less exact.
fn sampled(morph: &Morph, grid: &LocusGrid, epsilon: f64, boxes: bool) -> Result<Locus, GridError> {
    if !boxes {
        return Ok(grid.locus(morph, epsilon));
    }
    let plane = Slice::new(morph, 0.0);
    let (width, height) = (grid.width(), grid.height());
    let tile = grid.patch(&plane, epsilon, 0..width, 0..height, &mut Scratch::default());
    Locus::from_parts(*grid, tile.state, tile.gap)
}

#[cfg(test)]
mod tests {
    use frond_core::{Affine2, MorphOptions};
    use glam::DVec2;

    use super::*;
    use crate::path::check::check_path;
    use crate::path::plan::ENDS;

    #[test]
    fn the_terdragon_reaches_the_gasket_in_one_piece() {
        let row = Affine2::from_row;
        // {l z, -i z / sqrt 3 + l, l z + conj l}, l = 1/2 + i / (2 sqrt 3).
        let (h, r) = (1.0 / 12.0_f64.sqrt(), 1.0 / 3.0_f64.sqrt());
        let terdragon = [
            row([0.5, -h, h, 0.5, 0.0, 0.0]),
            row([0.0, r, -r, 0.0, 0.5, h]),
            row([0.5, -h, h, 0.5, 0.5, -h]),
        ];
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        let gasket = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
        let morph = Morph::new(&terdragon, &gasket, &MorphOptions::default()).unwrap();
        let plan = find_path(&morph, &PathOptions { epsilon: 1e-4, ..Default::default() }).unwrap();
        assert!(plan.holds, "{plan:?}");
    }

    #[test]
    fn the_dragon_reaches_the_gasket_in_one_piece() {
        let row = Affine2::from_row;
        let (a, b) = (row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]), row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]));
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        let gasket = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
        let morph = Morph::new(&[a, b * a, b * b], &gasket, &MorphOptions::default()).unwrap();
        let options = PathOptions { epsilon: 1e-3, size: 49, ..Default::default() };
        let plan = find_path(&morph, &options).unwrap();
        assert!(plan.holds && plan.gap == 0.0 && plan.points.len() <= PathPlan::MOST_POINTS, "{plan:?}");
        assert!(check_path(&morph, &plan.points, 1e-3, 2003).holds);
        // Not only as far as a thousandth tells: it comes to the gasket on u = 1, where it holds exactly.
        let fine = check_path(&morph, &plan.points, 1e-6, 1501);
        assert!(fine.gap < 2e-5, "{plan:?} {fine:?}");
        let straight = check_path(&morph, &ENDS, 1e-3, 400);
        assert!(!straight.holds && straight.gap > 0.01 && !straight.breaks.is_empty(), "{straight:?}");
        let (start, end) = straight.breaks[0];
        assert!(0.0 < start && start < end && end < 1.0);
    }
}
