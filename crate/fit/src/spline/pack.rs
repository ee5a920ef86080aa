//! A spline in few bytes.

use glam::DVec2;
use thiserror::Error;

use super::coder::{Decoder, Encoder};
use super::law::{ALL, FormerTable, MANY_SPREADS, StepLaw, TURNS, Table, WIDTHS};
use super::{FARTHEST, MAX_NODES, Node, Spline};

/// What the first byte says; a [`ClosedCurve`](crate::ClosedCurve)'s says 1. Curves of the former version, whose steps
/// had another law, are read.
const VERSION: u8 = 3;
const FORMER_VERSION: u8 = 2;

/// Bits of the grid's width that are kept: 11 of the exponent, 6 behind the point.
const GRID_SHIFT: u32 = 46;
const MANTISSA: u32 = 52 - GRID_SHIFT;

/// Exponents from here on, as many as less than the second number, take few bits: grids of some pixels, and of leaves
/// of size 1.
const USUAL_EXPONENTS: (u64, u64) = (1023 - 45, 63);

/// How far steps reach, in cells, of which one is written.
const REACHES: [u64; 12] = [1, 2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64];

/// More bits than a number of steps has.
const MOST_BITS: u64 = 48;

/// Why a curve is not packed or unpacked.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum SplineError {
    /// The first byte is another one, or there is none.
    #[error("These bytes are no curve that this version can read. Take the whole link, or update.")]
    UnknownVersion,
    /// What the bytes say, or what was given, is no curve.
    #[error("The curve does not hold together. Take the whole link, or fit the outline again.")]
    Unsound,
    /// Too many nodes for the form.
    #[error("The curve has too many nodes. Fit the outline with fewer bytes.")]
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

/// Cells of 2^k numbers, one of them around 0.
#[derive(Clone, Copy)]
struct Cells {
    k: u32,
}

impl Cells {
    fn half(self) -> i64 {
        (1 << self.k) >> 1
    }

    /// The cell of a number, and its place there.
    fn of(self, number: i64) -> (i64, u64) {
        let number = number + self.half();
        (number >> self.k, (number & ((1 << self.k) - 1)) as u64)
    }

    fn place(self, cell: i64, place: u64) -> f64 {
        ((cell << self.k) + place as i64 - self.half()) as f64
    }
}

/// The smallest cells of which so many reach as far as this, and the least reach.
fn cells(most: i64) -> (Cells, usize) {
    let mut cells = Cells { k: 0 };
    loop {
        let wide = cells.of(most).0.max(-cells.of(-most).0) as u64;
        if let Some(reach) = REACHES.iter().position(|&reach| reach >= wide) {
            return (cells, reach);
        }
        cells.k += 1;
    }
}

fn put_grid(coder: &mut Encoder, grid: f64) {
    let kept = grid.to_bits() >> GRID_SHIFT;
    let (exponent, mantissa) = (kept >> MANTISSA, kept & ((1 << MANTISSA) - 1));
    let (low, many) = USUAL_EXPONENTS;
    let usual = exponent.wrapping_sub(low);
    coder.even(usual.min(many), many + 1);
    if usual >= many {
        coder.bits(exponent, 11);
    }
    coder.bits(mantissa, MANTISSA);
}

fn take_grid(coder: &mut Decoder) -> f64 {
    let (low, many) = USUAL_EXPONENTS;
    let usual = coder.even(many + 1);
    let exponent = if usual < many { low + usual } else { coder.bits(11) };
    f64::from_bits((exponent << MANTISSA | coder.bits(MANTISSA)) << GRID_SHIFT)
}

/// The shares of steps, of this version or the former.
enum AnyTable {
    Now(Table),
    Former(FormerTable),
}

impl AnyTable {
    fn columns(&mut self, before: DVec2) -> Vec<u64> {
        match self {
            Self::Now(table) => table.columns(before),
            Self::Former(table) => table.columns(before),
        }
    }

    fn rows(&mut self, column: usize) -> Vec<u64> {
        match self {
            Self::Now(table) => table.rows(column),
            Self::Former(table) => table.rows(column),
        }
    }

    fn count(&mut self, step: DVec2, before: DVec2) {
        if let Self::Now(table) = self {
            table.count(step, before);
        }
    }
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

    /// The same curve from that node on which it takes the most to go to: how one comes to the first is not told.
    pub(crate) fn cut_where_it_costs(mut self) -> Self {
        let count = self.nodes.len();
        let step = |i: usize| self.nodes[i % count].at - self.nodes[(i + count - 1) % count].at;
        let law = StepLaw::of((0..count).map(|i| (step(i), step(i + count - 1))));
        // With the first step, how it turns is told from nothing.
        let bits = |i: usize| {
            let (now, next) = (step(i), step(i + 1));
            law.bits(now, step(i + count - 1)) + law.bits(next, now) - law.bits(next, DVec2::ZERO)
        };
        if let Some(first) = (0..count).max_by(|&a, &b| bits(a).total_cmp(&bits(b))) {
            self.nodes.rotate_left(first);
        }
        self
    }

    /// The curve in few bytes: a version; then, by a range coder, the width of the grid, how many nodes, the law of
    /// steps, the first node, and for each node its kind and its step from the one before.
    ///
    /// A step is told as one of some cells that lie around none, by the law and by how steps turned so far, and a place
    /// in it, all alike. Cells are single points unless some step is long.
    ///
    /// # Errors
    /// Where it is not [sound](Self::is_sound) or has more than [`MAX_NODES`] nodes.
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
        let most = (1..count).map(|i| step(i).abs().max_element()).fold(0.0, f64::max) as i64;
        let (cells, reach) = cells(most);
        let law = StepLaw::of((1..count).map(|i| (step(i), before(i)))).of_cells(cells.k);
        let mut coder = Encoder::new();
        put_grid(&mut coder, self.grid);
        let long = count.ilog2();
        coder.even(u64::from(long), 12);
        coder.bits(count as u64 - (1 << long), long);
        coder.even(law.width, WIDTHS);
        coder.even(law.spread, MANY_SPREADS);
        coder.gamma(u64::from(cells.k));
        coder.even(reach as u64, REACHES.len() as u64);
        let first = [self.nodes[0].at.x, self.nodes[0].at.y].map(folded);
        let long = 64 - first[0].max(first[1]).leading_zeros();
        coder.even(u64::from(long), MOST_BITS);
        first.iter().for_each(|&number| coder.bits(number, long));
        let mut bends = count - self.corners();
        coder.even(u64::from(bends > 0), 2);
        if bends > 0 {
            coder.even(bends as u64 - 1, count as u64);
        }
        let mut table = Table::new(law, REACHES[reach] as i64);
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
            let [x, y] = [step(i).x, step(i).y].map(|number| cells.of(number as i64));
            let column = (x.0 + REACHES[reach] as i64) as usize;
            coder.put(columns[column], columns[column + 1] - columns[column], ALL);
            let rows = table.rows(column);
            let row = (y.0 + REACHES[reach] as i64) as usize;
            coder.put(rows[row], rows[row + 1] - rows[row], ALL);
            coder.bits(x.1, cells.k);
            coder.bits(y.1, cells.k);
            table.count(step(i), before(i));
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
        let Some((&version @ (VERSION | FORMER_VERSION), rest)) = bytes.split_first() else {
            return Err(SplineError::UnknownVersion);
        };
        let mut coder = Decoder::new(rest);
        let grid = take_grid(&mut coder);
        let long = coder.even(12) as u32;
        let count = 1_usize << long | coder.bits(long) as usize;
        let width = coder.even(WIDTHS);
        let law = coder.even(if version == VERSION { MANY_SPREADS } else { TURNS });
        let k = coder.gamma().filter(|&k| k < MOST_BITS).ok_or(SplineError::Unsound)?;
        let cells = Cells { k: k as u32 };
        let most = REACHES[coder.even(REACHES.len() as u64) as usize] as i64;
        let long = coder.even(MOST_BITS) as u32;
        let [x, y] = [coder.bits(long), coder.bits(long)];
        let mut bends = if coder.even(2) == 1 { coder.even(count as u64) + 1 } else { 0 };
        if count < 3 || coder.is_past() {
            return Err(SplineError::Unsound);
        }
        let mut table = if version == VERSION {
            AnyTable::Now(Table::new(StepLaw::new(width, law), most))
        } else {
            AnyTable::Former(FormerTable::new(width, law, most))
        };
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
                let [x, y] = [x, y].map(|number| cells.place(number as i64 - most, coder.bits(cells.k)));
                let step = DVec2::new(x, y);
                table.count(step, before);
                before = step;
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
