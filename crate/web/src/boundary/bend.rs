//! Bends: fractal deformation from JavaScript.

use frond_deform::{Bend, BendError, Continuity, Mesh, Roughness, Settings, Spin, Tint};
use glam::DVec2;
use serde::Deserialize;
use wasm_bindgen::JsValue;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::palette::read_palette;
use crate::boundary::value::read;

#[derive(Clone, Debug, Deserialize, PartialEq)]
struct PlainTint {
    colours: Vec<String>,
    kb: f64,
    ke: f64,
    delta: f64,
    superposed: bool,
}

/// `Bend` of `api.d.ts`.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub(crate) struct PlainBend {
    columns: usize,
    rows: usize,
    #[serde(rename = "box")]
    bounds: [f64; 4],
    moves: Vec<f64>,
    kb: f64,
    ke: f64,
    delta: Roughness,
    spin: Spin,
    continuity: Continuity,
    superposed: bool,
    tint: Option<PlainTint>,
}

/// What a bend is made from.
pub(crate) type Parts = (Mesh, Settings, Option<Tint>);

impl PlainBend {
    /// A bend object.
    pub(crate) fn read(value: &JsValue) -> Result<Self, JsValue> {
        read("The bend", value.clone())
    }

    /// Whether another one differs in its moves alone, so that what was made of this one can go on.
    pub(crate) fn same_but_moved(&self, other: &Self) -> bool {
        let still = Self { moves: Vec::new(), ..self.clone() };
        still == Self { moves: Vec::new(), ..other.clone() }
    }

    /// The displacements of the control points.
    pub(crate) fn displacements(&self) -> Vec<DVec2> {
        self.moves.as_chunks::<2>().0.iter().map(|&pair| pair.into()).collect()
    }

    /// What the bend is made from.
    pub(crate) fn parts(&self) -> Result<Parts, JsValue> {
        let [x0, y0, x1, y1] = self.bounds;
        let mesh =
            Mesh::new(DVec2::new(x0, y0), DVec2::new(x1, y1), self.columns, self.rows, self.displacements())
                .map_err(|error| failure(error.code(), &error.to_string()))?;
        if !self.moves.len().is_multiple_of(2) {
            return Err(bad_input("The bend", "moves are two numbers a control point"));
        }
        let settings = Settings {
            kb: self.kb,
            ke: self.ke,
            roughness: self.delta,
            spin: self.spin,
            continuity: self.continuity,
            superposed: self.superposed,
        };
        let tint = self.tint.as_ref().map(read_tint).transpose()?;
        Ok((mesh, settings, tint))
    }
}

fn read_tint(plain: &PlainTint) -> Result<Tint, JsValue> {
    let colours = read_palette(&plain.colours)?;
    Ok(Tint {
        colours: colours.into_iter().map(|rgb| rgb.map(|byte| f64::from(byte) / 255.0)).collect(),
        kb: plain.kb,
        ke: plain.ke,
        roughness: plain.delta,
        superposed: plain.superposed,
    })
}

/// A bend object as the parts of a bend.
pub(crate) fn read_bend(value: &JsValue) -> Result<Parts, JsValue> {
    PlainBend::read(value)?.parts()
}

pub(crate) fn of_bend(error: &BendError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// A bend object on a shape.
#[cfg_attr(not(feature = "bend"), expect(dead_code, reason = "a renderer has its maps from elsewhere"))]
pub(crate) fn bend_on(maps: &[frond_core::Affine2], value: &JsValue) -> Result<Bend, JsValue> {
    let (mesh, settings, tint) = read_bend(value)?;
    Bend::new(maps, mesh, settings, tint).map_err(|error| of_bend(&error))
}
