//! The last refinement: heights of knots and factors, by what the attractor then is.

use super::features::Features;
use crate::fractal::recurrent::Recurrent;

/// First and last step of a factor; of heights in half heights.
const FACTOR_STEPS: [f64; 5] = [0.06, 0.03, 0.015, 0.006, 0.0025];

/// The most rounds through all numbers.
const MOST_ROUNDS: usize = 16;

/// Recurrent functions of more pieces are left as they are.
const MOST_PIECES: usize = 40;

/// The largest |c|.
const MOST_C: f64 = 0.95;

/// Tries every number a little larger and a little smaller, and keeps what brings the function nearer to the features.
pub(super) fn polish(mut recurrent: Recurrent, fine: &Features, unit: f64) -> Recurrent {
    if recurrent.c.len() > MOST_PIECES {
        return recurrent;
    }
    let [start, end] = fine.interval();
    let tolerance = 1e-4 * unit;
    let error = |recurrent: &Recurrent| {
        let Ok(function) = recurrent.function() else { return f64::INFINITY };
        let curve = function.curve();
        let at = |t: f64| curve.limit(t.clamp(start, end), crate::fractal::curve::Side::Right, tolerance).x;
        fine.points().iter().map(|p| (at(p.x) - p.y).powi(2)).sum::<f64>()
    };
    let mut best = error(&recurrent);
    let knots = recurrent.points.len();
    let mut rounds = FACTOR_STEPS.into_iter();
    let mut step = rounds.next();
    let mut left = MOST_ROUNDS;
    while let (Some(size), 1..) = (step, left) {
        let before = best;
        left -= 1;
        for index in 0..knots + recurrent.c.len() {
            for sign in [1.0, -1.0] {
                let mut next = recurrent.clone();
                match index.checked_sub(knots) {
                    None => next.points[index].y += sign * size * unit,
                    Some(piece) => next.c[piece] = (next.c[piece] + sign * size).clamp(-MOST_C, MOST_C),
                }
                let told = error(&next);
                if told < best {
                    (best, recurrent) = (told, next);
                    break;
                }
            }
        }
        if best > 0.95 * before {
            step = rounds.next();
        }
    }
    recurrent
}
