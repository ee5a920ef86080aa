//! Paths proved from end to end.

use frond_locus::{CertifyOptions, PathCertificate};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;
use crate::boundary::path::read_path;
use crate::boundary::value::{object, read, read_morph};

#[derive(Deserialize)]
struct Certifying {
    within: Option<f64>,
    t0: Option<f64>,
    t1: Option<f64>,
    budget: Option<f64>,
}

/// The most boxes that one call looks at: some minutes at worst.
const MOST_BOXES: f64 = 200_000.0;

/// Proves as small a bound of the widest gap along a stretch of a path as it can: at one moment where t0 is t1. Long
/// work: call it in a worker, a stretch at a time.
#[wasm_bindgen(js_name = certifyPath, unchecked_return_type = "PathCertificate")]
pub fn certify_path(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "readonly PathPoint[]")] points: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "CertifyOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let plain: Certifying = read("The options", options)?;
    let points = read_path(points)?;
    let default = CertifyOptions::default();
    let within = plain.within.unwrap_or(default.within);
    let (t0, t1) = (plain.t0.unwrap_or(default.t0), plain.t1.unwrap_or(default.t1));
    if within.is_nan() || t0.is_nan() || t1.is_nan() {
        return Err(bad_input("The options", "its numbers must not be NaN"));
    }
    let asked = CertifyOptions { within, t0, t1, ..default };
    if asked.stretch().is_none() {
        let why = "t0 must not be above t1, and some of the path from 0 to 1 must lie between them";
        return Err(bad_input("The options", why));
    }
    let budget = plain.budget.map_or(default.budget, |budget| budget.clamp(0.0, MOST_BOXES) as usize);
    let proved = frond_locus::certify_path(&morph, &points, &CertifyOptions { budget, ..asked });
    let PathCertificate { gap, holds, boxes, worst, complete, joints } = proved;
    Ok(object(&[
        ("gap", gap.into()),
        ("holds", holds.into()),
        ("boxes", (boxes as f64).into()),
        ("worst", worst.into()),
        ("complete", complete.into()),
        ("joints", (joints as f64).into()),
    ]))
}
