//! Loci over grids.

use std::ops::Range;

use frond_locus::{Bounds, Family, GridError, Locus, LocusGrid, Scratch, Tile};
use js_sys::{Float32Array, Reflect, Uint8Array};
use serde::Deserialize;
use wasm_bindgen::{JsCast, JsValue};

use super::error::{bad_input, failure};
use super::value::{object, read, read_given};

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

/// The grid that options speak of, and their epsilon.
pub(crate) fn read_grid(options: &JsValue) -> Result<(LocusGrid, f64), JsValue> {
    let plain: Sampling = read("The options", options.clone())?;
    let bounds = plain.bounds.map_or_else(Bounds::default, Bounds::from);
    // A cast of NaN or a negative number gives 0, which the grid refuses.
    let grid = LocusGrid::new(bounds, plain.width as usize, plain.height as usize);
    Ok((grid.map_err(|error| of_grid(&error))?, plain.epsilon.unwrap_or(EPSILON)))
}

/// A `Locus` object over `bounds`.
pub(crate) fn read_locus(locus: &JsValue, bounds: JsValue) -> Result<Locus, JsValue> {
    let bounds: Option<PlainBounds> = read_given("The bounds", bounds)?;
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

/// The states of a rectangle, as [`LocusGrid::prove`] leaves them.
pub(crate) fn prove(
    grid: &LocusGrid,
    family: &dyn Family,
    epsilon: f64,
    [x, y]: [Range<usize>; 2],
    mut state: Vec<u8>,
    scratch: &mut Scratch,
) -> Result<Vec<u8>, JsValue> {
    let side = |range: &Range<usize>, most: usize| range.end.min(most).saturating_sub(range.start);
    if state.len() != side(&x, grid.width()) * side(&y, grid.height()) {
        return Err(bad_input("state", "one number for each sample of the rectangle is needed"));
    }
    grid.prove(family, epsilon, x, y, &mut state, scratch);
    Ok(state)
}

pub(crate) fn write_tile(tile: &Tile) -> JsValue {
    object(&[
        ("state", Uint8Array::from(&tile.state[..]).into()),
        ("gap", Float32Array::from(&tile.gap[..]).into()),
    ])
}

pub(crate) fn write_samples(width: usize, height: usize, state: &[u8], gap: &[f32]) -> JsValue {
    object(&[
        ("width", (width as f64).into()),
        ("height", (height as f64).into()),
        ("state", Uint8Array::from(state).into()),
        ("gap", Float32Array::from(gap).into()),
    ])
}
