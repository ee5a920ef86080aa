//! Textures of the size of a picture.

use js_sys::{Object, Uint8Array, Uint32Array};
use web_sys::{WebGl2RenderingContext as Gl, WebGlTexture};

use super::card::Card;
use crate::gpu::words::Format;
use crate::picture::window::Window;

/// A texture for one picture.
#[derive(Debug)]
pub struct Texture {
    gl: Gl,
    pub(super) texture: Option<WebGlTexture>,
    pub window: Window,
    pub(super) format: Format,
}

impl Texture {
    /// One with nothing on it, to be drawn to.
    pub fn new(card: &Card, _label: &'static str, window: Window, format: Format) -> Self {
        Self::create(card, window, format, 1, Gl::NEAREST, Gl::NEAREST)
    }

    /// A photograph of so many levels, each half of the one before, to be written.
    pub fn photo(card: &Card, window: Window, levels: u32) -> Self {
        Self::create(card, window, Format::Colours, levels, Gl::LINEAR_MIPMAP_LINEAR, Gl::LINEAR)
    }

    fn create(card: &Card, window: Window, format: Format, levels: u32, min: u32, mag: u32) -> Self {
        let gl = &card.gl;
        let texture = gl.create_texture();
        let inside = match format {
            Format::Word => Gl::R32UI,
            Format::Sums if card.densities => Gl::RGBA16F,
            Format::Sums | Format::Colours | Format::Canvas => Gl::RGBA8,
            Format::Depth => Gl::DEPTH_COMPONENT24,
        };
        gl.bind_texture(Gl::TEXTURE_2D, texture.as_ref());
        let [width, height] = [window.width, window.height].map(|side| side as i32);
        gl.tex_storage_2d(Gl::TEXTURE_2D, levels as i32, inside, width, height);
        for (name, value) in [
            (Gl::TEXTURE_MIN_FILTER, min),
            (Gl::TEXTURE_MAG_FILTER, mag),
            (Gl::TEXTURE_WRAP_S, Gl::CLAMP_TO_EDGE),
            (Gl::TEXTURE_WRAP_T, Gl::CLAMP_TO_EDGE),
        ] {
            gl.tex_parameteri(Gl::TEXTURE_2D, name, value as i32);
        }
        Self { gl: gl.clone(), texture, window, format }
    }

    /// Replaces what a level holds: four bytes a pixel, row after row.
    pub fn write(&self, card: &Card, level: u32, window: Window, bytes: &[u8]) {
        let (order, kind, pixels): (_, _, Object) = match self.format {
            Format::Word => {
                let words: Vec<u32> =
                    bytes.as_chunks().0.iter().map(|word| u32::from_ne_bytes(*word)).collect();
                (Gl::RED_INTEGER, Gl::UNSIGNED_INT, Uint32Array::from(&words[..]).into())
            }
            _ => (Gl::RGBA, Gl::UNSIGNED_BYTE, Uint8Array::from(bytes).into()),
        };
        let [width, height] = [window.width, window.height].map(|side| side as i32);
        card.gl.bind_texture(Gl::TEXTURE_2D, self.texture.as_ref());
        let level = level as i32;
        let written = card.gl.tex_sub_image_2d_with_i32_and_i32_and_u32_and_type_and_opt_array_buffer_view(
            Gl::TEXTURE_2D,
            level,
            0,
            0,
            width,
            height,
            order,
            kind,
            Some(&pixels),
        );
        if written.is_err() {
            card.fault("a picture could not be written to its texture");
        }
    }
}

impl Drop for Texture {
    fn drop(&mut self) {
        self.gl.delete_texture(self.texture.as_ref());
    }
}
