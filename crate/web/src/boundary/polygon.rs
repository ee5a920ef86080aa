//! The polygon families: systems over one complex number.

#[cfg(feature = "compute")]
use frond_locus::Family;
use frond_locus::Polygons;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;
use crate::boundary::value::read;
#[cfg(feature = "compute")]
use crate::boundary::value::write_maps;

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

pub(crate) fn read_family(family: JsValue) -> Result<Polygons, JsValue> {
    let plain: PlainFamily = read("The family", family)?;
    polygons(plain.sides)
}

/// The system of a polygon family at `s`: `s z + exp(2 pi i k / sides)` for each k.
#[cfg(feature = "compute")]
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
#[cfg(feature = "compute")]
#[wasm_bindgen(js_name = criticalScale)]
pub fn critical_scale(sides: f64) -> Result<f64, JsValue> {
    Ok(polygons(sides)?.critical_scale())
}
