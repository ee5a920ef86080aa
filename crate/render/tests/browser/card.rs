//! What a graphics card is asked, and waited for.

use frond_render::gpu::{Canvas, Event, Gpu, ReadBack, Wanted};
use js_sys::{Function, Promise, Reflect, global};
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::console_log;
use web_sys::OffscreenCanvas;

/// Those that this program is built with: both can be, but the modules of the page have one each, and so their crates
/// are compiled already.
pub const BACKENDS: &[Wanted] = &[
    #[cfg(feature = "webgl2")]
    Wanted::WebGl2,
    #[cfg(feature = "webgpu")]
    Wanted::WebGpu,
];

/// A card by this backend and no other: webdriver.json has Chromium bring a software GPU for both.
pub async fn card([width, height]: [u32; 2], wanted: Wanted, listener: impl Fn(&Event) + 'static) -> Gpu {
    let canvas = Canvas::Offscreen(OffscreenCanvas::new(width, height).unwrap());
    let gpu = match Gpu::open(&canvas, wanted, Rc::new(listener)).await {
        Ok(gpu) => gpu,
        Err(error) => panic!("{wanted:?}: {error}"),
    };
    assert_eq!(gpu.backend, if wanted == Wanted::WebGpu { "webgpu" } else { "webgl2" });
    console_log!("{}: {}", gpu.backend, gpu.description);
    gpu
}

/// Lets the browser do something else.
async fn pause() {
    let mut wait = |resolve: Function, _| {
        let timer: Function = Reflect::get(&global(), &"setTimeout".into()).unwrap().dyn_into().unwrap();
        timer.call2(&JsValue::UNDEFINED, &resolve, &1.into()).unwrap();
    };
    JsFuture::from(Promise::new(&mut wait)).await.unwrap();
}

/// The picture that was asked for.
pub async fn picture_of(read: Option<ReadBack>) -> Vec<u8> {
    let read = read.unwrap();
    loop {
        if let Some(picture) = read.take() {
            return picture.unwrap();
        }
        pause().await;
    }
}
