//! What a graphics card is asked, and waited for.

use std::rc::Rc;

use frond_render::gpu::{Canvas, Event, Gpu, ReadBack, Wanted};

#[cfg(target_arch = "wasm32")]
pub use browser::{canvas, pause, print, shown_on};
#[cfg(not(target_arch = "wasm32"))]
pub use native::{canvas, pause, print};

/// The one that this program is built for.
pub const BACKENDS: &[Wanted] = if cfg!(feature = "webgpu") { &[Wanted::WebGpu] } else { &[Wanted::WebGl2] };

/// A card by this backend and no other: webdriver.json has Chromium bring a software GPU for both.
pub async fn card(size: [u32; 2], wanted: Wanted, listener: impl Fn(&Event) + 'static) -> Gpu {
    card_on(&canvas(size), wanted, listener).await
}

/// The same, on a canvas.
pub async fn card_on(canvas: &Canvas, wanted: Wanted, listener: impl Fn(&Event) + 'static) -> Gpu {
    let gpu = match Gpu::open(canvas, wanted, Rc::new(listener)).await {
        Ok(gpu) => gpu,
        Err(error) => panic!("{wanted:?}: {error}"),
    };
    assert_eq!(gpu.backend, if wanted == Wanted::WebGpu { "webgpu" } else { "webgl2" });
    print(&format!("{}: {}", gpu.backend, gpu.description));
    gpu
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

#[cfg(target_arch = "wasm32")]
mod browser {
    use frond_render::gpu::Canvas;
    use js_sys::{Function, Promise, Reflect, Uint8Array, global};
    use wasm_bindgen::prelude::*;
    use wasm_bindgen_futures::JsFuture;
    use wasm_bindgen_test::console_log;
    use web_sys::OffscreenCanvas;

    /// A canvas of such a size.
    pub fn canvas([width, height]: [u32; 2]) -> Canvas {
        Canvas::Offscreen(OffscreenCanvas::new(width, height).unwrap())
    }

    /// What a canvas shows now, with straight alpha: ask in the task that drew it, for its pixels go at the end of
    /// that.
    pub fn shown_on(canvas: &Canvas) -> Vec<u8> {
        let Canvas::Offscreen(canvas) = canvas else { panic!("it is a page's") };
        let code = "const { width, height } = canvas; const plain = new OffscreenCanvas(width, height).getContext('2d'); \
            plain.drawImage(canvas, 0, 0); return new Uint8Array(plain.getImageData(0, 0, width, height).data.buffer);";
        let pixels = Function::new_with_args("canvas", code).call1(&JsValue::UNDEFINED, canvas).unwrap();
        pixels.dyn_into::<Uint8Array>().unwrap().to_vec()
    }

    /// Lets the browser do something else.
    pub async fn pause() {
        let mut wait = |resolve: Function, _| {
            let timer: Function = Reflect::get(&global(), &"setTimeout".into()).unwrap().dyn_into().unwrap();
            timer.call2(&JsValue::UNDEFINED, &resolve, &1.into()).unwrap();
        };
        JsFuture::from(Promise::new(&mut wait)).await.unwrap();
    }

    pub fn print(line: &str) {
        console_log!("{line}");
    }
}

#[cfg(not(target_arch = "wasm32"))]
mod native {
    use frond_render::gpu::Canvas;

    /// None: what is drawn is read.
    pub fn canvas(_: [u32; 2]) -> Canvas {
        Canvas::Texture
    }

    /// Lets the card go on.
    pub async fn pause() {
        std::thread::yield_now();
    }

    pub fn print(line: &str) {
        println!("{line}");
    }
}
