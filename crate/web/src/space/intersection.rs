//! Where two shapes meet.

use frond_core::Affine3;
use frond_scene::Row3;
use js_sys::Float32Array;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::space::{read_maps3, write_maps3};
use crate::boundary::value::{object, read, write};

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Example {
    name: &'static str,
    first: Vec<Row3>,
    second: Vec<Row3>,
    is_attractor: bool,
    why: &'static str,
}

/// One example where the intersection of two attractors is one, and one where it is not.
#[wasm_bindgen(js_name = meetExamples, unchecked_return_type = "MeetExample[]")]
pub fn examples() -> Result<JsValue, JsValue> {
    let examples: Vec<Example> = frond_scene::intersection_examples()
        .into_iter()
        .map(|e| Example {
            name: e.name,
            first: e.first,
            second: e.second,
            is_attractor: e.is_attractor,
            why: e.why,
        })
        .collect();
    write(&examples)
}

#[derive(Serialize)]
struct PlainArrow {
    from: usize,
    first: usize,
    second: usize,
    to: usize,
}

#[derive(Deserialize)]
struct Options {
    points: Option<f64>,
}

/// The product of two systems whose maps share one linear part: where their shapes meet. Throws where they do not share
/// it, or where there is no end of shifts.
#[wasm_bindgen(unchecked_return_type = "Intersection3")]
pub fn intersection3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] first: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] second: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ points?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let Options { points } = read("The options", options)?;
    let found = frond_core::intersection(&read_maps3(&first)?, &read_maps3(&second)?)
        .map_err(|error| failure(error.code(), &error.to_string()))?;
    let arrows: Vec<PlainArrow> = found
        .arrows
        .iter()
        .map(|arrow| PlainArrow { from: arrow.from, first: arrow.first, second: arrow.second, to: arrow.to })
        .collect();
    let shifts: Vec<[f64; 3]> = found.shifts.iter().map(|shift| shift.to_array()).collect();
    let maps: Option<Vec<Affine3>> = found.attractor();
    let count = points.unwrap_or(0.0).clamp(0.0, 1e6) as usize;
    Ok(object(&[
        ("shifts", write(&shifts)?),
        ("arrows", write(&arrows)?),
        ("attractor", maps.map_or(Ok(JsValue::NULL), |maps| write_maps3(&maps))?),
        ("points", Float32Array::from(&found.points(count, 1)[..]).into()),
    ]))
}
