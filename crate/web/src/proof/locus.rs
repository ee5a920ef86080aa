//! The connectedness locus, whole or in tiles.

use frond_core::Morph;
use frond_locus::{Bounds, GridError, Locus, LocusGrid, Pass, Scratch, Slice, Tile};
use js_sys::{Float32Array, Reflect, Uint8Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{object, read, read_morph};

#[derive(Clone, Copy, Deserialize)]
pub(crate) struct PlainBounds {
    u0: f64,
    v0: f64,
    u1: f64,
    v1: f64,
}

impl From<PlainBounds> for Bounds {
    fn from(PlainBounds { u0, v0, u1, v1 }: PlainBounds) -> Self {
        Self { u0, v0, u1, v1 }
    }
}

#[derive(Deserialize)]
struct Sampling {
    bounds: Option<PlainBounds>,
    width: f64,
    height: f64,
    epsilon: Option<f64>,
}

/// What a picture of 600 pixels resolves.
pub(crate) const EPSILON: f64 = 1.0 / 600.0;

pub(crate) fn of_grid(error: &GridError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// Which plane of the parameters: how far the stretch is ahead of the turn.
fn read_w(options: &JsValue) -> Result<f64, JsValue> {
    let w = Reflect::get(options, &"w".into()).unwrap_or(JsValue::UNDEFINED);
    match w.as_f64() {
        Some(w) if w.is_finite() => Ok(w),
        None if w.is_undefined() || w.is_null() => Ok(0.0),
        _ => Err(bad_input("w", "a finite number is needed")),
    }
}

pub(crate) fn write_tile(tile: &Tile) -> JsValue {
    object(&[
        ("state", Uint8Array::from(&tile.state[..]).into()),
        ("gap", Float32Array::from(&tile.gap[..]).into()),
    ])
}

pub(crate) fn read_grid(options: &JsValue) -> Result<(LocusGrid, f64), JsValue> {
    let plain: Sampling = read("The options", options.clone())?;
    let bounds = plain.bounds.map_or_else(Bounds::default, Bounds::from);
    // A cast of NaN or a negative number gives 0, which the grid refuses.
    let grid = LocusGrid::new(bounds, plain.width as usize, plain.height as usize);
    Ok((grid.map_err(|error| of_grid(&error))?, plain.epsilon.unwrap_or(EPSILON)))
}

/// A `Locus` object over `bounds`.
pub(crate) fn read_locus(locus: &JsValue, bounds: JsValue) -> Result<Locus, JsValue> {
    let bounds: Option<PlainBounds> =
        if bounds.is_undefined() { None } else { Some(read("The bounds", bounds)?) };
    let side =
        |key: &str| Reflect::get(locus, &key.into()).ok().and_then(|x| x.as_f64()).unwrap_or(0.0) as usize;
    let array = |key: &str| Reflect::get(locus, &key.into()).unwrap_or(JsValue::UNDEFINED);
    let grid =
        LocusGrid::new(bounds.map_or_else(Bounds::default, Bounds::from), side("width"), side("height"))
            .map_err(|error| of_grid(&error))?;
    let state = array("state").dyn_into::<Uint8Array>().map_err(|_| of_grid(&GridError::Samples))?;
    let gap = array("gap").dyn_into::<Float32Array>().map_err(|_| of_grid(&GridError::Samples))?;
    Locus::from_parts(grid, state.to_vec(), gap.to_vec()).map_err(|error| of_grid(&error))
}

pub(crate) fn write_samples(width: usize, height: usize, state: &[u8], gap: &[f32]) -> JsValue {
    object(&[
        ("width", (width as f64).into()),
        ("height", (height as f64).into()),
        ("state", Uint8Array::from(state).into()),
        ("gap", Float32Array::from(gap).into()),
    ])
}

/// The connectedness locus of the morph between two systems of equally many maps (Burch & Hart 1997, section
/// 5). Long work: call it in a worker, or use `LocusTiles`.
#[wasm_bindgen(unchecked_return_type = "Locus")]
pub fn locus(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "LocusOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let (grid, epsilon) = read_grid(&options)?;
    let slice = Slice::new(&morph, read_w(&options)?);
    let (state, gap) = grid.locus(&slice, epsilon).into_parts();
    Ok(write_samples(grid.width(), grid.height(), &state, &gap))
}

/// A locus that is computed a few rows at a time, from coarse to fine.
#[wasm_bindgen]
pub struct LocusTiles {
    morph: Morph,
    w: f64,
    grid: LocusGrid,
    epsilon: f64,
    scratch: Scratch,
}

#[wasm_bindgen]
impl LocusTiles {
    /// The locus of the morph between two systems, with the options of `locus`. Nothing is computed yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LocusOptions")] options: JsValue,
    ) -> Result<Self, JsValue> {
        let morph = read_morph(&from, &to, &options)?;
        let (grid, epsilon) = read_grid(&options)?;
        let w = read_w(&options)?;
        Ok(Self { morph, w, grid, epsilon, scratch: Scratch::default() })
    }

    /// Decides the samples of rows `r0` to `r1` (exclusive) that lie on the grid of every `stride`-th row and
    /// column and, unless this is the `first` pass, not on that of twice the stride. The arrays hold one row
    /// of the full width for each row that is a multiple of the stride; samples of other passes are 255 and
    /// NaN.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn run(&mut self, r0: usize, r1: usize, stride: usize, first: bool) -> JsValue {
        let pass = Pass { rows: r0..r1, stride, first };
        let slice = Slice::new(&self.morph, self.w);
        write_tile(&self.grid.tile(&slice, self.epsilon, &pass, &mut self.scratch))
    }

    /// Decides all samples of columns `x0` to `x1` and rows `y0` to `y1` (both exclusive at their ends), whole boxes at
    /// once: the arrays hold them row by row.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn patch(&mut self, x0: usize, y0: usize, x1: usize, y1: usize) -> JsValue {
        let slice = Slice::new(&self.morph, self.w);
        write_tile(&self.grid.patch(&slice, self.epsilon, x0..x1, y0..y1, &mut self.scratch))
    }
}
