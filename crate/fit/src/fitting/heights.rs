//! An arc seen from its chord: heights over places on it.

use glam::DVec2;

use super::normal::dot;
use crate::closed::over;

/// Places on a chord; even.
pub(crate) const CHORD_PLACES: usize = 28;
const HALF: usize = CHORD_PLACES / 2;

pub(crate) type Heights = [f64; CHORD_PLACES];

/// Heights over the chord in parts of its length, averaged where there are several; none where the arc leaves its chord
/// too far behind or ahead.
pub(crate) fn heights(points: impl Iterator<Item = DVec2>, from: DVec2, to: DVec2) -> Option<Heights> {
    let chord = to - from;
    let mut sums = [0.0; CHORD_PLACES];
    let mut counts = [0_u32; CHORD_PLACES];
    let mut last: Option<DVec2> = None;
    let place = |g: usize| (g as f64 + 0.5) / CHORD_PLACES as f64;
    for p in points {
        let w = over(p - from, chord);
        if !(w.x.abs() < 3.0 && w.y.abs() < 4.0) {
            return None;
        }
        if let Some(before) = last {
            let (a, b) = if before.x <= w.x { (before, w) } else { (w, before) };
            let first = (a.x * CHORD_PLACES as f64 - 0.5).ceil().max(0.0) as usize;
            for g in first..CHORD_PLACES {
                let u = place(g);
                if u > b.x {
                    break;
                }
                let share = if b.x > a.x { (u - a.x) / (b.x - a.x) } else { 0.5 };
                sums[g] += a.y + share * (b.y - a.y);
                counts[g] += 1;
            }
        }
        last = Some(w);
    }
    let mut grid = [0.0; CHORD_PLACES];
    let mut before = 0.0;
    for g in 0..CHORD_PLACES {
        if counts[g] > 0 {
            before = sums[g] / f64::from(counts[g]);
        }
        grid[g] = before;
    }
    Some(grid)
}

/// Takes a line's share off, and says what is left: the sum of squares.
#[inline(never)]
pub(crate) fn free_of_lines(grid: &mut Heights) -> f64 {
    let mean = grid.iter().sum::<f64>() / CHORD_PLACES as f64;
    let place = |g: usize| (g as f64 + 0.5) / CHORD_PLACES as f64 - 0.5;
    let slope = (0..CHORD_PLACES).map(|g| place(g) * grid[g]).sum::<f64>()
        / (0..CHORD_PLACES).map(|g| place(g) * place(g)).sum::<f64>();
    let mut rest = 0.0;
    for (g, height) in grid.iter_mut().enumerate() {
        *height -= mean + slope * place(g);
        rest += *height * *height;
    }
    rest
}

/// Heights as a part that is the same seen from both ends, and one that changes its sign.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    even: [f64; HALF],
    odd: [f64; HALF],
}

impl Shape {
    pub fn new(heights: &Heights) -> Self {
        let half = |sign: f64| {
            std::array::from_fn(|g| {
                std::f64::consts::FRAC_1_SQRT_2 * (heights[g] + sign * heights[CHORD_PLACES - 1 - g])
            })
        };
        Self { even: half(1.0), odd: half(-1.0) }
    }

    /// The sum of products of heights with those of another arc, as it is, and turned by half a circle: its far end
    /// first, and what was above the chord below it.
    pub fn dots(&self, other: &Self) -> [f64; 2] {
        let (even, odd) = (dot(&self.even, &other.even), dot(&self.odd, &other.odd));
        [odd + even, odd - even]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_is_compared_both_ways_round() {
        let heights =
            |turn: f64| -> Heights { std::array::from_fn(|g| (turn * g as f64).sin() + 0.1 * turn) };
        let (a, b) = (heights(0.7), heights(1.9));
        let sum = |b: &Heights| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut back = b;
        back.reverse();
        back.iter_mut().for_each(|h| *h = -*h);
        let [straight, turned] = Shape::new(&a).dots(&Shape::new(&b));
        assert!((straight - sum(&b)).abs() < 1e-12 && (turned - sum(&back)).abs() < 1e-12);
    }
}
