//! Curves of corners and parabolas within so many bytes, and other ways to spend as many.

use frond_fit::{
    LEAST_BYTES, MOST_BYTES, Outline, Spline, SplineError, SplineFit as Found, SplineFitter, bezier_within,
    fidelity, fourier_within, polyline_within,
};
use glam::DVec2;
use js_sys::{Date, Uint8Array};
use wasm_bindgen::prelude::*;

use super::outline::{figures, flat, outline_of};
use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::object;

/// Sides of a parabola where a curve is measured and drawn.
const SIDES: usize = 16;

fn of_spline(error: SplineError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn within(bytes: u32) -> Result<usize, JsValue> {
    let bytes = bytes as usize;
    if (LEAST_BYTES..=MOST_BYTES).contains(&bytes) {
        Ok(bytes)
    } else {
        Err(bad_input("bytes", &format!("a number from {LEAST_BYTES} to {MOST_BYTES} is needed")))
    }
}

/// A fit as `SplineFit.measured` gives it.
fn told(outline: &Outline, spline: &Spline) -> Result<JsValue, JsValue> {
    let bytes = spline.to_bytes().map_err(of_spline)?;
    let line = spline.polyline(SIDES);
    Ok(object(&[
        ("word", spline.to_text().map_err(of_spline)?.into()),
        ("bytes", Uint8Array::from(&bytes[..]).into()),
        ("corners", spline.corners().into()),
        ("bends", (spline.nodes.len() - spline.corners()).into()),
        ("points", flat(&line)),
        ("figures", figures(outline, &line)?),
    ]))
}

/// Fits a curve of corners and parabolas within so many bytes to an outline, for a while at a time.
#[wasm_bindgen]
pub struct SplineFit {
    outline: Outline,
    fitter: SplineFitter,
}

#[wasm_bindgen]
impl SplineFit {
    /// `bytes`: 32 to 4000, everything counted.
    #[wasm_bindgen(constructor)]
    pub fn new(points: &[f64], bytes: u32) -> Result<SplineFit, JsValue> {
        let bytes = within(bytes)?;
        let outline = outline_of(points)?;
        Ok(Self { fitter: SplineFitter::new(&outline, bytes), outline })
    }

    /// Goes on for some milliseconds, one step at least: `{ share, done }`, the share from 0 to 1.
    #[wasm_bindgen(unchecked_return_type = "{ share: number; done: boolean }")]
    pub fn step(&mut self, milliseconds: f64) -> JsValue {
        let end = Date::now() + milliseconds;
        self.fitter.step();
        while !self.fitter.is_done() && Date::now() < end {
            self.fitter.step();
        }
        object(&[("share", self.fitter.share().into()), ("done", self.fitter.is_done().into())])
    }

    /// The best so far: `{ word, points, rms }`, the points those of a polyline, its error in percent of the diagonal;
    /// undefined where there is none yet.
    #[wasm_bindgen(
        unchecked_return_type = "{ word: string; points: Float64Array<ArrayBuffer>; rms: number } | undefined"
    )]
    pub fn best(&self) -> Result<JsValue, JsValue> {
        let Some(Found { spline, near, .. }) = self.fitter.best() else { return Ok(JsValue::UNDEFINED) };
        Ok(object(&[
            ("word", spline.to_text().map_err(of_spline)?.into()),
            ("points", flat(&spline.polyline(SIDES))),
            ("rms", near.rms.into()),
        ]))
    }

    /// The best so far as [`fit_within`] has it.
    ///
    /// Where nothing was found, the outline is too thin for a grid of so few bytes.
    #[wasm_bindgen(
        unchecked_return_type = "{ word: string; bytes: Uint8Array<ArrayBuffer>; corners: number; bends: number; points: Float64Array<ArrayBuffer>; figures: FitFigures }"
    )]
    pub fn measured(&self) -> Result<JsValue, JsValue> {
        let Some(Found { spline, .. }) = self.fitter.best() else {
            return Err(failure(
                "no-fit",
                "No curve was found within so many bytes: the outline is too thin, or too far from the origin. Allow more bytes.",
            ));
        };
        told(&self.outline, &spline)
    }
}

/// The nearest curve of corners and parabolas that is found within so many bytes (32 to 4000, everything counted):
/// `{ word, bytes, corners, bends, points, figures }`. `unpackSpline` reads the bytes, and the word, which is the same
/// in letters. `points` are those of a polyline, errors in percent of the diagonal. An outline
/// of few corners is fitted at once, another one in some seconds.
#[wasm_bindgen(
    js_name = fitWithin,
    unchecked_return_type = "{ word: string; bytes: Uint8Array<ArrayBuffer>; corners: number; bends: number; points: Float64Array<ArrayBuffer>; figures: FitFigures }"
)]
pub fn fit_within(outline: &[f64], bytes: u32) -> Result<JsValue, JsValue> {
    let mut fit = SplineFit::new(outline, bytes)?;
    while !fit.fitter.is_done() {
        fit.fitter.step();
    }
    fit.measured()
}

/// How near a curve of corners and parabolas, given as a word, is to an outline: as [`fit_within`] has it.
#[wasm_bindgen(
    js_name = measureSpline,
    unchecked_return_type = "{ word: string; bytes: Uint8Array<ArrayBuffer>; corners: number; bends: number; points: Float64Array<ArrayBuffer>; figures: FitFigures }"
)]
pub fn measure_spline(points: &[f64], word: &str) -> Result<JsValue, JsValue> {
    told(&outline_of(points)?, &Spline::from_text(word).map_err(of_spline)?)
}

/// Another way to spend so many bytes on an outline: `{ points, rms }`; undefined where nothing fits into them.
///
/// `"squares"`: the nearest polyline that is found, its corners those of the outline or moved by least squares, in the
/// form of [`fit_within`], all counted; it crosses itself nowhere but where the outline does, and a fit begins with it;
/// `"fourier"`: the lowest frequencies; `"bezier"`: cubic segments. The bits of the latter two are what an ideal coder
/// of fitting laws comes to, and the width of their grid is not counted. Each is on the grid by which it is nearest.
#[wasm_bindgen(
    js_name = rivalWithin,
    unchecked_return_type = "{ points: Float64Array<ArrayBuffer>; rms: number } | undefined"
)]
pub fn rival_within(points: &[f64], method: &str, bytes: u32) -> Result<JsValue, JsValue> {
    let bytes = within(bytes)?;
    let outline = outline_of(points)?;
    let line: Option<Vec<DVec2>> = match method {
        "squares" => polyline_within(&outline, bytes),
        "fourier" => fourier_within(&outline, bytes),
        "bezier" => bezier_within(&outline, bytes),
        _ => return Err(bad_input("The method", "squares, fourier and bezier are there")),
    };
    let Some(line) = line else { return Ok(JsValue::UNDEFINED) };
    Ok(object(&[("points", flat(&line)), ("rms", fidelity(&outline, &line).rms.into())]))
}
