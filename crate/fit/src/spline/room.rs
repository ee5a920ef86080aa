//! Whether a piece of a curve has room: it meets the rest nowhere.

use glam::DVec2;

use super::window::corners;
use super::{Node, joint};
use crate::outline::turn;

/// How often the pieces of some nodes, all but the first and the last, meet each other and the pieces of the rest. The
/// rest begins with the last two of these nodes, and ends with the first two.
pub fn meetings<'a>(nodes: &[Node], rest: impl Iterator<Item = &'a Node>) -> usize {
    let mut line = Vec::new();
    for w in nodes.windows(3) {
        corners([&w[0], &w[1], &w[2]], &mut line);
    }
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for p in &line {
        (low, high) = (low.min(*p), high.max(*p));
    }
    let mut near = Vec::new();
    let mut piece = Vec::new();
    let mut last: [Option<&Node>; 2] = [None; 2];
    for after in rest {
        if let [Some(before), Some(node)] = last {
            let (from, to) = (joint(before, node), joint(node, after));
            let apart = from.min(node.at).min(to).cmpgt(high) | from.max(node.at).max(to).cmplt(low);
            if !apart.any() {
                piece.clear();
                corners([before, node, after], &mut piece);
                near.extend(piece.windows(2).map(|w| [w[0], w[1]]));
            }
        }
        last = [last[1], Some(after)];
    }
    met(&line, &near)
}

/// How many pairs of sides of `line`, an open polyline, meet each other or those of `rest`, where they do not follow
/// on each other. `line` ends where `rest` begins and begins where it ends.
fn met(line: &[DVec2], rest: &[[DVec2; 2]]) -> usize {
    let mut many = 0;
    for (i, side) in line.windows(2).enumerate() {
        let later = line.windows(2).skip(i + 1);
        many += later
            .enumerate()
            .filter(|(k, other)| if *k == 0 { folds(side, other) } else { meet(side, other) })
            .count();
    }
    let last = rest.len().saturating_sub(1);
    for (j, other) in rest.iter().enumerate() {
        for (i, side) in line.windows(2).enumerate() {
            let fault = match (i + 2 == line.len() && j == 0, i == 0 && j == last) {
                (true, _) => folds(side, other),
                (_, true) => folds(other, side),
                _ => meet(side, other),
            };
            many += usize::from(fault);
        }
    }
    many
}

/// Whether the second side goes back along the first; sides of no length do.
fn folds(a: &[DVec2], b: &[DVec2]) -> bool {
    let (u, v) = (a[1] - a[0], b[1] - b[0]);
    turn(a[0], a[1], b[1]) == 0 && u.dot(v) <= 0.0
}

/// Whether two sides have a point in common.
fn meet(a: &[DVec2], b: &[DVec2]) -> bool {
    let apart = a[0].max(a[1]).cmplt(b[0].min(b[1])).any() || b[0].max(b[1]).cmplt(a[0].min(a[1])).any();
    !apart
        && turn(a[0], a[1], b[0]) * turn(a[0], a[1], b[1]) <= 0
        && turn(b[0], b[1], a[0]) * turn(b[0], b[1], a[1]) <= 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn many(line: &[[f64; 2]], rest: &[[f64; 2]]) -> usize {
        let points = |list: &[[f64; 2]]| list.iter().copied().map(DVec2::from).collect::<Vec<_>>();
        let rest: Vec<_> = points(rest).windows(2).map(|w| [w[0], w[1]]).collect();
        met(&points(line), &rest)
    }

    #[test]
    fn what_meets_is_counted_and_what_follows_on_is_not() {
        let rest = [[4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [0.0, 0.0]];
        assert_eq!(many(&[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0]], &rest), 0);
        // Through the far side and back, and up to it.
        assert_eq!(many(&[[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]], &rest), 2);
        assert_eq!(many(&[[0.0, 0.0], [1.0, 3.0], [2.0, 1.0], [4.0, 0.0]], &rest), 2);
        // Through itself.
        assert_eq!(many(&[[0.0, 0.0], [3.0, 2.0], [3.0, 1.0], [1.0, 2.0], [4.0, 0.0]], &rest), 2);
        // Back along the side before, at its beginning, inside and at its end: what goes on from there leaves it again.
        assert_eq!(many(&[[0.0, 0.0], [0.0, 1.0], [4.0, 0.0]], &rest), 2);
        assert_eq!(many(&[[0.0, 0.0], [2.0, 1.0], [2.0, 2.0], [2.0, 1.5], [4.0, 0.0]], &rest), 2);
        assert_eq!(many(&[[0.0, 0.0], [4.0, 1.0], [4.0, 0.0]], &rest), 2);
    }

    #[test]
    fn a_corner_beside_a_parabola_and_a_joint_of_two_meet_nothing() {
        let node = |x: f64, y: f64, on: bool| Node { at: DVec2::new(x, y), on };
        let ring = |lid: Node| {
            let sides = [node(0.0, 0.0, true), node(9.0, 0.0, true), node(12.0, 6.0, false)];
            let top = [node(8.0, 12.0, false), lid, node(0.0, 9.0, true)];
            [sides, top].concat()
        };
        let of = |nodes: &[Node]| {
            let at = |i: usize| &nodes[i % nodes.len()];
            meetings(&[5, 6, 7, 8].map(|i| *at(i)), (7..=12).map(at))
        };
        assert_eq!(of(&ring(node(4.0, 7.0, true))), 0);
        // Down through the bottom, as a corner and as a parabola that reaches so far.
        assert!(of(&ring(node(5.0, -3.0, true))) > 1);
        assert!(of(&ring(node(4.0, -30.0, false))) > 1);
    }
}
