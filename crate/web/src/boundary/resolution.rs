//! How finely a verdict is looked for.

use frond_locus::Options;
use serde::Deserialize;
use wasm_bindgen::JsValue;

use super::value::read;

#[derive(Deserialize)]
struct Resolution {
    epsilon: Option<f64>,
    budget: Option<f64>,
}

/// The options of a verdict.
pub(crate) fn read_options(options: JsValue) -> Result<Options, JsValue> {
    let resolution: Resolution = read("The options", options)?;
    let mut options = Options::default();
    if let Some(epsilon) = resolution.epsilon {
        options.epsilon = epsilon;
    }
    if let Some(budget) = resolution.budget {
        options.budget = budget as usize;
    }
    Ok(options)
}
