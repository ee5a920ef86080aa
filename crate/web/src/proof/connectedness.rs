//! Whether a shape is in one piece.

use frond_core::{Ifs, IfsError};
use frond_locus::{BarnsleyOptions, Choice, Connectedness, IndexBuffer, IndexBufferOptions};
use glam::DVec2;
use js_sys::Uint8Array;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure, of_ifs};
use crate::boundary::evidence::write_reason;
use crate::boundary::resolution::read_options;
use crate::boundary::value::{object, point, read, read_ifs, read_maps, write};

/// Whether the attractor is connected, which of its pieces meet, and how wide the widest gap is. Maps without
/// an attractor get the verdict `no-attractor`.
#[wasm_bindgen(unchecked_return_type = "Connectedness")]
pub fn connectedness(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ epsilon?: number; budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let options = read_options(options)?;
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
    if let Some(reason) = &found.reason {
        fields.push(("reason", write_reason(reason)?));
    }
    Ok(object(&fields))
}

/// The most points of the chaos game that one call throws.
const MOST_POINTS: f64 = 1e9;

#[derive(Deserialize)]
struct Buffer {
    size: f64,
    points: f64,
    #[serde(default)]
    seed: u32,
    margin: Option<f64>,
    #[serde(default)]
    weighted: bool,
    window: Option<[f64; 4]>,
}

/// The index buffer test: the chaos game into a small picture, and which pieces fell into the same pixels
/// (Burch & Hart 1997, Fig 2).
#[wasm_bindgen(js_name = indexBuffer, unchecked_return_type = "IndexBuffer")]
pub fn index_buffer(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "IndexBufferOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let plain: Buffer = read("The options", options)?;
    if !(0.0..=MOST_POINTS).contains(&plain.points) {
        return Err(bad_input("points", "a number from 0 to 1e9 is needed"));
    }
    let mut options = IndexBufferOptions {
        size: plain.size as usize,
        points: plain.points as u32,
        seed: plain.seed,
        choice: if plain.weighted { Choice::Weighted } else { Choice::Uniform },
        ..IndexBufferOptions::default()
    };
    if let Some(margin) = plain.margin {
        options.margin = margin;
    }
    options.window = plain.window.map(|[x0, y0, x1, y1]| [DVec2::new(x0, y0), DVec2::new(x1, y1)]);
    let found =
        IndexBuffer::run(&ifs, &options).map_err(|error| failure(error.code(), &error.to_string()))?;
    let components = found.graph.components();
    let labels = components.labels();
    let count = labels.iter().max().map_or(0, |most| most + 1);
    Ok(object(&[
        ("connected", found.is_connected().into()),
        ("overlaps", write(&found.graph.edges())?),
        ("components", write(&labels)?),
        ("count", (count as f64).into()),
        ("pixels", Uint8Array::from(&found.pixels[..]).into()),
    ]))
}

#[derive(Deserialize)]
struct Iterations {
    iterations: f64,
    points: Option<f64>,
}

#[derive(Serialize)]
struct PlainRound {
    distance: f64,
    bound: f64,
}

/// Barnsley's object test (Burch & Hart 1997, Fig 1). It can prove that a piece lies apart, and nothing else.
#[wasm_bindgen(js_name = barnsleyTest, unchecked_return_type = "BarnsleyTest")]
pub fn barnsley_test(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ iterations: number; points?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let plain: Iterations = read("The options", options)?;
    let mut options = BarnsleyOptions { iterations: plain.iterations as usize, ..BarnsleyOptions::default() };
    if let Some(points) = plain.points {
        options.points = (points as usize).min(1_000_000);
    }
    let found = frond_locus::barnsley_test(&ifs, &options);
    let rounds: Vec<PlainRound> = found
        .rounds
        .iter()
        .map(|round| PlainRound { distance: round.distance, bound: round.bound })
        .collect();
    Ok(object(&[
        ("disconnected", found.apart.is_some().into()),
        ("iterations", (rounds.len() as f64).into()),
        ("rounds", write(&rounds)?),
    ]))
}
