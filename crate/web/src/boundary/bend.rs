//! Bends: fractal deformation from JavaScript.

use std::cell::RefCell;

use frond_core::Affine2;
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
pub(crate) fn bend_on(maps: &[Affine2], value: &JsValue) -> Result<Bend, JsValue> {
    make(maps, &PlainBend::read(value)?)
}

fn make(maps: &[Affine2], plain: &PlainBend) -> Result<Bend, JsValue> {
    let (mesh, settings, tint) = plain.parts()?;
    Bend::new(maps, mesh, settings, tint).map_err(|error| of_bend(&error))
}

/// The bend that was asked for last, and what it was made from.
struct Last {
    maps: Vec<Affine2>,
    plain: PlainBend,
    bend: Bend,
}

thread_local! {
    static LAST: RefCell<Option<Last>> = const { RefCell::new(None) };
}

/// Does something with a bend object on a shape. The bend is kept for the next call: while control points are dragged,
/// nothing else of it changes, and what hangs on the shape alone takes longest to make.
#[cfg_attr(not(feature = "bend"), expect(dead_code, reason = "a renderer keeps its bend itself"))]
pub(crate) fn with_bend<T>(
    maps: &[Affine2],
    value: &JsValue,
    run: impl FnOnce(&Bend) -> Result<T, JsValue>,
) -> Result<T, JsValue> {
    let plain = PlainBend::read(value)?;
    // What is right in the mesh is looked at in any case.
    plain.parts()?;
    // Taken out while it is in use: what fails leaves none behind.
    let last = LAST.take().filter(|last| last.maps == maps && last.plain.same_but_moved(&plain));
    let mut last = match last {
        Some(last) => last,
        None => Last { maps: maps.to_vec(), plain: plain.clone(), bend: make(maps, &plain)? },
    };
    if last.plain != plain {
        last.bend.set_mesh(&plain.displacements()).map_err(|error| of_bend(&error))?;
        last.plain = plain;
    }
    let done = run(&last.bend);
    LAST.set(Some(last));
    done
}
