//! The context of a canvas.

use web_sys::{WebGl2RenderingContext as Gl, WebGlFramebuffer};

use crate::gpu::events::Loss;

/// A context of WebGL2. When it is lost calls have no effect, and what they would make is not there.
#[derive(Debug)]
pub struct Card {
    pub(super) gl: Gl,
    /// What textures are attached to while they are drawn to, and while they are read.
    pub(super) onto: Option<WebGlFramebuffer>,
    pub(super) from: Option<WebGlFramebuffer>,
    loss: Loss,
    /// Its name, as far as the browser tells.
    pub description: String,
    /// A browser does not say so.
    pub software: bool,
    /// The longest side of what can be drawn to.
    pub max_side: u32,
    /// Whether it can add up weights.
    pub densities: bool,
}

/// Of the extension that tells the card's name.
const UNMASKED_RENDERER: u32 = 0x9246;

impl Card {
    pub const BACKEND: &'static str = "webgl2";

    /// What can be done with a context.
    pub(super) fn new(gl: Gl, loss: Loss) -> Self {
        gl.disable(Gl::DITHER);
        let has = |name: &str| gl.get_extension(name).ok().flatten().is_some();
        let densities = has("EXT_color_buffer_float") || has("EXT_color_buffer_half_float");
        let said = |name| gl.get_parameter(name).ok();
        let word = |name| said(name).and_then(|value| value.as_string()).unwrap_or_default();
        let side = |name| said(name).and_then(|value| value.as_f64()).unwrap_or(0.0) as u32;
        let renderer = if has("WEBGL_debug_renderer_info") { UNMASKED_RENDERER } else { Gl::RENDERER };
        Self {
            description: [word(renderer), word(Gl::VERSION)].join(", "),
            max_side: side(Gl::MAX_TEXTURE_SIZE).min(side(Gl::MAX_RENDERBUFFER_SIZE)),
            onto: gl.create_framebuffer(),
            from: gl.create_framebuffer(),
            software: false,
            densities,
            gl,
            loss,
        }
    }

    /// Tells of a call that was in error. What fails after a loss fails because of it.
    pub(super) fn fault(&self, message: &str) {
        if !self.gl.is_context_lost() {
            self.loss.fault(message);
        }
    }

    /// Whoever wants it destroyed has the context lost.
    pub fn destroy(&self) {}
}

impl Drop for Card {
    fn drop(&mut self) {
        self.gl.delete_framebuffer(self.onto.as_ref());
        self.gl.delete_framebuffer(self.from.as_ref());
    }
}
