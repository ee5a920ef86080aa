//! Closed curves as files for other programs.

use std::fmt::Write as _;

use frond_fit::MorphedCurve;
use glam::DVec2;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::read::{read_curve, woven};
use crate::boundary::error::bad_input;
use crate::boundary::look::read_palette;
use crate::boundary::value::read;

/// The most corners of a file, and the most points.
const MOST_CORNERS: usize = 1 << 18;

/// Points of a table where nothing is said.
const USUAL_POINTS: f64 = 2048.0;

#[derive(Deserialize)]
struct SvgOptions {
    #[serde(default)]
    size: Option<f64>,
    #[serde(default)]
    tolerance: Option<f64>,
    #[serde(default)]
    fill: Option<String>,
}

/// A curve as an SVG file: one closed path. `size` is the longer side (16 to 100,000; default 1000), `tolerance` how far
/// the path may leave the curve, in the same unit (default 0.2), `fill` a colour "#rrggbb" or "none" for a line alone.
#[wasm_bindgen(js_name = curveSvg)]
pub fn curve_svg(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
    #[wasm_bindgen(
        unchecked_param_type = "{ size?: number; tolerance?: number; fill?: string } | null | undefined"
    )]
    options: JsValue,
) -> Result<String, JsValue> {
    let curve = read_curve(&curve)?;
    let SvgOptions { size, tolerance, fill } = read("The options", options)?;
    let size = size.unwrap_or(1000.0);
    if !(16.0..=100_000.0).contains(&size) {
        return Err(bad_input("size", "a number from 16 to 100000 is needed"));
    }
    let tolerance = tolerance.unwrap_or(0.2);
    if !(1e-4..=size).contains(&tolerance) {
        return Err(bad_input("tolerance", "a number from 0.0001 to the size is needed"));
    }
    let fill = fill.unwrap_or_else(|| "#000000".to_owned());
    if fill != "none" {
        read_palette(std::slice::from_ref(&fill))?;
    }
    Ok(svg(&woven(&curve)?, size, tolerance, &fill))
}

fn svg(woven: &MorphedCurve, size: f64, tolerance: f64, fill: &str) -> String {
    let [left, bottom, right, top] = woven.bounds();
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
    for (_, p) in woven.trace(0.8 * tolerance / scale, None, MOST_CORNERS) {
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

#[derive(Deserialize)]
struct CsvOptions {
    #[serde(default)]
    points: Option<f64>,
}

/// A curve as a table x,y with a line of names, at equal steps of its parameter: 3 to 262,144 points, 2048 where nothing
/// is said. The first point is not repeated.
#[wasm_bindgen(js_name = curveCsv)]
pub fn curve_csv(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ points?: number } | null | undefined")] options: JsValue,
) -> Result<String, JsValue> {
    let curve = read_curve(&curve)?;
    let CsvOptions { points } = read("The options", options)?;
    let points = points.unwrap_or(USUAL_POINTS);
    if !(3.0..=MOST_CORNERS as f64).contains(&points) {
        return Err(bad_input("points", "a number from 3 to 262144 is needed"));
    }
    let woven = woven(&curve)?;
    let mut table = "x,y\n".to_owned();
    for p in woven.grid(points as usize) {
        // Writing to a string cannot fail.
        let _ = writeln!(table, "{},{}", p.x, p.y);
    }
    Ok(table)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may fail so")]
mod tests {
    use frond_fit::{ClosedCurve, CurveMorph};

    use super::*;

    #[test]
    fn a_square_is_four_steps() {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| 10.0 * p - 3.0).to_vec();
        let woven = CurveMorph::new(&ClosedCurve::polygon(corners), None).unwrap().at(0.0);
        let file = svg(&woven, 100.0, 0.5, "#aabbcc");
        assert!(file.contains("viewBox=\"0 0 100 100\""), "{file}");
        assert!(file.contains("fill=\"#aabbcc\" d=\"M1 99l98 0l0-98l-98 0z\""), "{file}");
        let line = svg(&woven, 100.0, 0.01, "none");
        assert!(line.contains("stroke-width=\"0.2\""), "{line}");
    }

    #[test]
    fn a_point_is_a_picture_too() {
        let woven = CurveMorph::new(&ClosedCurve::polygon(vec![DVec2::ONE; 5]), None).unwrap().at(0.5);
        let file = svg(&woven, 100.0, 0.5, "none");
        assert!(file.contains("viewBox=\"0 0 2 2\"") && file.contains("d=\"M1 1z\""), "{file}");
    }
}
