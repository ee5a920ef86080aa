//! Ways through a locus.

use frond_locus::{PathError, PathOptions, PathPlan, check_path};
use glam::DVec2;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::{bad_input, failure};
use crate::locus::{EPSILON, read_locus};
use crate::value::{object, point, read, read_morph, write};

#[derive(Deserialize)]
struct Planning {
    epsilon: Option<f64>,
    size: Option<f64>,
}

/// Plans a path from (0, 0) to (1, 1) along which the shape stays in one piece, or comes as near to that as can
/// be. It computes a locus on the way: long work, for a worker.
#[wasm_bindgen(js_name = planPath, unchecked_return_type = "PathPlan")]
pub fn plan_path(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(
        unchecked_param_type = "(MorphOptions & { epsilon?: number; size?: number }) | undefined"
    )]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let plain: Planning = read("The options", options)?;
    let mut options = PathOptions::default();
    if let Some(epsilon) = plain.epsilon {
        options.epsilon = epsilon;
    }
    if let Some(size) = plain.size {
        options.size = size as usize;
    }
    plan(frond_locus::find_path(&morph, &options))
}

/// Plans a path in a locus that has been computed already, over `bounds` (default [-1, 2] x [-1, 2]).
#[wasm_bindgen(js_name = planPathIn, unchecked_return_type = "PathPlan")]
pub fn plan_path_in(
    #[wasm_bindgen(unchecked_param_type = "Locus")] locus: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Bounds | undefined")] bounds: JsValue,
) -> Result<JsValue, JsValue> {
    plan(frond_locus::plan_path(&read_locus(&locus, bounds)?, EPSILON))
}

fn plan(found: Result<PathPlan, PathError>) -> Result<JsValue, JsValue> {
    let found = found.map_err(|error| failure(error.code(), &error.to_string()))?;
    let points: Vec<[f64; 2]> = found.points.iter().map(|&p| point(p)).collect();
    Ok(object(&[("points", write(&points)?), ("gap", found.gap.into()), ("holds", found.holds.into())]))
}

#[derive(Deserialize)]
struct Checking {
    epsilon: Option<f64>,
    samples: Option<f64>,
}

/// Looks along a path of (u, v) points, ends included, and tells where it breaks, as fractions of its length.
#[wasm_bindgen(js_name = checkPath, unchecked_return_type = "PathCheck")]
pub fn check(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "[u: number, v: number][]")] points: JsValue,
    #[wasm_bindgen(
        unchecked_param_type = "(MorphOptions & { epsilon?: number; samples?: number }) | undefined"
    )]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let plain: Checking = read("The options", options)?;
    let points: Vec<[f64; 2]> = read("The path", points)?;
    if points.iter().flatten().any(|x| !x.is_finite()) {
        return Err(bad_input("The path", "its numbers must be finite"));
    }
    let points: Vec<DVec2> = points.into_iter().map(DVec2::from_array).collect();
    let samples = plain.samples.unwrap_or(400.0).clamp(2.0, 100_000.0) as usize;
    let found = check_path(&morph, &points, plain.epsilon.unwrap_or(EPSILON), samples);
    Ok(object(&[("gap", found.gap.into()), ("holds", found.holds.into()), ("breaks", write(&found.breaks)?)]))
}
