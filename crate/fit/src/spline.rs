//! Closed curves of corners and parabolas on a grid, and how they are fitted within so many bytes.

mod beginning;
mod coder;
mod contest;
mod descent;
mod fitter;
mod grids;
mod law;
mod pack;
mod path;
mod polylines;
mod room;
mod text;
mod window;

pub use fitter::{LEAST_BYTES, MOST_BYTES, SplineFit, SplineFitter, fit_within};
pub use law::StepLaw;
pub use pack::SplineError;
pub(crate) use polylines::nearest_polyline;

use glam::DVec2;

/// The most nodes of a packed curve.
pub const MAX_NODES: usize = 4095;

/// No node lies further out, in steps of the grid.
pub(crate) const FARTHEST: f64 = 1e12;

/// A point of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Where it lies, in steps of the grid: two whole numbers.
    pub at: DVec2,
    /// On the curve, a corner; else the middle control point of a parabola.
    pub on: bool,
}

/// A closed curve of nodes on a grid, which lie on the curve or pull at it, as in the outlines of TrueType.
///
/// Two control points side by side have a joint halfway between them, where the two parabolas have one tangent.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    /// The nodes, in order, three at least.
    pub nodes: Vec<Node>,
    /// The width of the grid, in plane units.
    pub grid: f64,
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
fn piece([before, node, after]: [&Node; 3], sides: usize, line: &mut Vec<DVec2>) {
    let (from, to) = (joint(before, node), joint(node, after));
    if node.on {
        if from != node.at {
            line.push(from);
        }
        line.push(node.at);
        return;
    }
    for i in 0..sides {
        let t = i as f64 / sides as f64;
        line.push(from.lerp(node.at, t).lerp(node.at.lerp(to, t), t));
    }
}

impl Spline {
    /// The curve as a closed polyline in plane units: a parabola has `sides` sides.
    #[must_use]
    pub fn polyline(&self, sides: usize) -> Vec<DVec2> {
        let count = self.nodes.len();
        let mut line = Vec::new();
        for i in 0..count {
            let (before, after) = (&self.nodes[(i + count - 1) % count], &self.nodes[(i + 1) % count]);
            // Between two corners, the side is told by them alone.
            if self.nodes[i].on {
                line.push(self.nodes[i].at);
            } else {
                piece([before, &self.nodes[i], after], sides.max(1), &mut line);
            }
        }
        line.dedup();
        while line.len() > 1 && line.first() == line.last() {
            line.pop();
        }
        line.iter_mut().for_each(|p| *p *= self.grid);
        line
    }

    /// The pieces of nodes `from` to `to`, which may pass the end, as an open polyline in plane units.
    #[must_use]
    pub fn stretch(&self, from: usize, to: usize, sides: usize) -> Vec<DVec2> {
        let node = |i: usize| &self.nodes[i % self.nodes.len()];
        let mut line = Vec::new();
        for i in from..=to {
            piece([node(i + self.nodes.len() - 1), node(i), node(i + 1)], sides.max(1), &mut line);
        }
        line.push(joint(node(to), node(to + 1)));
        line.iter_mut().for_each(|p| *p *= self.grid);
        line
    }

    /// How many nodes are corners.
    #[must_use]
    pub fn corners(&self) -> usize {
        self.nodes.iter().filter(|node| node.on).count()
    }
}
