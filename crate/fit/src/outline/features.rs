//! Feature points: polyline splitting.

use std::collections::BinaryHeap;

use glam::DVec2;

use super::Outline;

/// A stretch of the outline, with the point of it that is farthest from its chord. The order is that of the distance.
struct Stretch {
    distance: f64,
    from: usize,
    to: usize,
    farthest: usize,
}

impl PartialEq for Stretch {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Stretch {}
impl PartialOrd for Stretch {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Stretch {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        // Of equals the first along the outline, so that the choice is the same everywhere.
        self.distance.total_cmp(&other.distance).then(other.from.cmp(&self.from))
    }
}

/// Indices, in order, of `count` points of the outline (2 or more, at most all): polyline splitting.
///
/// It begins with two points far from each other and then splits, again and again, the stretch whose points lie
/// farthest from its chord, at the farthest of them (Jain, Kasturi & Schunck, Machine Vision, 1995, section 6.4).
#[must_use]
pub fn features(outline: &Outline, count: usize) -> Vec<usize> {
    let points = outline.points();
    let count = count.clamp(2, points.len());
    let farthest_from = |place: DVec2| {
        let mut best = (0, -1.0);
        for (i, p) in points.iter().enumerate() {
            let distance = p.distance_squared(place);
            if distance > best.1 {
                best = (i, distance);
            }
        }
        best.0
    };
    let (low, high) = outline.bounds();
    let first = farthest_from((low + high) / 2.0);
    let second = farthest_from(points[first]);
    let mut chosen = vec![first, second];
    let mut heap = BinaryHeap::from([stretch(points, first, second), stretch(points, second, first)]);
    while chosen.len() < count {
        let Some(Stretch { from, to, farthest, .. }) = heap.pop() else { break };
        if farthest == from {
            continue;
        }
        chosen.push(farthest);
        heap.push(stretch(points, from, farthest));
        heap.push(stretch(points, farthest, to));
    }
    chosen.sort_unstable();
    chosen
}

fn stretch(points: &[DVec2], from: usize, to: usize) -> Stretch {
    let (a, b) = (points[from], points[to]);
    let chord = b - a;
    let scale = chord.length_squared();
    let mut best = Stretch { distance: -1.0, from, to, farthest: from };
    let mut i = from;
    loop {
        i = if i + 1 == points.len() { 0 } else { i + 1 };
        if i == to {
            return best;
        }
        let share = if scale > 0.0 { ((points[i] - a).dot(chord) / scale).clamp(0.0, 1.0) } else { 0.0 };
        let distance = points[i].distance_squared(a + chord * share);
        if distance > best.distance {
            best = Stretch { distance, from, to, farthest: i };
        }
    }
}
