//! What a graphics card leaves of a locus.

use frond_locus::{Family, Polygons, Slice};
use js_sys::{Float32Array, Uint8Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::grid::{of_grid, read_grid};
use crate::boundary::value::{object, read, read_morph};

#[derive(Deserialize)]
struct Sampling {
    #[serde(default)]
    w: f64,
    most: Option<f64>,
}

#[derive(Deserialize)]
struct Polygon {
    sides: f64,
}

/// Decides in double precision what `LocusCompute.run` left undecided of a locus, with the options that it had: at
/// most `most` samples, so that the work can be done in slices. Returns new arrays and how many are still left.
/// A sample stays undecided if this cannot tell, either; then it is not counted.
#[wasm_bindgen(
    js_name = settleLocus,
    unchecked_return_type = "{ state: Uint8Array; gap: Float32Array; left: number }"
)]
pub fn settle_locus(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "LocusOptions & { most?: number }")] options: JsValue,
    state: Vec<u8>,
    gap: Vec<f32>,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let Sampling { w, most } = read("The options", options.clone())?;
    settle(&Slice::new(&morph, w), &options, most, state, gap)
}

/// The same for `LocusCompute.runFamily`.
#[wasm_bindgen(
    js_name = settleFamily,
    unchecked_return_type = "{ state: Uint8Array; gap: Float32Array; left: number }"
)]
pub fn settle_family(
    #[wasm_bindgen(unchecked_param_type = "PolygonFamily")] family: JsValue,
    #[wasm_bindgen(unchecked_param_type = "FamilyOptions & { most?: number }")] options: JsValue,
    state: Vec<u8>,
    gap: Vec<f32>,
) -> Result<JsValue, JsValue> {
    let Polygon { sides } = read("The family", family)?;
    let Sampling { most, .. } = read("The options", options.clone())?;
    settle(&Polygons::new(sides as usize), &options, most, state, gap)
}

fn settle(
    family: &impl Family,
    options: &JsValue,
    most: Option<f64>,
    mut state: Vec<u8>,
    mut gap: Vec<f32>,
) -> Result<JsValue, JsValue> {
    let (grid, epsilon) = read_grid(options)?;
    let most = most.map_or(usize::MAX, |most| most as usize);
    let left = grid.settle(family, epsilon, most, &mut state, &mut gap).map_err(|error| of_grid(&error))?;
    Ok(object(&[
        ("state", Uint8Array::from(&state[..]).into()),
        ("gap", Float32Array::from(&gap[..]).into()),
        ("left", (left as f64).into()),
    ]))
}
