//! Shadows of space in the plane.

use frond_core::{ChaosGame3, EpsilonFrame, Plane, ProjectError};
use js_sys::Float32Array;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::shape::Throwing;
use crate::boundary::error::failure;
use crate::boundary::space::{read_ifs3, read_maps3, read_point3, write_maps3};
use crate::boundary::value::{object, read, rows, write};

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

/// In which axes the maps of a flattened shape are written.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Frame {
    Picture,
    Space,
}

#[derive(Deserialize)]
struct Flattening {
    frame: Option<Frame>,
}

/// A shape flattened by epsilon, 1e-100 to 1, along a direction (Darwish & Abd-El-Wahab, section 3.5). `frame` says in
/// which axes the maps are written.
///
/// `"space"` are the axes of the shape, as in the paper: it stays where it is and becomes thin along the direction.
/// Along z the scale is diag(1, 1, epsilon). `"picture"`, the default, are those of the shadow: x to the right, y up, z
/// along the direction. They are left-handed, so that the maps are those of a mirror image. Along z the shape is
/// mirrored in x, and the transform is diag(-1, 1, epsilon).
#[wasm_bindgen(js_name = epsilonProjection, unchecked_return_type = "EpsilonProjection")]
pub fn epsilon(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Point3")] direction: JsValue,
    epsilon: f64,
    #[wasm_bindgen(unchecked_optional_param_type = "{ frame?: \"picture\" | \"space\" }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let Flattening { frame } = read("The options", options)?;
    let frame = match frame {
        Some(Frame::Space) => EpsilonFrame::Space,
        Some(Frame::Picture) | None => EpsilonFrame::Picture,
    };
    let found = frond_core::epsilon_projection(&read_maps3(&maps)?, &plane(direction)?, epsilon, frame)
        .map_err(|error| of_project(&error))?;
    let diverging = match frame {
        EpsilonFrame::Space => write(&found.diverging)?,
        EpsilonFrame::Picture => {
            write(&found.diverging.iter().map(|&[map, row, _]| [map, row]).collect::<Vec<_>>())?
        }
    };
    Ok(object(&[
        ("maps", write_maps3(&found.maps)?),
        ("largest", found.largest.into()),
        ("diverging", diverging),
    ]))
}
