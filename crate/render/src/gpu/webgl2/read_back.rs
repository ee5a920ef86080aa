//! Getting a picture back from the graphics card.

use web_sys::{WebGl2RenderingContext as Gl, WebGlBuffer, WebGlSync};

use super::card::Card;
use super::texture::Texture;
use crate::gpu::events::Loss;

/// A picture on its way back.
#[derive(Debug)]
pub struct ReadBack {
    gl: Gl,
    buffer: Option<WebGlBuffer>,
    bytes: usize,
    /// Told when the card has come so far.
    fence: Option<WebGlSync>,
    loss: Loss,
}

impl ReadBack {
    /// Begins to read a texture of colours.
    pub(in crate::gpu) fn begin(card: &Card, texture: &Texture, loss: Loss) -> Self {
        let gl = &card.gl;
        let [width, height] = [texture.window.width, texture.window.height].map(|side| side as i32);
        let bytes = texture.window.area() * 4;
        gl.bind_framebuffer(Gl::READ_FRAMEBUFFER, card.from.as_ref());
        let texture = texture.texture.as_ref();
        gl.framebuffer_texture_2d(Gl::READ_FRAMEBUFFER, Gl::COLOR_ATTACHMENT0, Gl::TEXTURE_2D, texture, 0);
        let buffer = gl.create_buffer();
        gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, buffer.as_ref());
        gl.buffer_data_with_i32(Gl::PIXEL_PACK_BUFFER, bytes as i32, Gl::STREAM_READ);
        let read = gl.read_pixels_with_i32(0, 0, width, height, Gl::RGBA, Gl::UNSIGNED_BYTE, 0);
        gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, None);
        gl.framebuffer_texture_2d(Gl::READ_FRAMEBUFFER, Gl::COLOR_ATTACHMENT0, Gl::TEXTURE_2D, None, 0);
        let fence = gl.fence_sync(Gl::SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        // Asking takes time: here, where one waits anyway, and not for each frame.
        let error = gl.get_error();
        if read.is_err() || ![Gl::NO_ERROR, Gl::CONTEXT_LOST_WEBGL].contains(&error) {
            card.fault(&format!("WebGL says error {error:#x}"));
        }
        Self { gl: gl.clone(), buffer, bytes, fence, loss }
    }

    /// The picture if it has arrived: RGBA with straight alpha, row 0 on top. `Some(None)` when it never
    /// will, because the device is lost. Ask again after letting the browser do something else.
    pub fn take(&self) -> Option<Option<Vec<u8>>> {
        let (gl, Some(fence)) = (&self.gl, &self.fence) else { return Some(None) };
        if self.loss.is_lost() {
            return Some(None);
        }
        match gl.client_wait_sync_with_u32(fence, 0, 0) {
            Gl::TIMEOUT_EXPIRED => None,
            Gl::WAIT_FAILED => Some(None),
            _ => {
                let mut pixels = vec![0; self.bytes];
                gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, self.buffer.as_ref());
                gl.get_buffer_sub_data_with_i32_and_u8_array(Gl::PIXEL_PACK_BUFFER, 0, &mut pixels);
                gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, None);
                Some(Some(pixels))
            }
        }
    }
}

impl Drop for ReadBack {
    fn drop(&mut self) {
        self.gl.delete_buffer(self.buffer.as_ref());
        self.gl.delete_sync(self.fence.as_ref());
    }
}
