//! A curve whose knots are points of an outline, or near them.

use frond_core::hash;
use glam::DVec2;

use super::candidates::Stretch;
use crate::closed::ClosedCurve;
use crate::outline::Nearest;

/// The curve with the index of the outline's point at each knot.
#[derive(Clone, Debug)]
pub(crate) struct Marked {
    pub curve: ClosedCurve,
    pub marks: Vec<usize>,
}

impl Marked {
    /// Moves each mark to the nearest point of the outline between its neighbours.
    #[inline(never)]
    pub fn follow(&mut self, ring: &[DVec2]) {
        let (count, knots) = (ring.len(), self.marks.len());
        for k in 0..knots {
            let (before, at, after) =
                (self.marks[(k + knots - 1) % knots], self.marks[k], self.marks[(k + 1) % knots]);
            let back = ((at + count - before) % count).saturating_sub(1) / 2;
            let ahead = ((after + count - at) % count).saturating_sub(1) / 2;
            let mut best = (f64::INFINITY, at);
            for step in 0..=back + ahead {
                let place = (at + count - back + step) % count;
                let distance = ring[place].distance_squared(self.curve.knots[k]);
                if distance < best.0 {
                    best = (distance, place);
                }
            }
            self.marks[k] = best.1;
        }
    }

    pub fn stretch(&self, ring: &[DVec2], from: usize, to: usize) -> Option<Stretch> {
        let count = self.marks.len();
        let (from, to) = (from % count, to % count);
        let ends = [self.curve.knots[from], self.curve.knots[to]];
        Stretch::new(ring, self.marks[from], self.marks[to], ends)
    }

    /// Whether a point of the outline lies between the marks of an edge.
    pub fn is_inside(&self, edge: usize, point: usize, count: usize) -> bool {
        let from = self.marks[edge];
        let many = (self.marks[(edge + 1) % self.marks.len()] + count - from) % count;
        (1..many).contains(&((point + count - from) % count))
    }

    /// The outline's point over a place of an edge's chord.
    #[inline(never)]
    pub fn mark_over(&self, ring: &[DVec2], edge: usize, share: f64) -> usize {
        let to = (edge + 1) % self.marks.len();
        let from = self.marks[edge];
        let many = (self.marks[to] + ring.len() - from) % ring.len();
        let chord = self.curve.knots[to] - self.curve.knots[edge];
        let aim = self.curve.knots[edge] + chord * share;
        let off = |s: &usize| (ring[(from + s) % ring.len()] - aim).dot(chord).abs();
        let best = (1..many.max(2)).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(1);
        (from + best) % ring.len()
    }
}

/// The points of a ring that are nearest to knots, in their order; none where they are too close for that.
pub(crate) fn marks_of(knots: &[DVec2], ring: &[DVec2]) -> Option<Vec<usize>> {
    let nearest = Nearest::new(ring, true);
    let mut marks: Vec<usize> = knots
        .iter()
        .map(|&p| {
            let near = nearest.to(p);
            (near.side + usize::from(near.share > 0.5)) % ring.len()
        })
        .collect();
    // The first is where the numbers begin anew at most once.
    let first = marks[0];
    for i in 1..marks.len() {
        let ahead = (marks[i] + ring.len() - first) % ring.len();
        let before = (marks[i - 1] + ring.len() - first) % ring.len();
        let place = if ahead <= before { before + 1 } else { ahead };
        if place + (marks.len() - 1 - i) >= ring.len() {
            return None;
        }
        marks[i] = (first + place) % ring.len();
    }
    Some(marks)
}

/// So many places of a ring of `count`, or fewer, by chance, in order.
pub(crate) fn scattered(count: usize, many: usize, seed: u32) -> Vec<usize> {
    let random = |k: usize| f64::from(hash::unit(hash::counter(seed, 5000 + k as u32)));
    let mut places: Vec<usize> = (0..many).map(|k| (random(k) * count as f64) as usize % count).collect();
    places.sort_unstable();
    places.dedup();
    places
}
