//! Closed curves of points on a grid, which lie on the curve or pull at it, as in the outlines of TrueType.

use glam::DVec2;

/// Sides of a quadratic piece.
const SIDES: usize = 6;

/// A point of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub at: DVec2,
    /// On the curve, a corner; else the middle control point of a parabola.
    pub on: bool,
    /// The index of the outline's point beside it.
    pub mark: usize,
}

/// Where the piece of one node ends and that of the next begins.
fn joint(a: &Node, b: &Node) -> DVec2 {
    match (a.on, b.on) {
        (true, false) => a.at,
        (false, true) => b.at,
        _ => a.at.midpoint(b.at),
    }
}

/// Adds the corners of the piece of a node, without its end.
fn piece(before: &Node, node: &Node, after: &Node, sides: usize, line: &mut Vec<DVec2>) {
    let (from, to) = (joint(before, node), joint(node, after));
    if node.on {
        line.push(from);
        line.push(node.at);
    } else {
        for i in 0..sides {
            let t = i as f64 / sides as f64;
            line.push(from.lerp(node.at, t).lerp(node.at.lerp(to, t), t));
        }
    }
}

/// The pieces of nodes `from` to `to`, which may pass the end, as an open polyline.
pub fn pieces(nodes: &[Node], from: usize, to: usize, line: &mut Vec<DVec2>) {
    let count = nodes.len();
    line.clear();
    for i in from..=to {
        piece(&nodes[(i + count - 1) % count], &nodes[i % count], &nodes[(i + 1) % count], SIDES, line);
    }
    line.push(joint(&nodes[to % count], &nodes[(to + 1) % count]));
}

/// All of it as a closed polyline for measuring.
pub fn closed(nodes: &[Node]) -> Vec<DVec2> {
    let mut line = Vec::new();
    let count = nodes.len();
    for i in 0..count {
        piece(&nodes[(i + count - 1) % count], &nodes[i], &nodes[(i + 1) % count], 16, &mut line);
    }
    line.dedup();
    line
}

/// The middle of a node's piece.
pub fn middle(nodes: &[Node], i: usize) -> DVec2 {
    let count = nodes.len();
    let (before, node, after) = (&nodes[(i + count - 1) % count], &nodes[i], &nodes[(i + 1) % count]);
    if node.on {
        return node.at;
    }
    let (from, to) = (joint(before, node), joint(node, after));
    from.midpoint(node.at).midpoint(node.at.midpoint(to))
}
