//! The connectedness locus, whole or in tiles.

use frond_core::Morph;
use frond_locus::{LocusGrid, Pass, Scratch, Slice};
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;
use crate::boundary::grid::{prove, read_grid, write_samples, write_tile};
use crate::boundary::value::read_morph;

/// Which plane of the parameters: how far the stretch is ahead of the turn.
fn read_w(options: &JsValue) -> Result<f64, JsValue> {
    let w = Reflect::get(options, &"w".into()).unwrap_or(JsValue::UNDEFINED);
    match w.as_f64() {
        Some(w) if w.is_finite() => Ok(w),
        None if w.is_undefined() || w.is_null() => Ok(0.0),
        _ => Err(bad_input("w", "a finite number is needed")),
    }
}

/// The connectedness locus of the morph between two systems of equally many maps (Burch & Hart 1997, section
/// 5). Long work: call it in a worker, or use `LocusTiles`.
#[wasm_bindgen(unchecked_return_type = "Locus")]
pub fn locus(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
    #[wasm_bindgen(unchecked_param_type = "LocusOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let morph = read_morph(&from, &to, &options)?;
    let (grid, epsilon) = read_grid(&options)?;
    let slice = Slice::new(&morph, read_w(&options)?);
    let (state, gap) = grid.locus(&slice, epsilon).into_parts();
    Ok(write_samples(grid.width(), grid.height(), &state, &gap))
}

/// A locus that is computed a few rows at a time, from coarse to fine.
#[wasm_bindgen]
pub struct LocusTiles {
    morph: Morph,
    w: f64,
    grid: LocusGrid,
    epsilon: f64,
    scratch: Scratch,
}

#[wasm_bindgen]
impl LocusTiles {
    /// The locus of the morph between two systems, with the options of `locus`. Nothing is computed yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LocusOptions")] options: JsValue,
    ) -> Result<Self, JsValue> {
        let morph = read_morph(&from, &to, &options)?;
        let (grid, epsilon) = read_grid(&options)?;
        let w = read_w(&options)?;
        Ok(Self { morph, w, grid, epsilon, scratch: Scratch::default() })
    }

    /// Decides the samples of rows `r0` to `r1` (exclusive) that lie on the grid of every `stride`-th row and
    /// column and, unless this is the `first` pass, not on that of twice the stride. The arrays hold one row
    /// of the full width for each row that is a multiple of the stride; samples of other passes are 255 and
    /// NaN.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn run(&mut self, r0: usize, r1: usize, stride: usize, first: bool) -> JsValue {
        let pass = Pass { rows: r0..r1, stride, first };
        let slice = Slice::new(&self.morph, self.w);
        write_tile(&self.grid.tile(&slice, self.epsilon, &pass, &mut self.scratch))
    }

    /// Decides all samples of columns `x0` to `x1` and rows `y0` to `y1` (both exclusive at their ends), whole boxes at
    /// once: the arrays hold them row by row.
    #[wasm_bindgen(unchecked_return_type = "{ state: Uint8Array; gap: Float32Array }")]
    pub fn patch(&mut self, x0: usize, y0: usize, x1: usize, y1: usize) -> JsValue {
        let slice = Slice::new(&self.morph, self.w);
        write_tile(&self.grid.patch(&slice, self.epsilon, x0..x1, y0..y1, &mut self.scratch))
    }

    /// Looks for proofs where the samples of a rectangle only touch: `state` holds what `patch` said of it, row by
    /// row, and so does the answer, `connected` where pieces were found to cross. It takes some 50 microseconds a
    /// sample.
    pub fn prove(
        &mut self,
        x0: usize,
        y0: usize,
        x1: usize,
        y1: usize,
        state: Vec<u8>,
    ) -> Result<Vec<u8>, JsValue> {
        let slice = Slice::new(&self.morph, self.w);
        prove(&self.grid, &slice, self.epsilon, [x0..x1, y0..y1], state, &mut self.scratch)
    }
}
