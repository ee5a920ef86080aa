//! Maps as text, and a link in a picture.

use frond_core::{DirectedError, IfsError, MAX_MAPS, MAX_STATES};
use frond_exchange::{DirectedCopy, ExportError, ExportFormat, Maps, System, export, png_with_link};
use js_sys::{Array, Reflect};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure, of_ifs};
use crate::boundary::palette::read_palette;
use crate::boundary::value::{longer_than, read, write};

#[derive(Serialize)]
struct PlainFormat {
    id: &'static str,
    label: &'static str,
    about: &'static str,
    extension: &'static str,
    space: bool,
}

/// The forms that `exportMaps` writes.
#[wasm_bindgen(js_name = exportFormats, unchecked_return_type = "ExportFormatInfo[]")]
pub fn export_formats() -> Result<JsValue, JsValue> {
    let all = ExportFormat::ALL.map(|format| PlainFormat {
        id: format.id(),
        label: format.label(),
        about: format.about(),
        extension: format.extension(),
        space: format.takes_space(),
    });
    write(&all)
}

#[derive(Deserialize)]
struct PlainSystem<Row> {
    #[serde(default)]
    name: String,
    maps: Vec<Row>,
    #[serde(default)]
    probabilities: Vec<f64>,
    #[serde(default)]
    colours: Vec<String>,
}

#[derive(Deserialize)]
struct PlainStates {
    #[serde(default)]
    name: String,
    states: Vec<Vec<DirectedCopy>>,
}

/// Maps of the plane or of space as a text; in AIFS also a graph-directed system, by its `states`. Throws where there
/// are none, or the form is one of the plane alone.
#[wasm_bindgen(js_name = exportMaps)]
pub fn export_maps(
    #[wasm_bindgen(
        unchecked_param_type = "{ name?: string; maps: MapRow[] | MapRow3[]; probabilities?: number[]; colours?: string[] } | { name?: string; states: DirectedMap[][] }"
    )]
    system: JsValue,
    #[wasm_bindgen(unchecked_param_type = "ExportFormat")] format: &str,
) -> Result<String, JsValue> {
    let format =
        ExportFormat::by_id(format).ok_or_else(|| bad_input("format", "there is none of this name"))?;
    let states = Reflect::get(&system, &"states".into()).unwrap_or(JsValue::UNDEFINED);
    if states.is_object() {
        return export(&read_states(system, &states)?, format).map_err(|error| of_export(&error));
    }
    let maps = Reflect::get(&system, &"maps".into()).unwrap_or(JsValue::UNDEFINED);
    // Before any of them is read.
    if let Some(count) = longer_than(&maps, MAX_MAPS) {
        return Err(of_ifs(&IfsError::TooManyMaps { count }));
    }
    let solid = maps.dyn_ref::<Array>().is_some_and(|maps| longer_than(&maps.get(0), 6).is_some());
    let system = if solid {
        let PlainSystem { name, maps, probabilities, .. } = read("The system", system)?;
        System { probabilities, ..System::space(name, maps) }
    } else {
        let PlainSystem { name, maps, probabilities, colours } = read("The system", system)?;
        let colours = read_palette(&colours)?;
        System { probabilities, colours, ..System::plane(name, maps) }
    };
    export(&system, format).map_err(|error| of_export(&error))
}

/// A graph-directed system. Longer lists than allowed are refused before they are read.
fn read_states(system: JsValue, states: &JsValue) -> Result<System, JsValue> {
    let refused = |error: &DirectedError| failure(error.code(), &error.to_string());
    if let Some(count) = longer_than(states, MAX_STATES) {
        return Err(refused(&DirectedError::TooManyStates { count, most: MAX_STATES }));
    }
    for (state, maps) in Array::from(states).iter().enumerate() {
        if let Some(count) = longer_than(&maps, MAX_MAPS) {
            return Err(refused(&DirectedError::TooManyMaps { state, count }));
        }
    }
    let PlainStates { name, states } = read("The system", system)?;
    let count = states.len();
    for (state, maps) in states.iter().enumerate() {
        if let Some(map) = maps.iter().position(|copy| copy.from >= count) {
            let from = maps[map].from;
            return Err(refused(&DirectedError::From { state, map, from, states: count }));
        }
    }
    Ok(System::of(name, Maps::Directed(states)))
}

fn of_export(error: &ExportError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// The same picture with a link in it, which `importFile` finds again. Throws where it is no PNG.
#[wasm_bindgen(js_name = pngWithLink)]
pub fn write_link(png: &[u8], link: &str) -> Result<Vec<u8>, JsValue> {
    png_with_link(png, link)
        .ok_or_else(|| bad_input("The picture", "a PNG is needed, and a link of at most a megabyte"))
}
