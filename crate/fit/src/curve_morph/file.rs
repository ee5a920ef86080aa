//! Curves as files for other programs.

use std::fmt::Write as _;

use glam::DVec2;

use super::morphed_curve::MorphedCurve;

/// The most corners of a file, and the most points.
pub const MAX_FILE_POINTS: usize = 1 << 18;

impl MorphedCurve {
    /// An SVG file: one closed path. `size` is its longer side, `tolerance` how far the path may leave the curve, in
    /// the same unit, `fill` a colour, or "none" for a line alone.
    #[must_use]
    pub fn svg(&self, size: f64, tolerance: f64, fill: &str) -> String {
        let [left, bottom, right, top] = self.bounds();
        let sides = DVec2::new(right - left, top - bottom);
        let longest = sides.max_element();
        // Knots that are all one make a picture of a point.
        let scale = if longest > 0.0 { 0.98 * size / longest } else { 1.0 };
        let margin = 0.01 * size;
        let [width, height] = (sides * scale + 2.0 * margin).to_array().map(|side| side.max(1.0).ceil());
        // Coordinates are whole steps, so that what is relative adds up to what is absolute.
        let decimals = (1.0 - tolerance.log10()).ceil().clamp(0.0, 6.0) as usize;
        let steps = 10_f64.powi(decimals as i32);
        let place = |p: DVec2| {
            let at = DVec2::new(p.x - left, top - p.y) * scale + margin;
            (at * steps).to_array().map(|x| x.round() as i64)
        };
        let mut path = String::new();
        let mut last: Option<[i64; 2]> = None;
        for (_, p) in self.trace(0.8 * tolerance / scale, None, MAX_FILE_POINTS) {
            let next = place(p);
            let (letter, by) = match last {
                None => ('M', next),
                Some(last) => ('l', [next[0] - last[0], next[1] - last[1]]),
            };
            if last != Some(next) {
                let [x, y] = by.map(|x| x as f64 / steps);
                let gap = if y < 0.0 { "" } else { " " };
                // Writing to a string cannot fail.
                let _ = write!(path, "{letter}{x}{gap}{y}");
            }
            last = Some(next);
        }
        let stroke = if fill == "none" {
            format!(" stroke=\"#000000\" stroke-width=\"{}\" stroke-linejoin=\"round\"", size / 500.0)
        } else {
            String::new()
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n<path fill=\"{fill}\"{stroke} d=\"{path}z\"/>\n</svg>\n"
        )
    }

    /// A table x,y with a line of names, at equal steps of the parameter. The first point is not repeated.
    #[must_use]
    pub fn csv(&self, points: usize) -> String {
        let mut table = "x,y\n".to_owned();
        for p in self.grid(points) {
            // Writing to a string cannot fail.
            let _ = writeln!(table, "{},{}", p.x, p.y);
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClosedCurve, CurveMorph};

    #[test]
    fn a_square_is_four_steps() {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| 10.0 * p - 3.0).to_vec();
        let morphed = CurveMorph::new(&ClosedCurve::polygon(corners), None).unwrap().at(0.0);
        let file = morphed.svg(100.0, 0.5, "#aabbcc");
        assert!(file.contains("viewBox=\"0 0 100 100\""), "{file}");
        assert!(file.contains("fill=\"#aabbcc\" d=\"M1 99l98 0l0-98l-98 0z\""), "{file}");
        let line = morphed.svg(100.0, 0.01, "none");
        assert!(line.contains("stroke-width=\"0.2\""), "{line}");
    }

    #[test]
    fn a_point_is_a_picture_too() {
        let morphed = CurveMorph::new(&ClosedCurve::polygon(vec![DVec2::ONE; 5]), None).unwrap().at(0.5);
        let file = morphed.svg(100.0, 0.5, "none");
        assert!(file.contains("viewBox=\"0 0 2 2\"") && file.contains("d=\"M1 1z\""), "{file}");
    }
}
