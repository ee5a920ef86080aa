//! Maps as text, and a link in a picture.

use frond_core::{IfsError, MAX_MAPS};
use frond_exchange::{ExportError, ExportFormat, System, export, png_with_link};
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

/// Maps of the plane or of space as a text. Throws where there are none, or the form is one of the plane alone.
#[wasm_bindgen(js_name = exportMaps)]
pub fn export_maps(
    #[wasm_bindgen(
        unchecked_param_type = "{ name?: string; maps: MapRow[] | MapRow3[]; probabilities?: number[]; colours?: string[] }"
    )]
    system: JsValue,
    #[wasm_bindgen(unchecked_param_type = "ExportFormat")] format: &str,
) -> Result<String, JsValue> {
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
    let format =
        ExportFormat::by_id(format).ok_or_else(|| bad_input("format", "there is none of this name"))?;
    export(&system, format).map_err(|error| of_export(&error))
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
