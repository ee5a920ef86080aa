//! Ways through a locus.

use frond_locus::{Axes, PathError, PathOptions, PathPlan, check_path};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::grid::{EPSILON, read_locus};
use crate::boundary::path::{read_path, read_planning, read_samples, write_check, write_plan};
use crate::boundary::value::{read, read_morph};

#[derive(Deserialize)]
struct Planning {
    axes: Option<f64>,
}

/// Plans a path from (0, 0) to (1, 1) along which the shape stays in one piece, or comes as near to that as can be;
/// with `axes` 3, it may take the stretch ahead of the turn where the plane has no way. It computes a locus on the way:
/// long work, for a worker.
#[wasm_bindgen(js_name = planPath, unchecked_return_type = "PathPlan")]
pub fn plan_path(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PathOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    plan(frond_locus::find_path(&morph, &read_options(options)?))
}

fn read_options(options: JsValue) -> Result<PathOptions, JsValue> {
    let Planning { axes } = read("The options", options.clone())?;
    let axes = match axes {
        None | Some(2.0) => Axes::Two,
        Some(3.0) => Axes::Three,
        Some(_) => return Err(bad_input("axes", "2 or 3 is needed")),
    };
    Ok(PathOptions { axes, ..read_planning(options)? })
}

/// The search of `planPath` in parts, so that it can be given up in between.
#[wasm_bindgen]
pub struct PathSearch(frond_locus::PathSearch);

#[wasm_bindgen]
impl PathSearch {
    /// A search between two systems, with the options of `planPath`. Nothing is looked for yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "PathOptions")] options: JsValue,
    ) -> Result<Self, JsValue> {
        let morph = read_morph(&from, &to, &options)?;
        Ok(Self(frond_locus::PathSearch::new(morph, read_options(options)?)))
    }

    /// Does the next part, of about a second or less. The plan comes with the last, `null` before.
    #[wasm_bindgen(unchecked_return_type = "PathPlan | null")]
    pub fn step(&mut self) -> Result<JsValue, JsValue> {
        match self.0.step() {
            Ok(None) => Ok(JsValue::NULL),
            Ok(Some(found)) => write_plan(&found),
            Err(error) => plan(Err(error)),
        }
    }
}

/// Plans a path in a locus that has been computed already, over `bounds` (default [-1, 2] x [-1, 2]).
#[wasm_bindgen(js_name = planPathIn, unchecked_return_type = "PathPlan")]
pub fn plan_path_in(
    #[wasm_bindgen(unchecked_param_type = "Locus")] locus: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Bounds")] bounds: JsValue,
) -> Result<JsValue, JsValue> {
    plan(frond_locus::plan_path(&read_locus(&locus, bounds)?, EPSILON))
}

fn plan(found: Result<PathPlan, PathError>) -> Result<JsValue, JsValue> {
    write_plan(&found.map_err(|error| failure(error.code(), &error.to_string()))?)
}

/// Looks along a path of (u, v) or (u, v, w) points, ends included, and tells where it breaks, as fractions of its
/// length.
#[wasm_bindgen(js_name = checkPath, unchecked_return_type = "PathCheck")]
pub fn check(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "readonly PathPoint[]")] points: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MorphOptions & { epsilon?: number; samples?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let (epsilon, samples) = read_samples(options, 400.0)?;
    write_check(&check_path(&morph, &read_path(points)?, epsilon, samples))
}
