//! The morph of closed curves, and its bend.

use frond_deform::{RingBend, Settings};
use frond_fit::MorphedCurve;
use glam::DVec2;
use js_sys::{Float64Array, Int32Array, Uint32Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::read::{of_morph, read_curve};
use crate::boundary::bend::{PlainBend, of_bend};
use crate::boundary::error::bad_input;
use crate::boundary::value::{object, read, write};

/// The most points that one call gives, and how many it gives where nothing is said.
const MAX_POINTS: f64 = 1_048_576.0;
const USUAL_POINTS: f64 = 65_536.0;

#[derive(Deserialize)]
struct View {
    tolerance: f64,
    #[serde(default)]
    window: Option<[f64; 4]>,
    #[serde(default)]
    bend: Option<PlainBend>,
    #[serde(default)]
    most: Option<f64>,
}

impl View {
    fn read(value: JsValue) -> Result<(Self, usize), JsValue> {
        let view: Self = read("The view", value)?;
        if !(view.tolerance >= 0.0 && view.tolerance.is_finite()) {
            return Err(bad_input("tolerance", "a number from 0 on is needed"));
        }
        if let Some([left, bottom, right, top]) = view.window
            && !(left <= right && bottom <= top && (right - left).is_finite() && (top - bottom).is_finite())
        {
            return Err(bad_input("window", "left, bottom, right and top are needed, the smaller first"));
        }
        let most = view.most.unwrap_or(USUAL_POINTS);
        if !(3.0..=MAX_POINTS).contains(&most) {
            return Err(bad_input("most", "a number from 3 to 1048576 is needed"));
        }
        Ok((view, most as usize))
    }
}

/// A polyline at rest, and what it was asked for with.
struct Line {
    tolerance: f64,
    window: Option<[f64; 4]>,
    most: usize,
    points: Vec<(f64, DVec2)>,
}

/// The curve at one moment, and what was made of it.
struct Moment {
    s: f64,
    morphed: MorphedCurve,
    line: Option<Line>,
    ring: Option<(PlainBend, RingBend)>,
    /// The parameters of the points that were given last.
    given: Vec<f64>,
}

impl Moment {
    /// The polyline at rest; the last one where the same is asked for again.
    fn line(&mut self, tolerance: f64, window: Option<[f64; 4]>, most: usize) -> &[(f64, DVec2)] {
        let same = |line: &Line| line.tolerance == tolerance && line.window == window && line.most == most;
        if !self.line.as_ref().is_some_and(same) {
            self.line = None;
        }
        let morphed = &self.morphed;
        let line = self.line.get_or_insert_with(|| {
            let points = morphed.trace(tolerance, window, most);
            Line { tolerance, window, most, points }
        });
        &line.points
    }

    /// The bend: only moved where all but the mesh is as it was.
    fn bend(&mut self, plain: PlainBend) -> Result<&RingBend, JsValue> {
        let kept = self.ring.take().filter(|(last, _)| last.same_but_moved(&plain));
        let ring = match kept {
            Some((last, ring)) if last == plain => ring,
            Some((_, mut ring)) => {
                // Reading it again tells what is wrong with the new mesh.
                plain.parts()?;
                ring.set_mesh(&plain.displacements()).map_err(|error| of_bend(&error))?;
                ring
            }
            None => {
                let (mesh, settings, _) = plain.parts()?;
                let grid = self.morphed.grid(points(&settings)?);
                RingBend::new(mesh, settings, &grid).map_err(|error| of_bend(&error))?
            }
        };
        Ok(&self.ring.insert((plain, ring)).1)
    }
}

fn points(settings: &Settings) -> Result<usize, JsValue> {
    RingBend::points(settings).map_err(|error| of_bend(&error))
}

/// One closed curve, or two brought to one structure: closed at every s from 0, the first, to 1, the second.
///
/// What was made for the last picture is kept: moving the mesh of a bend, or the view, does not do the rest again.
#[wasm_bindgen]
pub struct CurveMorph {
    morph: frond_fit::CurveMorph,
    moment: Option<Moment>,
}

#[wasm_bindgen]
impl CurveMorph {
    /// One curve, or two that are brought to one structure without changing either.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Curve")] a: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "Curve | null")] b: JsValue,
    ) -> Result<CurveMorph, JsValue> {
        let a = read_curve(&a)?;
        let b = if b.is_null() || b.is_undefined() { None } else { Some(read_curve(&b)?) };
        let morph = frond_fit::CurveMorph::new(&a, b.as_ref()).map_err(of_morph)?;
        Ok(Self { morph, moment: None })
    }

    fn at(&mut self, s: f64) -> Result<&mut Moment, JsValue> {
        if !s.is_finite() {
            return Err(bad_input("s", "a number from 0 to 1 is needed"));
        }
        let s = s.clamp(0.0, 1.0);
        if self.moment.as_ref().is_none_or(|moment| moment.s != s) {
            self.moment = None;
        }
        let morph = &self.morph;
        let fresh = || Moment { s, morphed: morph.at(s), line: None, ring: None, given: Vec::new() };
        Ok(self.moment.get_or_insert_with(fresh))
    }

    /// The curve as a closed polyline x0, y0, x1, y1, .., the first point not repeated.
    ///
    /// It leaves the curve by the tolerance at most inside the window, or by as little as `most` points allow, and is
    /// coarse outside. A bend displaces it by the base-4 digits of its parameter; its tint, spin and continuity do not
    /// count, and detail above 9 counts as 9.
    #[wasm_bindgen]
    pub fn polyline(
        &mut self,
        s: f64,
        #[wasm_bindgen(
            unchecked_param_type = "{ tolerance: number; window?: [minX: number, minY: number, maxX: number, maxY: number]; bend?: Bend | null; most?: number }"
        )]
        view: JsValue,
    ) -> Result<Float64Array, JsValue> {
        let (View { tolerance, window, bend, .. }, most) = View::read(view)?;
        let moment = self.at(s)?;
        let points = match bend {
            None => moment.line(tolerance, window, most).to_vec(),
            Some(bend) => {
                let [left, bottom, right, top] = moment.morphed.bounds();
                let (low, high) = (DVec2::new(left, bottom), DVec2::new(right, top));
                let mesh = moment.bend(bend)?.mesh();
                // What may come into the window. Doubling makes the line at rest last while the mesh is moved.
                let reach = mesh.reach(low, high).log2().ceil().exp2();
                let rest = window.map(|[a, b, c, d]| [a - reach, b - reach, c + reach, d + reach]);
                moment.line(0.5 * tolerance, rest, most);
                let (Some(line), Some((_, ring))) = (&moment.line, &moment.ring) else {
                    return Ok(Float64Array::new_with_length(0));
                };
                ring.corners(&line.points, 0.5 * tolerance, window, most)
            }
        };
        moment.given = points.iter().map(|&(t, _)| t).collect();
        let flat: Vec<f64> = points.into_iter().flat_map(|(_, p)| p.to_array()).collect();
        Ok(Float64Array::from(&flat[..]))
    }

    /// For each point of the polyline that was given last the edge that goes on from there, by the knot it begins at.
    #[wasm_bindgen]
    pub fn edges(&self) -> Uint32Array {
        let edges: Vec<u32> = self.moment.as_ref().map_or(Vec::new(), |moment| {
            moment.given.iter().map(|&t| moment.morphed.edge_at(t) as u32).collect()
        });
        Uint32Array::from(&edges[..])
    }

    /// For each edge what it copies at either end of the morph: for each the first knot and the number of edges of the
    /// arc, -1 and 0 where it is straight there. Four numbers an edge.
    #[wasm_bindgen]
    pub fn arcs(&self) -> Int32Array {
        let flat: Vec<i32> = self
            .morph
            .arcs()
            .into_iter()
            .flatten()
            .flat_map(|arc| arc.map_or([-1, 0], |(from, span)| [from as i32, span as i32]))
            .collect();
        Int32Array::from(&flat[..])
    }

    /// The box around the unbent curve: minX, minY, maxX, maxY.
    #[wasm_bindgen(unchecked_return_type = "[minX: number, minY: number, maxX: number, maxY: number]")]
    pub fn bounds(&mut self, s: f64) -> Result<JsValue, JsValue> {
        write(&self.at(s)?.morphed.bounds())
    }

    /// What the unbent curve is like: knots and copies it is made of, the dimension of its boxes, how often its
    /// polyline at a five-hundredth of the box crosses itself (10,000 at most), and the largest factor by which copies
    /// stretch lengths.
    #[wasm_bindgen(
        unchecked_return_type = "{ knots: number; copies: number; dimension: number; crossings: number; ratio: number }"
    )]
    pub fn facts(&mut self, s: f64) -> Result<JsValue, JsValue> {
        let knots = self.morph.knots();
        let morphed = &self.at(s)?.morphed;
        Ok(object(&[
            ("knots", knots.into()),
            ("copies", morphed.copies().into()),
            ("dimension", morphed.dimension_and_length().0.into()),
            ("crossings", morphed.crossings().into()),
            ("ratio", morphed.contraction().into()),
        ]))
    }
}
