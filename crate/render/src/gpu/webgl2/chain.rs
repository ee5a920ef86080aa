//! The frames of a canvas.

use std::rc::Rc;

use js_sys::{Object, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::WebGl2RenderingContext as Gl;

use super::card::Card;
use super::texture::Texture;
use crate::gpu::canvas::Canvas;
use crate::gpu::events::Loss;
use crate::gpu::words::Format;
use crate::picture::window::Window;

/// What a canvas shows, one frame after the other. They are drawn beside it: textures have their first row on top, a
/// canvas of WebGL has it below.
#[derive(Debug)]
pub struct Chain {
    canvas: Canvas,
    texture: Option<Rc<Texture>>,
}

/// What is shown next.
#[derive(Debug)]
pub struct Frame {
    pub texture: Rc<Texture>,
}

impl Chain {
    /// Opens the context of a canvas.
    #[expect(clippy::unused_async, reason = "the other interface has to wait")]
    pub async fn open(canvas: &Canvas, loss: Loss) -> Result<(Card, Self), String> {
        let options = Object::new();
        for name in ["antialias", "depth"] {
            // It fails for no plain object.
            let _ = Reflect::set(&options, &name.into(), &JsValue::FALSE);
        }
        let context = match canvas {
            Canvas::Html(canvas) => canvas.get_context_with_context_options("webgl2", &options),
            Canvas::Offscreen(canvas) => canvas.get_context_with_context_options("webgl2", &options),
        };
        let context =
            context.map_err(|problem| format!("{problem:?}"))?.ok_or("no context for the canvas")?;
        let gl: Gl = context.dyn_into().map_err(|_| "the canvas has another context")?;
        Ok((Card::new(gl, loss), Self { canvas: canvas.clone(), texture: None }))
    }

    /// Sets the size of the canvas, in pixels.
    pub fn resize(&mut self, card: &Card, width: u32, height: u32) {
        match &self.canvas {
            Canvas::Html(canvas) => {
                canvas.set_width(width);
                canvas.set_height(height);
            }
            Canvas::Offscreen(canvas) => {
                canvas.set_width(width);
                canvas.set_height(height);
            }
        }
        let window = Window { width, height };
        self.texture = Some(Rc::new(Texture::new(card, "frame", window, Format::Canvas)));
    }

    /// A frame, if the canvas has a size.
    pub fn next(&self, _card: &Card) -> Option<Frame> {
        Some(Frame { texture: self.texture.clone()? })
    }

    /// Shows a frame.
    #[expect(clippy::needless_pass_by_value, reason = "it is of no use any more")]
    pub fn present(&self, card: &Card, frame: Frame) {
        let gl = &card.gl;
        gl.bind_framebuffer(Gl::READ_FRAMEBUFFER, card.from.as_ref());
        let (window, texture) = (frame.texture.window, frame.texture.texture.as_ref());
        gl.framebuffer_texture_2d(Gl::READ_FRAMEBUFFER, Gl::COLOR_ATTACHMENT0, Gl::TEXTURE_2D, texture, 0);
        gl.bind_framebuffer(Gl::DRAW_FRAMEBUFFER, None);
        let [width, height] = [window.width, window.height].map(|side| side as i32);
        gl.blit_framebuffer(0, height, width, 0, 0, 0, width, height, Gl::COLOR_BUFFER_BIT, Gl::NEAREST);
    }
}
