//! What a graphics card leaves of a locus.

use frond_core::Affine2;
use frond_locus::{GridError, LocusGrid, Scratch, State, decide};
use glam::DVec2;
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
    settle(read_grid(&options)?, most, state, gap, |u, v, maps| morph.fill3(u, v, w, maps))
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
    let Sampling { most, .. } = read("The options", options.clone())?;
    settle(read_grid(&options)?, most, state, gap, |x, y, maps| {
        let linear = Affine2::from_row([x, -y, y, x, 0.0, 0.0]).linear;
        let corner = |k: usize| DVec2::from_angle(std::f64::consts::TAU * k as f64 / sides as f64);
        maps.clear();
        maps.extend((0..sides).map(|k| Affine2::new(linear, corner(k))));
    })
}

fn settle(
    (grid, epsilon): (LocusGrid, f64),
    most: Option<f64>,
    mut state: Vec<u8>,
    mut gap: Vec<f32>,
    mut fill: impl FnMut(f64, f64, &mut Vec<Affine2>),
) -> Result<JsValue, JsValue> {
    let count = grid.width() * grid.height();
    if state.len() != count || gap.len() != count {
        return Err(of_grid(&GridError::Samples));
    }
    let mut most = most.map_or(usize::MAX, |most| most as usize);
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
