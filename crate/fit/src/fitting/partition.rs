//! Where knots belong: a partition of the outline into arcs that are nearly straight.

use glam::DVec2;

use crate::outline::{Outline, features};

/// The longest arc, in candidates.
const LONGEST_ARC: usize = 160;

/// Sums over the first points, from which those of any stretch follow.
struct Sums(Vec<[f64; 5]>);

impl Sums {
    fn new(points: &[DVec2], middle: DVec2) -> Self {
        let mut sums = vec![[0.0; 5]];
        let mut sum = [0.0; 5];
        // Twice round, so that a stretch may pass the seam.
        for p in points.iter().chain(points) {
            let p = *p - middle;
            for (s, x) in sum.iter_mut().zip([p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y]) {
                *s += x;
            }
            sums.push(sum);
        }
        Self(sums)
    }

    /// The sum of squared distances of points `from` to `to` (one behind the last) from their best line: the smaller
    /// eigenvalue of their scatter.
    fn misfit(&self, from: usize, to: usize) -> f64 {
        let count = (to - from) as f64;
        let part: Vec<f64> = self.0[to].iter().zip(&self.0[from]).map(|(a, b)| a - b).collect();
        let xx = part[2] - part[0] * part[0] / count;
        let xy = part[3] - part[0] * part[1] / count;
        let yy = part[4] - part[1] * part[1] / count;
        (0.5 * (xx + yy) - f64::hypot(0.5 * (xx - yy), xy)).max(0.0)
    }
}

/// Indices, in order, of about `count` points of the outline that part it into arcs which lines fit best: the least sum
/// of squares over all choices among feature points, by dynamic programming with a price a knot.
#[must_use]
pub fn partition(outline: &Outline, count: usize) -> Vec<usize> {
    let points = outline.points();
    let count = count.clamp(3, points.len());
    let candidates = features(outline, (6 * count).clamp(64, 2000));
    let (low, high) = outline.bounds();
    let sums = Sums::new(points, (low + high) / 2.0);
    let total = candidates.len();
    let window = LONGEST_ARC.min(total);
    // The costs of all arcs from candidate i over 1, 2 .. candidates.
    let place = |i: usize| candidates[i % total] + if i >= total { points.len() } else { 0 };
    let costs: Vec<f64> = (0..total)
        .flat_map(|i| (1..=window).map(move |k| (i, i + k)))
        .map(|(i, j)| sums.misfit(place(i), place(j.min(2 * total - 1)) + 1))
        .collect();
    let cut = |price: f64| {
        let mut best = vec![f64::INFINITY; total + 1];
        let mut from = vec![0; total + 1];
        best[0] = 0.0;
        for i in 0..total {
            for k in 1..=window.min(total - i) {
                let cost = best[i] + costs[i * window + k - 1] + price;
                if cost < best[i + k] {
                    best[i + k] = cost;
                    from[i + k] = i;
                }
            }
        }
        let mut chosen = Vec::new();
        let mut at = total;
        while at > 0 {
            at = from[at];
            chosen.push(candidates[at]);
        }
        chosen.reverse();
        chosen
    };
    let (mut cheap, mut dear) = (0.0, outline.diagonal().powi(2) * points.len() as f64);
    let mut best = cut(dear);
    for _ in 0..60 {
        // The prices in question differ by powers of ten.
        let price = if cheap == 0.0 { dear * 1e-2 } else { (cheap * dear).sqrt() };
        let chosen = cut(price);
        if chosen.len() > count {
            cheap = price;
        } else {
            dear = price;
            if chosen.len() >= best.len() {
                best = chosen;
            }
        }
        if best.len() == count || price < 1e-18 {
            break;
        }
    }
    best
}
