//! The ellipse that all of some maps of the plane shrink.

use glam::{DMat2, DVec2};

use crate::linear::svd2::singular_values;

/// What a thin ellipse costs in the search for the best.
const ROUNDNESS: f64 = 1e-9;

#[inline(never)]
fn worst_norm(linear: &[DMat2], to: DMat2, from: DMat2) -> f64 {
    linear.iter().map(|&m| singular_values(to * m * from).0).fold(0.0, f64::max)
}

/// The ellipse `x^2 + 2 p x y + (p^2 + q^2) y^2 = 1` as coordinates that make it round, and back.
fn coordinates(p: f64, q: f64) -> (DMat2, DMat2) {
    let to = DMat2::from_cols(DVec2::new(1.0, 0.0), DVec2::new(p, q));
    let from = DMat2::from_cols(DVec2::new(1.0, 0.0), DVec2::new(-p / q, 1.0 / q));
    (to, from)
}

/// The ellipse whose largest shrunk image is about as small as can be, as coordinates that make it round, and back: a
/// rounder one than the best, where little is lost by it. `plain` is what the circle gives.
///
/// The factor is quasi-convex in the ellipse's matrix `P` (the condition `M^T P M <= f^2 P` is linear
/// in `P`), so that a search of one number inside a search of the other finds the least.
pub(crate) fn best(linear: &[DMat2], plain: f64) -> [DMat2; 2] {
    // Where the factor is that of a map which every ellipse shrinks alike, it is level: then the roundest will
    // do, and the search must not run off to the thinnest.
    let factor = |s: f64, log_q: f64| {
        let (to, from) = coordinates(s.sinh(), log_q.exp());
        worst_norm(linear, to, from) + ROUNDNESS * (s.abs() + log_q.abs())
    };
    let best_q = |s: f64| golden(-14.0, 14.0, &|log_q| factor(s, log_q));
    let (s, _) = golden(-12.0, 12.0, &|s| best_q(s).1);
    let (p, q) = (s.sinh(), best_q(s).0.exp());
    let (to, from) = coordinates(p, q);
    let least = worst_norm(linear, to, from);
    // Only for a gain that shows: the circle has no rounding errors of its own.
    if 1.0 - least <= 1.5 * (1.0 - plain) {
        return [DMat2::IDENTITY; 2];
    }
    // A defective map comes nearer to its spectral radius the thinner the ellipse, without end; and whatever is
    // bounded in a thin ellipse is bounded badly in the plane.
    let price = THINNESS * (1.0 - least).abs() * log_aspect(p, q);
    let rounder = |share: f64| if share < 1.0 { rounder(p, q, share) } else { (to, from) };
    let cost = |share: f64| {
        let (to, from) = rounder(share);
        worst_norm(linear, to, from) + price * share
    };
    let (share, least) = golden(0.0, 1.0, &cost);
    let (to, from) = rounder(if least < cost(1.0) { share } else { 1.0 });
    [to, from]
}

/// What an ellipse costs that is e times as thin, in parts of what the best one shrinks.
const THINNESS: f64 = 0.1;

/// The logarithm of how many times longer than wide the ellipse is.
fn log_aspect(p: f64, q: f64) -> f64 {
    ((1.0 + p * p + q * q) / (2.0 * q)).max(1.0).acosh()
}

/// The ellipse of the same axes as that of `p` and `q`, whose aspect is raised to the power `share`: its matrix is the
/// power of that of the other, at determinant 1. The factor falls from the circle to the best ellipse, since
/// these matrices are, but for their scale, on the straight line between the two.
fn rounder(p: f64, q: f64, share: f64) -> (DMat2, DMat2) {
    let log = log_aspect(p, q);
    if log < 1e-6 {
        return coordinates(p * share, 1.0 + (q - 1.0) * share);
    }
    let of_circle = (log * (1.0 - share)).sinh() / log.sinh();
    let of_ellipse = (log * share).sinh() / log.sinh();
    let first = of_circle + of_ellipse / q;
    coordinates(of_ellipse * p / q / first, 1.0 / first)
}

/// The least value of a quasi-convex function on an interval, by the golden section. Compiled once for all functions:
/// each of them takes far longer than to be called.
#[inline(never)]
fn golden(mut low: f64, mut high: f64, f: &dyn Fn(f64) -> f64) -> (f64, f64) {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let mut left = high - RATIO * (high - low);
    let mut right = low + RATIO * (high - low);
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..44 {
        if at_left <= at_right {
            high = right;
            (right, at_right) = (left, at_left);
            left = high - RATIO * (high - low);
            at_left = f(left);
        } else {
            low = left;
            (left, at_left) = (right, at_right);
            right = low + RATIO * (high - low);
            at_right = f(right);
        }
    }
    if at_left <= at_right { (left, at_left) } else { (right, at_right) }
}
