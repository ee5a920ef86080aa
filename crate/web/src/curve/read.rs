//! Curves that come from JavaScript.

use frond_fit::{ClosedCurve, CurveMorph, MAX_KNOTS, MorphError, MorphedCurve, PackError};
use frond_scene::Curve;
use js_sys::Reflect;
use wasm_bindgen::JsValue;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{longer_than, read};

/// A curve that holds together.
pub(super) fn read_curve(value: &JsValue) -> Result<ClosedCurve, JsValue> {
    for key in ["knots", "edges"] {
        let list = Reflect::get(value, &key.into()).unwrap_or(JsValue::UNDEFINED);
        if longer_than(&list, MAX_KNOTS).is_some() {
            let error = PackError::TooManyKnots;
            return Err(failure(error.code(), &error.to_string()));
        }
    }
    let plain: Curve = read("The curve", value.clone())?;
    let curve = ClosedCurve::from(&plain);
    if let Some(fault) = curve.fault() {
        return Err(failure(fault.code(), &fault.message()));
    }
    if curve.is_sound() { Ok(curve) } else { Err(bad_input("The curve", "a copy does not shrink")) }
}

pub(super) fn of_morph(error: MorphError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// The curve alone.
pub(super) fn morphed(curve: &ClosedCurve) -> Result<MorphedCurve, JsValue> {
    Ok(CurveMorph::new(curve, None).map_err(of_morph)?.at(0.0))
}
