//! Graph-directed shapes: several that are made of copies of each other.

mod grid;
mod locus;

use frond_core::{
    Affine2, DirectedError, DirectedGame, DirectedIfs, DirectedMap, DirectedMorph, HalfTurns, Hull, MAX_MAPS,
    MAX_STATES, MOST_FOUND_STATES, Mode, directed_dimension,
};
use frond_fit::{ClosedCurve, MAX_KNOTS, PackError};
use frond_locus::{
    DirectedCertifyOptions, Options, StateOnTheWay, certify_directed as certify,
    directed_connectedness as decide,
};
use frond_render::{DirectedColours, DirectedOptions, View, rasterize_directed as draw};
use frond_scene::{Curve, DirectedShape, directed_presets as presets};
use glam::DVec2;
use js_sys::{Array, Float32Array, Reflect, Uint8Array, Uint8ClampedArray};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::palette::read_palette;
use crate::boundary::value::{Row, longer_than, object, point, read, read_given, write};

#[derive(Deserialize, Serialize)]
struct PlainMap {
    from: usize,
    map: Row,
}

#[derive(Deserialize, Serialize)]
pub(crate) struct PlainSystem {
    states: Vec<Vec<PlainMap>>,
}

impl PlainSystem {
    pub(crate) fn of(states: &[Vec<DirectedMap>]) -> Self {
        let plain = |part: &DirectedMap| PlainMap { from: part.from, map: part.map.to_row() };
        Self { states: states.iter().map(|maps| maps.iter().map(plain).collect()).collect() }
    }
}

pub(crate) fn of_directed(error: &DirectedError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// A system that has an attractor. Longer lists than allowed are refused before their entries are read.
fn read_system(value: &JsValue) -> Result<DirectedIfs, JsValue> {
    DirectedIfs::new(read_states(value, MAX_STATES)?).map_err(|error| of_directed(&error))
}

/// The same of states that were found, of which there may be more.
fn read_found(value: &JsValue) -> Result<DirectedIfs, JsValue> {
    DirectedIfs::found(read_states(value, MOST_FOUND_STATES)?).map_err(|error| of_directed(&error))
}

fn read_states(value: &JsValue, most: usize) -> Result<Vec<Vec<DirectedMap>>, JsValue> {
    let states = Reflect::get(value, &"states".into()).unwrap_or(JsValue::UNDEFINED);
    if let Some(count) = longer_than(&states, most) {
        return Err(of_directed(&DirectedError::TooManyStates { count, most }));
    }
    if let Some(list) = states.dyn_ref::<Array>() {
        for (state, maps) in list.iter().enumerate() {
            if let Some(count) = longer_than(&maps, MAX_MAPS) {
                return Err(of_directed(&DirectedError::TooManyMaps { state, count }));
            }
        }
    }
    let plain: PlainSystem = read("The graph-directed system", value.clone())?;
    let map = |part: PlainMap| DirectedMap { from: part.from, map: Affine2::from_row(part.map) };
    Ok(plain.states.into_iter().map(|maps| maps.into_iter().map(map).collect()).collect())
}

/// Graph-directed shapes of the gallery.
#[wasm_bindgen(js_name = directedPresets, unchecked_return_type = "DirectedPreset[]")]
pub fn directed_presets() -> Result<JsValue, JsValue> {
    let all = Array::new();
    for preset in presets() {
        all.push(&object(&[
            ("id", preset.id.into()),
            ("name", preset.name.into()),
            ("about", preset.about.into()),
            ("system", write(&PlainSystem::of(&preset.states))?),
        ]));
    }
    Ok(all.into())
}

/// A closed curve as a graph-directed shape whose states run from point to point, so that ferns become it in one piece:
/// as high as `box` and on its lower side, in its middle, where that is given.
#[wasm_bindgen(js_name = outlineShape, unchecked_return_type = "DirectedShape")]
pub fn outline_shape(
    name: &str,
    #[wasm_bindgen(unchecked_param_type = "Curve")] curve: JsValue,
    #[wasm_bindgen(
        js_name = "box",
        unchecked_optional_param_type = "[x0: number, y0: number, x1: number, y1: number]"
    )]
    within: JsValue,
) -> Result<JsValue, JsValue> {
    for key in ["knots", "edges"] {
        let list = Reflect::get(&curve, &key.into()).unwrap_or(JsValue::UNDEFINED);
        if longer_than(&list, MAX_KNOTS).is_some() {
            let error = PackError::TooManyKnots;
            return Err(failure(error.code(), &error.to_string()));
        }
    }
    let plain: Curve = read("The curve", curve)?;
    let mut curve = ClosedCurve::from(&plain);
    let within: Option<[f64; 4]> = read_given("The box", within)?;
    if let Some([x0, y0, x1, y1]) = within {
        let low = curve.knots.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = curve.knots.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let scale = (y1 - y0) / (high.y - low.y);
        let foot = DVec2::new(0.5 * (low.x + high.x), low.y);
        let at = DVec2::new(0.5 * (x0 + x1), y0);
        curve.knots.iter_mut().for_each(|knot| *knot = (*knot - foot) * scale + at);
    }
    let shape = DirectedShape::of_outline(name, &curve);
    write(&shape.map_err(|error| failure(error.code(), &error.to_string()))?)
}

/// Where the states of a graph-directed system lie, their dimensions, and which of them the shape (state 0) is not made
/// of or no way leads back to. Throws what is wrong with the system. It may have 1024 states.
#[wasm_bindgen(js_name = directedFacts, unchecked_return_type = "DirectedFacts")]
pub fn directed_facts(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] system: JsValue,
) -> Result<JsValue, JsValue> {
    let system = read_found(&system)?;
    let states = Array::new();
    for (state, hull) in Hull::of_states(&system).iter().enumerate() {
        let corners: Vec<[f64; 2]> = hull.vertices().iter().map(|&v| point(v)).collect();
        let mut fields = vec![
            ("min", write(&point(hull.min()))?),
            ("max", write(&point(hull.max()))?),
            ("hull", write(&corners)?),
        ];
        if let Some(dimension) = directed_dimension(&system, state) {
            fields.push(("dimension", dimension.into()));
        }
        states.push(&object(&fields));
    }
    Ok(object(&[
        ("states", states.into()),
        ("unreached", write(&system.unreached())?),
        ("neverReturn", write(&system.never_return())?),
        ("factor", system.contraction().factor.into()),
    ]))
}

/// The most points that one call gives.
const MAX_POINTS: f64 = 16_777_216.0;

#[derive(Deserialize)]
struct Points {
    points: f64,
    #[serde(default)]
    seed: u32,
    #[serde(default)]
    state: usize,
}

fn no_state(state: usize) -> JsValue {
    failure("state", &format!("There is no state {}. Ask for one that is there.", state.saturating_add(1)))
}

/// Points of a state, by the chaos game: the same seed gives the same points everywhere. There may be 1024 states.
#[wasm_bindgen(js_name = directedAttractor, unchecked_return_type = "PointCloud")]
pub fn directed_attractor(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] system: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ points: number; seed?: number; state?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let system = read_found(&system)?;
    let Points { points, seed, state } = read("The options", options)?;
    if !(0.0..=MAX_POINTS).contains(&points) {
        return Err(bad_input("points", "a number from 0 to 16777216 is needed"));
    }
    let mut game = DirectedGame::new(&system, state, seed).ok_or_else(|| no_state(state))?;
    let count = points as usize;
    let (mut positions, mut pieces) = (vec![0.0; 2 * count], vec![0; count]);
    game.fill(&mut positions, &mut pieces);
    Ok(object(&[
        ("positions", Float32Array::from(&positions[..]).into()),
        ("pieces", Uint8Array::from(&pieces[..]).into()),
    ]))
}

#[derive(Deserialize)]
struct PlainView {
    x: f64,
    y: f64,
    scale: f64,
}

#[derive(Deserialize)]
struct Plain {
    width: f64,
    height: f64,
    #[serde(default)]
    state: usize,
    view: Option<PlainView>,
    #[serde(default)]
    level: u8,
    #[serde(default)]
    palette: Vec<String>,
    smooth: Option<bool>,
}

/// Draws a state of a graph-directed system, complete, as `rasterize` does: coloured by its maps, or, at a `level` of 1
/// to 8, by the states that are copied there after so many maps. There may be 1024 states.
#[wasm_bindgen(js_name = rasterizeDirected, unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
pub fn rasterize_directed(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] system: JsValue,
    #[wasm_bindgen(unchecked_param_type = "DirectedRasterOptions")] options: JsValue,
) -> Result<Uint8ClampedArray, JsValue> {
    let system = read_found(&system)?;
    let plain: Plain = read("The options", options)?;
    if plain.state >= system.len() {
        return Err(no_state(plain.state));
    }
    let palette = read_palette(&plain.palette)?;
    let options = DirectedOptions {
        // A cast of NaN or a negative number gives 0: an empty picture.
        width: plain.width as u32,
        height: plain.height as u32,
        state: plain.state,
        view: plain.view.map(|PlainView { x, y, scale }| View { x, y, scale }),
        colours: if plain.level == 0 { DirectedColours::Map } else { DirectedColours::State(plain.level) },
        palette: &palette,
        smooth: plain.smooth.unwrap_or(true),
    };
    let pixels = draw(&system, &options).map_err(|error| failure(error.code(), &error.to_string()))?;
    Ok(Uint8ClampedArray::from(&pixels[..]))
}

#[derive(Deserialize)]
struct PlainOptions {
    epsilon: Option<f64>,
    budget: Option<f64>,
}

/// Decides for each state of a graph-directed system, of 64 at most, whether it is in one piece.
#[wasm_bindgen(js_name = directedConnectedness, unchecked_return_type = "StateConnectedness[]")]
pub fn directed_connectedness(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] system: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ epsilon?: number; budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let system = read_system(&system)?;
    let PlainOptions { epsilon, budget } = read("The options", options)?;
    let own = Options::default();
    // A cast of NaN or a negative number gives 0.
    let budget = budget.map_or(own.budget, |budget| budget as usize);
    let options = Options { epsilon: epsilon.unwrap_or(own.epsilon), budget };
    let states = Array::new();
    for found in decide(&system, &options) {
        let links = Array::new();
        for link in &found.links {
            links.push(&object(&[
                ("pair", write(&link.pair)?),
                ("words", write(&link.words)?),
                ("at", write(&point(link.at))?),
            ]));
        }
        let gap = object(&[("lower", found.gap.lower.into()), ("upper", found.gap.upper.into())]);
        let mut fields = vec![
            ("verdict", found.verdict.name().into()),
            ("gap", gap),
            ("overlaps", write(&found.overlaps)?),
            ("links", links.into()),
            ("assuming", write(&found.assuming)?),
            ("openBy", write(&found.open_by)?),
            ("diameter", found.diameter.into()),
            ("nodes", (found.nodes as f64).into()),
        ];
        if let Some((from, to)) = found.closest {
            fields.push(("closest", object(&[("from", write(&point(from))?), ("to", write(&point(to))?)])));
        }
        states.push(&object(&fields));
    }
    Ok(states.into())
}

#[derive(Deserialize)]
struct PlainMorph {
    #[serde(default)]
    mode: Mode,
    #[serde(default, rename = "halfTurns")]
    half_turns: HalfTurns,
    #[serde(default)]
    u: f64,
    #[serde(default)]
    v: f64,
    epsilon: Option<f64>,
    moments: Option<f64>,
}

fn read_morph(
    from: &JsValue,
    to: &JsValue,
    options: JsValue,
) -> Result<(DirectedMorph, PlainMorph), JsValue> {
    let (from, to) = (read_system(from)?, read_system(to)?);
    let plain: PlainMorph = read("The options", options)?;
    let morph = DirectedMorph::turning(&from, &to, plain.mode, plain.half_turns);
    Ok((morph.map_err(|error| failure(error.code(), &error.to_string()))?, plain))
}

/// Which state of one graph-directed system becomes which of another, and what was done to match the graphs. Neither
/// may have more than 64 states, nor what they are matched to.
#[wasm_bindgen(js_name = matchDirected, unchecked_return_type = "DirectedMatch")]
pub fn match_directed(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] to: JsValue,
) -> Result<JsValue, JsValue> {
    let (morph, _) = read_morph(&from, &to, JsValue::UNDEFINED)?;
    Ok(object(&[
        ("states", write(&morph.states())?),
        ("steps", write(&morph.steps())?),
        ("halfTurns", (morph.half_turns() as f64).into()),
    ]))
}

/// The graph-directed system at (u, v) between two, whose graphs are matched (Burch & Hart 1997, eq 6 and section 7.1).
/// It need not have an attractor. Of 64 states at most, as for `matchDirected`.
#[wasm_bindgen(js_name = interpolateDirected, unchecked_return_type = "DirectedIfs")]
pub fn interpolate_directed(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ u: number; v: number; mode?: Mode; halfTurns?: HalfTurns }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let (morph, PlainMorph { u, v, .. }) = read_morph(&from, &to, options)?;
    write(&PlainSystem::of(&morph.at(u, v)))
}

/// Looks for a proof that the states stay in one piece on the way from one graph-directed system to another, u = v. Of
/// 64 states at most, as for `matchDirected`.
#[wasm_bindgen(js_name = certifyDirected, unchecked_return_type = "DirectedCertificate")]
pub fn certify_directed(
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] to: JsValue,
    #[wasm_bindgen(
        unchecked_optional_param_type = "{ mode?: Mode; halfTurns?: HalfTurns; epsilon?: number; moments?: number }"
    )]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let (morph, plain) = read_morph(&from, &to, options)?;
    let own = DirectedCertifyOptions::default();
    let moments = plain.moments.map_or(own.moments, |moments| moments as usize);
    let options = DirectedCertifyOptions { epsilon: plain.epsilon.unwrap_or(own.epsilon), moments, ..own };
    let proof = certify(&morph, &options);
    let states = Array::new();
    for state in &proof.states {
        states.push(&match *state {
            StateOnTheWay::Connected => object(&[("kind", "connected".into())]),
            StateOnTheWay::Within(gap) => object(&[("kind", "within".into()), ("gap", gap.into())]),
            StateOnTheWay::Open(at) => object(&[("kind", "open".into()), ("at", at.into())]),
        });
    }
    Ok(object(&[
        ("states", states.into()),
        ("assuming", write(&proof.assuming)?),
        ("moments", (proof.moments as f64).into()),
    ]))
}
