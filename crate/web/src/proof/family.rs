//! The locus of a polygon family, in tiles.

use frond_locus::{LocusGrid, Pass, Polygons, Scratch};
use wasm_bindgen::prelude::*;

use crate::boundary::grid::{prove, read_grid, write_tile};
use crate::boundary::polygon::read_family;

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

    /// As `LocusTiles.prove`.
    pub fn prove(
        &mut self,
        x0: usize,
        y0: usize,
        x1: usize,
        y1: usize,
        state: Vec<u8>,
    ) -> Result<Vec<u8>, JsValue> {
        prove(&self.grid, &self.family, self.epsilon, [x0..x1, y0..y1], state, &mut self.scratch)
    }
}
