//! From a chain of cells to a few way points.

use crate::field::Field;

/// The cells of `way` to keep, the first and the last among them, at most `most` in all: those whose polygon costs
/// least in the field, with a price on each way point.
///
/// No leg meets a gap wider than `widest`. If `most` is too few for that, more are kept.
pub(crate) fn simplify(field: &Field, way: &[usize], widest: f64, most: usize) -> Vec<usize> {
    // Corners are only looked for at some of the cells: a chain may have many hundred.
    let stride = way.len().div_ceil(MOST_CORNERS).max(1);
    let mut corners: Vec<usize> = way.iter().copied().step_by(stride).collect();
    if let Some(&end) = way.last().filter(|_| !(way.len() - 1).is_multiple_of(stride)) {
        corners.push(end);
    }
    let count = corners.len();
    let legs: Vec<f64> = (0..count * count)
        .map(|k| {
            if k / count < k % count {
                leg(field, corners[k / count], corners[k % count], widest)
            } else {
                0.0
            }
        })
        .collect();
    // A way point must save so much of the way, or of the closeness to what is broken, to be worth having: it is
    // one more thing on the screen to understand.
    let mut toll = field.side() / 40.0;
    loop {
        let kept = cheapest_chain(count, &legs, toll);
        let fits = kept.len() <= most || toll > 1e6;
        if let Some(kept) = fits.then_some(kept).filter(|kept| kept.len() > 1 || count == 1) {
            return kept.into_iter().map(|k| corners[k]).collect();
        }
        if toll > 1e6 {
            return way.to_vec();
        }
        toll *= 2.0;
    }
}

/// Corners looked at.
const MOST_CORNERS: usize = 160;

/// The chain from the first to the last corner that costs least, each corner a `toll`; empty if there is none.
fn cheapest_chain(count: usize, legs: &[f64], toll: f64) -> Vec<usize> {
    let mut cost = vec![f64::INFINITY; count];
    let mut before = vec![0; count];
    cost[0] = 0.0;
    for to in 1..count {
        for from in 0..to {
            let total = cost[from] + legs[from * count + to] + toll;
            if total < cost[to] {
                cost[to] = total;
                before[to] = from;
            }
        }
    }
    if count > 1 && cost[count - 1].is_infinite() {
        return Vec::new();
    }
    let mut chain = vec![count - 1];
    while chain[chain.len() - 1] != 0 {
        chain.push(before[chain[chain.len() - 1]]);
    }
    chain.reverse();
    chain
}

/// What a straight leg between two cells costs; infinite if it meets a gap wider than `widest`.
///
/// Where it passes between samples, all of those around must do: what holds in single samples only, say along
/// a line of the grid, is left at right angles.
fn leg(field: &Field, from: usize, to: usize, widest: f64) -> f64 {
    let ((x0, y0), (x1, y1)) = (field.place(from), field.place(to));
    let length = (x1 - x0).hypot(y1 - y0);
    if length < 1.5 {
        let gap = field.step_gap(from, to);
        let price = 0.5 * (field.price(from) + field.price(to));
        return if gap > widest { f64::INFINITY } else { length * price };
    }
    let steps = (2.0 * length).ceil() as usize;
    let mut sum = 0.0;
    for k in 0..=steps {
        let t = k as f64 / steps as f64;
        let (x, y) = (x0 + t * (x1 - x0), y0 + t * (y1 - y0));
        // Rounding must not turn a leg along a line of the grid into one beside it.
        let (x, y) = (snapped(x), snapped(y));
        if field.gap_around(x, y) > widest {
            return f64::INFINITY;
        }
        sum += field.cell(x, y).map_or(f64::INFINITY, |cell| field.price(cell));
    }
    length * sum / (steps + 1) as f64
}

fn snapped(x: f64) -> f64 {
    if (x - x.round()).abs() < 1e-6 { x.round() } else { x }
}
