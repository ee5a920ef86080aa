//! Fits of closed curves to outlines, and other ways to spend as many numbers.
//!
//! Outlines cross the boundary as flat arrays x0, y0, x1, y1, .. with y pointing up; the closing point is not repeated.

use frond_fit::{
    ArcCopy, ClosedCurve, CollageFit, CollageOptions, DRAWING_LEVELS, DRAWING_TOLERANCE, Fitter,
    MAX_PREPARED, Outline, PackError, bezier, crossings, features, fourier, island, least_squares_polyline,
    maple_leaf, noisy, oak_leaf, split_polyline, sugar_maple, white_oak,
};
use glam::DVec2;
use js_sys::Date;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use super::collage::of_collage;
use super::outline::{self, figures, flat, of_outline, outline_of};
use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{object, read, write};

/// An edge of a curve, as in `api.d.ts`.
#[derive(Serialize, Deserialize)]
struct PlainEdge {
    from: usize,
    span: usize,
    reversed: bool,
    c: f64,
}

#[derive(Serialize, Deserialize)]
struct PlainCurve {
    knots: Vec<[f64; 2]>,
    edges: Vec<Option<PlainEdge>>,
}

impl From<&ClosedCurve> for PlainCurve {
    fn from(curve: &ClosedCurve) -> Self {
        let edge = |copy: &ArcCopy| {
            let ArcCopy { from, span, reversed, c } = *copy;
            PlainEdge { from, span, reversed, c }
        };
        Self {
            knots: curve.knots.iter().map(|p| p.to_array()).collect(),
            edges: curve.edges.iter().map(|e| e.as_ref().map(edge)).collect(),
        }
    }
}

fn read_curve(value: JsValue) -> Result<ClosedCurve, JsValue> {
    let plain: PlainCurve = read("The curve", value)?;
    let edge = |PlainEdge { from, span, reversed, c }| ArcCopy { from, span, reversed, c };
    let curve = ClosedCurve {
        knots: plain.knots.into_iter().map(DVec2::from_array).collect(),
        edges: plain.edges.into_iter().map(|e| e.map(edge)).collect(),
    };
    if curve.is_sound() {
        Ok(curve)
    } else {
        Err(bad_input("The curve", "its copies do not shrink, or are not there"))
    }
}

/// An outline grown by program: a leaf as of a `"sugar-maple"` or a `"white-oak"`, a rougher star of five lobes,
/// `"maple"`, one of pointed lobes, `"oak"`, an `"island"`, or a maple leaf that was badly measured, `"noisy"`.
#[wasm_bindgen(js_name = grownOutline, unchecked_return_type = "Float64Array<ArrayBuffer>")]
pub fn grown_outline(kind: &str, seed: Option<u32>) -> Result<JsValue, JsValue> {
    let seed = seed.unwrap_or_default();
    match kind {
        "sugar-maple" => Ok(flat(&sugar_maple(seed))),
        "white-oak" => Ok(flat(&white_oak(seed))),
        "maple" => Ok(flat(&maple_leaf(seed))),
        "island" => Ok(flat(&island(seed))),
        "oak" => Ok(flat(&oak_leaf(seed))),
        "noisy" => Ok(flat(&noisy(&sugar_maple(seed), seed))),
        _ => Err(bad_input(
            "The kind of outline",
            "sugar-maple, white-oak, maple, oak, island and noisy are there",
        )),
    }
}

/// What is fitted of points: `{ points, diagonal, length, crossings }`, counter-clockwise, smoothed by 0 to 1 and of
/// 16384 points at most. `crossings` counts where it crosses itself, up to 99; null where it is too tangled to tell.
#[wasm_bindgen(js_name = prepareOutline, unchecked_return_type = "PreparedOutline")]
pub fn prepare_outline(points: &[f64], smoothing: f64) -> Result<JsValue, JsValue> {
    let outline =
        Outline::prepared(&outline::points(points)?, smoothing).map_err(|error| of_outline(&error))?;
    let crossed = crossings(outline.points(), 99).map(|found| found.len());
    Ok(object(&[
        ("points", flat(outline.points())),
        ("diagonal", outline.diagonal().into()),
        ("length", outline.length().into()),
        ("crossings", crossed.map_or(JsValue::NULL, |n| (n as f64).into())),
    ]))
}

/// `count` feature points of an outline, in order: polyline splitting.
#[wasm_bindgen(js_name = featurePoints, unchecked_return_type = "Float64Array<ArrayBuffer>")]
pub fn feature_points(points: &[f64], count: u32) -> Result<JsValue, JsValue> {
    let outline = outline_of(points)?;
    let marks: Vec<_> = features(&outline, count as usize).into_iter().map(|i| outline.points()[i]).collect();
    Ok(flat(&marks))
}

/// How near a curve is to an outline, as a link brings it back: `{ curve, points, figures, bytes }`; errors in percent
/// of the diagonal.
#[wasm_bindgen(js_name = measureCurve, unchecked_return_type = "MeasuredCurve")]
pub fn measure_curve(
    points: &[f64],
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
) -> Result<JsValue, JsValue> {
    measured(&outline_of(points)?, &read_curve(curve)?)
}

fn measured(outline: &Outline, curve: &ClosedCurve) -> Result<JsValue, JsValue> {
    let of_pack = |error: PackError| failure(error.code(), &error.to_string());
    let curve = curve.quantised().map_err(of_pack)?;
    // Four letters for three bytes.
    let bytes = 3 * curve.to_text().map_err(of_pack)?.len() / 4;
    let line = drawn(&curve, outline.diagonal());
    Ok(object(&[
        ("curve", write(&PlainCurve::from(&curve))?),
        ("points", flat(&line)),
        ("figures", figures(outline, &line)?),
        ("bytes", (bytes as f64).into()),
    ]))
}

fn drawn(curve: &ClosedCurve, diagonal: f64) -> Vec<DVec2> {
    curve.polyline(DRAWING_TOLERANCE * diagonal, DRAWING_LEVELS)
}

/// Fits a closed curve to an outline, for a while at a time.
#[wasm_bindgen]
pub struct CurveFit {
    outline: Outline,
    fitter: Fitter,
}

#[wasm_bindgen]
impl CurveFit {
    /// `numbers`: 12 to 2000. From the start on there is a fit.
    #[wasm_bindgen(constructor)]
    pub fn new(points: &[f64], numbers: u32) -> Result<CurveFit, JsValue> {
        let outline = outline_of(points)?;
        let fitter = Fitter::new(&outline, numbers as usize)
            .map_err(|error| failure(error.code(), &error.to_string()))?;
        Ok(Self { outline, fitter })
    }

    /// Goes on for some milliseconds, one step at least: `{ stage, share, rms, done }`.
    #[wasm_bindgen(
        unchecked_return_type = "{ stage: \"straight\" | \"copies\" | \"trade\" | \"polish\"; share: number; rms: number; done: boolean }"
    )]
    pub fn step(&mut self, milliseconds: f64) -> JsValue {
        let end = Date::now() + milliseconds;
        let mut progress = self.fitter.step();
        while !self.fitter.is_done() && Date::now() < end {
            progress = self.fitter.step();
        }
        object(&[
            ("stage", progress.stage.name().into()),
            ("share", progress.share.into()),
            ("rms", progress.rms.into()),
            ("done", self.fitter.is_done().into()),
        ])
    }

    /// The best so far: `{ curve, points }`, the points those of a polyline.
    #[wasm_bindgen(unchecked_return_type = "{ curve: Curve; points: Float64Array<ArrayBuffer> }")]
    pub fn best(&self) -> Result<JsValue, JsValue> {
        let curve = &self.fitter.best().curve;
        let line = drawn(curve, self.outline.diagonal());
        Ok(object(&[("curve", write(&PlainCurve::from(curve))?), ("points", flat(&line))]))
    }

    /// The best so far with its figures, as [`measure_curve`] has them.
    #[wasm_bindgen(unchecked_return_type = "MeasuredCurve")]
    pub fn measured(&self) -> Result<JsValue, JsValue> {
        measured(&self.outline, &self.fitter.best().curve)
    }
}

/// Another way to spend `numbers` on an outline, for comparison: `{ numbers, points, figures }`.
///
/// `"split"`: a polyline through feature points; `"squares"`: one whose corners were moved by least squares;
/// `"fourier"`: the lowest frequencies; `"bezier"`: cubic segments, 6 numbers each; `"collage"`: the fit of Cochran,
/// Hart & Flynn, with 9 intervals a map as in their Fig 7.
#[wasm_bindgen(js_name = rivalFit, unchecked_return_type = "RivalFit")]
pub fn rival_fit(points: &[f64], method: &str, numbers: u32) -> Result<JsValue, JsValue> {
    let outline = outline_of(points)?;
    let numbers = (numbers as usize).clamp(12, 2000);
    let (spent, line) = match method {
        "split" => counted(split_polyline(&outline, numbers)),
        "squares" => counted(least_squares_polyline(&outline, numbers)),
        "fourier" => {
            let terms = 2 * (numbers / 2);
            (terms, fourier(&outline, terms, (8 * outline.points().len()).min(MAX_PREPARED)))
        }
        "bezier" => {
            let pieces = (numbers / 6).max(3);
            (6 * pieces, bezier(&outline, numbers, (8 * outline.points().len()).min(MAX_PREPARED)))
        }
        "collage" => {
            let options = CollageOptions { maps: (numbers / 10).max(2), ..CollageOptions::default() };
            let fit = CollageFit::of(&outline, 9 * options.maps, &options).map_err(of_collage)?;
            (fit.numbers(), fit.pieces().concat())
        }
        _ => return Err(bad_input("The method", "split, squares, fourier, bezier and collage are there")),
    };
    Ok(object(&[
        ("numbers", (spent as f64).into()),
        ("points", flat(&line)),
        ("figures", figures(&outline, &line)?),
    ]))
}

fn counted(line: Vec<DVec2>) -> (usize, Vec<DVec2>) {
    (2 * line.len(), line)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_comes_back_from_its_plain_form() {
        let outline = Outline::new(&oak_leaf(1)).unwrap();
        let curve = Fitter::new(&outline, 40).unwrap().best().curve.clone();
        let plain = PlainCurve::from(&curve);
        assert_eq!(plain.knots.len(), curve.knots.len());
        assert_eq!(plain.edges.len(), curve.edges.len());
    }
}
