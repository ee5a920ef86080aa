//! Whether a shape is in one piece.

use frond_core::{Ifs, IfsError};
use frond_locus::{Connectedness, Options};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::of_ifs;
use crate::value::{object, point, read, read_maps, write};

#[derive(Deserialize)]
struct Resolution {
    epsilon: Option<f64>,
    budget: Option<f64>,
}

/// Whether the attractor is connected, which of its pieces meet, and how wide the widest gap is. Maps without
/// an attractor get the verdict `no-attractor`.
#[wasm_bindgen(unchecked_return_type = "Connectedness")]
pub fn connectedness(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ epsilon?: number; budget?: number } | undefined")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let resolution: Resolution = read("The options", options)?;
    let mut options = Options::default();
    if let Some(epsilon) = resolution.epsilon {
        options.epsilon = epsilon;
    }
    if let Some(budget) = resolution.budget {
        options.budget = budget as usize;
    }
    match Ifs::new(read_maps(&ifs)?) {
        Ok(ifs) => answer(&frond_locus::connectedness(&ifs, &options)),
        Err(IfsError::NoAttractor { .. } | IfsError::Unproved) => Ok(object(&[
            ("verdict", "no-attractor".into()),
            ("gap", object(&[("lower", 0.0.into()), ("upper", f64::INFINITY.into())])),
            ("overlaps", js_sys::Array::new().into()),
            ("components", js_sys::Array::new().into()),
            ("count", 0.into()),
            ("diameter", f64::INFINITY.into()),
            ("nodes", 0.into()),
        ])),
        Err(error) => Err(of_ifs(&error)),
    }
}

fn answer(found: &Connectedness) -> Result<JsValue, JsValue> {
    let mut fields = vec![
        ("verdict", found.verdict.name().into()),
        ("gap", object(&[("lower", found.gap.lower.into()), ("upper", found.gap.upper.into())])),
        ("overlaps", write(&found.overlaps)?),
        ("components", write(&found.components)?),
        ("count", (found.count as f64).into()),
        ("diameter", found.diameter.into()),
        ("nodes", (found.nodes as f64).into()),
    ];
    if let Some((from, to)) = found.closest {
        fields.push(("closest", object(&[("from", write(&point(from))?), ("to", write(&point(to))?)])));
    }
    Ok(object(&fields))
}
