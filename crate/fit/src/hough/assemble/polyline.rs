//! Polylines with corners at feature points: what a function of copies has to beat.

use frond_core::shared::sort_indices;

use super::super::features::Features;

/// How far the points between two feature points are from the chord of these, for any two.
pub(super) struct Chords {
    count: usize,
    farthest: Vec<f64>,
}

impl Chords {
    pub fn of(fine: &Features) -> Self {
        let points = fine.points();
        let count = points.len();
        let mut farthest = vec![0.0; count * count];
        for from in 0..count {
            for to in from + 2..count {
                let (a, b) = (points[from], points[to]);
                let slope = (b.y - a.y) / (b.x - a.x);
                let off = |p: &glam::DVec2| (p.y - (a.y + slope * (p.x - a.x))).abs();
                farthest[from * count + to] = points[from + 1..to].iter().map(off).fold(0.0, f64::max);
            }
        }
        Self { count, farthest }
    }

    pub fn farthest(&self, from: usize, to: usize) -> f64 {
        self.farthest[from * self.count + to]
    }

    /// Whether a function may have one piece there: even a straight piece copies something longer.
    pub fn is_part(&self, from: usize, to: usize) -> bool {
        from > 0 || to + 1 < self.count
    }

    /// The corners of a polyline with the fewest pieces of those that are nowhere farther off.
    pub fn fewest(&self, tolerance: f64) -> Vec<usize> {
        let mut best = vec![(0_usize, 0_usize)];
        for to in 1..self.count {
            let ways = (0..to).filter(|&from| self.is_part(from, to) && self.farthest(from, to) <= tolerance);
            // From the point before it is always near enough.
            best.push(
                ways.map(|from| (best[from].0 + 1, from)).min().unwrap_or((best[to - 1].0 + 1, to - 1)),
            );
        }
        let mut corners = vec![self.count - 1];
        let mut at = self.count - 1;
        while at > 0 {
            at = best[at].1;
            corners.push(at);
        }
        corners.reverse();
        corners
    }

    /// The corners of the polyline that is least far off, of those with at most so many pieces; two are the least.
    pub fn nearest(&self, pieces: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.farthest.len()).collect();
        sort_indices(&mut order, &|i, j| self.farthest[i].total_cmp(&self.farthest[j]));
        let mut sizes: Vec<f64> = order.into_iter().map(|i| self.farthest[i]).collect();
        sizes.dedup();
        let enough = |&size: &f64| self.fewest(size).len() > pieces.max(2) + 1;
        let at = sizes.partition_point(enough).min(sizes.len() - 1);
        self.fewest(sizes[at])
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    fn chords(heights: &[f64]) -> Chords {
        let points: Vec<_> = heights.iter().enumerate().map(|(i, &x)| DVec2::new(i as f64, x)).collect();
        Chords::of(&Features::new(&points).unwrap())
    }

    /// How far the polyline of corners is off.
    fn off(chords: &Chords, corners: &[usize]) -> f64 {
        corners.windows(2).map(|pair| chords.farthest(pair[0], pair[1])).fold(0.0, f64::max)
    }

    #[test]
    fn a_polyline_has_no_corner_that_it_does_not_need() {
        let peak = chords(&[0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0]);
        assert_eq!(peak.fewest(0.0), [0, 2, 3, 4, 6]);
        assert_eq!(peak.fewest(9.0).len(), 3);
        assert_eq!(chords(&[1.0, 2.0, 4.0]).fewest(0.0), [0, 1, 2]);
    }

    #[test]
    fn none_of_as_many_pieces_is_nearer() {
        let heights: Vec<_> = (0..12_u32).map(|i| f64::from(i * i * 7 % 13)).collect();
        let chords = chords(&heights);
        for pieces in 2..=11 {
            let ours = chords.nearest(pieces);
            assert!(ours.len() <= pieces + 1);
            // All choices of corners between the ends.
            for chosen in 0..1_u32 << 10 {
                if chosen.count_ones() as usize + 1 > pieces || chosen == 0 {
                    continue;
                }
                let inner = (0..10).filter(|bit| chosen >> bit & 1 == 1).map(|bit| bit + 1);
                let corners: Vec<_> = std::iter::once(0).chain(inner).chain([11]).collect();
                assert!(off(&chords, &ours) <= off(&chords, &corners), "{pieces}: {ours:?} {corners:?}");
            }
        }
    }
}
