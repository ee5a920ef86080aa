//! A spline in few bytes.

use glam::DVec2;
use thiserror::Error;

use super::coder::{Decoder, Encoder};
use super::law::{ALL, Steps, TURNS, Table, WIDTHS};
use super::{FARTHEST, MAX_NODES, Node, Spline};

/// What the first byte says; a [`ClosedCurve`](crate::ClosedCurve)'s says 1.
const VERSION: u8 = 2;

/// Bits of the grid's width that are kept: 11 of the exponent, 8 behind the point.
const GRID_SHIFT: u32 = 44;

/// The longest step in x or y.
const MOST_STEP: u64 = 255;

/// The most products that reading takes.
const MOST_WORK: i64 = 1 << 27;

/// Why a curve is not packed or unpacked.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SplineError {
    /// The first byte is another one, or there is none.
    #[error("These bytes are no curve that this version can read. Take the whole link, or update.")]
    UnknownVersion,
    /// What the bytes say, or what was given, is no curve.
    #[error("The curve does not hold together. Take the whole link, or fit the outline again.")]
    Unsound,
    /// Too many nodes, or steps too long for the form.
    #[error("The curve has too many nodes, or its grid is too fine. Fit the outline with fewer bytes.")]
    TooLarge,
}

impl SplineError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::UnknownVersion => "unknown-version",
            Self::Unsound => "unsound",
            Self::TooLarge => "too-large",
        }
    }
}

/// The next width not above this one that is kept.
pub(crate) fn kept_grid(grid: f64) -> f64 {
    f64::from_bits(grid.to_bits() >> GRID_SHIFT << GRID_SHIFT)
}

fn folded(x: f64) -> u64 {
    let x = x as i64;
    (x << 1 ^ x >> 63) as u64
}

fn unfolded(x: u64) -> f64 {
    ((x >> 1) as i64 ^ -((x & 1) as i64)) as f64
}

impl Spline {
    /// Whether there are three nodes, all on the grid, and its width is one that bytes keep.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let whole = |x: f64| x.abs() <= FARTHEST && x.fract() == 0.0;
        let grid = self.grid.is_normal() && self.grid > 0.0 && (1e-100..1e100).contains(&self.grid);
        self.nodes.len() >= 3
            && self.nodes.iter().all(|node| whole(node.at.x) && whole(node.at.y))
            && grid
            && kept_grid(self.grid) == self.grid
    }

    /// The curve in few bytes: a version; then, by a range coder, the width of the grid, how many nodes, the law of
    /// steps, the first node, and for each node its kind and its step from the one before.
    ///
    /// # Errors
    /// Where it is not [sound](Self::is_sound), has more than [`MAX_NODES`] nodes, or steps are too long.
    pub fn to_bytes(&self) -> Result<Vec<u8>, SplineError> {
        if !self.is_sound() {
            return Err(SplineError::Unsound);
        }
        let count = self.nodes.len();
        if count > MAX_NODES {
            return Err(SplineError::TooLarge);
        }
        let step = |i: usize| self.nodes[i].at - self.nodes[i - 1].at;
        let before = |i: usize| if i > 1 { step(i - 1) } else { DVec2::ZERO };
        let most = (1..count).map(|i| step(i).abs().max_element()).fold(0.0, f64::max);
        if most > MOST_STEP as f64 || Table::work(most as i64) * count as i64 > MOST_WORK {
            return Err(SplineError::TooLarge);
        }
        let most = most as i64;
        let law = Steps::of((1..count).map(|i| (step(i), before(i))));
        let mut coder = Encoder::new();
        coder.even(self.grid.to_bits() >> GRID_SHIFT, 1 << 20);
        coder.even(count as u64, 1 << 12);
        coder.even(law.width, WIDTHS);
        coder.even(law.turn, TURNS);
        coder.even(most as u64, MOST_STEP + 1);
        coder.gamma(folded(self.nodes[0].at.x));
        coder.gamma(folded(self.nodes[0].at.y));
        let mut bends = count - self.corners();
        coder.even(u64::from(bends > 0), 2);
        if bends > 0 {
            coder.even(bends as u64 - 1, count as u64);
        }
        let mut table = Table::new(law, most);
        for (i, node) in self.nodes.iter().enumerate() {
            // Of those that are left, so many are control points.
            let left = count - i;
            if node.on {
                coder.put(bends as u64, (left - bends) as u64, left as u64);
            } else {
                coder.put(0, bends as u64, left as u64);
                bends -= 1;
            }
            if i == 0 {
                continue;
            }
            let columns = table.columns(before(i));
            let (x, y) = ((step(i).x as i64 + most) as usize, (step(i).y as i64 + most) as usize);
            coder.put(columns[x], columns[x + 1] - columns[x], ALL);
            let rows = table.rows(x);
            coder.put(rows[y], rows[y + 1] - rows[y], ALL);
        }
        let mut bytes = vec![VERSION];
        bytes.extend(coder.finish());
        Ok(bytes)
    }

    /// The curve that these bytes say.
    ///
    /// # Errors
    /// Where they say none.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, SplineError> {
        let Some((&VERSION, rest)) = bytes.split_first() else { return Err(SplineError::UnknownVersion) };
        let mut coder = Decoder::new(rest);
        let grid = f64::from_bits(coder.even(1 << 20) << GRID_SHIFT);
        let count = coder.even(1 << 12) as usize;
        let law = Steps::new(coder.even(WIDTHS), coder.even(TURNS));
        let most = coder.even(MOST_STEP + 1) as i64;
        let (Some(x), Some(y)) = (coder.gamma(), coder.gamma()) else { return Err(SplineError::Unsound) };
        let mut bends = if coder.even(2) == 1 { coder.even(count.max(1) as u64) + 1 } else { 0 };
        if count < 3 || Table::work(most) * count as i64 > MOST_WORK || coder.is_past() {
            return Err(SplineError::Unsound);
        }
        let mut table = Table::new(law, most);
        let mut nodes: Vec<Node> = Vec::with_capacity(count);
        let mut at = DVec2::new(unfolded(x), unfolded(y));
        let mut before = DVec2::ZERO;
        for i in 0..count {
            let left = (count - i) as u64;
            let on = coder.place(left) >= bends;
            if on {
                coder.take(bends, left - bends, left);
            } else {
                coder.take(0, bends, left);
                bends -= 1;
            }
            if i > 0 {
                let mut number = |sums: &[u64]| {
                    let place = coder.place(ALL);
                    let number = sums.partition_point(|&sum| sum <= place) - 1;
                    coder.take(sums[number], sums[number + 1] - sums[number], ALL);
                    number
                };
                let x = number(&table.columns(before));
                let y = number(&table.rows(x));
                before = DVec2::new((x as i64 - most) as f64, (y as i64 - most) as f64);
                at += before;
            }
            nodes.push(Node { at, on });
            if coder.is_past() {
                return Err(SplineError::Unsound);
            }
        }
        let spline = Self { nodes, grid };
        if spline.is_sound() { Ok(spline) } else { Err(SplineError::Unsound) }
    }
}
