//! A closed curve in few bytes.

use glam::DVec2;
use thiserror::Error;

use super::{ArcCopy, ClosedCurve};

/// The most knots of a packed curve.
pub const MAX_KNOTS: usize = 4096;

/// What the first byte says.
const VERSION: u8 = 1;

/// Steps of c.
const FACTOR_STEP: f64 = 1.0 / 1024.0;

/// The largest |c| that is kept, in steps.
const MOST_FACTOR: i64 = 1 << 20;

/// The finest grid, in parts of the box's diagonal.
const FINEST_GRID: f64 = 1e-9;

/// No knot lies further out, and no curve is smaller unless it is a point: squares of lengths are numbers then.
const FARTHEST_KNOT: f64 = 1e100;
const SMALLEST_CURVE: f64 = 1e-100;

/// Why a curve is not packed or unpacked.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum PackError {
    /// The first byte is another one.
    #[error("These bytes are no curve that this version can read. Take the whole link, or update.")]
    UnknownVersion,
    /// There are too few bytes.
    #[error("The curve is cut short. Take the whole link.")]
    CutShort,
    /// What the bytes say, or what was given, is no curve: copies do not shrink, or knots or arcs are missing.
    #[error("The curve does not hold together. Take the whole link, or fit the outline again.")]
    Unsound,
    /// More than [`MAX_KNOTS`].
    #[error("The curve has more than 4096 knots. Fit the outline with fewer numbers.")]
    TooManyKnots,
    /// It would be a word of more than [`MAX_TEXT`](super::MAX_TEXT) characters.
    #[error(
        "The curve takes more than the 48 KB that a link has for it. Fit the outline with fewer numbers."
    )]
    TooLong,
    /// A knot lies beyond 1e100, or the box is smaller than 1e-100 and no point.
    #[error(
        "The curve is too large, too small or too far out for a link, which holds 1e-100 to 1e100. Scale it."
    )]
    Size,
}

impl PackError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::UnknownVersion => "unknown-version",
            Self::CutShort => "cut-short",
            Self::Unsound => "unsound",
            Self::TooManyKnots => "too-many-knots",
            Self::TooLong => "too-long",
            Self::Size => "size",
        }
    }
}

impl ClosedCurve {
    /// The curve in few bytes. Knots move by less than `precision` (in plane units; it is held to a billionth of the
    /// box at least), factors by 1/2048; factors that would then be too large become a little smaller.
    ///
    /// A version, the first knot and the width of the grid; then, bit by bit, steps from knot to knot and what edges
    /// copy.
    ///
    /// # Errors
    /// Where the curve is not [sound](Self::is_sound), has more than [`MAX_KNOTS`] knots, or lies beyond 1e100 or is
    /// smaller than 1e-100.
    pub fn to_bytes(&self, precision: f64) -> Result<Vec<u8>, PackError> {
        self.check()?;
        let step = self.step(precision);
        let (curve, places) = self.on_grid(step);
        if !curve.is_sound() {
            return Err(PackError::Unsound);
        }
        let steps: Vec<_> =
            places.windows(2).flat_map(|pair| [0, 1].map(|i| pair[1][i] - pair[0][i])).collect();
        let order =
            (0..24).min_by_key(|&order| steps.iter().map(|&step| length(zigzag(step), order)).sum::<u32>());
        let order = order.unwrap_or(0);
        let mut bits = Bits::default();
        bits.put(u64::from(VERSION), 8);
        for number in [curve.knots[0].x, curve.knots[0].y, step] {
            bits.put(number.to_bits(), 64);
        }
        let count = curve.knots.len();
        bits.put(count as u64, 13);
        bits.put(u64::from(order), 5);
        for step in steps {
            bits.put_number(zigzag(step), order);
        }
        for (index, edge) in curve.edges.iter().enumerate() {
            bits.put(u64::from(edge.is_some()), 1);
            let Some(copy) = edge else { continue };
            bits.put(((copy.from + count - index) % count) as u64, width(count));
            bits.put(copy.span as u64 - 2, 3);
            bits.put(u64::from(copy.reversed), 1);
            bits.put_number(zigzag((copy.c / FACTOR_STEP).round() as i64), 8);
        }
        Ok(bits.bytes)
    }

    /// The curve that [`to_bytes`](Self::to_bytes) made bytes of. It is sound.
    ///
    /// # Errors
    /// Where the bytes are no curve, cut short, or of one that [`to_bytes`](Self::to_bytes) refuses.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, PackError> {
        let mut bits = Reader { bytes, at: 0 };
        if bits.take(8)? != u64::from(VERSION) {
            return Err(PackError::UnknownVersion);
        }
        let [x, y, step] = [bits.take(64)?, bits.take(64)?, bits.take(64)?].map(f64::from_bits);
        let count = bits.take(13)? as usize;
        let order = bits.take(5)? as u32;
        if !(3..=MAX_KNOTS).contains(&count) {
            return Err(PackError::Unsound);
        }
        let mut place = [0_i64; 2];
        let mut curve = Self::polygon(Vec::with_capacity(count));
        curve.knots.push(DVec2::new(x, y));
        for _ in 1..count {
            for along in &mut place {
                *along = along.saturating_add(unzigzag(bits.take_number(order)?));
            }
            curve.knots.push(grid_point(DVec2::new(x, y), step, place));
        }
        for index in 0..count {
            if bits.take(1)? == 0 {
                curve.edges.push(None);
                continue;
            }
            let from = (bits.take(width(count))? as usize + index) % count;
            let span = bits.take(3)? as usize + 2;
            let reversed = bits.take(1)? == 1;
            let c = unzigzag(bits.take_number(8)?) as f64 * FACTOR_STEP;
            curve.edges.push(Some(ArcCopy { from, span, reversed, c }));
        }
        curve.check().map(|()| curve)
    }

    /// Whether it can be packed.
    pub(super) fn check(&self) -> Result<(), PackError> {
        if !self.is_sound() {
            return Err(PackError::Unsound);
        }
        if self.knots.len() > MAX_KNOTS {
            return Err(PackError::TooManyKnots);
        }
        let (low, high) = crate::outline::bounds(&self.knots);
        let size = (high - low).max_element();
        let near = low.abs().max(high.abs()).max_element() <= FARTHEST_KNOT;
        if near && (size == 0.0 || size >= SMALLEST_CURVE) { Ok(()) } else { Err(PackError::Size) }
    }

    /// The width of the grid for a precision: a knot moves by half a diagonal of the grid at most.
    fn step(&self, precision: f64) -> f64 {
        let (low, high) = crate::outline::bounds(&self.knots);
        let finest = FINEST_GRID * low.distance(high);
        1.4 * if precision > finest { precision.min(1e9 * finest) } else { finest }
    }

    /// Whether packing with this precision changes nothing.
    pub(super) fn lies_on_grid(&self, precision: f64) -> bool {
        self.on_grid(self.step(precision)).0 == *self
    }

    /// The curve with knots and factors on their grids, and the places of the knots.
    fn on_grid(&self, step: f64) -> (Self, Vec<[i64; 2]>) {
        let first = self.knots[0];
        let place = |p: &DVec2| ((*p - first) / step).to_array().map(|x| x.round() as i64);
        let places: Vec<_> = self.knots.iter().map(place).collect();
        let knots = places.iter().map(|&place| grid_point(first, step, place)).collect();
        let mut curve = Self { knots, edges: self.edges.clone() };
        for index in 0..curve.edges.len() {
            let Some(copy) = self.edges[index] else { continue };
            let factor = (copy.c / FACTOR_STEP).round() as i64;
            let mut factor = factor.clamp(-MOST_FACTOR, MOST_FACTOR);
            // What shrank only just may not on the grid; a smaller factor, or a straight edge, always does.
            loop {
                curve.edges[index] = Some(ArcCopy { c: factor as f64 * FACTOR_STEP, ..copy });
                if curve.shrinks(index) {
                    break;
                }
                if factor == 0 {
                    curve.edges[index] = None;
                    break;
                }
                factor -= factor.signum() * (factor.abs() / 64).max(1);
            }
        }
        (curve, places)
    }
}

fn grid_point(first: DVec2, step: f64, place: [i64; 2]) -> DVec2 {
    first + step * DVec2::new(place[0] as f64, place[1] as f64)
}

/// Bits of an index below `count`.
fn width(count: usize) -> u32 {
    usize::BITS - (count - 1).leading_zeros()
}

/// 0, -1, 1, -2, 2 .. as 0, 1, 2, 3, 4 ..
fn zigzag(x: i64) -> u64 {
    ((x << 1) ^ (x >> 63)) as u64
}

fn unzigzag(x: u64) -> i64 {
    (x >> 1) as i64 ^ -((x & 1) as i64)
}

/// Bits of a number in an exponential Golomb code of an order.
fn length(x: u64, order: u32) -> u32 {
    2 * ((x >> order) + 1).ilog2() + 1 + order
}

#[derive(Default)]
struct Bits {
    bytes: Vec<u8>,
    used: u32,
}

impl Bits {
    /// The lowest `many` bits, the highest first. Once in the module for the first picture, not at each call.
    #[inline(never)]
    fn put(&mut self, value: u64, many: u32) {
        for at in (0..many).rev() {
            if self.used.is_multiple_of(8) {
                self.bytes.push(0);
            }
            if let Some(last) = self.bytes.last_mut() {
                *last |= (value >> at & 1) as u8 * (128 >> (self.used % 8));
            }
            self.used += 1;
        }
    }

    fn put_number(&mut self, x: u64, order: u32) {
        let top = (x >> order) + 1;
        self.put(0, top.ilog2());
        self.put(top, top.ilog2() + 1);
        self.put(x, order);
    }
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    #[inline(never)]
    fn take(&mut self, many: u32) -> Result<u64, PackError> {
        let mut value = 0;
        for _ in 0..many {
            let byte = self.bytes.get(self.at / 8).ok_or(PackError::CutShort)?;
            value = value << 1 | u64::from(byte >> (7 - self.at % 8) & 1);
            self.at += 1;
        }
        Ok(value)
    }

    fn take_number(&mut self, order: u32) -> Result<u64, PackError> {
        let mut long = 0;
        while self.take(1)? == 0 {
            long += 1;
            if long + order > 62 {
                return Err(PackError::Unsound);
            }
        }
        let top = 1 << long | self.take(long)?;
        Ok((top - 1) << order | self.take(order)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed::MAX_SPAN;

    #[test]
    fn numbers_come_back_from_bits() {
        let numbers = [0, 1, -1, 2, 77, -4096, 1 << 40, -(1 << 40)];
        for order in [0, 1, 5, 12, 23] {
            let mut bits = Bits::default();
            for x in numbers {
                let before = bits.used;
                bits.put_number(zigzag(x), order);
                assert_eq!(bits.used - before, length(zigzag(x), order));
            }
            let mut reader = Reader { bytes: &bits.bytes, at: 0 };
            for x in numbers {
                assert_eq!(reader.take_number(order).map(unzigzag), Ok(x));
            }
        }
        assert_eq!([3, 4, 5, 4096].map(width), [2, 2, 3, 12]);
        const { assert!(MAX_SPAN - 2 < 8, "three bits") };
    }
}
