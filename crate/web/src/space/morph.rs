//! Morphs in space, and where they hold together.

use frond_core::{Ifs3, IfsError, Morph3};
use frond_locus::{LocusGrid, Reason3, Scratch3, tile3};
use js_sys::Array;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{failure, of_ifs, of_morph};
use crate::boundary::grid::{read_grid, write_tile};
use crate::boundary::path::{read_path, read_planning, read_samples, write_check, write_plan};
use crate::boundary::resolution::read_options;
use crate::boundary::space::{read_ifs3, read_maps3, write_maps3};
use crate::boundary::value::{object, read_morph_options, read_parameters, write};

fn read_morph3(from: &JsValue, to: &JsValue, options: &JsValue) -> Result<Morph3, JsValue> {
    let options = read_morph_options(options)?;
    Morph3::new(&read_maps3(from)?, &read_maps3(to)?, &options).map_err(|error| of_morph(&error))
}

/// Which map of `to` each map of `from` becomes, so that pieces travel, turn and stretch least.
#[wasm_bindgen(unchecked_return_type = "number[]")]
pub fn correspondence3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] to: JsValue,
) -> Result<JsValue, JsValue> {
    write(&Morph3::correspondence(&read_ifs3(&from)?, &read_ifs3(&to)?))
}

/// The maps of a morph at (u, v, w) (Burch & Hart, eq 6). There need not be an attractor.
#[wasm_bindgen(unchecked_return_type = "MapRow3[]")]
pub fn interpolate3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MorphOptions & { u: number; v: number; w?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let [u, v, w] = read_parameters(options.clone())?;
    write_maps3(&read_morph3(&from, &to, &options)?.at3(u, v, w))
}

/// For each map that turns by half a turn from `from` to `to`, which is as short either way, the whole turns (1 or -1)
/// that make it the other half turn when they are added to its `turns`; 0 for all others.
#[wasm_bindgen(js_name = halfTurns3, unchecked_return_type = "number[]")]
pub fn half_turns3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MorphOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    write(&read_morph3(&from, &to, &options)?.other_half_turns())
}

/// Whether a shape of space is in one piece. Maps without an attractor get the verdict `no-attractor`.
#[wasm_bindgen(unchecked_return_type = "Connectedness3")]
pub fn connectedness3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ epsilon?: number; budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let options = read_options(options)?;
    let ifs = match Ifs3::new(read_maps3(&maps)?) {
        Ok(ifs) => ifs,
        Err(IfsError::NoAttractor { .. } | IfsError::Unproved) => {
            return Ok(object(&[
                ("verdict", "no-attractor".into()),
                ("gap", object(&[("lower", 0.0.into()), ("upper", f64::INFINITY.into())])),
                ("overlaps", Array::new().into()),
                ("components", Array::new().into()),
                ("count", 0.into()),
                ("closest", JsValue::NULL),
                ("diameter", f64::INFINITY.into()),
                ("reason", JsValue::NULL),
            ]));
        }
        Err(error) => return Err(of_ifs(&error)),
    };
    let found = frond_locus::connectedness3(&ifs, &options);
    let closest = found.closest.map(|(a, b)| write(&[a.to_array(), b.to_array()])).transpose()?;
    Ok(object(&[
        ("verdict", found.verdict.name().into()),
        ("gap", object(&[("lower", found.gap.lower.into()), ("upper", found.gap.upper.into())])),
        ("overlaps", write(&found.overlaps)?),
        ("components", write(&found.components)?),
        ("count", (found.count as f64).into()),
        ("closest", closest.unwrap_or(JsValue::NULL)),
        ("diameter", found.diameter.into()),
        ("reason", found.reason.as_ref().map(Reason3::text).map_or(JsValue::NULL, JsValue::from)),
    ]))
}

/// A locus of a morph in space, row by row.
#[wasm_bindgen]
pub struct SpaceLocus {
    grid: LocusGrid,
    morph: Morph3,
    epsilon: f64,
    scratch: Scratch3,
}

#[wasm_bindgen]
impl SpaceLocus {
    /// Over `bounds`, [-1, 2] x [-1, 2] by default. Nothing is decided yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] to: JsValue,
        #[wasm_bindgen(
            unchecked_param_type = "MorphOptions & { bounds?: Bounds; width: number; height: number; epsilon?: number }"
        )]
        options: JsValue,
    ) -> Result<Self, JsValue> {
        let (grid, epsilon) = read_grid(&options)?;
        let morph = read_morph3(&from, &to, &options)?;
        Ok(Self { grid, morph, epsilon, scratch: Scratch3::default() })
    }

    /// Every `stride`th sample of the rows from r0 to before r1 that are a multiple of it: `{ state, gap }`, as in a
    /// `Locus`.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn run(&mut self, r0: usize, r1: usize, stride: usize) -> JsValue {
        write_tile(&tile3(&self.grid, &self.morph, self.epsilon, r0..r1, stride, &mut self.scratch))
    }
}

/// A path from (0, 0) to (1, 1) along which the shape stays in one piece, or comes as near to that as can be: long
/// work, for a worker.
#[wasm_bindgen(js_name = findPath3, unchecked_return_type = "PathPlan")]
pub fn find_path(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MorphOptions & { epsilon?: number; size?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph3(&from, &to, &options)?;
    let options = read_planning(options)?;
    let plan = frond_locus::find_path3(&morph, &options)
        .map_err(|error| failure(error.code(), &error.to_string()))?;
    write_plan(&plan)
}

/// Looks along a path, ends included, and tells where it breaks, as fractions of its length.
#[wasm_bindgen(js_name = checkPath3, unchecked_return_type = "PathCheck")]
pub fn check_path(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "readonly PathPoint[]")] points: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MorphOptions & { epsilon?: number; samples?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph3(&from, &to, &options)?;
    let (epsilon, samples) = read_samples(options, 100.0)?;
    write_check(&frond_locus::check_path3(&morph, &read_path(points)?, epsilon, samples))
}
