//! Where a morph between graph-directed systems is in one piece.

use frond_core::DirectedMorph;
use frond_locus::{LocusGrid, directed_tile};
use wasm_bindgen::prelude::*;

use crate::boundary::grid::{read_grid, write_tile};
use crate::directed::read_morph;

/// The locus of a morph between two graph-directed systems, row by row: where its shape, state 0, is in one piece.
#[wasm_bindgen]
pub struct DirectedLocus {
    grid: LocusGrid,
    morph: DirectedMorph,
    epsilon: f64,
}

#[wasm_bindgen]
impl DirectedLocus {
    /// Over `bounds`, [-1, 2] x [-1, 2] by default, of systems of 64 states at most. Nothing is decided yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "DirectedIfs")] to: JsValue,
        #[wasm_bindgen(
            unchecked_param_type = "{ mode?: Mode; halfTurns?: HalfTurns; bounds?: Bounds; width: number; height: number; epsilon?: number }"
        )]
        options: JsValue,
    ) -> Result<Self, JsValue> {
        let (grid, epsilon) = read_grid(&options)?;
        let (morph, _) = read_morph(&from, &to, options)?;
        Ok(Self { grid, morph, epsilon })
    }

    /// Every `stride`th sample of the rows from r0 to before r1 that are a multiple of it: `{ state, gap }`, as in a
    /// `Locus`. A sample takes some milliseconds.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn run(&self, r0: usize, r1: usize, stride: usize) -> JsValue {
        write_tile(&directed_tile(&self.grid, &self.morph, self.epsilon, r0..r1, stride))
    }
}
