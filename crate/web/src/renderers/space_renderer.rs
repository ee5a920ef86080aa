//! The picture of space on a canvas, by the graphics card.

use bytemuck::{AnyBitPattern, pod_collect_to_vec, try_pod_read_unaligned};
use frond_render::gpu::{Drawn3, Stage3, Uniforms3};
use frond_render::solid::Cloud;
use js_sys::{Array, Promise, Reflect, Uint8Array};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;
use crate::boundary::value::object;
use crate::renderers::canvas::{Held, canvas_methods, open, pixels_of};

/// Draws attractors of space on one canvas, on WebGPU or WebGL2. Lengths are device pixels; clouds and uniforms are
/// bytes that `SpacePicture` of the module `frond-space` makes, as the shaders read them.
///
/// A change of the clouds, the size or the eye shows points, and a carved picture from when it is set. Call `draw`
/// after each.
#[wasm_bindgen]
pub struct SpaceRenderer {
    stage: Stage3,
    held: Held,
}

#[wasm_bindgen]
impl SpaceRenderer {
    /// Opens the graphics card for a canvas that has had no context yet, as `Renderer.create` does.
    pub async fn create(
        #[wasm_bindgen(unchecked_param_type = "HTMLCanvasElement | OffscreenCanvas")] canvas: JsValue,
        #[wasm_bindgen(
            unchecked_optional_param_type = "{ backend?: \"auto\" | \"webgpu\" | \"webgl2\"; onLost?: (reason: string) => void }"
        )]
        options: JsValue,
    ) -> Result<SpaceRenderer, JsValue> {
        let (gpu, held) = open(canvas, options).await?;
        Ok(Self { stage: Stage3::new(gpu), held })
    }

    /// Sets the size of the canvas.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.stage.resize(width, height);
    }

    /// Sets the points, a cloud for each object.
    #[wasm_bindgen(js_name = setClouds)]
    pub fn set_clouds(
        &mut self,
        #[wasm_bindgen(
            unchecked_param_type = "{ vertices: Uint8Array; instances: Uint8Array; gap: number }[]"
        )]
        clouds: Array,
    ) -> Result<(), JsValue> {
        let cloud = |value: JsValue| {
            let gap = Reflect::get(&value, &"gap".into()).ok().and_then(|gap| gap.as_f64()).unwrap_or(0.0);
            let (vertices, instances) = (list(&value, "vertices")?, list(&value, "instances")?);
            Ok(Cloud { vertices, instances, gap: gap as f32 })
        };
        let clouds = clouds.iter().map(cloud).collect::<Result<Vec<_>, JsValue>>()?;
        self.stage.set_clouds(&clouds);
        Ok(())
    }

    /// Sets where it is seen from, and light and colours.
    #[wasm_bindgen(js_name = setUniforms)]
    pub fn set_uniforms(
        &mut self,
        #[wasm_bindgen(
            unchecked_param_type = "{ eye: Uint8Array; lamp: Uint8Array; stillLamp: Uint8Array; look: Uint8Array }"
        )]
        bytes: JsValue,
    ) -> Result<(), JsValue> {
        let uniforms = Uniforms3 {
            eye: one(&bytes, "eye")?,
            lamp: one(&bytes, "lamp")?,
            still_lamp: one(&bytes, "stillLamp")?,
            colours: one(&bytes, "look")?,
        };
        self.stage.set_uniforms(uniforms);
        Ok(())
    }

    /// Shows what was carved of these clouds for this eye. Whether it is of the size that the uniforms say.
    #[wasm_bindgen(js_name = setStill)]
    pub fn set_still(&mut self, width: u32, height: u32, depth: &[f32], codes: &[u32]) -> bool {
        self.stage.put_still([width, height], depth, codes)
    }

    /// Draws what is new. `complete` says that the carved picture is shown, `points` how many points there are else.
    #[wasm_bindgen(unchecked_return_type = "{ complete: boolean; points: number }")]
    pub fn draw(&mut self) -> JsValue {
        let Drawn3 { complete, points } = self.stage.draw();
        object(&[("complete", complete.into()), ("points", (points as f64).into())])
    }
}

canvas_methods!(SpaceRenderer);

fn bytes(value: &JsValue, key: &str) -> Result<Vec<u8>, JsValue> {
    let found = Reflect::get(value, &key.into()).ok().and_then(|found| found.dyn_into::<Uint8Array>().ok());
    found.map(|found| found.to_vec()).ok_or_else(|| bad_input(key, "a Uint8Array is needed"))
}

fn list<T: AnyBitPattern + bytemuck::NoUninit>(value: &JsValue, key: &str) -> Result<Vec<T>, JsValue> {
    let bytes = bytes(value, key)?;
    if !bytes.len().is_multiple_of(size_of::<T>()) {
        return Err(bad_input(key, "it holds a part of an item"));
    }
    Ok(pod_collect_to_vec(&bytes))
}

fn one<T: AnyBitPattern>(value: &JsValue, key: &str) -> Result<T, JsValue> {
    try_pod_read_unaligned(&bytes(value, key)?).map_err(|_| bad_input(key, "it is of another size"))
}
