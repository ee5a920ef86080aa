//! What a graphics card leaves of a locus.

use frond_core::Affine2;
use frond_locus::{Bounds, GridError, LocusGrid, Scratch, State, decide};
use glam::DVec2;
use js_sys::{Float32Array, Uint8Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::value::{object, read, read_morph};
use crate::proof::locus::{EPSILON, PlainBounds, of_grid};

#[derive(Deserialize)]
struct Sampling {
    bounds: Option<PlainBounds>,
    width: f64,
    height: f64,
    epsilon: Option<f64>,
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
    let plain: Sampling = read("The options", options)?;
    let w = plain.w;
    settle(&plain, state, gap, |u, v, maps| morph.fill3(u, v, w, maps))
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
    let sides = (sides as usize).clamp(1, frond_core::MAX_MAPS);
    settle(&read("The options", options)?, state, gap, |x, y, maps| {
        let linear = Affine2::from_row([x, -y, y, x, 0.0, 0.0]).linear;
        let corner = |k: usize| DVec2::from_angle(std::f64::consts::TAU * k as f64 / sides as f64);
        maps.clear();
        maps.extend((0..sides).map(|k| Affine2::new(linear, corner(k))));
    })
}

fn settle(
    plain: &Sampling,
    mut state: Vec<u8>,
    mut gap: Vec<f32>,
    mut fill: impl FnMut(f64, f64, &mut Vec<Affine2>),
) -> Result<JsValue, JsValue> {
    let bounds = plain.bounds.map_or_else(Bounds::default, Bounds::from);
    // A cast of NaN or a negative number gives 0, which the grid refuses.
    let grid = LocusGrid::new(bounds, plain.width as usize, plain.height as usize)
        .map_err(|error| of_grid(&error))?;
    let count = grid.width() * grid.height();
    if state.len() != count || gap.len() != count {
        return Err(of_grid(&GridError::Samples));
    }
    let epsilon = plain.epsilon.unwrap_or(EPSILON);
    let mut most = plain.most.map_or(usize::MAX, |most| most as usize);
    let (mut maps, mut scratch, mut left) = (Vec::new(), Scratch::default(), 0_usize);
    for k in 0..count {
        // A gap that is not known marks those that nobody has looked at in double precision.
        if state[k] != State::Undecided as u8 || !gap[k].is_nan() {
            continue;
        }
        if most == 0 {
            left += 1;
            continue;
        }
        most -= 1;
        fill(grid.u(k % grid.width()), grid.v(k / grid.width()), &mut maps);
        let budget = LocusGrid::BUDGET.max(2_000 * maps.len());
        let sample = decide(&maps, epsilon, budget, &mut scratch);
        state[k] = sample.state as u8;
        // Where there is no bound of the gap at all: it is no wider than the attractor.
        gap[k] = if sample.state == State::Undecided && sample.gap.is_nan() { 1.0 } else { sample.gap };
    }
    Ok(object(&[
        ("state", Uint8Array::from(&state[..]).into()),
        ("gap", Float32Array::from(&gap[..]).into()),
        ("left", (left as f64).into()),
    ]))
}
