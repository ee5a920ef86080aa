//! Two maps of one linear part: power series with coefficients -1, 0 and 1.
//!
//! The pieces of `M x + s` and `M x + t` are as far apart as 0 is from the values of the series
//! `d + a_1 M d + a_2 M^2 d + ..`, where `d = s - t` and all a_k are -1, 0 or 1: they meet just if one of these
//! vanishes (Barnsley & Harrington 1985; Bousch 1988). A sum of finitely many terms is a value, too; and of all series
//! that begin with a sum the values are as near it as the lengths of all further terms add up to.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::gap::complex_series::{BRACKET_WIDTH, COSINE, ComplexSeries, Look, along};
use crate::support::extremes::{larger, lesser};
use crate::support::f64x4::F64x4;
use crate::verdict::{Bounded, Sample, State};

/// How far a sum may be from 0 for a quick look to go on with it, against the disc that the rest of the series reaches,
/// squared.
const SQUARE_TO_ENTER: f64 = 0.5;
/// How often a quick look goes back, and how many steps it takes in all.
const MOST_RETURNS: usize = 12;
const MOST_STEPS: usize = 120;
/// So many of the sums that were passed over last are kept: no fewer than the returns.
const KEPT: usize = 16;
/// Where maps shrink no faster other coordinates may be better.
const LARGEST_NORM: f64 = 0.97;
/// Sums looked at most for the least of all.
const MOST_SUMS: usize = 1500;
/// Terms at most.
const MOST_TERMS: usize = 96;
/// Finer resolutions are near what rounding leaves to see.
const LEAST_EPSILON: f64 = 1e-11;
/// What rounding adds to a sum, at most, for the length of its first term, where `1 / (1 - |M|)` is 1.
const ROUNDING: f64 = 1e-14;
/// What the terms leave out, against what is to be told.
const LARGEST_REST: f64 = 0.004;
/// Looks for small values of the series of two maps; it keeps its memory for the next two.
#[derive(Clone, Debug, Default)]
pub(crate) struct PowerSeries {
    complex: ComplexSeries,
    /// `M^k d`.
    terms: Vec<DVec2>,
    /// How far the terms from each on reach together, at most, along eight directions.
    spans: Vec<[F64x4; 2]>,
    /// Sums and how many terms they have.
    open: Vec<(DVec2, usize)>,
}

/// What is known where the least value is at most `upper` from 0, and of one that is not `near` not much less; and
/// rounding may be `off`.
fn bounded(upper: f64, near: f64, off: f64, diameter: f64) -> Option<Bounded> {
    let relative = |length: f64| length / diameter;
    let known = Bounded {
        sample: Sample { state: State::Touching, gap: 0.0 },
        lower: 0.0,
        upper: relative(upper + off),
        diameter,
        ..Bounded::unknown(State::Touching)
    };
    if upper <= near {
        return Some(known);
    }
    let lower = (1.0 - BRACKET_WIDTH) * upper - off;
    let gap = relative(f64::midpoint(lower, upper)) as f32;
    let sample = Sample { state: State::Disconnected, gap };
    (off < 0.01 * upper).then_some(Bounded { sample, lower: relative(lower), ..known })
}

/// A sum, the next term, and how far, squared, the sum may be from 0 when that is added or left out.
#[derive(Clone, Copy)]
struct Sum {
    at: DVec2,
    term: DVec2,
    limit: f64,
}

impl PowerSeries {
    /// What [`decide_bounds`](crate::decide_bounds) says of two maps of one linear part, but for where the attractor
    /// lies; `None` where this does not tell, or of other maps. Without `bounds` the state and the gap alone.
    pub fn decide(&mut self, maps: &[Affine2], epsilon: f64, bounds: bool) -> Option<Bounded> {
        let [a, b] = maps else { return None };
        let (d, norm) = (a.translation - b.translation, a.norm());
        let size = a.translation.abs().max(b.translation.abs()).max_element();
        // NaN is none of these.
        let usual =
            norm < LARGEST_NORM && size < 1e100 && d.length() > 1e-6 * size && epsilon >= LEAST_EPSILON;
        if a.linear != b.linear || !usual {
            return None;
        }
        if a.linear.y_axis == a.linear.x_axis.perp()
            && let Some(known) = self.decide_complex(a.linear.x_axis, d.length(), epsilon, bounds)
        {
            return Some(known);
        }
        // The attractor has the step between its pieces across, and more.
        let found = self.quick_look(a.linear, norm, d, epsilon * d.length());
        let touching = Sample { state: State::Touching, gap: 0.0 };
        if found.is_some() && !bounds {
            return Some(Bounded { sample: touching, ..Bounded::unknown(State::Touching) });
        }
        self.set(a.linear, norm, d, LARGEST_REST * epsilon);
        let diameter = self.diameter();
        let near = epsilon * diameter;
        let upper = found.or_else(|| self.least(near))?;
        let off = ROUNDING * d.length() / ((1.0 - norm) * (1.0 - norm));
        bounded(upper, near, off, diameter)
    }

    /// The same for maps that are multiplied by the complex number `s`, and are `d` apart.
    fn decide_complex(&mut self, s: DVec2, d: f64, epsilon: f64, bounds: bool) -> Option<Bounded> {
        let series = &mut self.complex;
        if !series.begin(s) {
            return None;
        }
        // Two copies of a segment, no shorter than half of it, cover it.
        let whole = s.y == 0.0 && s.x.abs() >= 0.5;
        let found =
            if whole { Look::Near(0.0) } else { series.quick_look(epsilon * series.least_diameter()) };
        let state = if whole { State::Connected } else { State::Touching };
        let holds = Bounded { sample: Sample { state, gap: 0.0 }, ..Bounded::unknown(state) };
        if matches!(found, Look::Near(_)) && !bounds {
            return Some(holds);
        }
        let diameter = series.measure();
        if whole {
            return Some(Bounded { upper: 0.0, diameter: d * diameter, ..holds });
        }
        let near = epsilon * diameter;
        let upper = match found {
            Look::Near(length) => length,
            Look::Far(least) => series.least(near, least)?,
        };
        let room = 1.0 - s.length();
        let known = bounded(upper, near, ROUNDING / (room * room), diameter)?;
        Some(Bounded { diameter: d * diameter, ..known })
    }

    /// The terms, down to a part `rest` of the first, and how far those from each on reach.
    fn set(&mut self, m: DMat2, norm: f64, d: DVec2, rest: f64) {
        self.terms.clear();
        let (mut term, mut left) = (d, 1.0 / (1.0 - norm));
        while left > rest && self.terms.len() < MOST_TERMS {
            self.terms.push(term);
            (term, left) = (m * term, left * norm);
        }
        let beyond = F64x4::splat(left * d.length() * (1.0 + 1e-12));
        self.spans.clear();
        self.spans.resize(self.terms.len() + 1, [beyond; 2]);
        let mut span = [beyond; 2];
        for (k, &term) in self.terms.iter().enumerate().rev() {
            let term = along(term);
            span = [span[0] + term[0].abs(), span[1] + term[1].abs()];
            self.spans[k] = span;
        }
    }

    /// The diameter of the attractor, at most: it is as wide along a direction as the terms are, one by one.
    fn diameter(&self) -> f64 {
        let widest = self.spans[0][0].max(self.spans[0][1]).to_array().into_iter().fold(0.0, larger);
        widest / COSINE * (1.0 + 1e-12)
    }

    /// How far a value is from 0 that is no farther than `reach`, if one is found: always on to where the sum is
    /// least, and back to the last that was passed over where that is too far from 0.
    fn quick_look(&self, m: DMat2, norm: f64, d: DVec2, reach: f64) -> Option<f64> {
        // Of the series from the square of M on.
        let rest = d.length_squared() * (norm * norm / (1.0 - norm)).powi(2);
        let mut sum = Sum { at: d, term: m * d, limit: SQUARE_TO_ENTER * rest };
        // A ring.
        let mut passed = [sum; KEPT];
        let (mut end, mut kept, mut back) = (0, 0, 0);
        for _ in 0..MOST_STEPS {
            let Sum { at, term, limit } = sum;
            let square = at.length_squared();
            // All further terms may be left out.
            if square <= reach * reach {
                return Some(square.sqrt());
            }
            // Of adding the term and taking it away one is worse than leaving it out.
            let along = at.dot(term);
            let (moved, after) =
                (at - term * along.signum(), square + term.length_squared() - 2.0 * along.abs());
            let ((best, least), (second, more)) =
                if after < square { ((moved, after), (at, square)) } else { ((at, square), (moved, after)) };
            let next = |at: DVec2| Sum { at, term: m * term, limit: limit * (norm * norm) };
            if more < limit {
                passed[end] = next(second);
                (end, kept) = ((end + 1) % KEPT, KEPT.min(kept + 1));
            }
            if least < limit {
                sum = next(best);
            } else {
                back += 1;
                if back > MOST_RETURNS || kept == 0 {
                    return None;
                }
                (end, kept) = ((end + KEPT - 1) % KEPT, kept - 1);
                sum = passed[end];
            }
        }
        None
    }

    /// How far the least value found is from 0, where it is known that none is much nearer: by the part
    /// [`BRACKET_WIDTH`] at most. Or a value not farther than `near`.
    fn least(&mut self, near: f64) -> Option<f64> {
        // Whether any is near is soon told, as all that leads to farther ones is left out; and the least that was met
        // on the way leaves little to look at for the least of all.
        let met = self.search(near, f64::INFINITY, |_| near)?;
        if met <= near {
            return Some(met);
        }
        self.search(near, met, |least| (1.0 - BRACKET_WIDTH) * least)
    }

    /// The distance from 0 of the least value found, or of one not farther than `near`; `least` is that of one known.
    /// Sums that lead to none nearer than `far` of the least are left out.
    fn search(&mut self, near: f64, mut least: f64, far: impl Fn(f64) -> f64) -> Option<f64> {
        let Self { terms, spans, open, .. } = self;
        open.clear();
        open.push((terms[0], 1));
        // Its square, so that no root is taken of each sum.
        let (mut shortest, mut limit) = (least * least, far(least));
        for _ in 0..MOST_SUMS {
            let Some((at, k)) = open.pop() else { return Some(least) };
            let square = at.length_squared();
            if square < shortest {
                shortest = square;
                least = lesser(least, square.sqrt());
                limit = far(least);
                if least <= near {
                    return Some(least);
                }
            }
            // All further values lie in the polygon about the sum that the terms left reach.
            let [first, second] = along(at);
            let apart = (first.abs() - spans[k][0]).max(second.abs() - spans[k][1]);
            let [a, b, c, d] = apart.to_array();
            if larger(larger(a, b), larger(c, d)) >= limit {
                continue;
            }
            let &term = terms.get(k)?;
            let moved = term * at.dot(term).signum();
            let mut two = [(at, k + 1), (at - moved, k + 1)];
            if two[1].0.length_squared() > square {
                two.swap(0, 1);
            }
            // The most promising last.
            let [second, first] = two;
            open.extend([(at + moved, k + 1), second, first]);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(s: DVec2) -> [Affine2; 2] {
        let linear = DMat2::from_cols(s, s.perp());
        [DVec2::X, -DVec2::X].map(|t| Affine2::new(linear, t))
    }

    /// The same maps, but for what no complex number does: across the line on which the pieces of real s lie they
    /// shrink otherwise, and where s is not real, in the last digit.
    fn other_pair(s: DVec2) -> [Affine2; 2] {
        pair(s).map(|mut map| {
            map.linear.y_axis =
                if s.y == 0.0 { DVec2::new(0.0, 0.3) } else { map.linear.y_axis * (1.0 + 1e-15) };
            map
        })
    }

    #[test]
    fn pieces_on_a_line_are_as_near_as_is_said() {
        for pair in [pair, other_pair] {
            pieces_on_a_line(pair);
        }
    }

    fn pieces_on_a_line(pair: fn(DVec2) -> [Affine2; 2]) {
        let mut series = PowerSeries::default();
        for k in 0..200 {
            let s = 0.3 + 0.0015 * f64::from(k);
            for sign in [1.0, -1.0] {
                let maps = pair(DVec2::new(sign * s, 0.0));
                // Of -s they are those of s: an interval from one half on, 2 / (1 - s) across in any case.
                let gap = 2.0 * (1.0 - 2.0 * s).max(0.0) / (1.0 - s);
                for epsilon in [0.1, 1e-3, 1e-9] {
                    let known = series.decide(&maps, epsilon, true);
                    let Some(known) = known else {
                        assert!((0.5..0.56).contains(&s), "{s} {epsilon}");
                        continue;
                    };
                    let touches = known.sample.state.holds();
                    assert_eq!(touches, gap <= known.diameter * epsilon, "{s} {epsilon} {known:?}");
                    let [lower, upper] = [known.lower, known.upper].map(|x| x * known.diameter);
                    assert!(lower <= gap && gap <= upper, "{s} {epsilon} {known:?}");
                    assert!(known.upper <= epsilon * 1.0001 || !touches && known.lower > 0.0);
                    assert!((2.0 / (1.0 - s)..2.06 / (1.0 - s)).contains(&known.diameter), "{known:?}");
                }
            }
        }
    }

    #[test]
    fn half_a_segment_twice_is_a_segment() {
        let mut series = PowerSeries::default();
        for s in [0.5, -0.5, 0.6, -0.9] {
            for bounds in [false, true] {
                let known = series.decide(&pair(DVec2::new(s, 0.0)), 1e-6, bounds).expect("an answer");
                assert_eq!(known.sample, Sample { state: State::Connected, gap: 0.0 });
            }
        }
        let less = pair(DVec2::new(0.5 - 1e-9, 0.0));
        assert!(
            series.decide(&less, 1e-11, false).is_none_or(|known| known.sample.state != State::Connected)
        );
    }

    #[test]
    fn complex_numbers_are_told_as_others_are() {
        let (mut series, mut apart) = (PowerSeries::default(), 0);
        for k in 0..300 {
            let s = DVec2::from_angle(f64::from(k)) * (0.3 + 0.0013 * f64::from(k));
            let known = [pair(s), other_pair(s)].map(|maps| series.decide(&maps, 1e-5, true));
            let [Some(one), Some(other)] = known else { continue };
            assert!(
                one.lower <= other.upper * 1.001 && other.lower <= one.upper * 1.001,
                "{one:?} {other:?}"
            );
            assert!((one.diameter / other.diameter - 1.0).abs() < 0.005, "{one:?} {other:?}");
            assert_eq!(one.sample.state, other.sample.state);
            apart += usize::from(one.sample.state == State::Disconnected);
        }
        assert!(apart > 150, "{apart}");
    }

    #[test]
    fn nothing_is_near_in_the_hole_and_outside() {
        for pair in [pair, other_pair] {
            hole_and_outside(pair);
        }
    }

    fn hole_and_outside(pair: fn(DVec2) -> [Affine2; 2]) {
        let mut series = PowerSeries::default();
        for s in [[0.0227, 0.703], [0.3, 0.4], [0.55, 0.2]] {
            let known = series.decide(&pair(DVec2::from(s)), 1e-6, true).expect("an answer");
            assert!(known.sample.state == State::Disconnected && known.lower > 0.0, "{known:?}");
            assert!(known.lower >= 0.88 * known.upper);
        }
        let known = series.decide(&pair(DVec2::new(0.2, 0.67)), 1e-6, true).expect("an answer");
        assert_eq!(known.sample.state, State::Touching);
        for bad in [DVec2::new(0.98, 0.1), DVec2::splat(f64::NAN)] {
            assert!(series.decide(&pair(bad), 1e-6, true).is_none());
        }
        assert!(series.decide(&pair(DVec2::new(0.2, 0.67)), f64::NAN, true).is_none());
    }
}
