//! The document and its links.

use frond_scene::Scene;
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{failure, of_ifs};
use crate::boundary::value::{object, read, write};

#[derive(Serialize)]
struct Item {
    id: &'static str,
    name: &'static str,
    about: &'static str,
    maps: Vec<[f64; 6]>,
}

/// The gallery.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn presets() -> Result<JsValue, JsValue> {
    let items: Vec<Item> = frond_scene::presets()
        .into_iter()
        .map(|p| Item { id: p.id, name: p.name, about: p.about, maps: p.maps })
        .collect();
    write(&items)
}

/// What a visitor sees first.
#[wasm_bindgen(js_name = defaultScene, unchecked_return_type = "Scene")]
pub fn default_scene() -> Result<JsValue, JsValue> {
    write(&Scene::default())
}

/// The link of a document: the fragment of a URL, without the `#`. Throws where it would not open again: a shape has no
/// attractor, a curve cannot be written, a number is out of its range, or it would be longer than 64 KiB.
#[wasm_bindgen(js_name = encodeScene)]
pub fn encode_scene(
    #[wasm_bindgen(unchecked_param_type = "Scene")] scene: JsValue,
) -> Result<String, JsValue> {
    let scene: Scene = read("The scene", scene)?;
    for shape in [&scene.a, &scene.b] {
        shape.ifs().map_err(|error| of_ifs(&error))?;
    }
    frond_scene::encode(&scene).map_err(|error| failure(error.code(), &error.to_string()))
}

/// The document of a link. Never throws: a link that cannot be read gives the default document and a problem.
#[wasm_bindgen(js_name = decodeScene, unchecked_return_type = "{ scene: Scene; problem?: FrondError }")]
pub fn decode_scene(text: &str) -> Result<JsValue, JsValue> {
    let (scene, problem) = frond_scene::decode(text);
    let mut fields = vec![("scene", write(&scene)?)];
    if let Some(problem) = problem {
        let plain = object(&[("code", problem.code().into()), ("message", problem.to_string().into())]);
        fields.push(("problem", plain));
    }
    Ok(object(&fields))
}
