//! Exact numbers: formulas, proofs about what they mean, and what neighbours tell.

use frond_core::{MAX_MAPS, MAX_STATES};
use frond_exact::{
    Analysis, Dimension, DoubleMap, ExactNumber, ExactNumbers, MOST_NUMBERS, OpenSetCondition, Reason,
    Settings, System,
};
use frond_locus::ExactProof;
use js_sys::Array;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::evidence::write_reason;
use crate::boundary::resolution::read_options;
use crate::boundary::value::{object, read, read_maps, rows, write};

/// Pairs of pieces that are looked at for a proof: a second or two where numbers are long.
const MOST_PAIRS: usize = 3000;
/// The most pairs of pieces that one search looks at: some seconds.
const MOST_BUDGET: f64 = 1e6;

/// Reads formulas, one by one.
#[wasm_bindgen(js_name = readNumbers, unchecked_return_type = "ReadNumber[]")]
pub fn read_numbers(
    #[wasm_bindgen(unchecked_param_type = "string[]")] formulas: JsValue,
) -> Result<JsValue, JsValue> {
    let one = |formula: &String| match ExactNumber::read(formula) {
        Ok(number) => {
            let text = number.text().unwrap_or_else(|| formula.clone());
            object(&[("value", number.value().into()), ("text", text.into())])
        }
        Err(error) => object(&[("problem", error.to_string().into())]),
    };
    Ok(read_formulas(&formulas)?.iter().map(one).collect::<Array>().into())
}

/// Longer lists than allowed are refused before their entries are read.
fn read_formulas(list: &JsValue) -> Result<Vec<String>, JsValue> {
    let count = list.dyn_ref::<Array>().map_or(0, Array::length) as usize;
    if count > MOST_NUMBERS {
        return Err(bad_input("The list of numbers", &format!("it has more than {MOST_NUMBERS} entries")));
    }
    read("The list of numbers", list.clone())
}

fn read_exact(numbers: &JsValue) -> Result<ExactNumbers, JsValue> {
    ExactNumbers::read(&read_formulas(numbers)?)
        .map_err(|wrong| failure(wrong.error.code(), &wrong.to_string()))
}

/// A proof that the attractor is in one piece, or in several, about the numbers that its entries mean.
#[wasm_bindgen(js_name = proveExact, unchecked_return_type = "ExactProof")]
pub fn prove_exact(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "string[]")] numbers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ epsilon?: number; budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let maps = rows(&read_maps(&ifs)?);
    let (numbers, options) = (read_exact(&numbers)?, read_options(options)?);
    match frond_locus::prove_exact(&maps, &numbers, &options, MOST_PAIRS) {
        ExactProof::Connected { reason, certificate } => Ok(object(&[
            ("state", "connected".into()),
            ("reason", write_reason(&reason)?),
            ("certificate", write(&certificate)?),
        ])),
        ExactProof::Disconnected { certificate } => {
            Ok(object(&[("state", "disconnected".into()), ("certificate", write(&certificate)?)]))
        }
        ExactProof::Undecided(why) => {
            Ok(object(&[("state", "undecided".into()), ("why", why.to_string().into())]))
        }
        _ => Ok(object(&[("state", "undecided".into()), ("why", "No proof was found.".into())])),
    }
}

#[derive(Deserialize)]
struct AnalysisOptions {
    budget: Option<f64>,
}

/// What the ways in which pieces touch tell of a shape: open set condition, dimension, inner points, boundary.
#[wasm_bindgen(unchecked_return_type = "Analysis")]
pub fn analyze(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "string[]")] numbers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let maps = rows(&read_maps(&ifs)?);
    let AnalysisOptions { budget } = read("The options", options)?;
    let mut settings = Settings::default();
    if let Some(budget) = budget {
        if !(1.0..=MOST_BUDGET).contains(&budget) {
            return Err(bad_input("budget", "a number from 1 to 1e6 is needed"));
        }
        settings.budget = budget as usize;
    }
    let wrong = |error: frond_exact::ExactError| failure(error.code(), &error.to_string());
    let system = read_exact(&numbers)?.system(&maps).map_err(wrong)?;
    let analysis = frond_exact::analyze(&system, settings, |_| true).map_err(wrong)?;
    write_analysis(&analysis)
}

#[derive(Serialize)]
struct PlainDimension {
    value: f64,
    lower: f64,
    upper: f64,
    proved: bool,
    exact: Option<String>,
}

impl From<&Dimension> for PlainDimension {
    fn from(found: &Dimension) -> Self {
        let Dimension { value, lower, upper, is_proved: proved, ref exact } = *found;
        Self { value, lower, upper, proved, exact: exact.clone() }
    }
}

fn write_analysis(found: &Analysis) -> Result<JsValue, JsValue> {
    let condition = match found.open_set_condition {
        OpenSetCondition::Yes => "yes",
        OpenSetCondition::No => "no",
        OpenSetCondition::Undecided => "undecided",
    };
    let dimension = found.dimension.as_ref().map(PlainDimension::from);
    let boundary = found.boundary.as_ref();
    let boundary = match boundary.map(|boundary| PlainDimension::from(&boundary.dimension)) {
        Some(dimension) => {
            let states = found.boundary.as_ref().and_then(|boundary| drawn(&boundary.system));
            object(&[("dimension", write(&dimension)?), ("states", write(&states)?)])
        }
        None => JsValue::NULL,
    };
    Ok(object(&[
        ("openSetCondition", condition.into()),
        ("neighbours", found.neighbours.map_or(JsValue::NULL, |count| (count as u32).into())),
        ("dimension", write(&dimension)?),
        ("boundary", boundary),
        ("innerPoints", found.has_inner_points.map_or(JsValue::NULL, JsValue::from)),
        ("reasons", found.reasons.iter().map(reason).collect::<Array>().into()),
    ]))
}

#[derive(Serialize)]
struct PlainMap {
    from: usize,
    map: [f64; 6],
}

/// A system of the plane as a graph-directed shape, if a document can hold it.
fn drawn(system: &System) -> Option<Vec<Vec<PlainMap>>> {
    let states = system.without_copies().filter(|system| system.dimension() == 2)?.in_doubles();
    let fits = states.len() <= MAX_STATES && states.iter().all(|maps| maps.len() <= MAX_MAPS);
    let plain = |map: DoubleMap| {
        let ([[a, b, ..], [c, d, ..], ..], [e, f, ..]) = (map.matrix, map.shift);
        PlainMap { from: map.from, map: [a, b, c, d, e, f] }
    };
    fits.then(|| states.into_iter().map(|maps| maps.into_iter().map(plain).collect()).collect())
}

fn reason(reason: &Reason) -> JsValue {
    let counted =
        |kind: &str, count: usize| object(&[("kind", kind.into()), ("count", (count as u32).into())]);
    let plain = |kind: &str| object(&[("kind", kind.into())]);
    match reason {
        Reason::FiniteType => plain("finite-type"),
        Reason::ExactOverlap(overlap) => {
            let words = write(&[&overlap.first, &overlap.second]).unwrap_or(JsValue::NULL);
            object(&[("kind", "exact-overlap".into()), ("words", words)])
        }
        Reason::TypesCounted { types } => counted("types-counted", *types),
        Reason::FullDimension => plain("full-dimension"),
        Reason::BudgetSpent { pairs } => counted("budget-spent", *pairs),
        Reason::NotSimilar => plain("not-similar"),
        Reason::NotStronglyConnected => plain("not-strongly-connected"),
        Reason::RatiosDiffer => plain("ratios-differ"),
        Reason::NotShrinking => plain("not-shrinking"),
        _ => plain("other"),
    }
}
