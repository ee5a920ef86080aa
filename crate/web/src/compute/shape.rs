//! One shape, and the way to another.

use frond_core::{Affine2, ChaosGame, Hull, Polar2, probabilities_between, similarity_dimension};
use glam::DMat2;
use js_sys::{Float32Array, Uint8Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{
    Row, given_probabilities, object, point, read, read_ifs, read_maps, read_morph, read_morph_options,
    read_parameters, rows, write, write_maps,
};

/// The most points that one call gives.
const MAX_POINTS: f64 = 16_777_216.0;

/// Throws what is wrong with an IFS; returns if it has an attractor.
#[wasm_bindgen]
pub fn validate(#[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue) -> Result<(), JsValue> {
    read_ifs(&ifs).map(|_| ())
}

/// Both systems with the same number of maps, by refining or doubling maps of the smaller one, which does
/// not change its shape, nor, where probabilities are given, its measure.
#[wasm_bindgen(unchecked_return_type = "Pairing")]
pub fn pair(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] a: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] b: JsValue,
) -> Result<JsValue, JsValue> {
    let pairing = frond_core::pair(&read_ifs(&a)?, &read_ifs(&b)?);
    let mut fields = vec![
        ("from", write(&rows(&pairing.from))?),
        ("to", write(&rows(&pairing.to))?),
        ("steps", write(&pairing.steps)?),
    ];
    if given_probabilities(&a)?.or(given_probabilities(&b)?).is_some() {
        fields.push(("probabilities", write(&[pairing.from_probabilities, pairing.to_probabilities])?));
    }
    Ok(object(&fields))
}

/// The maps at (u, v) between two systems of equally many maps (Burch & Hart 1997, eq 6), or at (u, v, w) with
/// the stretch ahead of the turn by w. The result need not have an attractor. Where both systems give probabilities it
/// has those in between, in proportion to u.
#[wasm_bindgen(unchecked_return_type = "Ifs")]
pub fn interpolate(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MorphOptions & { u: number; v: number; w?: number }")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let given = (given_probabilities(&from)?, given_probabilities(&to)?);
    let order = read_morph_options(&options)?.correspondence;
    let [u, v, w] = read_parameters(options)?;
    let mut fields = vec![("maps", write(&rows(&morph.at3(u, v, w)))?)];
    if let (Some(p), Some(q)) = given {
        fields.push(("probabilities", write(&probabilities_between(&p, &q, &order, u))?));
    }
    Ok(object(&fields))
}

/// For each map that turns by half a turn from `from` to `to`, which is as short either way, the whole turns (1 or -1)
/// that make it the other half turn when they are added to its `turns`; 0 for all others.
#[wasm_bindgen(js_name = halfTurns, unchecked_return_type = "number[]")]
pub fn half_turns(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MorphOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    write(&read_morph(&from, &to, &options)?.other_half_turns())
}

/// The same shape elsewhere: every map conjugated by `transform`, a row of six numbers.
#[wasm_bindgen(unchecked_return_type = "Ifs")]
pub fn conjugate(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow")] transform: JsValue,
) -> Result<JsValue, JsValue> {
    let by = Affine2::from_row(read("The transform", transform)?);
    let maps: Option<Vec<_>> = read_maps(&ifs)?.into_iter().map(|map| map.conjugate(by)).collect();
    let singular =
        || failure("singular", "The transform is flat, so that it has no inverse. Give one that is not.");
    write_maps(&maps.ok_or_else(singular)?)
}

#[derive(Deserialize)]
struct Points {
    points: f64,
    #[serde(default)]
    seed: u32,
}

/// Points of the attractor, by the chaos game: the same seed gives the same points everywhere.
#[wasm_bindgen(unchecked_return_type = "PointCloud")]
pub fn attractor(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ points: number; seed?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let Points { points, seed } = read("The options", options)?;
    if !(0.0..=MAX_POINTS).contains(&points) {
        return Err(bad_input("points", "a number from 0 to 16777216 is needed"));
    }
    let count = points as usize;
    let (mut positions, mut pieces) = (vec![0.0; 2 * count], vec![0; count]);
    ChaosGame::new(&ifs, seed).fill(&mut positions, &mut pieces);
    Ok(object(&[
        ("positions", Float32Array::from(&positions[..]).into()),
        ("pieces", Uint8Array::from(&pieces[..]).into()),
    ]))
}

/// Where the attractor lies.
#[wasm_bindgen(unchecked_return_type = "BoundingBox")]
pub fn bounds(#[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue) -> Result<JsValue, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let hull = Hull::of(&ifs);
    let corners: Vec<[f64; 2]> = hull.vertices().iter().map(|&v| point(v)).collect();
    let mut fields = vec![
        ("min", write(&point(hull.min()))?),
        ("max", write(&point(hull.max()))?),
        ("hull", write(&corners)?),
    ];
    if let Some(dimension) = similarity_dimension(&ifs) {
        fields.push(("dimension", dimension.into()));
    }
    Ok(object(&fields))
}

/// The polar factors of a map's linear part: `M = R(angle) S`, or `M = R(angle) diag(1, -1) S` where it reflects.
#[wasm_bindgen(
    unchecked_return_type = "{ angle: number; reflects: boolean; stretch: [xx: number, xy: number, yy: number]; determinant: number }"
)]
pub fn polar(#[wasm_bindgen(unchecked_param_type = "MapRow")] map: JsValue) -> Result<JsValue, JsValue> {
    let row: Row = read("The map", map)?;
    let linear: DMat2 = Affine2::from_row(row).linear;
    let Polar2 { angle, reflects, stretch } = Polar2::of(linear);
    Ok(object(&[
        ("angle", angle.into()),
        ("reflects", reflects.into()),
        ("stretch", write(&[stretch.x_axis.x, stretch.x_axis.y, stretch.y_axis.y])?),
        ("determinant", linear.determinant().into()),
    ]))
}
