//! Meshes of shapes of space, for 3-D printers.

use frond_render::mesh::file::{MeshFormat, glb, ply, stl};
use frond_render::mesh::{Mesh, MeshError, MeshOptions, Mesher};
use js_sys::{Array, Uint8Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use super::picture::read_objects;
use crate::boundary::error::{bad_input, failure};
use crate::boundary::palette::read_palette;
use crate::boundary::value::{read, write};

#[derive(Deserialize)]
struct PlainOptions {
    fineness: f64,
    size: f64,
    #[serde(default)]
    wall: f64,
}

#[derive(Serialize)]
struct Facts {
    triangles: usize,
    parts: usize,
    size: [f32; 3],
    volume: f64,
    wall: f64,
}

fn of_mesh(error: &MeshError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn format_of(id: &str) -> Result<MeshFormat, JsValue> {
    MeshFormat::by_id(id).ok_or_else(|| bad_input("format", "it is \"stl\", \"ply\" or \"glb\""))
}

/// About how many bytes a mesh of so many triangles has.
#[wasm_bindgen(js_name = meshBytes)]
pub fn bytes_of_mesh(
    #[wasm_bindgen(unchecked_param_type = "MeshFormat")] format: &str,
    triangles: f64,
) -> Result<f64, JsValue> {
    Ok(format_of(format)?.bytes(triangles))
}

/// A watertight surface around objects, in the making: `run` it until it is done, then `finish` it.
#[wasm_bindgen]
pub struct SpaceMesher {
    mesher: Mesher,
    /// Of each object its own colour, and how many maps it has.
    tints: Vec<(Option<[u8; 3]>, usize)>,
}

#[wasm_bindgen]
impl SpaceMesher {
    /// Of `{ maps, tint? }` each. `fineness` is the number of samples along the longest side, of `size` millimetres,
    /// and `wall` how thick it is at least, in millimetres. Throws where that is too much.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "{ maps: MapRow3[]; tint?: string }[]")] objects: Array,
        #[wasm_bindgen(unchecked_param_type = "MeshOptions")] options: JsValue,
    ) -> Result<Self, JsValue> {
        let PlainOptions { fineness, size, wall } = read("The options", options)?;
        // What is printed is the shape before it is bent.
        let (systems, tints, _) = read_objects(&objects, &[])?;
        let mesher =
            Mesher::new(&systems, MeshOptions { fineness, size, wall }).map_err(|error| of_mesh(&error))?;
        let tints = tints.into_iter().zip(systems.iter().map(|ifs| ifs.len())).collect();
        Ok(Self { mesher, tints })
    }

    /// Follows `budget` pieces at most. Whether all are followed. Throws where there are too many.
    pub fn run(&mut self, budget: f64) -> Result<bool, JsValue> {
        self.mesher.run(budget.clamp(1.0, 1e9) as usize).map_err(|error| of_mesh(&error))
    }

    /// How many points of the objects were found so far.
    #[wasm_bindgen(getter)]
    pub fn found(&self) -> f64 {
        self.mesher.found() as f64
    }

    /// The surface; this handle is used up. Throws where it has too many triangles.
    pub fn finish(self) -> Result<SpaceMesh, JsValue> {
        let wall = self.mesher.wall();
        let mesh = self.mesher.finish().map_err(|error| of_mesh(&error))?;
        Ok(SpaceMesh { mesh, wall, tints: self.tints })
    }
}

/// A watertight surface.
#[wasm_bindgen]
pub struct SpaceMesh {
    mesh: Mesh,
    wall: f64,
    tints: Vec<(Option<[u8; 3]>, usize)>,
}

#[wasm_bindgen]
impl SpaceMesh {
    /// What there is to say of it: millimetres, and cubic ones.
    #[wasm_bindgen(unchecked_return_type = "MeshFacts")]
    pub fn facts(&self) -> Result<JsValue, JsValue> {
        let [least, largest] = self.mesh.bounds();
        write(&Facts {
            triangles: self.mesh.triangles.len(),
            parts: self.mesh.parts(),
            size: (largest - least).to_array(),
            volume: self.mesh.volume(),
            wall: self.wall,
        })
    }

    /// The whole file. `palette` has the colours of maps, "#rrggbb", repeated, where an object has none of its own; STL
    /// has no colours.
    pub fn file(
        &self,
        #[wasm_bindgen(unchecked_param_type = "MeshFormat")] format: &str,
        palette: Vec<String>,
    ) -> Result<Uint8Array, JsValue> {
        let palette = read_palette(&palette)?;
        let white = [255; 3];
        let of = |&(tint, maps): &(Option<[u8; 3]>, usize)| {
            let palette = &palette;
            (0..maps).map(move |map| {
                tint.unwrap_or_else(|| palette.get(map % palette.len().max(1)).copied().unwrap_or(white))
            })
        };
        let colours: Vec<[u8; 3]> = self.tints.iter().flat_map(of).collect();
        let bytes = match format_of(format)? {
            MeshFormat::Stl => stl(&self.mesh),
            MeshFormat::Ply => ply(&self.mesh, &colours),
            MeshFormat::Glb => glb(&self.mesh, &colours),
        };
        Ok(Uint8Array::from(&bytes[..]))
    }
}
