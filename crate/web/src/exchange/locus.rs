//! Samples of a locus for other programs.

use frond_exchange::{LocusSamples, locus_csv, locus_npy};
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;

/// What both take.
fn samples<'a>(
    bounds: &[f64],
    width: usize,
    state: &'a [u8],
    gap: &'a [f32],
) -> Result<LocusSamples<'a>, JsValue> {
    let bounds =
        bounds.try_into().map_err(|_| bad_input("bounds", "four numbers are needed: u0, u1, v0, v1"))?;
    if width == 0 || !state.len().is_multiple_of(width) || state.len() != gap.len() {
        return Err(bad_input(
            "The locus",
            "`state` and `gap` have a value for each sample, in rows of `width`",
        ));
    }
    Ok(LocusSamples { bounds, width, state, gap })
}

/// A locus as a table, `u,v,state,gap`. `bounds` are u0, u1, v0, v1; samples as in `Locus`, row 0 at the bottom.
#[wasm_bindgen(js_name = locusCsv)]
pub fn write_csv(bounds: &[f64], width: usize, state: &[u8], gap: &[f32]) -> Result<String, JsValue> {
    Ok(locus_csv(&samples(bounds, width, state, gap)?))
}

/// The same as a file of NumPy (.npy): a field each for u, v, state and gap.
#[wasm_bindgen(js_name = locusNpy)]
pub fn write_npy(bounds: &[f64], width: usize, state: &[u8], gap: &[f32]) -> Result<Vec<u8>, JsValue> {
    Ok(locus_npy(&samples(bounds, width, state, gap)?))
}
