//! A spline as a word of a link, and as corners alone.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use glam::DVec2;

use super::window::bend;
use super::{MOST_BYTES, Spline, SplineError, joint, piece};
use crate::MAX_KNOTS;
use crate::closed::ClosedCurve;

/// The longest word that is read, in characters: four for three bytes.
const MOST_LETTERS: usize = (4 * MOST_BYTES).div_ceil(3);

/// How far the sides of a polygon may be from its parabolas at first: in parts of the diagonal of its nodes, and in
/// steps of the grid, to which a fit is true.
const FINE: f64 = 1.0 / 2000.0;
const FINE_STEPS: f64 = 0.125;

/// The most sides of one parabola.
const MOST_SIDES: f64 = 64.0;

impl Spline {
    /// The curve in letters, digits, `-` and `_`: four for three bytes.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes), and where there are more than [`MOST_BYTES`].
    pub fn to_text(&self) -> Result<String, SplineError> {
        let bytes = self.to_bytes()?;
        if bytes.len() > MOST_BYTES { Err(SplineError::TooLarge) } else { Ok(URL_SAFE_NO_PAD.encode(bytes)) }
    }

    /// The curve of a word that [`to_text`](Self::to_text) wrote.
    ///
    /// # Errors
    /// Where it is none.
    pub fn from_text(text: &str) -> Result<Self, SplineError> {
        if text.len() > MOST_LETTERS {
            return Err(SplineError::TooLarge);
        }
        let bytes = URL_SAFE_NO_PAD.decode(text).map_err(|_| SplineError::Unsound)?;
        Self::from_bytes(&bytes)
    }

    /// The curve as one of corners alone, as morphs and bends take it: each parabola has so many sides that they leave
    /// it by no more than 1/2000 of the diagonal and 1/8 of a step of the grid, or by twice that and so on where there
    /// would be more than [`MAX_KNOTS`] corners. So no copies are in it.
    #[must_use]
    pub fn polygon(&self) -> ClosedCurve {
        let (low, high) = crate::outline::bounds(&self.nodes.iter().map(|node| node.at).collect::<Vec<_>>());
        let mut off = (FINE * low.distance(high)).clamp(1e-3, FINE_STEPS);
        loop {
            let mut knots = self.sides_within(off);
            if knots.len() <= MAX_KNOTS {
                knots.iter_mut().for_each(|p| *p *= self.grid);
                return ClosedCurve::polygon(knots);
            }
            off *= 2.0;
        }
    }

    /// Corners of a polygon that leaves the curve by no more than `off`, all in steps of the grid.
    fn sides_within(&self, off: f64) -> Vec<DVec2> {
        let count = self.nodes.len();
        let mut line = Vec::new();
        for (i, node) in self.nodes.iter().enumerate() {
            let (before, after) = (&self.nodes[(i + count - 1) % count], &self.nodes[(i + 1) % count]);
            if node.on {
                line.push(node.at);
                continue;
            }
            // Half the second derivative over four times the square of the number of sides.
            let bend = bend(joint(before, node), node.at, joint(node, after));
            let sides = (bend / (4.0 * off)).sqrt().ceil().clamp(1.0, MOST_SIDES);
            piece([before, node, after], sides as usize, &mut line);
        }
        line.dedup();
        while line.len() > 1 && line.first() == line.last() {
            line.pop();
        }
        line
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::{MAX_NODES, Node};

    fn wave(count: usize) -> Spline {
        let node = |i: usize| {
            let angle = std::f64::consts::TAU * i as f64 / count as f64;
            let at = DVec2::from_angle(angle) * (2000.0 + 300.0 * (7.0 * angle).sin());
            Node { at: at.round(), on: i.is_multiple_of(5) }
        };
        Spline { nodes: (0..count).map(node).collect(), grid: 0.25 }
    }

    #[test]
    fn a_word_brings_the_curve_back_and_others_are_refused() {
        let curve = wave(60);
        let word = curve.to_text().unwrap();
        assert!(word.len() * 3 / 4 == curve.to_bytes().unwrap().len(), "{word}");
        assert_eq!(Spline::from_text(&word), Ok(curve));
        for wrong in ["", "A", "not a word", "AQ", &word[..8], &"A".repeat(MOST_LETTERS + 1)] {
            assert!(Spline::from_text(wrong).is_err(), "{wrong}");
        }
        let mut large = wave(MAX_NODES);
        large.nodes.iter_mut().for_each(|node| node.at *= 1000.0);
        assert_eq!(large.to_text(), Err(SplineError::TooLarge));
    }

    #[test]
    fn a_word_of_the_former_version_is_read_and_written_in_this_one() {
        let word = "ArD2Sst0yl5_ukz6f1W7bH7QZZArw72oRfqqS7rYKZ7lvzYslYyPymBzZ2GeQou2DRUP5EGfUCWQ0cpg";
        let curve = Spline::from_text(word).unwrap();
        let node = |x: f64, y: f64, on: bool| Node { at: DVec2::new(x, y), on };
        assert_eq!((curve.nodes.len(), curve.grid), (27, 0.617_187_5));
        assert_eq!([curve.nodes[0], curve.nodes[7]], [node(227.0, -93.0, false), node(62.0, 149.0, true)]);
        assert_eq!(curve.nodes[26], node(163.0, -183.0, false));
        let again = curve.to_text().unwrap();
        assert!(again != word && Spline::from_text(&again) == Ok(curve), "{again}");
    }

    #[test]
    fn a_polygon_stays_near_its_parabolas_and_has_no_more_corners_than_a_curve_may() {
        let curve = wave(60);
        let polygon = curve.polygon();
        let near = crate::outline::Nearest::new(&polygon.knots, true);
        let off = curve.polyline(64).iter().map(|&p| near.to(p).squared.sqrt()).fold(0.0, f64::max);
        assert!(off < 0.13 * 0.25, "{off}");
        assert!(polygon.is_sound() && polygon.copies() == 0);
        assert!(polygon.knots.len() > 60 && polygon.knots.len() < 900, "{}", polygon.knots.len());
        // A far point makes the others' parabolas small; so does one that is far out alone.
        let mut zigzag = wave(MAX_NODES);
        for (i, node) in zigzag.nodes.iter_mut().enumerate() {
            *node = Node { at: node.at + if i.is_multiple_of(2) { node.at } else { DVec2::ZERO }, on: false };
        }
        let polygon = zigzag.polygon();
        assert!(polygon.is_sound() && polygon.knots.len() <= MAX_KNOTS, "{}", polygon.knots.len());
    }
}
