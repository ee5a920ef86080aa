//! Shadows of space in the plane.

use frond_core::{ChaosGame3, Plane, ProjectError};
use js_sys::Float32Array;
use wasm_bindgen::prelude::*;

use super::shape::Throwing;
use crate::boundary::error::failure;
use crate::boundary::space::{read_ifs3, read_maps3, read_point3, write_maps3};
use crate::boundary::value::{object, rows, write};

fn of_project(error: &ProjectError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn plane(direction: JsValue) -> Result<Plane, JsValue> {
    Plane::across(read_point3("The direction", direction)?).map_err(|error| of_project(&error))
}

/// Directions that every map keeps: unit vectors; empty where there are none.
#[wasm_bindgen(js_name = invariantDirections, unchecked_return_type = "Point3[]")]
pub fn directions(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
) -> Result<JsValue, JsValue> {
    let found = frond_core::invariant_directions(&read_maps3(&maps)?);
    write(&found.iter().map(|direction| direction.to_array()).collect::<Vec<_>>())
}

/// The system of the plane whose attractor is the shadow along a direction that every map keeps. Throws else.
#[wasm_bindgen(js_name = projectExactly, unchecked_return_type = "MapRow[]")]
pub fn project(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Point3")] direction: JsValue,
) -> Result<JsValue, JsValue> {
    let found = frond_core::exact_projection(&read_maps3(&maps)?, &plane(direction)?);
    write(&rows(&found.map_err(|error| of_project(&error))?))
}

/// The shadow of points of a shape along a direction, z up in it as far as it can be.
#[wasm_bindgen(unchecked_return_type = "Shadow")]
pub fn shadow(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Point3")] direction: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ points: number; seed?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let (ifs, plane) = (read_ifs3(&maps)?, plane(direction)?);
    let (count, seed) = Throwing::read(options)?;
    let mut positions = vec![0.0_f32; 3 * count];
    let made = ChaosGame3::new(&ifs, seed).fill(&mut positions, &mut vec![0_u8; count]);
    Ok(object(&[
        ("points", Float32Array::from(&plane.shadows(&positions[..3 * made])[..]).into()),
        ("right", write(&plane.right.to_array())?),
        ("up", write(&plane.up.to_array())?),
    ]))
}

/// A shape flattened by epsilon, 1e-100 to 1, along a direction (Darwish & Abd-El-Wahab, section 3.5).
#[wasm_bindgen(js_name = epsilonProjection, unchecked_return_type = "EpsilonProjection")]
pub fn epsilon(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Point3")] direction: JsValue,
    epsilon: f64,
) -> Result<JsValue, JsValue> {
    let found = frond_core::epsilon_projection(&read_maps3(&maps)?, &plane(direction)?, epsilon)
        .map_err(|error| of_project(&error))?;
    Ok(object(&[
        ("maps", write_maps3(&found.maps)?),
        ("largest", found.largest.into()),
        ("diverging", write(&found.diverging)?),
    ]))
}
