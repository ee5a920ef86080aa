//! How large the dimension of maps that are no similarities is at most.
//!
//! Pieces are covered by balls of the size of their shorter axis. Where the singular values of words of one length, to
//! the power s as far as they count (Falconer 1988), add up to at most one, the upper box dimension is at most s.

use crate::number::interval::Interval;
use crate::system::build::System;
use crate::system::real::Square;

/// Words of one length that are looked at.
const MOST_WORDS: usize = 1024;

/// A bound from above of the dimension of a system of one state of a line or plane; `None` of others.
pub(crate) fn bound(system: &System) -> Option<f64> {
    let ([maps], 1..=2) = (&system.states[..], system.dimension()) else { return None };
    let linears: Vec<Square> = maps.iter().map(|edge| system.space.action(&edge.linear)).collect();
    let space = system.dimension() as f64;
    let mut words = linears.clone();
    let mut best = space;
    loop {
        best = best.min(of_words(&words, space));
        if linears.len() < 2 || words.len() * linears.len() > MOST_WORDS {
            return Some(best);
        }
        words = words.iter().flat_map(|word| linears.iter().map(|map| word.times(map))).collect();
    }
}

/// The least s, nearly, for which the sum over these words is at most one.
fn of_words(words: &[Square], space: f64) -> f64 {
    let sizes: Vec<[f64; 2]> =
        words.iter().map(|word| [word.norm(), word.determinant().abs().upper()]).collect();
    if sizes.iter().flatten().any(|x| !x.is_finite() || *x < 0.0) {
        return space;
    }
    let is_enough = |s: f64| {
        let sum = sizes.iter().fold(Interval::ZERO, |sum, &[norm, area]| sum + covered(norm, area, s));
        sum.upper() <= 1.0
    };
    if !is_enough(space) {
        return space;
    }
    let (mut low, mut high) = (0.0, space);
    while high - low > 1e-9 {
        let middle = f64::midpoint(low, high);
        if is_enough(middle) { high = middle } else { low = middle }
    }
    high
}

/// The larger singular value to the power s, for s up to one; and beyond it the smaller one to what is left of s. Their
/// product is the area. Only bounds from above are meant: neither is more than the norm allows.
fn covered(norm: f64, area: f64, s: f64) -> Interval {
    let power = |base: f64, exponent: f64| {
        if base == 0.0 {
            return if exponent == 0.0 { Interval::ONE } else { Interval::ZERO };
        }
        Interval::point(base).power(Interval::point(exponent))
    };
    if s <= 1.0 { power(norm, s) } else { power(area, s - 1.0) * power(norm, 2.0 - s) }
}
