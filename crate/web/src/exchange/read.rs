//! Files with maps.

use frond_exchange::{Camera, DirectedCopy, ImportError, Imported, Maps, System, import, link_in_png};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::write;

#[derive(Serialize)]
struct PlainSystem {
    name: String,
    dimension: u8,
    maps: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    states: Option<Vec<Vec<DirectedCopy>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    objects: Option<Vec<Vec<Vec<f64>>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    camera: Option<PlainCamera>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    probabilities: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    colours: Vec<String>,
    remarks: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<String>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum PlainCamera {
    Plane { centre: [f64; 2], radius: f64, angle: f64 },
    Space { eye: [f64; 3], target: [f64; 3], up: [f64; 3], field: f64 },
}

impl From<Camera> for PlainCamera {
    fn from(camera: Camera) -> Self {
        match camera {
            Camera::Plane { centre, radius, angle } => Self::Plane { centre, radius, angle },
            Camera::Space { eye, target, up, field } => Self::Space { eye, target, up, field },
        }
    }
}

impl From<System> for PlainSystem {
    fn from(system: System) -> Self {
        let problem = system.check().err().map(|error| error.to_string());
        let System { name, maps, probabilities, colours, remarks, camera, .. } = system;
        let colours = colours.iter().map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}")).collect();
        let lists = |rows: &[[f64; 12]]| rows.iter().map(|row| row.to_vec()).collect::<Vec<_>>();
        let (dimension, maps, states, objects) = match maps {
            Maps::Plane(rows) => (2, rows.iter().map(|row| row.to_vec()).collect(), None, None),
            Maps::Space(rows) => (3, lists(&rows), None, None),
            Maps::Directed(states) => (2, Vec::new(), Some(states), None),
            Maps::Objects(all) => (3, Vec::new(), None, Some(all.iter().map(|rows| lists(rows)).collect())),
        };
        let camera = camera.map(PlainCamera::from);
        Self { name, dimension, maps, states, objects, camera, probabilities, colours, remarks, problem }
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
