//! What a descent begins with: nodes, each with the point beside it.

use glam::DVec2;

use super::contest::Contest;
use super::descent::FEWEST;
use super::{MAX_NODES, Node, Spline};
use crate::outline::{Outline, decimated};

/// About how many bits a node takes.
const NODE_BITS: f64 = 9.0;

/// The most pairs of a node and a point that are looked at.
const MOST_PAIRS: usize = 1 << 22;

/// Kicks, in turn: by how much the grid is wider than that of the best, and how dear a bit is at first. Some
/// drop nodes and some add them, before all is as it was.
const KICKS: [(f64, f64); 5] = [(0.96, 0.75), (1.1, 1.3), (0.9, 0.75), (1.0, 1.3), (1.04, 0.75)];

/// What a descent begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// Corners of the outline, as corners, and no parabolas.
    Plain,
    /// Corners of the outline, as corners.
    Corners,
    /// Corners of the outline, as control points.
    Bends,
    /// The best curve so far.
    Best,
    /// The same after a kick, the first, the second or so, that may take it out of where no single change helps.
    Kick(usize),
}

/// Nodes in plane units, the indices of the points beside them, the grid to begin with, and how dear a bit is in the
/// first sweep.
#[derive(Clone, Debug)]
pub struct Start {
    pub nodes: Vec<Node>,
    pub marks: Vec<usize>,
    pub grid: f64,
    pub greed: f64,
    /// Whether there may be more parabolas.
    pub bends: bool,
}

impl Beginning {
    /// Where so many bits are for nodes; what there is to follow are points of the outline.
    pub fn start(self, followed: &Outline, contest: &Contest) -> Start {
        let (wider, greed) = match self {
            Self::Kick(kick) => KICKS[kick % KICKS.len()],
            _ => (1.0, 1.0),
        };
        if matches!(self, Self::Best | Self::Kick(_))
            && let Some((spline, _)) = contest.best()
            && let Some(marks) = spline.beside(followed.points()).filter(|marks| marks.len() >= FEWEST)
        {
            let place = |node: &Node| Node { at: node.at * spline.grid, ..*node };
            let nodes = spline.nodes.iter().map(place).collect();
            // Where corners alone are best so far, every second kick stays with them.
            let plain = matches!(self, Self::Kick(kick) if kick % 2 == 0) && spline.corners() == marks.len();
            return Start { nodes, marks, grid: wider * spline.grid, greed, bends: !plain };
        }
        let free = contest.free_bits().max(64.0);
        let most = (MAX_NODES / 2).min(followed.points().len() / 2);
        let marks = decimated(followed, ((free / NODE_BITS) as usize).max(FEWEST + 2).min(most));
        let place = |&mark: &usize| Node { at: followed.points()[mark], on: self != Self::Bends };
        let nodes = marks.iter().map(place).collect();
        let grid = 5.6 * contest.outline().diagonal() / free;
        Start { nodes, marks, grid, greed, bends: self != Self::Plain }
    }
}

impl Spline {
    /// The index of one of these points beside each node, in order all round, such that the sum of squares of their
    /// distances is least when the first has its nearest; none where there are fewer points than nodes, or too many.
    #[must_use]
    pub fn beside(&self, points: &[DVec2]) -> Option<Vec<usize>> {
        let (count, many) = (points.len(), self.nodes.len());
        if many > count || count * many > MOST_PAIRS {
            return None;
        }
        let off = |i: usize, k: usize| points[k % count].distance_squared(self.nodes[i].at * self.grid);
        let first = (0..count).min_by(|&a, &b| off(0, a).total_cmp(&off(0, b)))?;
        // The least sums up to node i with its point k places behind the first, and where node i - 1 has its own then.
        let mut sums = vec![f64::INFINITY; count];
        sums[0] = 0.0;
        let mut ways = vec![0_u32; count * many];
        for i in 1..many {
            let mut next = vec![f64::INFINITY; count];
            let mut best = (f64::INFINITY, 0);
            for k in 1..count {
                if sums[k - 1] < best.0 {
                    best = (sums[k - 1], k as u32 - 1);
                }
                next[k] = best.0 + off(i, first + k);
                ways[i * count + k] = best.1;
            }
            sums = next;
        }
        let mut k = (0..count).min_by(|&a, &b| sums[a].total_cmp(&sums[b]))?;
        let mut marks = vec![0; many];
        for i in (0..many).rev() {
            marks[i] = (first + k) % count;
            k = ways[i * count + k] as usize;
        }
        Some(marks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_have_points_beside_them_in_order_even_where_others_are_nearer() {
        // There and back, so near that the nearest point may be one of the other way.
        let there = (0..60).map(|i| DVec2::new(f64::from(i), 0.0));
        let back = (0..60).map(|i| DVec2::new(f64::from(59 - i), 1.0));
        let points: Vec<DVec2> = there.chain(back).collect();
        let want = [50, 58, 62, 70, 80, 90, 100, 110, 117, 5, 15, 25, 35];
        let off = |mark: usize| if mark.is_multiple_of(2) { 0.7 } else { 0.0 };
        let nodes: Vec<Node> = want
            .iter()
            .map(|&mark| {
                let p = points[mark];
                Node { at: DVec2::new(p.x, if p.y > 0.5 { 1.0 - off(mark) } else { off(mark) }), on: true }
            })
            .collect();
        let of = |nodes: &[Node]| Spline { nodes: nodes.to_vec(), grid: 1.0 }.beside(&points);
        let marks = of(&nodes[2..]).unwrap();
        assert!(marks.iter().zip(&want[2..]).skip(1).all(|(a, b)| a == b), "{marks:?}");
        assert_eq!(of(&nodes.repeat(10)), None, "more nodes than points");
    }
}
