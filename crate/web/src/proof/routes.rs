//! Ways from one shape to another: which map becomes which, and what maps they may have.

use frond_core::{Candidate, Morph, Route};
use frond_locus::RateOptions;
use js_sys::Array;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{failure, of_morph};
use crate::boundary::grid::write_samples;
use crate::boundary::path::write_plan;
use crate::boundary::value::{object, read, read_ifs, read_morph, rows, write};

/// How many candidates are listed unless told.
const USUAL_CANDIDATES: f64 = 12.0;
/// The most candidates of one list.
const MOST_CANDIDATES: f64 = 1000.0;

#[derive(Deserialize)]
struct Listing {
    limit: Option<f64>,
}

/// Ways to match the maps of two systems of equally many, the plainest first; the given order is always among them.
#[wasm_bindgen(unchecked_return_type = "Candidate[]")]
pub fn candidates(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ limit?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let (from, to) = (read_ifs(&from)?, read_ifs(&to)?);
    let plain: Listing = read("The options", options)?;
    let limit = plain.limit.unwrap_or(USUAL_CANDIDATES).clamp(1.0, MOST_CANDIDATES) as usize;
    let found = frond_core::candidates(&from, &to, limit).map_err(|error| of_morph(&error))?;
    let list = Array::new();
    for candidate in &found {
        list.push(&object(&matching(candidate)?));
    }
    Ok(list.into())
}

fn matching(candidate: &Candidate) -> Result<Vec<(&'static str, JsValue)>, JsValue> {
    Ok(vec![
        ("correspondence", write(&candidate.correspondence)?),
        ("turns", write(&candidate.turns)?),
        ("cost", candidate.cost.into()),
    ])
}

#[derive(Deserialize)]
struct Rating {
    #[serde(default)]
    correspondence: Vec<usize>,
    #[serde(default)]
    turns: Vec<i32>,
    size: Option<f64>,
    epsilon: Option<f64>,
}

/// A way to match the maps with its best path and a small locus, which is computed on the way: work for a worker, but
/// of a tenth of a second rather than of seconds.
#[wasm_bindgen(js_name = rateCandidate, unchecked_return_type = "RatedCandidate")]
pub fn rate_candidate(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MorphOptions & { size?: number; epsilon?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph: Morph = read_morph(&from, &to, &options)?;
    let (from, to) = (read_ifs(&from)?, read_ifs(&to)?);
    let plain: Rating = read("The options", options)?;
    let candidate =
        Candidate::of(&from, &to, plain.correspondence, plain.turns).map_err(|error| of_morph(&error))?;
    let mut options = RateOptions::default();
    if let Some(size) = plain.size {
        // A cast of NaN or a negative number gives 0, the least there is.
        options.size = size as usize;
    }
    if let Some(epsilon) = plain.epsilon {
        options.epsilon = epsilon;
    }
    let rated =
        frond_locus::rate(&morph, &options).map_err(|error| failure(error.code(), &error.to_string()))?;
    let grid = *rated.locus.grid();
    let (state, gap) = rated.locus.into_parts();
    let mut fields = matching(&candidate)?;
    fields.extend([
        ("plan", write_plan(&rated.plan)?),
        ("share", rated.share.into()),
        ("locus", write_samples(grid.width(), grid.height(), &state, &gap)),
    ]);
    Ok(object(&fields))
}

/// Ways to bring two shapes to a morph, whatever numbers of maps they have: what happens if nothing is chosen, then the
/// others.
#[wasm_bindgen(unchecked_return_type = "Route[]")]
pub fn routes(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
) -> Result<JsValue, JsValue> {
    let list = Array::new();
    for route in frond_core::routes(&read_ifs(&from)?, &read_ifs(&to)?) {
        list.push(&write_route(&route)?);
    }
    Ok(list.into())
}

/// The most ways of one list.
const MOST_WAYS: f64 = 1000.0;
/// How many are listed unless told.
const USUAL_WAYS: f64 = 200.0;

/// All ways that are worth being looked at where the plain one breaks, the most promising first: other matchings and
/// windings, pieces split otherwise, the last shape laid elsewhere, and first the one that keeps joints joined, where
/// both shapes are chains of pieces.
#[wasm_bindgen(unchecked_return_type = "Route[]")]
pub fn ways(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ limit?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let plain: Listing = read("The options", options)?;
    let limit = plain.limit.unwrap_or(USUAL_WAYS).clamp(1.0, MOST_WAYS) as usize;
    let list = Array::new();
    for route in frond_core::ways(&read_ifs(&from)?, &read_ifs(&to)?, limit) {
        list.push(&write_route(&route)?);
    }
    Ok(list.into())
}

fn write_route(route: &Route) -> Result<JsValue, JsValue> {
    let mut fields = vec![
        ("kind", route.kind.name().into()),
        ("about", (&*route.about).into()),
        ("from", write(&rows(&route.from))?),
        ("to", write(&rows(&route.to))?),
        ("fromProbabilities", write(&route.from_probabilities)?),
        ("toProbabilities", write(&route.to_probabilities)?),
        ("correspondence", write(&route.correspondence)?),
        ("turns", write(&route.turns)?),
        ("cost", route.cost.into()),
    ];
    if let Some(mode) = route.mode {
        fields.push(("mode", write(&mode)?));
    }
    if let Some(place) = route.place {
        fields.push(("place", write(&place.to_row())?));
    }
    Ok(object(&fields))
}
