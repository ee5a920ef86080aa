//! Feature points: polyline splitting.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use frond_core::shared::Total;
use glam::DVec2;

use super::Outline;

/// A stretch of the outline, with the point of it that is farthest from its chord, in the order of that distance. Of
/// equals the first along the outline is the greatest, so that the choice is the same everywhere.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Stretch {
    distance: Total,
    from: Reverse<usize>,
    to: usize,
    farthest: usize,
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
        let Some(Stretch { from: Reverse(from), to, farthest, .. }) = heap.pop() else { break };
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
    let (mut most, mut farthest) = (-1.0, from);
    let mut i = from;
    loop {
        i = if i + 1 == points.len() { 0 } else { i + 1 };
        if i == to {
            return Stretch { distance: Total(most), from: Reverse(from), to, farthest };
        }
        let share = if scale > 0.0 { ((points[i] - a).dot(chord) / scale).clamp(0.0, 1.0) } else { 0.0 };
        let distance = points[i].distance_squared(a + chord * share);
        if distance > most {
            (most, farthest) = (distance, i);
        }
    }
}
