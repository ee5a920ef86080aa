//! Corners taken away one by one, so that no side ever crosses another.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use frond_core::shared::Total;
use glam::DVec2;

use super::Outline;
use super::crossing::turn;
use super::near::to_side;

/// Corners of the outline that are left, by a grid.
struct Left {
    low: DVec2,
    cell: f64,
    columns: usize,
    rows: usize,
    cells: Vec<Vec<u32>>,
}

impl Left {
    fn new(points: &[DVec2], (low, high): (DVec2, DVec2)) -> Self {
        let size = high - low;
        let across = (points.len() as f64).sqrt().clamp(4.0, 256.0);
        let cell = (size.max_element() / across).max(f64::MIN_POSITIVE);
        let columns = ((size.x / cell) as usize).min(512) + 1;
        let rows = ((size.y / cell) as usize).min(512) + 1;
        let mut left = Self { low, cell, columns, rows, cells: vec![Vec::new(); columns * rows] };
        for (i, &p) in points.iter().enumerate() {
            let cell = left.cell_of(p);
            left.cells[cell].push(i as u32);
        }
        left
    }

    fn place(&self, p: DVec2) -> (usize, usize) {
        let at = (p - self.low) / self.cell;
        ((at.x as usize).min(self.columns - 1), (at.y as usize).min(self.rows - 1))
    }

    fn cell_of(&self, p: DVec2) -> usize {
        let (column, row) = self.place(p);
        row * self.columns + column
    }

    fn take(&mut self, i: usize, p: DVec2) {
        let cell = self.cell_of(p);
        self.cells[cell].retain(|&k| k as usize != i);
    }

    /// Whether a triangle of corners holds no other corner, not even on its border.
    fn is_empty(&self, points: &[DVec2], triangle: [usize; 3]) -> bool {
        let [a, b, c] = triangle.map(|i| points[i]);
        let (low, high) = (self.place(a.min(b).min(c)), self.place(a.max(b).max(c)));
        let way = turn(a, b, c);
        let inside = |p: DVec2| {
            let turns = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
            // A triangle of no area holds what is on its line, as far as boxes tell.
            turns.iter().all(|&t| t == 0 || t == way)
                && p.cmpge(a.min(b).min(c)).all()
                && p.cmple(a.max(b).max(c)).all()
        };
        for row in low.1..=high.1 {
            for column in low.0..=high.0 {
                for &i in &self.cells[row * self.columns + column] {
                    if !triangle.contains(&(i as usize)) && inside(points[i as usize]) {
                        return false;
                    }
                }
            }
        }
        true
    }
}

/// Indices, in order, of `count` points of the outline (3 or more, at most all): the corner whose loss moves the
/// outline least goes, again and again (Visvalingam and Whyatt, "Line generalisation by repeated elimination of
/// points", 1993, with squares of distances in the place of areas).
///
/// A corner goes only where the triangle that it leaves holds no other: where the outline does not meet itself, the
/// polygon does not either. A simple polygon has two such corners at least, its ears.
#[must_use]
pub fn decimated(outline: &Outline, count: usize) -> Vec<usize> {
    let points = outline.points();
    let many = points.len();
    let count = count.clamp(3, many);
    let (low, high) = outline.bounds();
    let mut left = Left::new(points, (low, high));
    let mut next: Vec<usize> = (0..many).map(|i| (i + 1) % many).collect();
    let mut before: Vec<usize> = (0..many).map(|i| (i + many - 1) % many).collect();
    let mut stamp = vec![0_u32; many];
    // Squares of distances from the chord, not from its line: a spike along it would cost nothing.
    let stretch = |from: usize, to: usize| {
        let (a, b) = (points[from], points[to]);
        let between = if to > from { to - from } else { to + many - from };
        let inside = (1..between).map(|k| points[(from + k) % many]);
        inside.map(|p| to_side(p, a, b).1).sum::<f64>()
    };
    let cost = |before: &[usize], next: &[usize], i: usize| {
        let (a, b) = (before[i], next[i]);
        stretch(a, b) - stretch(a, i) - stretch(i, b)
    };
    let mut heap: BinaryHeap<_> =
        (0..many).map(|i| Reverse((Total(cost(&before, &next, i)), i, 0_u32))).collect();
    let mut held: Vec<usize> = Vec::new();
    let mut remaining = many;
    let mut freed = true;
    while remaining > count {
        let Some(Reverse((_, i, at))) = heap.pop() else {
            if !freed || held.is_empty() {
                break;
            }
            // What stood in the way of one may be gone by now.
            freed = false;
            let again = held.drain(..).filter(|&i| stamp[i] != u32::MAX);
            heap.extend(again.map(|i| Reverse((Total(cost(&before, &next, i)), i, stamp[i]))));
            continue;
        };
        if stamp[i] != at {
            continue;
        }
        let (a, b) = (before[i], next[i]);
        if !left.is_empty(points, [a, i, b]) {
            held.push(i);
            continue;
        }
        freed = true;
        left.take(i, points[i]);
        stamp[i] = u32::MAX;
        (next[a], before[b]) = (b, a);
        remaining -= 1;
        for k in [a, b] {
            stamp[k] += 1;
            heap.push(Reverse((Total(cost(&before, &next, k)), k, stamp[k])));
        }
    }
    if remaining > count {
        // Of an outline that meets itself not all can be taken so: then those go that are left over.
        let kept: Vec<_> = (0..many).filter(|&i| stamp[i] != u32::MAX).collect();
        return (0..count).map(|k| kept[k * kept.len() / count]).collect();
    }
    (0..many).filter(|&i| stamp[i] != u32::MAX).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grown::island;
    use crate::outline::contacts;

    #[test]
    fn a_rough_outline_keeps_from_crossing_down_to_a_triangle() {
        let outline = Outline::new(&island(2)).unwrap();
        assert_eq!(contacts(outline.points(), 1), Some(vec![]), "the outline is simple");
        for count in [400, 150, 60, 20, 7, 3] {
            let marks = decimated(&outline, count);
            let line: Vec<_> = marks.iter().map(|&i| outline.points()[i]).collect();
            assert!(marks.len() == count && marks.is_sorted());
            assert_eq!(contacts(&line, 1), Some(vec![]), "{count}");
        }
    }

    #[test]
    fn a_square_of_many_points_keeps_its_corners_and_a_tangle_is_parted_evenly() {
        let side = |a: DVec2, b: DVec2| (0..25).map(move |i| a.lerp(b, f64::from(i) / 25.0));
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let square: Vec<_> = (0..4).flat_map(|i| side(corners[i], corners[(i + 1) % 4])).collect();
        assert_eq!(decimated(&Outline::new(&square).unwrap(), 4), [0, 25, 50, 75]);
        let doubled: Vec<_> = square.iter().chain(&square).copied().collect();
        assert_eq!(decimated(&Outline::new(&doubled).unwrap(), 10).len(), 10);
    }
}
