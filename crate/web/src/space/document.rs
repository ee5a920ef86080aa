//! What there is in space, its gallery, its links and its moments.

use frond_scene::{Film, FilmError, Moved, PackedError, Row3, Space, SpaceView};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::{read, write};

#[derive(Serialize)]
struct Item {
    id: &'static str,
    name: &'static str,
    about: &'static str,
    maps: &'static [Row3],
}

/// The gallery of space.
#[wasm_bindgen(js_name = presets3, unchecked_return_type = "Preset3[]")]
pub fn gallery3() -> Result<JsValue, JsValue> {
    let items: Vec<Item> = frond_scene::presets3()
        .iter()
        .map(|p| Item { id: p.id, name: p.name, about: p.about, maps: &p.maps })
        .collect();
    write(&items)
}

/// The objects of the natural scene, z up, the eye at the origin and the scene along x.
#[wasm_bindgen(js_name = naturalScene, unchecked_return_type = "SpaceObject[]")]
pub fn natural() -> Result<JsValue, JsValue> {
    write(&frond_scene::natural_objects())
}

/// The same with its light and its sky.
#[wasm_bindgen(js_name = naturalSpace, unchecked_return_type = "Space")]
pub fn natural_space() -> Result<JsValue, JsValue> {
    write(&frond_scene::natural_space())
}

/// What the tool begins with.
#[wasm_bindgen(js_name = defaultSpace, unchecked_return_type = "Space")]
pub fn default_space() -> Result<JsValue, JsValue> {
    write(&Space::default())
}

/// The view that shows all of it, from a little above; that of the eye at the origin for the natural scene.
#[wasm_bindgen(js_name = defaultView, unchecked_return_type = "SpaceView")]
pub fn default_view(
    #[wasm_bindgen(unchecked_param_type = "Space")] space: JsValue,
) -> Result<JsValue, JsValue> {
    write(&read_space(space)?.whole_view())
}

/// A space as a word of a link. Throws where it could not be read back.
#[wasm_bindgen(js_name = packSpace)]
pub fn pack_space(#[wasm_bindgen(unchecked_param_type = "Space")] space: JsValue) -> Result<String, JsValue> {
    frond_scene::pack(&read_space(space)?).map_err(|error| of_packed(&error))
}

/// What a word of a link says. Throws where it is damaged, or a shape has no attractor.
#[wasm_bindgen(js_name = unpackSpace, unchecked_return_type = "Space")]
pub fn unpack_space(packed: &str) -> Result<JsValue, JsValue> {
    write(&frond_scene::unpack(packed).map_err(|error| of_packed(&error))?)
}

fn read_space(value: JsValue) -> Result<Space, JsValue> {
    let objects = js_sys::Reflect::get(&value, &"objects".into()).unwrap_or(JsValue::UNDEFINED);
    // Before any of it is read: the list may be of any length.
    let count = js_sys::Array::is_array(&objects).then(|| js_sys::Array::from(&objects).length() as usize);
    if let Some(count) = count.filter(|&count| count > frond_scene::MAX_OBJECTS3) {
        let error = PackedError::Count { what: "objects", count, range: "1 to 60" };
        return Err(of_packed(&error));
    }
    read("The space", value)
}

fn of_packed(error: &PackedError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn of_film(error: &FilmError) -> JsValue {
    failure(error.code(), &error.to_string())
}

#[derive(Serialize)]
struct PlainMoved {
    maps: Vec<Row3>,
    moved: Row3,
    now: Vec<Row3>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bend: Option<Vec<[f64; 3]>>,
}

#[derive(Serialize)]
struct PlainMoment {
    objects: Vec<PlainMoved>,
    #[serde(skip_serializing_if = "Option::is_none")]
    view: Option<SpaceView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    t: Option<f64>,
}

/// A space at any moment.
#[wasm_bindgen]
pub struct SpaceMotion(Film);

#[wasm_bindgen]
impl SpaceMotion {
    /// Throws where keys cannot be played, or the morph is none.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Space")] space: JsValue) -> Result<Self, JsValue> {
        Film::new(&read_space(space)?).map(Self).map_err(|error| of_film(&error))
    }

    /// All that is at a time in seconds. Throws where something has no attractor then.
    #[wasm_bindgen(unchecked_return_type = "SpaceFrame")]
    pub fn at(&self, seconds: f64) -> Result<JsValue, JsValue> {
        let moment = self.0.at(seconds).map_err(|error| of_film(&error))?;
        let objects = moment
            .objects
            .into_iter()
            .map(|Moved { maps, moved, now, bend }| PlainMoved { maps, moved, now, bend })
            .collect();
        write(&PlainMoment { objects, view: moment.view, t: moment.t })
    }
}
