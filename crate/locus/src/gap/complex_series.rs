//! Power series at a complex number: [`power_series`](super::power_series) where the maps turn and shrink alike all
//! round.
//!
//! With `|d|` as unit and d along x the series are `f = 1 + a_1 s + a_2 s^2 + ..`. Of a sum `f_k` of k terms its *rest*
//! is what the coefficients from `a_k` on have to undo, magnified to what they began with: `z_k = f_k / s^(k - 1)`, so
//! that `z_1 = 1` and `z_(k + 1) = z_k / s + a_k`. A series vanishes just if all its rests stay where minus the values
//! of `a_1 s + a_2 s^2 + ..` lie, which is one set for all k.
//!
//! Where to go: with coefficients drawn at random these values scatter as an ellipse does, whose squared axes are those
//! of the matrix of `sum (Re s^k, Im s^k) (Re s^k, Im s^k)^T`, k = 1, 2, ... A step along x moves the rest along one
//! line of the plane; so the coefficient is best that brings it nearest to the middle of the chord where that line
//! meets ellipses about 0. It is a division with digits -1, 0, 1, and mostly goes on forever where s is in M: each step
//! finds a value nearer to 0 by `|s|`.

use std::f64::consts::FRAC_1_SQRT_2;

use glam::DVec2;

use crate::support::extremes::larger;
use crate::support::f64x4::{DVec2x4, F64x4};

/// How far from 0 a rest may be for a quick look to go on with it: against the ellipse, squared.
const SQUARE_TO_ENTER: f64 = 8.0;
/// How often a quick look goes back, and how many steps it takes in all.
const MOST_RETURNS: usize = 12;
const MOST_STEPS: usize = 120;
/// So many of the rests that were passed over last are kept: no fewer than the returns.
const KEPT: usize = 16;
/// Sums looked at most for the least of all.
const MOST_SUMS: usize = 1500;
/// How far the least value may be below the least found, relative to it.
pub(crate) const BRACKET_WIDTH: f64 = 0.095;
/// What is left of the set's reach when no further terms are added up.
const LARGEST_REST: f64 = 0.002;
/// Rests are magnified by no more than this: then rounding would be seen.
const LARGEST_GROWTH: f64 = 1e15;
/// Numbers nearer to 0 are left to others, as their inverses are large.
const LEAST_LENGTH: f64 = 1e-30;
/// An ellipse that is thinner, squared, is a line.
const THINNEST: f64 = 1e-9;
/// Of half the angle between two of the eight directions.
pub(crate) const COSINE: f64 = 0.980_785_280_403_230_4;
/// The cosines of 0, 1, 2 and 3 eighths of half a turn.
const EIGHTHS: [f64; 4] = [1.0, 0.923_879_532_511_286_7, FRAC_1_SQRT_2, 0.382_683_432_365_089_8];

/// Looks for small values of the series at one number; it keeps its memory for the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct ComplexSeries {
    s: DVec2,
    back: DVec2,
    length: f64,
    /// `x + lean y` is 0 in the middle of each chord along x.
    lean: f64,
    /// The squared distance against the ellipse is `across (x + lean y)^2 + along y^2`.
    across: f64,
    along: f64,
    /// How far all but the first term reach together, at most: in y, in `x + lean y`, and all round.
    highest: f64,
    leaning: f64,
    radius: f64,
    /// How much longer than a vector `x + lean y` may be.
    steepness: f64,
    /// Rests, and how much each is magnified.
    open: Vec<(DVec2, f64)>,
}

/// What a quick look found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Look {
    /// A value that is as near to 0 as was asked for, and how far it is.
    Near(f64),
    /// The least distance from 0 that was met.
    Far(f64),
}

/// A rest, the square of what it is to be multiplied by to be a sum, and the square of what is near, so magnified.
#[derive(Clone, Copy, Default)]
struct Rest {
    z: DVec2,
    scale: f64,
    near: f64,
}

impl ComplexSeries {
    /// Begins with another number; whether it is a usual one, inside the unit circle.
    pub fn begin(&mut self, s: DVec2) -> bool {
        let square = s.length_squared();
        // NaN is none of these.
        if !(LEAST_LENGTH * LEAST_LENGTH..1.0).contains(&square) {
            return false;
        }
        let twice = times(s, s);
        let (e, f) = (square / (1.0 - square), times(twice, inverse(DVec2::X - twice)));
        let (xx, yy, xy) = (0.5 * (e + f.x), 0.5 * (e - f.x), 0.5 * f.y);
        let thin = yy <= THINNEST * xx;
        self.s = s;
        self.back = inverse(s);
        self.length = square.sqrt();
        self.lean = if thin { 0.0 } else { -xy / yy };
        self.along = if thin { 0.0 } else { 1.0 / yy };
        self.across = 1.0 / (xx + self.lean * xy);
        self.steepness = (1.0 + self.lean * self.lean).sqrt();
        true
    }

    /// How far, at least, the shape of the maps is across, where `|d|` is 1.
    pub fn least_diameter(&self) -> f64 {
        let s = self.s;
        1.0 + s.x.abs() + (s.x * s.x - s.y * s.y).abs()
    }

    /// Whether a value is no farther from 0 than `near`, if one is found: always on with the best coefficient, and back
    /// to the last that was passed over where that leads too far out.
    pub fn quick_look(&self, near: f64) -> Look {
        let (shrink, grow) = (self.length * self.length, 1.0 / (self.length * self.length));
        let mut rest = Rest { z: DVec2::X, scale: 1.0, near: near * near };
        let mut least = 1.0;
        // A ring.
        let mut passed = [Rest::default(); KEPT];
        let (mut end, mut kept, mut returns) = (0, 0, 0);
        for _ in 0..MOST_STEPS {
            let square = rest.z.length_squared();
            let sum = square * rest.scale;
            least = if sum < least { sum } else { least };
            if square <= rest.near {
                return Look::Near(sum.sqrt());
            }
            let before = times(rest.z, self.back);
            let off = before.x + self.lean * before.y;
            let best = best_coefficient(off);
            let left = off + best;
            let second = best - 1_f64.copysign(left);
            let fixed = before.y * before.y * self.along;
            let square = |off: f64| fixed + off * off * self.across;
            let (scale, near) = (rest.scale * shrink, rest.near * grow);
            let next = |a: f64| Rest { z: DVec2::new(before.x + a, before.y), scale, near };
            // What is near reaches about the set of values.
            let limit = SQUARE_TO_ENTER + self.across * near;
            // Written in any case: a branch would be foreseen wrongly as often as not.
            passed[end] = next(second);
            let keep = usize::from(second.abs() < 1.5) & usize::from(square(off + second) < limit);
            (end, kept) = ((end + keep) % KEPT, KEPT.min(kept + keep));
            if square(left) < limit {
                rest = next(best);
            } else {
                returns += 1;
                if returns > MOST_RETURNS || kept == 0 {
                    break;
                }
                (end, kept) = ((end + KEPT - 1) % KEPT, kept - 1);
                rest = passed[end];
            }
        }
        Look::Far(f64::sqrt(least))
    }

    /// Measures how far the values reach. Returns the diameter of the shape of the maps, at most, where `|d|` is 1: it
    /// is as wide along a direction as the terms are, one by one.
    pub fn measure(&mut self) -> f64 {
        let (mut term, mut left) = (self.s, self.length / (1.0 - self.length));
        let mut spans = [F64x4::splat(0.0); 2];
        let mut leaning = 0.0;
        let least = LARGEST_REST * left;
        while left > least {
            let [first, second] = along(term);
            spans = [spans[0] + first.abs(), spans[1] + second.abs()];
            leaning += (term.x + self.lean * term.y).abs();
            (term, left) = (times(term, self.s), left * self.length);
        }
        left *= 1.0 + 1e-9;
        self.leaning = leaning + left * self.steepness;
        let spans = spans.map(|span| span + F64x4::splat(left));
        let [first, second] = along(DVec2::X);
        let widest = |[one, other]: [F64x4; 2]| {
            one.max(other).to_array().into_iter().fold(0.0, larger) / COSINE * (1.0 + 1e-12)
        };
        // Along y.
        self.highest = spans[1].to_array()[0];
        self.radius = widest(spans);
        widest([spans[0] + first.abs(), spans[1] + second.abs()])
    }

    /// The rest before the next coefficient is added, and the coefficients: the most promising last.
    #[inline(always)]
    pub fn step(&self, z: DVec2) -> (DVec2, [f64; 3]) {
        let before = times(z, self.back);
        let off = before.x + self.lean * before.y;
        let best = best_coefficient(off);
        let side = 1_f64.copysign(off);
        (before, if best == 0.0 { [side, -side, 0.0] } else { [-best, 0.0, best] })
    }

    /// Whether a value that begins with a rest may be nearer to 0 than `room`, as much magnified. After
    /// [`Self::measure`].
    #[inline(always)]
    pub fn leads_within(&self, z: DVec2, room: f64) -> bool {
        let farthest = self.radius + room;
        z.y.abs() < self.highest + room
            && (z.x + self.lean * z.y).abs() < self.leaning + room * self.steepness
            && z.length_squared() < farthest * farthest
    }

    /// The inverse of the number.
    pub fn back(&self) -> DVec2 {
        self.back
    }

    /// How far the least value found is from 0, where it is known that none is nearer by more than the part
    /// [`BRACKET_WIDTH`]; or a value not farther than `near`. `least` is that of one known. After [`Self::measure`].
    pub fn least(&mut self, near: f64, mut least: f64) -> Option<f64> {
        let far = |least: f64| larger(near, (1.0 - BRACKET_WIDTH) * least);
        let (mut limit, mut shortest) = (far(least), least * least);
        let grow = 1.0 / self.length;
        let mut open = std::mem::take(&mut self.open);
        open.clear();
        open.push((DVec2::X, 1.0));
        let mut looks = 0;
        let found = loop {
            let Some((z, growth)) = open.pop() else { break Some(least) };
            looks += 1;
            if looks > MOST_SUMS || growth > LARGEST_GROWTH {
                break None;
            }
            let square = z.length_squared();
            if square < shortest * (growth * growth) {
                shortest = square / (growth * growth);
                least = shortest.sqrt();
                limit = far(least);
            }
            if least <= near {
                break Some(least);
            }
            let (growth, (before, coefficients)) = (growth * grow, self.step(z));
            // Rests from which no value may come below the limit are left out.
            let room = limit * growth;
            for a in coefficients {
                let z = DVec2::new(before.x + a, before.y);
                if self.leads_within(z, room) {
                    open.push((z, growth));
                }
            }
        };
        self.open = open;
        found
    }
}

/// The coefficient that brings a number nearest to 0.
#[inline(always)]
fn best_coefficient(off: f64) -> f64 {
    if off > 0.5 {
        -1.0
    } else if off < -0.5 {
        1.0
    } else {
        0.0
    }
}

/// The product of two complex numbers.
#[inline(always)]
pub(crate) fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

#[inline(always)]
fn inverse(a: DVec2) -> DVec2 {
    DVec2::new(a.x, -a.y) / a.length_squared()
}

/// The parts of a vector along eight directions, all round.
#[inline(always)]
pub(crate) fn along(v: DVec2) -> [F64x4; 2] {
    let v = DVec2x4::splat(v);
    let directions =
        DVec2x4 { x: F64x4::new(EIGHTHS), y: F64x4::new([0.0, EIGHTHS[3], EIGHTHS[2], EIGHTHS[1]]) };
    let turned = DVec2x4 { x: -directions.y, y: directions.x };
    [directions.dot(v), turned.dot(v)]
}

#[cfg(test)]
mod tests {
    use frond_core::hash;

    use super::*;

    fn unit(seed: u32, k: u32) -> f64 {
        f64::from(hash::unit(hash::counter(seed, k)))
    }

    /// A number in a ring about 0.
    fn any_number(seed: u32, from: f64, to: f64) -> DVec2 {
        DVec2::from_angle(6.3 * unit(seed, 0)) * (from + (to - from) * unit(seed, 1))
    }

    /// The least of all sums of so many terms.
    fn least_of_all(s: DVec2, terms: u32) -> f64 {
        let mut sums = vec![DVec2::X];
        let mut term = DVec2::X;
        for _ in 1..terms {
            term = times(term, s);
            sums = sums.iter().flat_map(|&sum| [sum, sum + term, sum - term]).collect();
        }
        sums.iter().map(|sum| sum.length()).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn the_least_value_is_bracketed() {
        let (mut series, mut told) = (ComplexSeries::default(), 0);
        for seed in 0..400 {
            let s = any_number(seed, 0.1, 0.68);
            assert!(series.begin(s));
            let near = 0.02 * unit(seed, 2);
            let met = match series.quick_look(near) {
                Look::Near(length) => length,
                Look::Far(least) => least,
            };
            series.measure();
            let least = series.least(near, met).expect("an answer");
            let all = least_of_all(s, 10);
            let rest = s.length().powi(10) / (1.0 - s.length());
            assert!(least >= all - rest - 1e-12, "{s}: {least}, not {all} less {rest}");
            if least > near {
                assert!(all >= (1.0 - BRACKET_WIDTH) * least - 1e-12, "{s}: {least}, but {all}");
                told += 1;
            }
        }
        assert!(told > 150, "{told}");
    }

    #[test]
    fn a_quick_look_finds_nearly_all_that_vanish() {
        let (mut series, mut found, mut all) = (ComplexSeries::default(), 0, 0);
        for seed in 0..400 {
            let s = any_number(seed, 0.55, 0.7);
            assert!(series.begin(s));
            series.measure();
            all += u32::from(series.least(1e-3, 1.0).is_some_and(|least| least <= 1e-3));
            if let Look::Near(length) = series.quick_look(1e-9) {
                assert!(length <= 1e-9, "{length}");
                found += 1;
            }
        }
        assert!(all > 80 && 100 * found >= 97 * all, "{found} of {all}");
    }

    #[test]
    fn shapes_are_as_wide_as_is_said() {
        let mut series = ComplexSeries::default();
        for seed in 0..200 {
            let s = any_number(seed, 0.01, 0.9);
            assert!(series.begin(s));
            let width = |angle: f64| {
                let (mut term, mut width) = (DVec2::X, 0.0);
                for _ in 0..400 {
                    width += term.dot(DVec2::from_angle(angle)).abs();
                    term = times(term, s);
                }
                width
            };
            let widest = (0..360).map(|k| width(f64::from(k).to_radians())).fold(0.0, f64::max);
            assert!(series.least_diameter() <= widest * (1.0 + 1e-12), "{s}");
            let diameter = series.measure();
            assert!(widest <= diameter && diameter < 1.03 * widest, "{s}: {widest}, not {diameter}");
        }
    }

    #[test]
    fn unusual_numbers_are_refused() {
        let mut series = ComplexSeries::default();
        for bad in [DVec2::ZERO, DVec2::X, DVec2::splat(1e-40), DVec2::splat(f64::NAN), DVec2::splat(1e200)] {
            assert!(!series.begin(bad), "{bad}");
        }
    }
}
