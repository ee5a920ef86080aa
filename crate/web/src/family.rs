//! The polygon families: systems over one complex number.

use frond_locus::{Family, LocusGrid, Pass, Polygons, Scratch};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::bad_input;
use crate::locus::{read_grid, write_tile};
use crate::value::{read, write_maps};

#[derive(Deserialize)]
struct PlainFamily {
    sides: f64,
}

fn polygons(sides: f64) -> Result<Polygons, JsValue> {
    if (2.0..=64.0).contains(&sides) && sides.fract() == 0.0 {
        Ok(Polygons::new(sides as usize))
    } else {
        Err(bad_input("sides", "a whole number from 2 to 64 is needed"))
    }
}

fn read_family(family: JsValue) -> Result<Polygons, JsValue> {
    let plain: PlainFamily = read("The family", family)?;
    polygons(plain.sides)
}

/// The system of a polygon family at `s`: `s z + exp(2 pi i k / sides)` for each k.
#[wasm_bindgen(js_name = familyMaps, unchecked_return_type = "Ifs")]
pub fn family_maps(
    #[wasm_bindgen(unchecked_param_type = "PolygonFamily")] family: JsValue,
    #[wasm_bindgen(unchecked_param_type = "[re: number, im: number]")] s: JsValue,
) -> Result<JsValue, JsValue> {
    let [re, im]: [f64; 2] = read("s", s)?;
    let mut maps = Vec::new();
    read_family(family)?.fill(re, im, &mut maps);
    write_maps(&maps)
}

/// The least real s > 0 at which the attractors of a polygon family are in one piece: a theorem.
#[wasm_bindgen(js_name = criticalScale)]
pub fn critical_scale(sides: f64) -> Result<f64, JsValue> {
    Ok(polygons(sides)?.critical_scale())
}

/// The locus of a polygon family over s, a part at a time. For two sides it is the set M.
#[wasm_bindgen]
pub struct FamilyTiles {
    family: Polygons,
    grid: LocusGrid,
    epsilon: f64,
    scratch: Scratch,
}

#[wasm_bindgen]
impl FamilyTiles {
    /// The locus over the `bounds` of the options, u the real part of s and v the imaginary. Nothing is computed yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "PolygonFamily")] family: JsValue,
        #[wasm_bindgen(unchecked_param_type = "FamilyOptions")] options: JsValue,
    ) -> Result<Self, JsValue> {
        let family = read_family(family)?;
        let (grid, epsilon) = read_grid(&options)?;
        Ok(Self { family, grid, epsilon, scratch: Scratch::default() })
    }

    /// As `LocusTiles.run`.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn run(&mut self, r0: usize, r1: usize, stride: usize, first: bool) -> JsValue {
        let pass = Pass { rows: r0..r1, stride, first };
        write_tile(&self.grid.tile(&self.family, self.epsilon, &pass, &mut self.scratch))
    }

    /// As `LocusTiles.patch`.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn patch(&mut self, x0: usize, y0: usize, x1: usize, y1: usize) -> JsValue {
        write_tile(&self.grid.patch(&self.family, self.epsilon, x0..x1, y0..y1, &mut self.scratch))
    }
}
