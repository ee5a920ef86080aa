//! A part of a graph as a polyline.

use crate::fractal::curve::{FractalCurve, Side};
use crate::fractal::function::FractalFunction;
use crate::fractal::sample::Ends;

/// A copy of a part of the graph: t = scale * source + shift, x = shear * source + factor * F(source) + offset.
#[derive(Clone, Copy)]
struct Part {
    source: [f64; 2],
    scale: f64,
    shift: f64,
    shear: f64,
    factor: f64,
    offset: f64,
}

impl Part {
    /// Where it lies, from left to right.
    fn range(&self) -> [f64; 2] {
        let ends = self.source.map(|t| self.scale * t + self.shift);
        if self.scale < 0.0 { [ends[1], ends[0]] } else { ends }
    }

    /// How far apart two of its values can be.
    fn spread(&self, bound: f64) -> f64 {
        (self.shear * (self.source[1] - self.source[0])).abs() + 2.0 * self.factor.abs() * bound
    }

    fn first(&self, ends: &mut Ends) -> (f64, f64) {
        let [low, high] = self.source;
        let (t, side) = if self.scale > 0.0 { (low, Side::Right) } else { (high, Side::Left) };
        let value = ends.limit(t, side, 0.0).x;
        (self.scale * t + self.shift, self.shear * t + self.factor * value + self.offset)
    }

    /// Puts the copies it is made of on the stack, the leftmost on top.
    fn split(&self, curve: &FractalCurve, stack: &mut Vec<Self>) {
        let [low, high] = self.source;
        let pieces = curve.pieces();
        let (from, first) = (stack.len(), pieces.partition_point(|piece| piece.range[1] <= low));
        let first = first.min(pieces.len() - 1);
        for (index, piece) in pieces.iter().enumerate().skip(first) {
            let [begin, end] = curve.seen(index);
            if begin >= high && index > first {
                break;
            }
            let seen = [low.max(begin), high.min(end)];
            if seen[0] > seen[1] {
                continue;
            }
            let ends = seen.map(|t| piece.source(t));
            let [a, b, c, d, e] = piece.map();
            stack.push(Self {
                source: if piece.reflected { [ends[1], ends[0]] } else { ends },
                scale: self.scale * a,
                shift: self.scale * d + self.shift,
                shear: self.shear * a + self.factor * b,
                factor: self.factor * c,
                offset: self.offset + self.shear * d + self.factor * e,
            });
        }
        if self.scale > 0.0 {
            stack[from..].reverse();
        }
    }
}

impl FractalFunction {
    /// Points (t, x) from one end of the window to the other; between two, x stays within the tolerance of both. Where
    /// that would take more than `most` points, the tolerance is doubled until it does not.
    #[must_use]
    pub fn sample(&self, tolerance: f64, window: [f64; 2], most: usize) -> Vec<(f64, f64)> {
        let curve = self.curve();
        // The window may lie beyond the ends of the graph.
        let [start, end] = curve.interval();
        let [low, high] = window.map(|t| t.clamp(start, end));
        let mut known = Ends::new(curve);
        let ends = [(low, Side::Right), (high, Side::Left)].map(|(t, side)| (t, known.limit(t, side, 0.0).x));
        if low >= high || most <= 2 {
            return ends.to_vec();
        }
        let mut tolerance = tolerance.max(curve.bound() / (64.0 * most as f64));
        let parts = loop {
            match parts(self, tolerance, [low, high], most - 2) {
                Some(parts) => break parts,
                None => tolerance = 2.0 * tolerance.max(f64::MIN_POSITIVE),
            }
        };
        let inner =
            parts.iter().map(|part| part.first(&mut known)).filter(|point| point.0 > low && point.0 < high);
        ends[..1].iter().copied().chain(inner).chain(ends[1..].iter().copied()).collect()
    }
}

/// The parts of the graph within the window that are as flat as the tolerance, from left to right; none where there are
/// more than `most`.
fn parts(
    function: &FractalFunction,
    tolerance: f64,
    [low, high]: [f64; 2],
    most: usize,
) -> Option<Vec<Part>> {
    let curve = function.curve();
    let (pieces, bound) = (curve.pieces(), curve.bound());
    let whole = Part {
        source: function.curve().interval(),
        scale: 1.0,
        shift: 0.0,
        shear: 0.0,
        factor: 1.0,
        offset: 0.0,
    };
    let (mut found, mut stack) = (Vec::new(), vec![whole]);
    while let Some(part) = stack.pop() {
        let [from, to] = part.range();
        if to <= low || from >= high {
            continue;
        }
        // Parts too narrow to be told apart are not split any more.
        let narrow = to - from <= 4.0 * f64::EPSILON * from.abs().max(to.abs());
        if narrow || part.spread(bound) <= tolerance {
            found.push(part);
        } else {
            part.split(curve, &mut stack);
        }
        // What waits is mostly outside of the window where there are few points and many pieces.
        if found.len() > most || stack.len() > most + 16 * pieces.len() {
            return None;
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    fn rough() -> FractalFunction {
        let points = [[0.0, 0.5], [0.2, -0.25], [0.6, 1.0], [1.0, 0.3]].map(DVec2::from);
        FractalFunction::fif(&points, &[1.0 / 3.0, -0.5, 0.6], &[false, true, false]).unwrap()
    }

    #[test]
    fn what_lies_between_two_points_is_near_both() {
        let function = rough();
        for window in [[0.0, 1.0], [0.31, 0.3100001], [-5.0, 0.2], [0.9, 7.0]] {
            let points = function.sample(0.01, window, 1 << 16);
            assert_eq!((points[0].0, points[points.len() - 1].0), (window[0].max(0.0), window[1].min(1.0)));
            for pair in points.windows(2) {
                let [(t0, x0), (t1, x1)] = [pair[0], pair[1]];
                assert!(t0 < t1);
                for share in [0.01, 0.25, 0.618, 0.99] {
                    let x = function.at(t0 + share * (t1 - t0));
                    assert!((x - x0).abs() <= 0.01 + 1e-9 && (x - x1).abs() <= 0.01 + 1e-9, "{t0} {t1}");
                }
            }
        }
        let few = function.sample(0.01, [0.31, 0.3101], 1 << 16).len();
        assert!(few * 20 < function.sample(0.01, [0.0, 1.0], 1 << 16).len(), "{few}");
    }

    #[test]
    fn there_are_never_more_points_than_asked_for() {
        let function = rough();
        for most in [2, 3, 7, 100, 3000] {
            let points = function.sample(0.0, [0.0, 1.0], most);
            assert!(points.len() <= most && points.len() * 20 > most, "{most}: {}", points.len());
        }
        // A window without anything in it has the value of the nearer end.
        for (t, x) in function.sample(0.1, [3.0, 4.0], 100) {
            assert!(t == 1.0 && (x - 0.3).abs() < 1e-15, "{t} {x}");
        }
    }
}
