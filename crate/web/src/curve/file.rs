//! Closed curves as files for other programs.

use frond_fit::MAX_FILE_POINTS;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::read::{morphed, read_curve};
use crate::boundary::error::bad_input;
use crate::boundary::palette::read_palette;
use crate::boundary::value::read;

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

/// A curve as an SVG file: one closed path. `size` is the longer side (16 to 100,000; default 1000), `tolerance` how
/// far the path may leave the curve, in the same unit (default 0.2), `fill` a colour "#rrggbb" or "none" for a line
/// alone.
#[wasm_bindgen(js_name = curveSvg)]
pub fn curve_svg(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
    #[wasm_bindgen(
        unchecked_optional_param_type = "{ size?: number; tolerance?: number; fill?: string } | null"
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
    Ok(morphed(&curve)?.svg(size, tolerance, &fill))
}

#[derive(Deserialize)]
struct CsvOptions {
    #[serde(default)]
    points: Option<f64>,
}

/// A curve as a table x,y with a line of names, at equal steps of its parameter: 3 to 262,144 points, 2048 where
/// nothing is said. The first point is not repeated.
#[wasm_bindgen(js_name = curveCsv)]
pub fn curve_csv(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ points?: number } | null")] options: JsValue,
) -> Result<String, JsValue> {
    let curve = read_curve(&curve)?;
    let CsvOptions { points } = read("The options", options)?;
    let points = points.unwrap_or(USUAL_POINTS);
    if !(3.0..=MAX_FILE_POINTS as f64).contains(&points) {
        return Err(bad_input("points", "a number from 3 to 262144 is needed"));
    }
    Ok(morphed(&curve)?.csv(points as usize))
}
