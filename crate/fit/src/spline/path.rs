//! A spline as a path of SVG.

use std::fmt::Write as _;

use glam::DVec2;

use super::contest::SIDES;
use super::{Spline, joint};
use crate::outline::bounds;

/// What a picture leaves free on each side, in parts of the longer one.
const MARGIN: f64 = 0.01;

/// Parts of a step of the grid to which numbers are written: joints lie on halves.
const FINE: f64 = 20.0;

impl Spline {
    /// The curve as the data of an SVG path (`M`, `L`, `Q`, `Z`): its corners and parabolas as they are. There y points
    /// down, so the curve is turned over.
    #[must_use]
    pub fn path(&self) -> String {
        let digits = (FINE / self.grid).log10().ceil().clamp(0.0, 100.0) as usize;
        let point = |p: DVec2| {
            // Zero has no sign.
            let [x, y] = [p.x * self.grid, -p.y * self.grid].map(|number| number + 0.0);
            format!("{x:.digits$} {y:.digits$}")
        };
        let Some(last) = self.nodes.last() else { return String::new() };
        let first = &self.nodes[0];
        let mut at = if first.on { first.at } else { joint(last, first) };
        let mut path = format!("M{}", point(at));
        for (i, node) in self.nodes.iter().enumerate() {
            let to = joint(node, self.nodes.get(i + 1).unwrap_or(first));
            // Writing to a string cannot fail.
            if !node.on {
                let _ = write!(path, "Q{} {}", point(node.at), point(to));
                at = to;
            } else if node.at != at {
                let _ = write!(path, "L{}", point(node.at));
                at = node.at;
            }
        }
        path + "Z"
    }

    /// The curve as an SVG file of one path, whose longer side is `size` pixels. `fill`: a colour, or "none" for a line
    /// alone.
    #[must_use]
    pub fn svg(&self, size: f64, fill: &str) -> String {
        let (low, high) = bounds(&self.polyline(SIDES));
        let sides = (high - low).max(DVec2::splat(self.grid));
        let longest = sides.max_element();
        let margin = DVec2::splat(MARGIN * longest);
        let (corner, all) = (DVec2::new(low.x, -high.y) - margin, sides + 2.0 * margin);
        let [width, height] = (all * (size / all.max_element())).to_array().map(|side| side.max(1.0).ceil());
        let stroke = if fill == "none" {
            let wide = all.max_element() / 500.0;
            format!(" stroke=\"#000000\" stroke-width=\"{wide}\" stroke-linejoin=\"round\"")
        } else {
            String::new()
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" width=\"{width}\" \
             height=\"{height}\">\n<path fill=\"{fill}\"{stroke} d=\"{}\"/>\n</svg>\n",
            corner.x,
            corner.y,
            all.x,
            all.y,
            self.path()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::Node;

    #[test]
    fn corners_and_parabolas_are_written_as_they_are() {
        let node = |x: f64, y: f64, on: bool| Node { at: DVec2::new(x, y), on };
        let nodes =
            vec![node(0.0, 0.0, true), node(4.0, 0.0, true), node(6.0, 2.0, false), node(5.0, 4.0, false)];
        let path = |nodes: Vec<Node>| Spline { nodes, grid: 0.5 }.path();
        assert_eq!(path(nodes.clone()), "M0.00 0.00L2.00 0.00Q3.00 -1.00 2.75 -1.50Q2.50 -2.00 0.00 0.00Z");
        let mut turned = nodes.clone();
        turned.rotate_left(2);
        assert_eq!(path(turned), "M2.00 0.00Q3.00 -1.00 2.75 -1.50Q2.50 -2.00 0.00 0.00L2.00 0.00Z");
        let picture = Spline { nodes: nodes.clone(), grid: 0.5 }.svg(300.0, "none");
        assert!(picture.contains("width=\"300\"") && picture.contains("Q3.00 -1.00 2.75 -1.50"), "{picture}");
        assert!(picture.contains("viewBox=\"-0.0") && picture.contains("stroke-width"), "{picture}");
        let corners: Vec<Node> = nodes.into_iter().map(|node| Node { on: true, ..node }).collect();
        assert_eq!(path(corners), "M0.00 0.00L2.00 0.00L3.00 -1.00L2.50 -2.00Z");
    }
}
