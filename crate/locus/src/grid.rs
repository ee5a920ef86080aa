//! The connectedness locus over a rectangle of parameters, in tiles and from coarse to fine.

use std::ops::Range;

use frond_core::Affine2;
use thiserror::Error;

use crate::decide::{Scratch, decide};
use crate::family::Family;
use crate::verdict::{Sample, State};

/// A rectangle of the (u, v) plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Left.
    pub u0: f64,
    /// Bottom.
    pub v0: f64,
    /// Right.
    pub u1: f64,
    /// Top.
    pub v1: f64,
}

impl Default for Bounds {
    /// [-1, 2] x [-1, 2], where Burch & Hart (1997, section 5) draw the locus.
    fn default() -> Self {
        Self { u0: -1.0, v0: -1.0, u1: 2.0, v1: 2.0 }
    }
}

/// Why a locus cannot be sampled so.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum GridError {
    /// No samples, or more than [`LocusGrid::LARGEST`] along a side.
    #[error("A locus of {width} x {height} samples cannot be made. Give 1 to 8192 along each side.")]
    Size {
        /// Samples across.
        width: usize,
        /// Samples up.
        height: usize,
    },
    /// A bound is NaN or infinite.
    #[error("The bounds of the locus must be finite numbers.")]
    Bounds,
    /// The arrays of a [`Locus`] do not have one number for each sample.
    #[error("The locus must have one state (0 to 4) and one gap for each of its samples.")]
    Samples,
}

impl GridError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Size { .. } => "locus-size",
            Self::Bounds => "locus-bounds",
            Self::Samples => "locus-samples",
        }
    }
}

/// Where a locus is sampled: `width` x `height` parameters, evenly over a rectangle, both ends included.
/// Row 0 is `v0`, the bottom.
///
/// A side of 3 k + 1 samples over [-1, 2] holds 0 and 1, exactly: the ends of a morph often lie on the very
/// boundary of the locus, where a sample a hair's breadth off would paint them as broken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocusGrid {
    bounds: Bounds,
    width: usize,
    height: usize,
}

impl LocusGrid {
    /// The most samples along a side.
    pub const LARGEST: usize = 8192;
    /// The budget of [`decide`] for each sample of up to ten maps; more maps have more pairs.
    pub const BUDGET: usize = 20_000;
    /// The state of a sample that a tile leaves to another.
    pub const UNTOUCHED: u8 = 255;

    /// The budget of [`decide`] for each sample of so many maps.
    #[must_use]
    pub fn budget(maps: usize) -> usize {
        Self::BUDGET.max(2_000 * maps)
    }

    /// A grid over `bounds`, which may be of zero size or turned round.
    ///
    /// # Errors
    /// [`GridError::Size`] and [`GridError::Bounds`].
    pub fn new(bounds: Bounds, width: usize, height: usize) -> Result<Self, GridError> {
        let side = 1..=Self::LARGEST;
        if !side.contains(&width) || !side.contains(&height) {
            return Err(GridError::Size { width, height });
        }
        let Bounds { u0, v0, u1, v1 } = bounds;
        if ![u0, v0, u1, v1, u1 - u0, v1 - v0].iter().all(|x| x.is_finite()) {
            return Err(GridError::Bounds);
        }
        Ok(Self { bounds, width, height })
    }

    /// Its rectangle.
    #[must_use]
    pub const fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Samples across.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width
    }

    /// Samples up.
    #[must_use]
    pub const fn height(&self) -> usize {
        self.height
    }

    /// The u of column `x`.
    #[must_use]
    pub fn u(&self, x: usize) -> f64 {
        at(self.bounds.u0, self.bounds.u1, x, self.width)
    }

    /// The v of row `y`.
    #[must_use]
    pub fn v(&self, y: usize) -> f64 {
        at(self.bounds.v0, self.bounds.v1, y, self.height)
    }

    /// Decides the samples of a range of rows that lie on the grid of every `stride`-th row and column and,
    /// unless this is the `first` pass, not on that of twice the stride, which the pass before has done. So
    /// the passes 8 (first), 4, 2, 1, over any split of the rows, visit every sample once.
    ///
    /// `epsilon` is relative to the diameter of each attractor. A [`Morph`](frond_core::Morph) is the family of its
    /// plane w = 0; [`LocusGrid::patch`] needs fewer decisions where there is no need for passes.
    pub fn run<F: Family + ?Sized>(
        &self,
        family: &F,
        epsilon: f64,
        pass: &Pass,
        scratch: &mut Scratch,
        mut visit: impl FnMut(usize, usize, Sample),
    ) {
        let mut maps: Vec<Affine2> = Vec::with_capacity(family.len());
        let stride = pass.stride.max(1);
        let end = pass.rows.end.min(self.height);
        for y in (pass.rows.start.next_multiple_of(stride)..end).step_by(stride) {
            let done_before = !pass.first && y % (2 * stride) == 0;
            let (start, step) = if done_before { (stride, 2 * stride) } else { (0, stride) };
            for x in (start..self.width).step_by(step) {
                family.fill(self.u(x), self.v(y), &mut maps);
                visit(x, y, decide(&maps, epsilon, Self::budget(maps.len()), scratch));
            }
        }
    }

    /// [`LocusGrid::run`] into arrays of the full width: one row for each row of the range that is a multiple
    /// of the stride. Samples of other passes are [`LocusGrid::UNTOUCHED`] and NaN.
    #[must_use]
    pub fn tile<F: Family + ?Sized>(
        &self,
        family: &F,
        epsilon: f64,
        pass: &Pass,
        scratch: &mut Scratch,
    ) -> Tile {
        let stride = pass.stride.max(1);
        let start = pass.rows.start.next_multiple_of(stride);
        let rows = pass.rows.end.min(self.height).saturating_sub(start).div_ceil(stride);
        let mut tile =
            Tile { state: vec![Self::UNTOUCHED; rows * self.width], gap: vec![f32::NAN; rows * self.width] };
        self.run(family, epsilon, pass, scratch, |x, y, sample| {
            let i = (y - start) / stride * self.width + x;
            tile.state[i] = sample.state as u8;
            tile.gap[i] = sample.gap;
        });
        tile
    }

    /// Decides samples that are [`State::Undecided`] with a gap of NaN, which says that nobody has looked at them in
    /// double precision: at most `most` of them. Returns how many such are left; one that this cannot tell either stays
    /// undecided, and has a gap.
    ///
    /// # Errors
    /// [`GridError::Samples`] where an array does not have one number for each sample.
    pub fn settle<F: Family + ?Sized>(
        &self,
        family: &F,
        epsilon: f64,
        mut most: usize,
        state: &mut [u8],
        gap: &mut [f32],
    ) -> Result<usize, GridError> {
        let count = self.width * self.height;
        if state.len() != count || gap.len() != count {
            return Err(GridError::Samples);
        }
        let (mut maps, mut scratch, mut left) = (Vec::new(), Scratch::default(), 0);
        for k in 0..count {
            if state[k] != State::Undecided as u8 || !gap[k].is_nan() {
                continue;
            }
            if most == 0 {
                left += 1;
                continue;
            }
            most -= 1;
            family.fill(self.u(k % self.width), self.v(k / self.width), &mut maps);
            let sample = decide(&maps, epsilon, Self::budget(maps.len()), &mut scratch);
            state[k] = sample.state as u8;
            // Where there is no bound of the gap at all: it is no wider than the attractor.
            gap[k] = if sample.state == State::Undecided && sample.gap.is_nan() { 1.0 } else { sample.gap };
        }
        Ok(left)
    }

    /// The whole locus in one pass.
    #[must_use]
    pub fn locus<F: Family + ?Sized>(&self, family: &F, epsilon: f64) -> Locus {
        let pass = Pass { rows: 0..self.height, stride: 1, first: true };
        let Tile { state, gap } = self.tile(family, epsilon, &pass, &mut Scratch::default());
        Locus { grid: *self, state, gap }
    }
}

/// The `i`-th of `count` numbers from `from` to `to`, both included.
fn at(from: f64, to: f64, i: usize, count: usize) -> f64 {
    if i + 1 == count && count > 1 {
        return to;
    }
    // Multiplied first: 3 * k / (3 * k) is exactly 1.
    from + (to - from) * i as f64 / (count.max(2) - 1) as f64
}

/// A part of the work on a locus: see [`LocusGrid::run`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pass {
    /// The rows to do.
    pub rows: Range<usize>,
    /// Every how-manieth row and column.
    pub stride: usize,
    /// Whether no coarser pass was done before.
    pub first: bool,
}

/// What a [`Pass`] found: see [`LocusGrid::tile`].
#[derive(Clone, Debug, PartialEq)]
pub struct Tile {
    /// Numbers of [`State`].
    pub state: Vec<u8>,
    /// Relative gaps, as in [`Sample`].
    pub gap: Vec<f32>,
}

/// A locus: the verdict and the relative widest gap of every sample of a grid, row by row from the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Locus {
    grid: LocusGrid,
    state: Vec<u8>,
    gap: Vec<f32>,
}

impl Locus {
    /// A locus whose samples were decided elsewhere.
    ///
    /// # Errors
    /// [`GridError::Samples`] if an array has the wrong length or a state is not one of [`State`].
    pub fn from_parts(grid: LocusGrid, state: Vec<u8>, gap: Vec<f32>) -> Result<Self, GridError> {
        let count = grid.width * grid.height;
        let known = state.iter().all(|&code| State::from_code(code).is_some());
        if state.len() == count && gap.len() == count && known {
            Ok(Self { grid, state, gap })
        } else {
            Err(GridError::Samples)
        }
    }

    /// Where it is sampled.
    #[must_use]
    pub const fn grid(&self) -> &LocusGrid {
        &self.grid
    }

    /// The numbers of the states.
    #[must_use]
    pub fn state(&self) -> &[u8] {
        &self.state
    }

    /// The relative gaps.
    #[must_use]
    pub fn gap(&self) -> &[f32] {
        &self.gap
    }

    /// The arrays, without copying them.
    #[must_use]
    pub fn into_parts(self) -> (Vec<u8>, Vec<f32>) {
        (self.state, self.gap)
    }

    /// The sample in column `x` and row `y`.
    ///
    /// # Panics
    /// If there is no such sample.
    #[must_use]
    pub fn sample(&self, x: usize, y: usize) -> Sample {
        let i = y * self.grid.width + x;
        let state = State::from_code(self.state[i]).unwrap_or(State::Undecided);
        Sample { state, gap: self.gap[i] }
    }
}

#[cfg(test)]
mod tests {
    use frond_core::{Morph, MorphOptions};

    use super::*;

    fn morph() -> Morph {
        let at = |s: f64, e, f| Affine2::from_row([s, 0.0, 0.0, s, e, f]);
        let gasket = [at(0.5, 0.0, 0.0), at(0.5, 0.5, 0.0), at(0.5, 0.0, 0.5)];
        let dust = [at(0.3, 0.0, 0.0), at(0.3, 0.7, 0.0), at(0.3, 0.0, 0.7)];
        Morph::new(&gasket, &dust, &MorphOptions::default()).unwrap()
    }

    #[test]
    fn three_k_plus_one_samples_hold_both_ends_exactly() {
        for k in [1, 7, 21, 85, 333] {
            let grid = LocusGrid::new(Bounds::default(), 3 * k + 1, 3 * k + 1).unwrap();
            assert_eq!([grid.u(0), grid.u(k), grid.u(2 * k), grid.u(3 * k)], [-1.0, 0.0, 1.0, 2.0]);
            assert_eq!([grid.v(k), grid.v(2 * k)], [0.0, 1.0]);
        }
        let odd = Bounds { u0: 0.1, v0: 0.0, u1: 0.7, v1: 0.0 };
        let grid = LocusGrid::new(odd, 11, 1).unwrap();
        assert_eq!((grid.u(0), grid.u(10), grid.v(0)), (0.1, 0.7, 0.0));
    }

    #[test]
    fn coarse_to_fine_visits_every_sample_once_and_agrees_with_one_pass() {
        let grid = LocusGrid::new(Bounds::default(), 22, 19).unwrap();
        let (morph, mut scratch) = (morph(), Scratch::default());
        let whole = grid.locus(&morph, 1e-3);
        let mut visits = vec![0; 22 * 19];
        for (k, stride) in [8, 4, 2, 1].into_iter().enumerate() {
            for rows in [0..5, 5..16, 16..40] {
                let pass = Pass { rows, stride, first: k == 0 };
                let tile = grid.tile(&morph, 1e-3, &pass, &mut scratch);
                grid.run(&morph, 1e-3, &pass, &mut scratch, |x, y, sample| {
                    visits[y * 22 + x] += 1;
                    assert_eq!(sample.state, whole.sample(x, y).state);
                    assert_eq!(sample.gap, whole.sample(x, y).gap);
                    let row = y / stride - pass.rows.start.div_ceil(stride);
                    assert_eq!(tile.state[row * 22 + x], sample.state as u8);
                });
            }
        }
        assert!(visits.iter().all(|&n| n == 1), "{visits:?}");
    }

    #[test]
    fn what_is_left_is_settled_in_slices() {
        let grid = LocusGrid::new(Bounds::default(), 13, 10).unwrap();
        let whole = grid.locus(&morph(), 1e-3);
        let (mut state, mut gap) = (whole.state().to_vec(), whole.gap().to_vec());
        // What somebody has looked at is left alone.
        (state[1], gap[1]) = (State::Undecided as u8, 0.5);
        for k in (2..130).step_by(3) {
            (state[k], gap[k]) = (State::Undecided as u8, f32::NAN);
        }
        let mut settle = |most| grid.settle(&morph(), 1e-3, most, &mut state, &mut gap);
        assert_eq!([settle(40), settle(usize::MAX)], [Ok(3), Ok(0)]);
        assert_eq!((state[1], gap[1]), (State::Undecided as u8, 0.5));
        assert_eq!(state[2..], whole.state()[2..]);
        assert_eq!(grid.settle(&morph(), 1e-3, 9, &mut state[1..], &mut gap), Err(GridError::Samples));
    }

    #[test]
    fn the_ends_and_the_states_are_right() {
        let grid = LocusGrid::new(Bounds::default(), 31, 31).unwrap();
        let locus = grid.locus(&morph(), 1e-4);
        assert_eq!(locus.sample(10, 10).state, State::Touching);
        let broken = locus.sample(20, 20);
        assert_eq!(broken.state, State::Disconnected);
        // Pieces of size 0.3, 0.4 apart, along a leg; the diameter is the root of 2.
        assert!((f64::from(broken.gap) / (0.4 / 2.0_f64.sqrt()) - 1.0).abs() < 0.06, "{}", broken.gap);
        // Scale 0.7 at u = -1, below 0 nowhere.
        assert!(locus.state().iter().all(|&code| code <= 2));
        let wide = Bounds { u0: -3.0, u1: -2.6, ..Bounds::default() };
        let none = LocusGrid::new(wide, 2, 2).unwrap().locus(&morph(), 1e-4);
        assert!(none.state().iter().all(|&code| code == State::NoAttractor as u8));
        assert!(none.gap().iter().all(|gap| gap.is_nan()));
    }

    #[test]
    fn bad_grids_are_refused() {
        let size = |w, h| LocusGrid::new(Bounds::default(), w, h).map_err(|e| e.code());
        assert_eq!(size(0, 5), Err("locus-size"));
        assert_eq!(size(5, 1 << 40), Err("locus-size"));
        let bad = Bounds { u1: f64::INFINITY, ..Bounds::default() };
        assert_eq!(LocusGrid::new(bad, 4, 4), Err(GridError::Bounds));
        let grid = LocusGrid::new(Bounds::default(), 2, 2).unwrap();
        assert_eq!(Locus::from_parts(grid, vec![0; 4], vec![0.0; 3]), Err(GridError::Samples));
        assert_eq!(Locus::from_parts(grid, vec![255; 4], vec![0.0; 4]), Err(GridError::Samples));
    }
}
