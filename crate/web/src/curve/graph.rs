//! Fractal functions from JavaScript: graphs made of smaller copies of their own parts.

use frond_fit::{Dimension, FractalFunction, FunctionError, Piece};
use js_sys::{Array, Float64Array, Reflect};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{object, read, write};

/// The most pieces of a graph: more than a link holds by far, and read in an instant.
pub(super) const MAX_PIECES: usize = 4096;

/// The most points that one call gives, and how many it gives where nothing is said.
pub(super) const MAX_SAMPLES: f64 = 1_048_576.0;
pub(super) const USUAL_SAMPLES: f64 = 65_536.0;

/// Ends of pieces that are nearer than this part of their bound count as one.
const SAME_END: f64 = 1e-9;

#[derive(Clone, Copy, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Fif,
    Rfif,
    Pfif,
}

#[derive(Deserialize, Serialize)]
struct PlainPiece {
    map: [f64; 5],
    domain: [f64; 2],
}

/// `Graph` of `api.d.ts`. What it says of its kind is for people: its pieces say all.
#[derive(Deserialize, Serialize)]
struct PlainGraph {
    kind: Kind,
    pieces: Vec<PlainPiece>,
}

pub(super) fn of_function(error: &FunctionError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// Refuses a list that is longer than allowed before its entries are read.
pub(super) fn check_length(value: &JsValue, key: &str) -> Result<(), JsValue> {
    let list = Reflect::get(value, &key.into()).unwrap_or(JsValue::UNDEFINED);
    match list.dyn_ref::<Array>() {
        Some(list) if list.length() as usize > MAX_PIECES + 1 => Err(too_many(list.length())),
        _ => Ok(()),
    }
}

pub(super) fn too_many(count: u32) -> JsValue {
    let what =
        format!("There are {count} of them, and the most is {MAX_PIECES}. Take every second, or fewer.");
    failure("too-many-points", &what)
}

fn read_graph(value: &JsValue) -> Result<FractalFunction, JsValue> {
    check_length(value, "pieces")?;
    let plain: PlainGraph = read("The graph", value.clone())?;
    let maps: Vec<_> = plain.pieces.iter().map(|piece| (piece.map, piece.domain)).collect();
    FractalFunction::pfif(&maps).map_err(|error| of_function(&error))
}

fn write_graph(kind: Kind, function: &FractalFunction) -> Result<JsValue, JsValue> {
    let plain = |piece: &Piece| PlainPiece { map: piece.map(), domain: piece.domain };
    write(&PlainGraph { kind, pieces: function.curve().pieces().iter().map(plain).collect() })
}

/// From which point to which each piece copies, the other way round where `reflected`.
pub(super) fn whole_spans(spans: Vec<[f64; 2]>, reflected: &[bool]) -> Result<Vec<(usize, usize)>, JsValue> {
    let mut whole = Vec::with_capacity(spans.len());
    for (index, pair) in spans.into_iter().enumerate() {
        if !pair.iter().all(|x| x.fract() == 0.0 && (0.0..=MAX_PIECES as f64).contains(x)) {
            return Err(bad_input("The options", "spans are pairs of numbers of points, from 0"));
        }
        let [from, to] = pair.map(|x| x as usize);
        whole.push(if reflected.get(index) == Some(&true) { (to, from) } else { (from, to) });
    }
    Ok(whole)
}

#[derive(Deserialize)]
struct Options {
    c: Vec<f64>,
    #[serde(default)]
    reflected: Vec<bool>,
    #[serde(default)]
    spans: Option<Vec<[f64; 2]>>,
    #[serde(default)]
    domains: Option<Vec<[f64; 2]>>,
}

/// The fractal function through points [t, x] with roughness `c`, one a piece (Cochran, Hart & Flynn, sections 2.1 to
/// 2.3): each piece a copy of all of it; or, with `spans`, of what lies between two of the points; or, with `domains`,
/// of any part. `reflected` turns copies around.
#[wasm_bindgen(unchecked_return_type = "Graph")]
pub fn interpolation(
    #[wasm_bindgen(unchecked_param_type = "[t: number, x: number][]")] points: JsValue,
    #[wasm_bindgen(
        unchecked_param_type = "{ c: number[]; reflected?: boolean[]; spans?: [j: number, k: number][]; domains?: [alpha: number, beta: number][] }"
    )]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    if let Some(list) = points.dyn_ref::<Array>()
        && list.length() as usize > MAX_PIECES + 1
    {
        return Err(too_many(list.length()));
    }
    for key in ["c", "reflected", "spans", "domains"] {
        check_length(&options, key)?;
    }
    let points: Vec<[f64; 2]> = read("The list of points", points)?;
    let points: Vec<_> = points.into_iter().map(Into::into).collect();
    let Options { c, mut reflected, spans, domains } = read("The options", options)?;
    if reflected.is_empty() {
        reflected = vec![false; points.len().saturating_sub(1)];
    }
    let (kind, function) = match (spans, domains) {
        (Some(_), Some(_)) => return Err(bad_input("The options", "give spans or domains, not both")),
        (None, None) => (Kind::Fif, FractalFunction::fif(&points, &c, &reflected)),
        (Some(spans), None) => {
            (Kind::Rfif, FractalFunction::rfif(&points, &c, &whole_spans(spans, &reflected)?))
        }
        (None, Some(domains)) => (Kind::Pfif, FractalFunction::through(&points, &c, &reflected, &domains)),
    };
    write_graph(kind, &function.map_err(|error| of_function(&error))?)
}

#[derive(Deserialize)]
struct Sampling {
    #[serde(default)]
    tolerance: Option<f64>,
    #[serde(default)]
    window: Option<[f64; 2]>,
    #[serde(default)]
    most: Option<f64>,
}

/// A graph as a polyline t0, x0, t1, x1, .. from left to right, over the window or over all of it. Between two points
/// x stays within the tolerance of both, or as near to that as `most` points allow. Default: a thousandth of the height
/// that the graph may have, 65,536 points.
#[wasm_bindgen(js_name = sampleGraph)]
pub fn sample_graph(
    #[wasm_bindgen(unchecked_param_type = "Graph")] graph: JsValue,
    #[wasm_bindgen(
        unchecked_optional_param_type = "{ tolerance?: number; window?: [t0: number, t1: number]; most?: number }"
    )]
    options: JsValue,
) -> Result<Float64Array, JsValue> {
    let function = read_graph(&graph)?;
    let Sampling { tolerance, window, most } = read("The options", options)?;
    let most = most.unwrap_or(USUAL_SAMPLES);
    if !(2.0..=MAX_SAMPLES).contains(&most) {
        return Err(bad_input("most", "a number from 2 to 1048576 is needed"));
    }
    let tolerance = tolerance.unwrap_or(2e-3 * function.curve().bound());
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        return Err(bad_input("tolerance", "a number from 0 on is needed"));
    }
    let [start, end] = function.curve().interval();
    let [low, high] = window.unwrap_or([start, end]);
    if !(low.is_finite() && high.is_finite() && low < high) {
        return Err(bad_input("window", "two numbers are needed, the smaller first"));
    }
    let points = function.sample(tolerance, [low.max(start), high.min(end)], most as usize);
    let flat: Vec<f64> = points.into_iter().flat_map(|(t, x)| [t, x]).collect();
    Ok(Float64Array::from(&flat[..]))
}

/// The value at t; beyond the ends that of the nearer end, and where pieces do not meet the limit from the right.
///
/// It is right to the last digits of the greatest height that the graph may have, for factors c up to 0.998. Maps are
/// taken as the numbers that they are, and t as well, but where t comes to a knot or to a copy of one but for rounding:
/// then it is that knot.
#[wasm_bindgen(js_name = graphAt)]
pub fn graph_at(
    #[wasm_bindgen(unchecked_param_type = "Graph")] graph: JsValue,
    t: f64,
) -> Result<f64, JsValue> {
    Ok(read_graph(&graph)?.precise_at(t))
}

/// What can be said of a graph.
///
/// The contractivity is that under the metric of eq 2. The dimension is that of boxes, `counted` where no equation
/// gives it, null where it cannot be told. The widest gap is between neighbouring pieces. The integral is null where a
/// domain does not begin and end at knots.
#[wasm_bindgen(
    js_name = graphFacts,
    unchecked_return_type = "{ contractivity: number; dimension: number | null; counted: boolean; widestGap: number; continuous: boolean; integral: number | null; interval: [t0: number, t1: number] }"
)]
pub fn graph_facts(
    #[wasm_bindgen(unchecked_param_type = "Graph")] graph: JsValue,
) -> Result<JsValue, JsValue> {
    let function = read_graph(&graph)?;
    let curve = function.curve();
    let (dimension, counted) = match function.dimension() {
        Dimension::Equation(dimension) => (dimension, false),
        Dimension::Counted(dimension) => (dimension, true),
    };
    let gap = curve.widest_gap();
    let finite = |x: Option<f64>| x.filter(|x| x.is_finite()).map_or(JsValue::NULL, JsValue::from);
    Ok(object(&[
        ("contractivity", curve.contractivity().into()),
        ("dimension", finite(Some(dimension))),
        ("counted", counted.into()),
        ("widestGap", gap.into()),
        ("continuous", (gap <= SAME_END * curve.bound()).into()),
        ("integral", finite(function.integral())),
        ("interval", write(&curve.interval())?),
    ]))
}

/// The same function as a RFIF of `most` pieces at most; null where it takes more, or endlessly many. Where pieces did
/// not meet, they do then.
#[wasm_bindgen(js_name = toRecurrent, unchecked_return_type = "Graph | null")]
pub fn to_recurrent(
    #[wasm_bindgen(unchecked_param_type = "Graph")] graph: JsValue,
    most: f64,
) -> Result<JsValue, JsValue> {
    let function = read_graph(&graph)?;
    if !(1.0..=MAX_PIECES as f64).contains(&most) {
        return Err(bad_input("most", "a number from 1 to 4096 is needed"));
    }
    let Some(recurrent) = function.to_recurrent(most as usize) else { return Ok(JsValue::NULL) };
    let function = recurrent.function().map_err(|error| of_function(&error))?;
    write_graph(Kind::Rfif, &function)
}
