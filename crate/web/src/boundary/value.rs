//! Values that cross the boundary.

use frond_core::{Affine2, Ifs, IfsError, MAX_MAPS, Mode, Morph, MorphOptions};
use glam::DVec2;
use js_sys::{Array, ArrayBuffer, Object, Reflect};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use wasm_bindgen::{JsCast, JsValue};

use crate::boundary::error::{bad_input, of_ifs, of_morph};

/// A row of six numbers.
pub(crate) type Row = [f64; 6];

/// Reads a plain object; `undefined` and `null` are read as the empty one, and a field that is `undefined` as absent.
pub(crate) fn read<T: DeserializeOwned>(what: &str, value: JsValue) -> Result<T, JsValue> {
    let value = if value.is_undefined() || value.is_null() { Object::new().into() } else { defined(value) };
    serde_wasm_bindgen::from_value(value).map_err(|error| {
        let why = error.to_string();
        bad_input(what, why.strip_prefix("Error: ").unwrap_or(&why))
    })
}

/// Reads what may be left out and has no empty form, such as a box: `undefined` and `null` are none.
pub(crate) fn read_given<T: DeserializeOwned>(what: &str, value: JsValue) -> Result<Option<T>, JsValue> {
    if value.is_undefined() || value.is_null() { Ok(None) } else { read(what, value).map(Some) }
}

/// The object, or a copy without the fields that are `undefined`: `{ seed: options.seed }` is how options are handed
/// on.
fn defined(value: JsValue) -> JsValue {
    let Some(object) = value.dyn_ref::<Object>() else { return value };
    if Array::is_array(&value) || ArrayBuffer::is_view(&value) {
        return value;
    }
    let absent: Vec<JsValue> = Object::keys(object)
        .iter()
        .filter(|key| Reflect::get(object, key).is_ok_and(|field| field.is_undefined()))
        .collect();
    if absent.is_empty() {
        return value;
    }
    let copy = Object::assign(&Object::new(), object);
    for key in &absent {
        // Deleting a property of a fresh object cannot fail.
        let _ = Reflect::delete_property(&copy, key);
    }
    copy.into()
}

/// Writes a plain object.
pub(crate) fn write<T: Serialize>(value: &T) -> Result<JsValue, JsValue> {
    value
        .serialize(&serde_wasm_bindgen::Serializer::json_compatible())
        .map_err(|error| bad_input("The result", &error.to_string()))
}

/// An object from its fields, some of which may be typed arrays.
pub(crate) fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in fields {
        // Setting a property of a fresh object cannot fail.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}

#[derive(Deserialize)]
struct PlainIfs {
    maps: Vec<Row>,
    #[serde(default)]
    probabilities: Option<Vec<f64>>,
}

/// The maps of an IFS object, whether or not they have an attractor. Longer lists than allowed are refused
/// before their entries are read.
pub(crate) fn read_maps(value: &JsValue) -> Result<Vec<Affine2>, JsValue> {
    Ok(read_plain(value)?.maps.into_iter().map(Affine2::from_row).collect())
}

/// An IFS object that has an attractor.
pub(crate) fn read_ifs(value: &JsValue) -> Result<Ifs, JsValue> {
    let plain = read_plain(value)?;
    let maps = plain.maps.into_iter().map(Affine2::from_row).collect();
    let ifs = Ifs::new(maps).map_err(|error| of_ifs(&error))?;
    match plain.probabilities {
        None => Ok(ifs),
        Some(list) => ifs.with_probabilities(&list).map_err(|error| of_ifs(&error)),
    }
}

/// The probabilities that an IFS object gives, if it does.
pub(crate) fn given_probabilities(value: &JsValue) -> Result<Option<Vec<f64>>, JsValue> {
    Ok(read_plain(value)?.probabilities)
}

fn read_plain(value: &JsValue) -> Result<PlainIfs, JsValue> {
    let maps = Reflect::get(value, &"maps".into()).unwrap_or(JsValue::UNDEFINED);
    if let Some(list) = maps.dyn_ref::<Array>() {
        let count = list.length() as usize;
        if count > MAX_MAPS {
            return Err(of_ifs(&IfsError::TooManyMaps { count }));
        }
    }
    read("The IFS", value.clone())
}

/// An IFS object without probabilities.
pub(crate) fn write_maps(maps: &[Affine2]) -> Result<JsValue, JsValue> {
    Ok(object(&[("maps", write(&rows(maps))?)]))
}

pub(crate) fn rows(maps: &[Affine2]) -> Vec<Row> {
    maps.iter().map(|map| map.to_row()).collect()
}

pub(crate) fn point(p: DVec2) -> [f64; 2] {
    p.to_array()
}

#[derive(Deserialize)]
struct PlainMorph {
    #[serde(default)]
    mode: Mode,
    #[serde(default)]
    correspondence: Vec<usize>,
    #[serde(default)]
    turns: Vec<i32>,
}

/// The fields `mode`, `correspondence` and `turns` of an object, all of which may be absent.
pub(crate) fn read_morph_options(options: &JsValue) -> Result<MorphOptions, JsValue> {
    let PlainMorph { mode, correspondence, turns } = read("The options", options.clone())?;
    Ok(MorphOptions { mode, correspondence, turns })
}

/// The family between two IFS objects, by the fields of `options` that [`read_morph_options`] reads.
pub(crate) fn read_morph(from: &JsValue, to: &JsValue, options: &JsValue) -> Result<Morph, JsValue> {
    let (from, to) = (read_maps(from)?, read_maps(to)?);
    Morph::new(&from, &to, &read_morph_options(options)?).map_err(|error| of_morph(&error))
}

#[derive(Deserialize)]
struct Parameters {
    u: f64,
    v: f64,
    #[serde(default)]
    w: f64,
}

/// The fields `u`, `v` and `w` of an object; the last may be absent.
pub(crate) fn read_parameters(options: JsValue) -> Result<[f64; 3], JsValue> {
    let Parameters { u, v, w } = read("The options", options)?;
    Ok([u, v, w])
}

/// A list that is too long, before its entries are read.
pub(crate) fn longer_than(value: &JsValue, most: usize) -> Option<usize> {
    value.dyn_ref::<Array>().map(|list| list.length() as usize).filter(|&length| length > most)
}
