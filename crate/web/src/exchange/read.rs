//! Files with maps.

use frond_exchange::{ImportError, Imported, Maps, System, import, link_in_png};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::write;

#[derive(Serialize)]
struct PlainSystem {
    name: String,
    dimension: u8,
    maps: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    probabilities: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    colours: Vec<String>,
    remarks: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<String>,
}

impl From<System> for PlainSystem {
    fn from(system: System) -> Self {
        let problem = system.check().err().map(|error| error.to_string());
        let System { name, maps, probabilities, colours, remarks } = system;
        let colours = colours.iter().map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}")).collect();
        let (dimension, maps) = match maps {
            Maps::Plane(rows) => (2, rows.iter().map(|row| row.to_vec()).collect()),
            Maps::Space(rows) => (3, rows.iter().map(|row| row.to_vec()).collect()),
        };
        Self { name, dimension, maps, probabilities, colours, remarks, problem }
    }
}

#[derive(Serialize)]
struct PlainFile {
    format: &'static str,
    systems: Vec<PlainSystem>,
    remarks: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    link: Option<String>,
}

/// What is in a file: the systems of a Fractint, flame, IFStile, JSON or table file, or the document in a PNG or JSON
/// of Frond. It is known by its content. Throws with the line where it is wrong.
#[wasm_bindgen(js_name = importFile, unchecked_return_type = "ImportedFile")]
pub fn import_file(bytes: &[u8]) -> Result<JsValue, JsValue> {
    let Imported { format, systems, remarks, link } = import(bytes).map_err(|error| of_import(&error))?;
    let systems = systems.into_iter().map(PlainSystem::from).collect();
    write(&PlainFile { format: format.id(), systems, remarks, link })
}

/// The fragment of the link that Frond wrote into a PNG; undefined where there is none.
#[wasm_bindgen(js_name = linkInPng)]
pub fn find_link(png: &[u8]) -> Option<String> {
    link_in_png(png)
}

fn of_import(error: &ImportError) -> JsValue {
    failure(error.code(), &error.to_string())
}
