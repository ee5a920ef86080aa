//! Addresses without rounding errors, and values that are right to the last digits.
//!
//! To come from t to the place that a piece copies, t = a s + d is solved for s: errors grow by 1 / |a| a letter, and a
//! value that counts c a letter forgets them more slowly. Where |c| is near 1 and |a| small, an error of 1e-16 in t is
//! one of 1e-3 in the value. Hence places are whole numbers of as many bits as it takes.

use glam::{DMat2, DVec2};
use num_bigint::BigInt;

use super::curve::{FractalCurve, NEAR_KNOT, Side};

/// What is left of a value when its letters end, in parts of the bound of the curve: of one that is right to the last
/// digits, and of one that is drawn.
pub(super) const LEFT: f64 = 1e-20;
pub(super) const LEFT_OF_DRAWN: f64 = 1e-11;

/// The most pieces whose ends are drawn so: of more it would take too long.
const MOST_DRAWN: usize = 64;

/// The most letters of an address. Factors up to 0.998 take fewer.
const MOST_LETTERS: usize = 1 << 15;

/// The fewest and the most bits of a place.
const BITS: (usize, usize) = (256, 1 << 17);

/// Bits of a place that are right, behind the width of the narrowest piece.
const RIGHT_BITS: f64 = 110.0;

/// The sum of two numbers that do not overlap: twice as many digits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// The sum of two numbers, without rounding (Knuth's two-sum).
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        let sum = Self::sum(self.high, other.high);
        Self::sum(sum.high, sum.low + self.low + other.low)
    }

    fn times(self, factor: f64) -> Self {
        let high = self.high * factor;
        let low = self.high.mul_add(factor, -high) + self.low * factor;
        Self::sum(high, low)
    }

    pub(super) fn value(self) -> f64 {
        self.high + self.low
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

/// A number m 2^e.
fn parts(x: f64) -> (i64, i64) {
    let bits = x.to_bits();
    let (exponent, mantissa) = ((bits >> 52 & 0x7ff) as i64, (bits & ((1 << 52) - 1)) as i64);
    let (m, e) = if exponent == 0 { (mantissa, -1074) } else { (mantissa | 1 << 52, exponent - 1075) };
    let zeros = i64::from(m.trailing_zeros().min(62));
    let m = if m == 0 { 0 } else { m >> zeros };
    (if x < 0.0 { -m } else { m }, e + zeros)
}

/// A place: a number of units of 2^-bits, and the power of two of units that it may be off; none where it is exact.
struct Place {
    units: BigInt,
    error: Option<f64>,
}

impl Place {
    fn new(x: f64, bits: usize) -> Self {
        let (m, e) = parts(x);
        let shift = e + bits as i64;
        if shift >= 0 {
            Self { units: BigInt::from(m) << shift, error: None }
        } else {
            let units = BigInt::from(m) >> -shift;
            Self { error: (m != 0).then_some(0.0), units }
        }
    }

    fn minus(self, other: &Self) -> Self {
        Self { units: self.units - &other.units, error: grown(self.error, other.error) }
    }

    /// Divided by a number of size below 1.
    fn over(self, a: f64) -> Self {
        let (m, e) = parts(a);
        let long = if e < 0 { self.units << -e } else { self.units >> e };
        let units = &long / m;
        let exact = e <= 0 && &units * m == long;
        let error = self.error.map(|error| error - a.abs().log2());
        Self { units, error: if exact { error } else { grown(error, Some(0.0)) } }
    }

    fn double(&self, bits: usize) -> Double {
        let high = rounded(&self.units, bits);
        let rest = &self.units - Self::new(high, bits).units;
        Double { high, low: rounded(&rest, bits) }
    }

    /// The same, less a number.
    fn less(&self, x: f64, bits: usize) -> f64 {
        rounded(&(&self.units - Self::new(x, bits).units), bits)
    }
}

/// The sum of two powers of two, as one.
fn grown(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.max(b) + (1.0 + (-(a - b).abs()).exp2()).log2()),
        (one, other) => one.or(other),
    }
}

/// So many units of 2^-bits, cut to a number.
fn rounded(units: &BigInt, bits: usize) -> f64 {
    let shift = units.bits().saturating_sub(62) as i64;
    let top = i64::try_from(units >> shift).unwrap_or(0) as f64;
    let exponent = shift - bits as i64;
    // In two steps: a power of two that is no number by itself may be one times the top.
    let half = exponent / 2;
    top * (half as f64).exp2() * ((exponent - half) as f64).exp2()
}

/// A letter of an address: the piece, and the place in its domain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Letter {
    pub index: usize,
    pub source: Double,
}

/// More bits are needed.
struct Short;

impl FractalCurve {
    /// The point at `t` (taken to the nearest end of the interval; NaN to the first), right to the last digits of the
    /// [bound](Self::bound): maps are taken as the numbers that they are.
    ///
    /// Where a place comes as near to a knot as the rounding of `t` and of the maps allows, it is that knot. Where
    /// pieces do not meet it is the limit from the right, at the last end that from the left. No more than 32,768
    /// letters are followed: with factors above 0.998 the last digits are not right.
    #[must_use]
    pub fn precise_at(&self, t: f64) -> DVec2 {
        self.precise_limit(t, Side::Right, LEFT)
    }

    /// The limit at the end of a piece, from inside: right, where there are not too many pieces.
    ///
    /// Maps through points bring ends of domains there, and only their true values.
    pub(super) fn limit_at_end(&self, t: f64, side: Side) -> DVec2 {
        if self.pieces().len() > MOST_DRAWN {
            return self.limit(t, side, 0.0);
        }
        self.precise_limit(t, side, LEFT_OF_DRAWN)
    }

    /// The widest step between neighbouring pieces: 0, or rounding, where the curve is continuous.
    #[must_use]
    pub fn widest_gap(&self) -> f64 {
        let knots = self.pieces().iter().skip(1).map(|piece| piece.range[0]);
        let step = |t| self.limit_at_end(t, Side::Left).distance(self.limit_at_end(t, Side::Right));
        knots.map(step).fold(0.0, f64::max)
    }

    /// The limit from a side, but for what is left.
    fn precise_limit(&self, t: f64, side: Side, least: f64) -> DVec2 {
        let (letters, side) = self.letters(t, side, least);
        let last = letters.last().map_or(t, |letter| letter.source.value());
        // Next to nothing, but where there were too many letters.
        let mut at = self.limit(last, side, 0.0).to_array().map(Double::from);
        for letter in letters.iter().rev() {
            let piece = &self.pieces()[letter.index];
            let (DMat2 { x_axis, y_axis }, DVec2 { x, y }) = (piece.factor, piece.offset);
            let along = |shear: f64, offset: f64| letter.source.times(shear).plus(offset.into());
            at = [
                at[0].times(x_axis.x).plus(at[1].times(y_axis.x)).plus(along(piece.shear.x, x)),
                at[0].times(x_axis.y).plus(at[1].times(y_axis.y)).plus(along(piece.shear.y, y)),
            ];
        }
        DVec2::from(at.map(Double::value))
    }

    /// The letters of the address of `t` from a side, and the side from which the place of the last is approached.
    pub(super) fn letters(&self, t: f64, side: Side, least: f64) -> (Vec<Letter>, Side) {
        let mut bits = BITS.0;
        loop {
            let mut letters = Vec::new();
            match self.follow(t, side, (bits, least), &mut letters) {
                Err(Short) if bits < BITS.1 => bits *= 2,
                Ok(side) => return (letters, side),
                Err(Short) => return (letters, side),
            }
        }
    }

    /// Adds letters, with places of so many bits.
    fn follow(
        &self,
        t: f64,
        side: Side,
        (bits, least): (usize, f64),
        letters: &mut Vec<Letter>,
    ) -> Result<Side, Short> {
        let [start, end] = self.interval();
        let t = if t > start { t.min(end) } else { start };
        let mut side = match t {
            _ if t <= start => Side::Right,
            _ if t >= end => Side::Left,
            _ => side,
        };
        let narrowest = self.pieces().iter().map(|piece| piece.range[1] - piece.range[0]);
        let right = narrowest.fold(f64::INFINITY, f64::min).log2() - RIGHT_BITS + bits as f64;
        // Numbers of the maps are rounded, and so is t.
        let unit = 4.0 * f64::EPSILON * start.abs().max(end.abs());
        let mut off = unit;
        let mut place = Place::new(t, bits);
        let mut left = 1.0;
        while left > least && letters.len() < MOST_LETTERS {
            if place.error.is_some_and(|error| error > right) {
                return Err(Short);
            }
            let near = place.double(bits).value();
            let mut index = self.piece_at(near, side);
            let [low, high] = self.pieces()[index].range;
            let next = self.pieces().get(index + 1).map(|piece| piece.range[0]);
            let knot = if place.less(low, bits).abs() <= off {
                // The value on the other side of a knot is another one only where pieces do not meet.
                if side == Side::Left && index > 0 && self.pieces()[index - 1].range[1] == low {
                    index -= 1;
                }
                Some(low)
            } else if place.less(high, bits).abs() <= off {
                if side == Side::Right && next == Some(high) {
                    index += 1;
                }
                Some(high)
            } else {
                None
            };
            let piece = &self.pieces()[index];
            if piece.reflected {
                side = side.other();
            }
            let [first, last] = piece.domain;
            let mut end_of_domain = knot.map(|knot| piece.source(knot));
            if knot.is_none() {
                let [a, d] = piece.along;
                place = place.minus(&Place::new(d, bits)).over(a);
                // In a slit between pieces that were printed with few digits the nearer end goes on.
                if place.less(first, bits) <= 0.0 {
                    end_of_domain = Some(first);
                } else if place.less(last, bits) >= 0.0 {
                    end_of_domain = Some(last);
                }
            } else {
                off = unit;
            }
            if let Some(end) = end_of_domain {
                place = Place::new(end, bits);
                side = if end == first { Side::Right } else { Side::Left };
            }
            off = (off / piece.a().abs() + unit).min(NEAR_KNOT * (high - low));
            letters.push(Letter { index, source: place.double(bits) });
            left *= piece.gain();
        }
        Ok(side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_into_places_and_come_back() {
        for x in [0.0, 1.0, -0.1, 1e-30, 123_456.789, -f64::MIN_POSITIVE, 5e-324, 1e100] {
            let place = Place::new(x, 1200);
            assert_eq!(place.double(1200), Double { high: x, low: 0.0 });
            assert!(place.error.is_none());
        }
        assert!(Place::new(1e-100, 64).error.is_some());
        // A third: twice as many digits as a number has.
        let third = Place::new(1.0, 300).over(0.75).minus(&Place::new(1.0, 300)).double(300);
        let back = third.times(3.0).plus((-1.0).into());
        assert!(back.value().abs() < 1e-32, "{back:?}");
        assert!(Place::new(1.0, 300).over(0.5).error.is_none());
    }
}
