//! Closed curves made of smaller copies of their own arcs, from JavaScript.

use frond_fit::{ClosedCurve, CopyFacts, MAX_TEXT, PackError, spectral_norm};
use frond_scene::Curve;
use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::read::{self, read_curve};
use crate::boundary::error::failure;
use crate::boundary::value::{Row, object, write};

fn of_pack(error: PackError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn write_curve(curve: &ClosedCurve) -> Result<JsValue, JsValue> {
    write(&Curve::from(curve))
}

#[derive(Serialize)]
struct Item {
    id: &'static str,
    name: &'static str,
    about: &'static str,
    curve: Curve,
}

/// The gallery of closed curves.
#[wasm_bindgen(js_name = curvePresets, unchecked_return_type = "CurvePreset[]")]
pub fn curve_presets() -> Result<JsValue, JsValue> {
    let item = |preset: frond_fit::CurvePreset| Item {
        id: preset.id,
        name: preset.name,
        about: preset.about,
        curve: Curve::from(&preset.curve),
    };
    write(&frond_fit::curve_presets().into_iter().map(item).collect::<Vec<_>>())
}

/// A curve in letters, digits, `-` and `_`, as a link holds it: some three characters a knot, four more a copied edge.
#[wasm_bindgen(js_name = packCurve)]
pub fn pack_curve(#[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue) -> Result<String, JsValue> {
    read_curve(&curve)?.to_text().map_err(of_pack)
}

/// The curve that [`pack_curve`] wrote; of another word, as a link keeps it.
#[wasm_bindgen(js_name = unpackCurve, unchecked_return_type = "Curve")]
pub fn unpack_curve(text: &str) -> Result<JsValue, JsValue> {
    if text.len() > MAX_TEXT {
        return Err(of_pack(PackError::TooLong));
    }
    write_curve(&ClosedCurve::from_text(text).map_err(of_pack)?)
}

/// The curve as a link brings it back: knots to a hundred-thousandth of the box's diagonal, roughness to 1/2048.
/// What this gives does not change any more.
#[wasm_bindgen(unchecked_return_type = "Curve")]
pub fn quantised(#[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue) -> Result<JsValue, JsValue> {
    write_curve(&read_curve(&curve)?.quantised().map_err(of_pack)?)
}

/// What a curve costs and what it is like.
///
/// Numbers are 2 a knot and 2 a copied edge, bytes those of the packed curve. The dimension is that of boxes between
/// 1/64 and 1/256 of the box's diagonal, the length that of a polyline that is true to 1/2000 of it; contractivity is
/// the largest factor by which a copy stretches lengths, 0 where all edges are straight.
#[wasm_bindgen(
    js_name = curveFacts,
    unchecked_return_type = "{ numbers: number; knots: number; copies: number; bytes: number; dimension: number; length: number; contractivity: number }"
)]
pub fn curve_facts(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
) -> Result<JsValue, JsValue> {
    let curve = read_curve(&curve)?;
    let (dimension, length) = read::morphed(&curve)?.dimension_and_length();
    let norms = (0..curve.knots.len()).filter_map(|i| curve.map(i)).map(|(linear, _)| spectral_norm(linear));
    // Three characters of a link are four bytes of the packed curve in base 64.
    let bytes = curve.to_text().map_err(of_pack)?.len() * 3 / 4;
    Ok(object(&[
        ("numbers", curve.numbers().into()),
        ("knots", curve.knots.len().into()),
        ("copies", curve.copies().into()),
        ("bytes", bytes.into()),
        ("dimension", dimension.into()),
        ("length", length.into()),
        ("contractivity", norms.fold(0.0, f64::max).into()),
    ]))
}

#[derive(Serialize)]
struct EdgeCopy {
    edge: usize,
    from: usize,
    span: usize,
    ratio: f64,
    across: f64,
    degrees: f64,
    mirrored: bool,
}

/// How each copied edge lies to its arc: its knot, the arc's first knot and its edges, how many times as long and as
/// far from the chord it is, by how many degrees it is turned (counterclockwise, y up), and whether it is mirrored.
#[wasm_bindgen(
    js_name = curveCopies,
    unchecked_return_type = "{ edge: number; from: number; span: number; ratio: number; across: number; degrees: number; mirrored: boolean }[]"
)]
pub fn curve_copies(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
) -> Result<JsValue, JsValue> {
    let facts = read_curve(&curve)?.copy_facts().into_iter();
    let plain = |CopyFacts { edge, from, span, ratio, across, degrees, mirrored }| EdgeCopy {
        edge,
        from,
        span,
        ratio,
        across,
        degrees,
        mirrored,
    };
    write(&facts.map(plain).collect::<Vec<_>>())
}

/// The curve after a number of steps (any number from 0), as x0, y0, x1, y1, ..: 0 is the polygon of its knots, and at
/// each step every copy is drawn anew from what its arc was before.
#[wasm_bindgen(js_name = curveSteps)]
pub fn curve_steps(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
    steps: f64,
) -> Result<Vec<f64>, JsValue> {
    Ok(read_curve(&curve)?.grown(steps).into_iter().flat_map(|p| p.to_array()).collect())
}

#[derive(Serialize)]
struct EdgeMap {
    map: Option<Row>,
    arc: [usize; 2],
    reversed: bool,
}

/// What makes each edge: the map that takes an arc to it (null: it is straight), and the arc by its first knot and how
/// many edges it has. The curve is what is left the same when each edge is replaced by the image of its arc.
#[wasm_bindgen(
    js_name = curveMaps,
    unchecked_return_type = "{ map: MapRow | null; arc: [from: number, span: number]; reversed: boolean }[]"
)]
pub fn curve_maps(
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
) -> Result<JsValue, JsValue> {
    let curve = read_curve(&curve)?;
    let edges: Vec<_> = curve
        .edges
        .iter()
        .enumerate()
        .map(|(i, edge)| {
            let map = curve.map(i).map(|(linear, origin)| {
                let shift = curve.knots[i] - linear * origin;
                [linear.x_axis.x, linear.y_axis.x, linear.x_axis.y, linear.y_axis.y, shift.x, shift.y]
            });
            let arc = edge.map_or([i, 1], |copy| [copy.from, copy.span]);
            EdgeMap { map, arc, reversed: edge.is_some_and(|copy| copy.reversed) }
        })
        .collect();
    write(&edges)
}
