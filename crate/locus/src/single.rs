//! The locus in single precision, the very way a graphics card does it.

mod descent;
mod map;
mod sample;
mod support;
mod system;

use frond_core::{Affine2, Morph};
use glam::{DMat2, DVec2};
use thiserror::Error;

use crate::grid::LocusGrid;
use crate::verdict::{Sample, State};
use map::{Unit, sum};

pub use map::SingleMap;

/// Why a locus is not one for single precision.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum SingleError {
    /// Too many maps for the memory of one invocation.
    #[error("A graphics card decides 1 to 8 maps, not {maps}. Use the processor.")]
    Maps {
        /// Their number.
        maps: usize,
    },
    /// Epsilon or the step from sample to sample is too small for numbers of 24 bits.
    #[error("This is finer than single precision can tell apart. Use the processor.")]
    Fine,
}

impl SingleError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Maps { .. } => "single-maps",
            Self::Fine => "single-fine",
        }
    }
}

/// A locus to be decided in single precision, by a graphics card or, the same way, by [`SingleLocus::decide`].
///
/// The maps of a sample are sums of a part that depends on its column alone and one that depends on its row: in a
/// morph the linear parts are the column's and the translations the row's; in `s z + t` the real part of s is
/// the column's and the imaginary part the row's. Both come in double precision and are rounded once, with
/// a bound of what that costs, however far one has zoomed in; and no sine is left to the card.
///
/// Coordinates are centred on the attractor of the middle sample and of about its size.
///
/// What is said: `Disconnected` and `Connected` are proved, the rounding of every step from the exact maps on
/// reckoned with (see single/system.rs); `Touching` means that points of the attractor come within epsilon; so two
/// answers differ only where the gap is between zero and epsilon. Whatever single precision cannot tell is
/// `Undecided`: maps that do not contract in the plane's own norm, expansions, points, budgets spent. Those are for
/// [`decide()`](crate::decide()), and both together are right everywhere.
#[derive(Clone, Debug, PartialEq)]
pub struct SingleLocus {
    maps: usize,
    epsilon: f32,
    columns: Vec<SingleMap>,
    rows: Vec<SingleMap>,
}

impl SingleLocus {
    /// The most maps of a system.
    pub const MAX_MAPS: usize = descent::MAX_MAPS;
    /// The least epsilon: rounding alone may be a third of it.
    pub const MIN_EPSILON: f64 = 5e-6;
    /// The least step from sample to sample.
    pub const MIN_STEP: f64 = 1e-6;

    /// The locus of a morph in the plane of (u, v), its stretches `ahead` of its turns.
    ///
    /// # Errors
    /// [`SingleError`]: leave it to the processor.
    pub fn of_morph(morph: &Morph, ahead: f64, grid: &LocusGrid, epsilon: f64) -> Result<Self, SingleError> {
        let linear = |u: f64, maps: &mut Vec<Affine2>| {
            morph.fill3(u, 0.0, ahead, maps);
            maps.iter_mut().for_each(|map| map.translation = DVec2::ZERO);
        };
        let shift = |v: f64, maps: &mut Vec<Affine2>| {
            morph.fill3(0.0, v, 0.0, maps);
            maps.iter_mut().for_each(|map| map.linear = DMat2::ZERO);
        };
        Self::new(morph.len(), grid, epsilon, linear, shift)
    }

    /// The locus of the maps `s z + exp(2 pi i k / sides)`, k = 0 to `sides` - 1, over the complex s: the set M for two
    /// `sides`, {s z - 1, s z + 1}.
    ///
    /// # Errors
    /// [`SingleError`]: leave it to the processor.
    pub fn of_polygons(sides: usize, grid: &LocusGrid, epsilon: f64) -> Result<Self, SingleError> {
        let corner = |k: usize| DVec2::from_angle(std::f64::consts::TAU * k as f64 / sides as f64);
        let real = |x: f64, maps: &mut Vec<Affine2>| {
            maps.clear();
            maps.extend((0..sides).map(|k| Affine2::new(DMat2::from_diagonal(DVec2::splat(x)), corner(k))));
        };
        let imaginary = |y: f64, maps: &mut Vec<Affine2>| {
            let turn = DMat2::from_cols(DVec2::new(0.0, y), DVec2::new(-y, 0.0));
            maps.clear();
            maps.extend((0..sides).map(|_| Affine2::new(turn, DVec2::ZERO)));
        };
        Self::new(sides, grid, epsilon, real, imaginary)
    }

    /// A locus whose maps are sums of what `column` gives for x and `row` for y. Of each entry of a matrix
    /// at most one of the two may be other than zero, so that their sum is exact.
    fn new(
        maps: usize,
        grid: &LocusGrid,
        epsilon: f64,
        column: impl Fn(f64, &mut Vec<Affine2>),
        row: impl Fn(f64, &mut Vec<Affine2>),
    ) -> Result<Self, SingleError> {
        if !(1..=Self::MAX_MAPS).contains(&maps) {
            return Err(SingleError::Maps { maps });
        }
        let bounds = grid.bounds();
        let step = |from: f64, to: f64, count: usize| (to - from).abs() / (count.max(2) - 1) as f64;
        let across = step(bounds.u0, bounds.u1, grid.width());
        let up = step(bounds.v0, bounds.v1, grid.height());
        let too_fine = |step: f64| step != 0.0 && step < Self::MIN_STEP;
        if epsilon.is_nan() || epsilon < Self::MIN_EPSILON || too_fine(across) || too_fine(up) {
            return Err(SingleError::Fine);
        }
        let (mut these, mut those) = (Vec::new(), Vec::new());
        column(grid.u(grid.width() / 2), &mut these);
        row(grid.v(grid.height() / 2), &mut those);
        let middle: Vec<Affine2> = these.iter().zip(&those).map(|(a, b)| sum(a, b)).collect();
        let unit = Unit::of(&middle);
        // The middle row is taken along by the columns: what is left of the rows is small.
        let of_middle_row: Vec<DVec2> = those.iter().map(|map| map.translation).collect();
        let mut columns = Vec::with_capacity(maps * grid.width());
        for x in 0..grid.width() {
            column(grid.u(x), &mut these);
            let with_row = these.iter().zip(&of_middle_row);
            let moved = with_row.map(|(map, &t)| {
                let shift = map.linear * unit.centre - unit.centre + map.translation + t;
                unit.rounded(map.linear, shift)
            });
            columns.extend(moved);
        }
        let mut rows = Vec::with_capacity(maps * grid.height());
        for y in 0..grid.height() {
            row(grid.v(y), &mut those);
            let with_row = those.iter().zip(&of_middle_row);
            let moved = with_row
                .map(|(map, &t)| unit.rounded(map.linear, map.linear * unit.centre + map.translation - t));
            rows.extend(moved);
        }
        Ok(Self { maps, epsilon: epsilon.min(1.0) as f32, columns, rows })
    }

    /// The number of maps.
    #[must_use]
    pub const fn maps(&self) -> usize {
        self.maps
    }

    /// Epsilon, relative to the diameter of each attractor.
    #[must_use]
    pub const fn epsilon(&self) -> f32 {
        self.epsilon
    }

    /// The columns' part of the maps, all maps of the first column first.
    #[must_use]
    pub fn columns(&self) -> &[SingleMap] {
        &self.columns
    }

    /// The rows' part of the maps, all maps of the bottom row first.
    #[must_use]
    pub fn rows(&self) -> &[SingleMap] {
        &self.rows
    }

    /// The answer for the sample in column `x` and row `y`, as a graphics card would give it but for rounding; the gap
    /// of those that are not disconnected is 0.
    ///
    /// # Panics
    /// If there is no such sample.
    #[must_use]
    pub fn decide(&self, x: usize, y: usize) -> Sample {
        self.decide_counting(x, y).0
    }

    /// The same, and how many pairs of pieces were looked at for it.
    #[must_use]
    pub fn decide_counting(&self, x: usize, y: usize) -> (Sample, u32) {
        let columns = &self.columns[x * self.maps..(x + 1) * self.maps];
        let rows = &self.rows[y * self.maps..(y + 1) * self.maps];
        sample::decide(columns, rows, self.epsilon)
    }
}

/// What a graphics card answers for one sample: the bits of the gap, with the number of the state in the lowest three.
#[must_use]
pub fn unpack_single(bits: u32) -> Sample {
    let state = State::from_code((bits & 7) as u8).unwrap_or(State::Undecided);
    Sample { state, gap: f32::from_bits(bits & !7) }
}
