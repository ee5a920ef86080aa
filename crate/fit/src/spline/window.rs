//! A stretch of a curve, apart from the rest: how far points are from it while one node of it moves.

use glam::DVec2;

use super::{Node, joint, piece};

/// How many points are looked at together.
const LANES: usize = 8;

type Lanes = [f32; LANES];

/// While it is fitted, a parabola has so many sides that none is farther from it than this, in steps of the grid.
const FLAT: f64 = 0.1;

/// The most sides of a parabola while it is fitted.
const MOST_SIDES: usize = 8;

/// Half the length of the second derivative of a parabola with these control points.
pub fn bend(from: DVec2, at: DVec2, to: DVec2) -> f64 {
    (from - 2.0 * at + to).length()
}

/// How many sides a parabola with these control points has while it is fitted.
pub fn sides(from: DVec2, at: DVec2, to: DVec2) -> usize {
    // Half the second derivative over four times the square of the number of sides.
    ((bend(from, at, to) / (4.0 * FLAT)).sqrt().ceil() as usize).clamp(2, MOST_SIDES)
}

/// The corners of the piece of node i, its end among them, none twice in a row.
pub fn corners([before, node, after]: [&Node; 3], line: &mut Vec<DVec2>) {
    let (from, to) = (joint(before, node), joint(node, after));
    let begin = line.len();
    piece([before, node, after], sides(from, node.at, to), line);
    line.push(to);
    // A corner beside a parabola is its own joint, and a side of no length would seem to fold.
    let mut kept = begin.saturating_sub(1);
    for i in kept + 1..line.len() {
        if line[i] != line[kept] {
            kept += 1;
            line[kept] = line[i];
        }
    }
    line.truncate(kept + 1);
}

/// A side: its beginning, its way, and one over the square of its length.
#[derive(Clone, Copy, Debug)]
struct Side {
    at: [f32; 2],
    way: [f32; 2],
    scale: f32,
}

/// Nodes, one more at each end than those whose pieces are measured, and the points beside them.
#[derive(Clone, Debug, Default)]
pub struct Window {
    pub nodes: Vec<Node>,
    origin: DVec2,
    x: Vec<Lanes>,
    y: Vec<Lanes>,
    /// How many points there are. Lanes that are left over are at no distance.
    many: usize,
    /// The squares of distances from all pieces but those that the moved node takes part in.
    rest: Vec<Lanes>,
    sides: Vec<Side>,
    line: Vec<DVec2>,
}

fn nearest(x: &Lanes, y: &Lanes, best: &mut Lanes, sides: &[Side]) {
    for side in sides {
        for i in 0..LANES {
            let (a, b) = (x[i] - side.at[0], y[i] - side.at[1]);
            let share = (a * side.way[0] + b * side.way[1]) * side.scale;
            // Written so, and not as a clamp, since this is what processors have.
            let share = if share > 0.0 { share } else { 0.0 };
            let share = if share < 1.0 { share } else { 1.0 };
            let (a, b) = (a - side.way[0] * share, b - side.way[1] * share);
            let squared = a * a + b * b;
            best[i] = if squared < best[i] { squared } else { best[i] };
        }
    }
}

impl Window {
    /// Takes up the points beside the nodes that were set before.
    pub fn load(&mut self, points: impl Iterator<Item = DVec2>) {
        // What lies near is told finely enough by short numbers.
        self.origin = self.nodes[self.nodes.len() / 2].at;
        self.x.clear();
        self.y.clear();
        self.many = 0;
        for p in points {
            let (i, lane) = (self.many / LANES, self.many % LANES);
            if lane == 0 {
                self.x.push([0.0; LANES]);
                self.y.push([0.0; LANES]);
            }
            self.x[i][lane] = (p.x - self.origin.x) as f32;
            self.y[i][lane] = (p.y - self.origin.y) as f32;
            self.many += 1;
        }
    }

    /// The sides of these pieces.
    fn lay(&mut self, pieces: impl Iterator<Item = usize>) {
        self.sides.clear();
        for i in pieces {
            self.line.clear();
            corners([&self.nodes[i - 1], &self.nodes[i], &self.nodes[i + 1]], &mut self.line);
            for w in self.line.windows(2) {
                let (at, way) = (w[0] - self.origin, w[1] - w[0]);
                let scale = 1.0 / way.length_squared().max(1e-12);
                self.sides.push(Side {
                    at: [at.x as f32, at.y as f32],
                    way: [way.x as f32, way.y as f32],
                    scale: scale as f32,
                });
            }
        }
    }

    /// Prepares for moves of nodes `first` to `last`.
    pub fn hold_rest(&mut self, first: usize, last: usize) {
        let end = self.nodes.len() - 2;
        self.lay((1..=end).filter(|i| i + 1 < first || *i > last + 1));
        self.rest.clear();
        for (i, (x, y)) in self.x.iter().zip(&self.y).enumerate() {
            let mut best = [f32::INFINITY; LANES];
            nearest(x, y, &mut best, &self.sides);
            best.iter_mut().skip(self.many - i * LANES).for_each(|squared| *squared = 0.0);
            self.rest.push(best);
        }
    }

    /// The sum of the squares of the points' distances, where it is below `most`; else at least that. Nodes `first` to
    /// `last` may have moved since the rest was prepared for them.
    pub fn squares(&mut self, first: usize, last: usize, most: f64) -> f64 {
        let end = self.nodes.len() - 2;
        self.lay(first.saturating_sub(1).max(1)..=(last + 1).min(end));
        let mut sum = 0.0;
        for (i, rest) in self.rest.iter().enumerate() {
            let mut best = *rest;
            nearest(&self.x[i], &self.y[i], &mut best, &self.sides);
            sum += f64::from(best.iter().sum::<f32>());
            if sum >= most {
                break;
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::Nearest;

    #[test]
    fn squares_are_those_of_the_stretch_wherever_its_node_is_moved() {
        let place = |i: usize| DVec2::new(12.0 * i as f64, if i.is_multiple_of(2) { 0.0 } else { 9.0 });
        let points: Vec<DVec2> = (0..45).map(|i| DVec2::new(2.0 * f64::from(i), 4.0)).collect();
        let mut window = Window {
            nodes: (0..9).map(|i| Node { at: place(i), on: i % 3 == 0 }).collect(),
            ..Window::default()
        };
        window.load(points.iter().copied());
        for k in [3, 4, 5] {
            window.hold_rest(k, k);
            for at in [place(k), place(k) + DVec2::new(5.0, 20.0), DVec2::new(900.0, -40.0)] {
                for on in [true, false] {
                    let kept = std::mem::replace(&mut window.nodes[k], Node { at, on });
                    let mut line = Vec::new();
                    for w in window.nodes.windows(3) {
                        corners([&w[0], &w[1], &w[2]], &mut line);
                    }
                    let near = Nearest::new(&line, false);
                    let all: f64 = points.iter().map(|&p| near.to(p).squared).sum();
                    let told = window.squares(k, k, f64::INFINITY);
                    assert!((told - all).abs() < 1e-4 * all, "{k} {at} {on}: {told} {all}");
                    assert!(window.squares(k, k, 0.5 * all) >= 0.5 * all);
                    window.nodes[k] = kept;
                }
            }
        }
    }
}
