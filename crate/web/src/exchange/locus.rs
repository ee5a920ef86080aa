//! Samples of a locus for other programs.

use frond_exchange::{LocusSamples, locus_csv, locus_npy};
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;

/// What both take.
fn samples<'a>(
    bounds: &JsValue,
    width: usize,
    state: &'a [u8],
    gap: &'a [f32],
) -> Result<LocusSamples<'a>, JsValue> {
    let bounds = corners(bounds)?;
    if width == 0 || !state.len().is_multiple_of(width) || state.len() != gap.len() {
        return Err(bad_input(
            "The locus",
            "`state` and `gap` have a value for each sample, in rows of `width`",
        ));
    }
    Ok(LocusSamples { bounds, width, state, gap })
}

/// The rectangle `{ u0, u1, v0, v1 }`, or these four numbers in this order, as the first callers gave them.
fn corners(bounds: &JsValue) -> Result<[f64; 4], JsValue> {
    let list = js_sys::Array::is_array(bounds) || js_sys::ArrayBuffer::is_view(bounds);
    let count = js_sys::Reflect::get(bounds, &"length".into()).ok().and_then(|count| count.as_f64());
    let mut corners = [0.0; 4];
    for (i, (corner, name)) in corners.iter_mut().zip(["u0", "u1", "v0", "v1"]).enumerate() {
        let key = if list { JsValue::from(i as u32) } else { JsValue::from(name) };
        let value = js_sys::Reflect::get(bounds, &key).ok().and_then(|value| value.as_f64());
        *corner =
            value.filter(|value| value.is_finite() && (!list || count == Some(4.0))).ok_or_else(|| {
                bad_input("bounds", "a rectangle is needed: { u0, u1, v0, v1 }, four finite numbers")
            })?;
    }
    Ok(corners)
}

/// A locus as a table, `u,v,state,gap`. `bounds` are `{ u0, u1, v0, v1 }`; samples as in `Locus`, row 0 at the bottom.
#[wasm_bindgen(js_name = locusCsv)]
pub fn write_csv(
    #[wasm_bindgen(
        unchecked_param_type = "{ u0: number; v0: number; u1: number; v1: number } | ArrayLike<number>"
    )]
    bounds: JsValue,
    width: usize,
    state: &[u8],
    gap: &[f32],
) -> Result<String, JsValue> {
    Ok(locus_csv(&samples(&bounds, width, state, gap)?))
}

/// The same as a file of NumPy (.npy): a field each for u, v, state and gap.
#[wasm_bindgen(js_name = locusNpy)]
pub fn write_npy(
    #[wasm_bindgen(
        unchecked_param_type = "{ u0: number; v0: number; u1: number; v1: number } | ArrayLike<number>"
    )]
    bounds: JsValue,
    width: usize,
    state: &[u8],
    gap: &[f32],
) -> Result<Vec<u8>, JsValue> {
    Ok(locus_npy(&samples(&bounds, width, state, gap)?))
}
