//! How far two shapes are from each other.

use frond_core::HausdorffOptions;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;
use crate::boundary::value::{object, point, read, read_ifs, write};

/// The most comparisons that one call makes: some seconds.
const MOST_BUDGET: f64 = 1e8;

#[derive(Deserialize)]
struct Asked {
    tolerance: Option<f64>,
    budget: Option<f64>,
}

/// The Hausdorff distance of two attractors, between bounds.
#[wasm_bindgen(js_name = hausdorffDistance, unchecked_return_type = "HausdorffDistance")]
pub fn hausdorff_distance(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] a: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] b: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ tolerance?: number; budget?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let (a, b) = (read_ifs(&a)?, read_ifs(&b)?);
    let asked: Asked = read("The options", options)?;
    let mut options = HausdorffOptions::default();
    if let Some(tolerance) = asked.tolerance {
        if !(1e-9..=1.0).contains(&tolerance) {
            return Err(bad_input("tolerance", "a number from 1e-9 to 1 is needed"));
        }
        options.tolerance = tolerance;
    }
    if let Some(budget) = asked.budget {
        if !(0.0..=MOST_BUDGET).contains(&budget) {
            return Err(bad_input("budget", "a number from 0 to 1e8 is needed"));
        }
        options.budget = budget as usize;
    }
    let found = frond_core::hausdorff_distance(&a, &b, &options);
    Ok(object(&[
        ("lower", found.lower.into()),
        ("upper", found.upper.into()),
        ("points", write(&found.points.map(point))?),
    ]))
}
