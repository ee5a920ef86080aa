//! Fractal curves of the plane from JavaScript: x and y over one t, made of smaller copies of their own parts.

use frond_fit::{FractalCurve, FunctionError, Piece};
use glam::{DMat2, DVec2};
use js_sys::{Array, Float64Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use super::graph::{
    MAX_PIECES, MAX_SAMPLES, USUAL_SAMPLES, check_length, of_function, too_many, whole_spans,
};
use crate::boundary::error::bad_input;
use crate::boundary::value::{read, write};

#[derive(Deserialize, Serialize)]
struct PlainPiece {
    map: [f64; 10],
    domain: [f64; 2],
}

/// `PlaneGraph` of `api.d.ts`.
#[derive(Deserialize, Serialize)]
struct PlainCurve {
    pieces: Vec<PlainPiece>,
    /// Told, and not read.
    #[serde(default, skip_deserializing)]
    contractivity: f64,
}

#[derive(Deserialize)]
struct Options {
    factors: Vec<[f64; 4]>,
    #[serde(default)]
    reflected: Vec<bool>,
    #[serde(default)]
    spans: Option<Vec<[f64; 2]>>,
}

/// The fractal curve through points [t, x, y] with a factor `[cx, cxy, cyx, cy]` a piece (Cochran, Hart & Flynn,
/// section 2.4): each piece a copy of all of it, or with `spans` of what lies between two of the points, turned around
/// where `reflected`. With cxy and cyx 0 it is separable
/// (eq 8); else x and y answer to each other (eq 9). Each factor must shorten every direction of the plane.
#[wasm_bindgen(js_name = interpolationCurve, unchecked_return_type = "PlaneGraph")]
pub fn interpolation_curve(
    #[wasm_bindgen(unchecked_param_type = "[t: number, x: number, y: number][]")] points: JsValue,
    #[wasm_bindgen(
        unchecked_param_type = "{ factors: [cx: number, cxy: number, cyx: number, cy: number][]; reflected?: boolean[]; spans?: [j: number, k: number][] }"
    )]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    if let Some(list) = points.dyn_ref::<Array>()
        && list.length() as usize > MAX_PIECES + 1
    {
        return Err(too_many(list.length()));
    }
    for key in ["factors", "reflected", "spans"] {
        check_length(&options, key)?;
    }
    let points: Vec<[f64; 3]> = read("The list of points", points)?;
    let Options { factors, mut reflected, spans } = read("The options", options)?;
    if reflected.is_empty() {
        reflected = vec![false; points.len().saturating_sub(1)];
    }
    let (t, knots): (Vec<_>, Vec<_>) = points.iter().map(|&[t, x, y]| (t, DVec2::new(x, y))).unzip();
    let matrix = |&[cx, cxy, cyx, cy]: &[f64; 4]| DMat2::from_cols(DVec2::new(cx, cyx), DVec2::new(cxy, cy));
    let factors: Vec<_> = factors.iter().map(matrix).collect();
    let curve = match spans {
        None => FractalCurve::fif(&t, &knots, &factors, &reflected),
        Some(spans) => FractalCurve::rfif(&t, &knots, &factors, &whole_spans(spans, &reflected)?),
    };
    let curve = curve.map_err(|error| of_function(&error))?;
    let plain = |piece: &Piece| PlainPiece { map: piece.plane_map(), domain: piece.domain };
    let pieces = curve.pieces().iter().map(plain).collect();
    write(&PlainCurve { pieces, contractivity: curve.contractivity() })
}

#[derive(Deserialize)]
struct Sampling {
    #[serde(default)]
    tolerance: Option<f64>,
    #[serde(default)]
    window: Option<[f64; 4]>,
    #[serde(default)]
    most: Option<f64>,
}

/// A curve as a polyline t0, x0, y0, t1, x1, y1, .. in the order of t. Between two points it stays within the tolerance
/// of both, or as near to that as `most` points allow. Default: a thousandth of what the curve may reach, and 65,536
/// points. With a window [x0, y0, x1, y1] only what may be seen there is followed, and a point of NaN stands in place
/// of what is left out.
#[wasm_bindgen(js_name = sampleInterpolationCurve)]
pub fn sample_interpolation_curve(
    #[wasm_bindgen(unchecked_param_type = "PlaneGraph")] curve: JsValue,
    #[wasm_bindgen(
        unchecked_optional_param_type = "{ tolerance?: number; most?: number; window?: [x0: number, y0: number, x1: number, y1: number] }"
    )]
    options: JsValue,
) -> Result<Float64Array, JsValue> {
    check_length(&curve, "pieces")?;
    let plain: PlainCurve = read("The curve", curve)?;
    let maps: Vec<_> = plain.pieces.iter().map(|piece| (piece.map, piece.domain)).collect();
    let curve = FractalCurve::from_maps(&maps).map_err(|error| of_function(&error))?;
    let Sampling { tolerance, window, most } = read("The options", options)?;
    let most = most.unwrap_or(USUAL_SAMPLES);
    if !(2.0..=MAX_SAMPLES).contains(&most) {
        return Err(bad_input("most", "a number from 2 to 1048576 is needed"));
    }
    let asked = tolerance.unwrap_or(1e-3 * curve.bound());
    if !(asked >= 0.0 && asked.is_finite()) {
        return Err(bad_input("tolerance", "a number from 0 on is needed"));
    }
    let window = match window {
        Some([x0, y0, x1, y1]) if x0 < x1 && y0 < y1 => Some([DVec2::new(x0, y0), DVec2::new(x1, y1)]),
        Some(_) => return Err(bad_input("window", "x0, y0, x1, y1 are needed, x0 below x1 and y0 below y1")),
        None => None,
    };
    let mut tolerance = asked.max(1e-12 * curve.bound());
    loop {
        match curve.polyline_in(window, tolerance, most as usize) {
            Ok(points) => {
                let flat: Vec<f64> = points.into_iter().flat_map(|(t, at)| [t, at.x, at.y]).collect();
                return Ok(Float64Array::from(&flat[..]));
            }
            Err(FunctionError::TooManyPoints { .. }) if tolerance < 4.0 * curve.bound() => tolerance *= 2.0,
            Err(error) => return Err(of_function(&error)),
        }
    }
}
