//! Curves of corners and parabolas, as a fit within so many bytes gives them.

use frond_fit::{Spline, SplineError};
use frond_scene::Curve;
use js_sys::{Float64Array, Uint8Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::palette::read_palette;
use crate::boundary::value::{object, read, write};

/// Sides of a parabola of the polyline.
const SIDES: usize = 16;

fn of_spline(error: SplineError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn read_spline(packed: &JsValue) -> Result<Spline, JsValue> {
    if let Some(word) = packed.as_string() {
        return Spline::from_text(&word).map_err(of_spline);
    }
    match packed.dyn_ref::<Uint8Array>() {
        // No more are read than a curve takes.
        Some(bytes) if bytes.length() > 1 << 16 => Err(of_spline(SplineError::TooLarge)),
        Some(bytes) => Spline::from_bytes(&bytes.to_vec()).map_err(of_spline),
        None => Err(bad_input("The curve", "a word, or bytes in a Uint8Array, are needed")),
    }
}

#[derive(Serialize)]
struct PlainNode {
    at: [f64; 2],
    on: bool,
}

/// The curve of a word, or of bytes, of a fit within so many bytes: `{ nodes, grid, bytes, points, path }`.
///
/// Each node lies on the curve, a corner, or is the middle control point of a parabola; two of these side by side have
/// a joint halfway, where their parabolas have one tangent, as in the outlines of TrueType. All lie on whole steps of
/// the `grid`. `points` are x0, y0, x1, y1, .. of a closed polyline with 16 sides a parabola, `path` the data of an SVG
/// path, where y points down.
#[wasm_bindgen(
    js_name = unpackSpline,
    unchecked_return_type = "{ nodes: { at: [x: number, y: number]; on: boolean }[]; grid: number; bytes: number; points: Float64Array; path: string }"
)]
pub fn unpack_spline(
    #[wasm_bindgen(unchecked_param_type = "string | Uint8Array")] packed: JsValue,
) -> Result<JsValue, JsValue> {
    let spline = read_spline(&packed)?;
    let plain: Vec<_> = spline
        .nodes
        .iter()
        .map(|node| PlainNode { at: (node.at * spline.grid).to_array(), on: node.on })
        .collect();
    let line: Vec<f64> = spline.polyline(SIDES).iter().flat_map(|p| p.to_array()).collect();
    Ok(object(&[
        ("nodes", write(&plain)?),
        ("grid", spline.grid.into()),
        ("bytes", spline.to_bytes().map_err(of_spline)?.len().into()),
        ("points", Float64Array::from(&line[..]).into()),
        ("path", spline.path().into()),
    ]))
}

/// The same as a closed curve of corners alone, which morphs and bends take: parabolas become short straight sides,
/// which leave them by 1/2000 of the diagonal and 1/8 of a step of the grid at most, or by more where that would be
/// more than 4096 corners.
#[wasm_bindgen(js_name = splineCurve, unchecked_return_type = "Curve")]
pub fn spline_curve(
    #[wasm_bindgen(unchecked_param_type = "string | Uint8Array")] packed: JsValue,
) -> Result<JsValue, JsValue> {
    write(&Curve::from(&read_spline(&packed)?.polygon()))
}

#[derive(Deserialize)]
struct SvgOptions {
    #[serde(default)]
    size: Option<f64>,
    #[serde(default)]
    fill: Option<String>,
}

/// The same as an SVG file: one closed path of lines and quadratic Bézier segments, the curve exactly. `size` is the
/// longer side (16 to 100,000; default 1000), `fill` a colour "#rrggbb" or "none" for a line alone.
#[wasm_bindgen(js_name = splineSvg)]
pub fn spline_svg(
    #[wasm_bindgen(unchecked_param_type = "string | Uint8Array")] packed: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ size?: number; fill?: string } | null")]
    options: JsValue,
) -> Result<String, JsValue> {
    let spline = read_spline(&packed)?;
    let SvgOptions { size, fill } = read("The options", options)?;
    let size = size.unwrap_or(1000.0);
    if !(16.0..=100_000.0).contains(&size) {
        return Err(bad_input("size", "a number from 16 to 100000 is needed"));
    }
    let fill = fill.unwrap_or_else(|| "#000000".to_owned());
    if fill != "none" {
        read_palette(std::slice::from_ref(&fill))?;
    }
    Ok(spline.svg(size, &fill))
}
