//! Maps and points of space.

use frond_core::{Affine3, Ifs3, IfsError, MAX_MAPS, TransformError};
use frond_scene::Row3;
use glam::DVec3;
use js_sys::Array;
use wasm_bindgen::{JsCast, JsValue};

use super::error::{bad_input, failure, of_ifs};
use super::value::{read, write};

/// Maps of space, rows of twelve numbers. Longer lists than allowed are refused before their entries are read.
pub(crate) fn read_maps3(value: &JsValue) -> Result<Vec<Affine3>, JsValue> {
    if let Some(list) = value.dyn_ref::<Array>() {
        let count = list.length() as usize;
        if count > MAX_MAPS {
            return Err(of_ifs(&IfsError::TooManyMaps { count }));
        }
    }
    let rows: Vec<Row3> = read("The maps", value.clone())?;
    Ok(rows.into_iter().map(Affine3::from_row).collect())
}

/// Maps of space that have an attractor.
pub(crate) fn read_ifs3(value: &JsValue) -> Result<Ifs3, JsValue> {
    Ifs3::new(read_maps3(value)?).map_err(|error| of_ifs(&error))
}

pub(crate) fn read_map3(value: JsValue) -> Result<Affine3, JsValue> {
    Ok(Affine3::from_row(read("The transform", value)?))
}

pub(crate) fn write_maps3(maps: &[Affine3]) -> Result<JsValue, JsValue> {
    write(&maps.iter().map(|map| map.to_row()).collect::<Vec<Row3>>())
}

pub(crate) fn read_point3(what: &str, value: JsValue) -> Result<DVec3, JsValue> {
    let point = DVec3::from_array(read(what, value)?);
    if point.is_finite() { Ok(point) } else { Err(bad_input(what, "three finite numbers are needed")) }
}

pub(crate) fn of_transform(error: &TransformError) -> JsValue {
    failure(error.code(), &error.to_string())
}
