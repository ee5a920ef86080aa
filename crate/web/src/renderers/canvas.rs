//! A canvas, and the graphics device behind it.

use std::rc::Rc;

use frond_render::gpu::{Canvas, Event, Gpu, ReadBack, Wanted};
use js_sys::{Array, Function, Promise, Reflect, Uint8Array, global};
use serde::Deserialize;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, future_to_promise, spawn_local};
use web_sys::{EventTarget, HtmlCanvasElement, OffscreenCanvas};

use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::read;

#[derive(Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Backend {
    #[default]
    Auto,
    Webgpu,
    Webgl2,
}

#[derive(Deserialize)]
struct Options {
    #[serde(default)]
    backend: Backend,
}

/// A canvas that a renderer draws on: it hears when its context goes.
pub(crate) struct Held {
    canvas: Canvas,
    context_lost: Closure<dyn Fn()>,
}

/// Opens the graphics card for a canvas, as the options of a renderer say.
pub(crate) async fn open(canvas: JsValue, options: JsValue) -> Result<(Gpu, Held), JsValue> {
    let on_lost = Reflect::get(&options, &"onLost".into()).ok().and_then(|f| f.dyn_into::<Function>().ok());
    let plain: Options = read("The options", options)?;
    let wanted = match plain.backend {
        Backend::Auto => Wanted::Auto,
        Backend::Webgpu => Wanted::WebGpu,
        Backend::Webgl2 => Wanted::WebGl2,
    };
    let canvas = as_canvas(canvas)?;
    let gpu = Gpu::open(&canvas, wanted, Rc::new(move |event| hear(event, on_lost.as_ref())))
        .await
        .map_err(|error| failure(error.code(), &error.to_string()))?;
    // Nobody else sees it when the context of WebGL goes.
    let loss = gpu.loss();
    let context_lost = Closure::<dyn Fn()>::new(move || loss.tell("the browser took the WebGL context away"));
    let callback = context_lost.as_ref().unchecked_ref();
    // It fails for no event name that is a string.
    let _ = events_of(&canvas).add_event_listener_with_callback(CONTEXT_LOST, callback);
    Ok((gpu, Held { canvas, context_lost }))
}

impl Held {
    /// Loses the device, for tests.
    pub(crate) fn lose(&self, gpu: &Gpu) {
        if gpu.backend == "webgl2" {
            // What is missing here leaves the context alone; the device counts as lost all the same.
            let _ = lose_context(&self.canvas);
        }
        gpu.destroy();
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        let callback = self.context_lost.as_ref().unchecked_ref();
        let _ = events_of(&self.canvas).remove_event_listener_with_callback(CONTEXT_LOST, callback);
    }
}

/// What is being read back, as a promise of its pixels.
pub(crate) fn pixels_of(read: Option<ReadBack>) -> Promise {
    future_to_promise(async move {
        let none = || failure("no-picture", "There is no picture to read. Draw one first.");
        let pixels = arrival(read.ok_or_else(none)?).await?;
        pixels
            .map(|bytes| Uint8Array::from(&bytes[..]).into())
            .ok_or_else(|| failure("device-lost", "The graphics device was lost. Create another renderer."))
    })
}

/// What every renderer tells of its card and canvas: for a class with a `stage` and a `held` canvas.
macro_rules! canvas_methods {
    ($class:ident) => {
        #[wasm_bindgen]
        impl $class {
            /// `"webgpu"` or `"webgl2"`.
            #[wasm_bindgen(getter, unchecked_return_type = "\"webgpu\" | \"webgl2\"")]
            pub fn backend(&self) -> String {
                self.stage.gpu().backend.to_owned()
            }

            /// The adapter's own words; may be empty.
            #[wasm_bindgen(getter)]
            pub fn description(&self) -> String {
                self.stage.gpu().description.clone()
            }

            /// The last picture, read back from the engine's own texture: RGBA with straight alpha, row 0 on top.
            /// Rejects when there is none, or the device is lost.
            #[wasm_bindgen(js_name = readPixels, unchecked_return_type = "Promise<Uint8Array>")]
            pub fn read_pixels(&self) -> Promise {
                pixels_of(self.stage.read())
            }

            /// Loses the device, for tests.
            #[wasm_bindgen(js_name = forceLoss)]
            pub fn force_loss(&mut self) {
                self.held.lose(self.stage.gpu());
            }
        }
    };
}
pub(crate) use canvas_methods;

const CONTEXT_LOST: &str = "webglcontextlost";

fn as_canvas(value: JsValue) -> Result<Canvas, JsValue> {
    let other = match value.dyn_into::<HtmlCanvasElement>() {
        Ok(canvas) => return Ok(Canvas::Html(canvas)),
        Err(other) => other,
    };
    let canvas = other.dyn_into::<OffscreenCanvas>();
    canvas
        .map(Canvas::Offscreen)
        .map_err(|_| bad_input("The canvas", "a canvas element or an OffscreenCanvas is needed"))
}

fn events_of(canvas: &Canvas) -> &EventTarget {
    match canvas {
        Canvas::Html(canvas) => canvas,
        Canvas::Offscreen(canvas) => canvas,
    }
}

/// Passes an event on, later: what it calls may free the renderer, which may be at work right now.
fn hear(event: &Event, on_lost: Option<&Function>) {
    match event {
        Event::Lost(reason) => {
            let Some(on_lost) = on_lost.cloned() else { return };
            let reason = JsValue::from(reason);
            spawn_local(async move {
                // What the page throws there is the page's.
                let _ = on_lost.call1(&JsValue::UNDEFINED, &reason);
            });
        }
        Event::Fault(message) => web_sys::console::error_1(&message.into()),
    }
}

/// Waits for a picture, letting the browser work meanwhile.
async fn arrival(read: ReadBack) -> Result<Option<Vec<u8>>, JsValue> {
    loop {
        if let Some(pixels) = read.take() {
            return Ok(pixels);
        }
        let timer: Function = Reflect::get(&global(), &"setTimeout".into())?.dyn_into()?;
        let mut wait = |resolve: Function, _| {
            // If it cannot wait it polls again at once.
            if timer.call2(&JsValue::UNDEFINED, &resolve, &1.into()).is_err() {
                let _ = resolve.call0(&JsValue::UNDEFINED);
            }
        };
        JsFuture::from(Promise::new(&mut wait)).await?;
    }
}

fn lose_context(canvas: &Canvas) -> Result<(), JsValue> {
    let call = |object: &JsValue, method: &str, argument: &str| -> Result<JsValue, JsValue> {
        let method: Function = Reflect::get(object, &method.into())?.dyn_into()?;
        method.apply(object, &Array::of1(&argument.into()))
    };
    let canvas: &JsValue = match canvas {
        Canvas::Html(canvas) => canvas,
        Canvas::Offscreen(canvas) => canvas,
    };
    let context = call(canvas, "getContext", "webgl2")?;
    let extension = call(&context, "getExtension", "WEBGL_lose_context")?;
    call(&extension, "loseContext", "").map(|_| ())
}
