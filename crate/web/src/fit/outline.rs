//! Outlines as flat lists of numbers, and how near a fit is to one.

use frond_fit::{Fidelity, Outline, OutlineError, fidelity};
use glam::DVec2;
use js_sys::Float64Array;
use serde::Serialize;
use wasm_bindgen::JsValue;

use crate::boundary::error::failure;
use crate::boundary::value::write;

/// Points from a flat list x0, y0, x1, y1, ..
pub(super) fn points(list: &[f64]) -> Result<Vec<DVec2>, JsValue> {
    if !list.len().is_multiple_of(2) {
        return Err(failure("bad-input", "A list of points holds two numbers for each point."));
    }
    Ok(list.chunks_exact(2).map(DVec2::from_slice).collect())
}

pub(super) fn flat(points: &[DVec2]) -> JsValue {
    let numbers: Vec<f64> = points.iter().flat_map(|p| p.to_array()).collect();
    Float64Array::from(&numbers[..]).into()
}

pub(super) fn of_outline(error: &OutlineError) -> JsValue {
    failure(error.code(), &error.to_string())
}

pub(super) fn outline_of(flat: &[f64]) -> Result<Outline, JsValue> {
    Outline::new(&points(flat)?).map_err(|error| of_outline(&error))
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Figures {
    rms: f64,
    hausdorff: f64,
    length_ratio: f64,
    outline_slope: f64,
    fit_slope: f64,
}

impl From<Fidelity> for Figures {
    fn from(f: Fidelity) -> Self {
        let Fidelity { rms, hausdorff, length_ratio, outline_slope, fit_slope } = f;
        Self { rms, hausdorff, length_ratio, outline_slope, fit_slope }
    }
}

pub(super) fn figures(outline: &Outline, fit: &[DVec2]) -> Result<JsValue, JsValue> {
    write(&Figures::from(fidelity(outline, fit)))
}
