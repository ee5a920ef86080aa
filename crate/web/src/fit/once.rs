//! The fit in one call each, for pages that do not wait for it on the screen.

use frond_fit::{FirstPass, SecondPass};
use js_sys::{Object, Reflect};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::collage::collage_fit;
use super::curve::CurveFit;
use super::hough::{features, hough_clusters, peaks, read_options};
use super::trace::PictureTracer;
use crate::boundary::error::bad_input;
use crate::boundary::value::{object, read, write};

#[derive(Deserialize)]
#[serde(default)]
struct TraceOptions {
    threshold: f64,
    stalk: bool,
    component: usize,
}

impl Default for TraceOptions {
    fn default() -> Self {
        Self { threshold: 0.0, stalk: true, component: 0 }
    }
}

/// The outline of what a picture shows: `{ points, area, length, warnings }`, in pixels, y up, counter-clockwise.
///
/// `pixels`: red, green, blue and alpha, row after row from the top, 4194304 at most. `threshold` (-1 to 1) moves the
/// border between ground and leaf, `stalk: false` takes a stalk off, `component` is the piece, 0 the largest.
#[wasm_bindgen(js_name = traceOutline, unchecked_return_type = "TracedOutline")]
pub fn trace_outline(
    pixels: &[u8],
    width: usize,
    height: usize,
    #[wasm_bindgen(
        unchecked_optional_param_type = "{ threshold?: number; stalk?: boolean; component?: number }"
    )]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let TraceOptions { threshold, stalk, component } = read("The options", options)?;
    let mut tracer = PictureTracer::new(width, height, pixels)?;
    tracer.mask(object(&[
        ("threshold", threshold.into()),
        ("petiole", if stalk { "keep" } else { "remove" }.into()),
        ("strokes", js_sys::Array::new().into()),
    ]))?;
    tracer.outline(component)
}

#[derive(Deserialize)]
#[serde(default)]
struct FitOptions {
    model: String,
    numbers: u32,
    maps: usize,
    features: usize,
    separable: bool,
    tied: bool,
    partitioned: bool,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            model: "closed".to_owned(),
            numbers: 260,
            maps: 52,
            features: 261,
            separable: false,
            tied: false,
            partitioned: false,
        }
    }
}

/// A fit of an outline x0, y0, x1, y1, ..; one of 12 numbers takes about a tenth of a second, one of hundreds some
/// seconds. `model: "closed"` (the default) spends `numbers`, 12 to 2000, on a closed curve: `{ curve, points, figures,
/// bytes }`. `"collage"` is the fit of Cochran, Hart & Flynn with so many `maps`. Its types, which depend on the model,
/// are in `types.d.ts`.
#[wasm_bindgen(js_name = fitCurve, skip_typescript)]
pub fn fit_curve(outline: &[f64], options: JsValue) -> Result<JsValue, JsValue> {
    let FitOptions { model, numbers, maps, features, separable, tied, partitioned } =
        read("The options", options)?;
    match model.as_str() {
        "closed" => {
            let mut fit = CurveFit::new(outline, numbers)?;
            while !is_done(&fit.step(1000.0)) {}
            fit.measured()
        }
        "collage" => collage_fit(
            outline,
            object(&[
                ("maps", write(&maps)?),
                ("features", write(&features)?),
                ("separable", separable.into()),
                ("tied", tied.into()),
                ("partitioned", partitioned.into()),
            ]),
        ),
        _ => Err(bad_input("The model", "closed and collage are there")),
    }
}

fn is_done(progress: &JsValue) -> bool {
    Reflect::get(progress, &"done".into()).is_ok_and(|done| done.is_truthy())
}

/// The maps that a graph is made of, by both passes of the Hough transform: `{ found, space }`, the most hits first.
/// Feature points t0, x0, t1, x1, ..: domains are taken from `coarse`, ranges from `fine`.
#[wasm_bindgen(js_name = houghMaps, unchecked_return_type = "HoughClusters")]
pub fn hough_maps(
    coarse: &[f64],
    fine: &[f64],
    #[wasm_bindgen(unchecked_optional_param_type = "HoughOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    // It is read twice: an empty object stands for none.
    let options = if options.is_object() { options } else { Object::new().into() };
    let (domains, ranges, chosen) = (features(coarse)?, features(fine)?, read_options(options.clone())?);
    let mut first = FirstPass::new(&domains, &ranges, chosen, (0, 1));
    while first.step().share < 1.0 {}
    let mut second = SecondPass::new(&domains, &ranges, chosen, &first.promising(), (0, 1));
    while second.step().share < 1.0 {}
    hough_clusters(coarse, fine, options, &peaks(&second))
}
