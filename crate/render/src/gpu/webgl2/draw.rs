//! Carrying out a pass.

use js_sys::Array;
use web_sys::WebGl2RenderingContext as Gl;

use super::buffer::Buffer;
use super::card::Card;
use super::pipeline::Program;
use super::texture::Texture;
use crate::gpu::pass::{Bound, Draw, Pass};
use crate::gpu::words::{Attribute, Blend, Each, Format, Layout, OnTop, stride};

/// Draws, onto nothing or onto what is there.
pub fn draw<'a>(card: &Card, pass: &Pass<'_>, draws: impl IntoIterator<Item = Draw<'a>>) {
    let gl = &card.gl;
    let Some(program) = pass.pipeline.program(card) else { return };
    begin(gl, card, pass);
    gl.use_program(Some(&program.program));
    bind(gl, program, pass.bindings);
    let (buffers, points) = (&pass.pipeline.buffers, pass.pipeline.points);
    let mode = if points { Gl::POINTS } else { Gl::TRIANGLES };
    let mut locations = 0;
    for Draw { buffers: given, indices, count, instances } in draws {
        locations = 0;
        for (layout, (buffer, first)) in buffers.iter().zip(given.into_iter().flatten()) {
            point_to(gl, *layout, buffer, first, &mut locations);
        }
        if let Some(indices) = indices {
            gl.bind_buffer(Gl::ELEMENT_ARRAY_BUFFER, indices.buffer.as_ref());
            gl.draw_elements_instanced_with_i32(mode, count as i32, Gl::UNSIGNED_INT, 0, instances as i32);
        } else {
            gl.draw_arrays_instanced(mode, 0, count as i32, instances as i32);
        }
    }
    (0..locations).for_each(|location| gl.disable_vertex_attrib_array(location));
    end(gl, pass);
}

/// Attaches what is drawn onto, clears it where that is wanted, and says how things meet.
fn begin(gl: &Gl, card: &Card, pass: &Pass<'_>) {
    gl.bind_framebuffer(Gl::DRAW_FRAMEBUFFER, card.onto.as_ref());
    let attach = |place, texture: Option<&Texture>| {
        let texture = texture.and_then(|texture| texture.texture.as_ref());
        gl.framebuffer_texture_2d(Gl::DRAW_FRAMEBUFFER, place, Gl::TEXTURE_2D, texture, 0);
    };
    let places = Array::new();
    for (place, texture) in (Gl::COLOR_ATTACHMENT0..).zip(pass.onto) {
        attach(place, Some(texture));
        places.push(&place.into());
        gl.viewport(0, 0, texture.window.width as i32, texture.window.height as i32);
    }
    gl.draw_buffers(&places);
    let on_top = pass.pipeline.on_top.filter(|_| pass.depth.is_some());
    attach(Gl::DEPTH_ATTACHMENT, pass.depth);
    let switch = |what, on| if on { gl.enable(what) } else { gl.disable(what) };
    switch(Gl::DEPTH_TEST, on_top.is_some());
    if let Some(on_top) = on_top {
        gl.depth_func(match on_top {
            OnTop::Largest => Gl::GEQUAL,
            OnTop::Smallest => Gl::LESS,
        });
    }
    switch(Gl::BLEND, pass.pipeline.blend.is_some());
    match pass.pipeline.blend {
        Some(Blend::Add) => gl.blend_func(Gl::ONE, Gl::ONE),
        Some(Blend::Under) => gl.blend_func(Gl::ONE_MINUS_DST_ALPHA, Gl::ONE),
        None => {}
    }
    if pass.clear {
        for (place, texture) in (0..).zip(pass.onto) {
            match texture.format {
                Format::Word => gl.clear_bufferuiv_with_u32_array(Gl::COLOR, place, &[0; 4]),
                _ => gl.clear_bufferfv_with_f32_array(Gl::COLOR, place, &[0.0; 4]),
            }
        }
        if let Some(on_top) = on_top {
            gl.clear_bufferfv_with_f32_array(Gl::DEPTH, 0, &[on_top.nothing()]);
        }
    }
}

/// Lets go of what was attached: what is drawn onto may be read next.
fn end(gl: &Gl, pass: &Pass<'_>) {
    let detach = |place| gl.framebuffer_texture_2d(Gl::DRAW_FRAMEBUFFER, place, Gl::TEXTURE_2D, None, 0);
    (Gl::COLOR_ATTACHMENT0..).zip(pass.onto).for_each(|(place, _)| detach(place));
}

fn bind(gl: &Gl, program: &Program, bindings: &[(u32, Bound<'_>)]) {
    for (binding, bound) in bindings {
        match bound {
            Bound::Uniform(buffer) => {
                gl.bind_buffer_base(Gl::UNIFORM_BUFFER, *binding, buffer.buffer.as_ref());
            }
            Bound::Texture(texture) => {
                for (unit, _) in (0..).zip(&program.textures).filter(|(_, wanted)| *wanted == binding) {
                    gl.active_texture(Gl::TEXTURE0 + unit);
                    gl.bind_texture(Gl::TEXTURE_2D, texture.texture.as_ref());
                }
            }
        }
    }
}

/// Has the next locations read from a buffer, from an item on.
fn point_to(gl: &Gl, layout: Layout, buffer: &Buffer, first: u32, location: &mut u32) {
    gl.bind_buffer(Gl::ARRAY_BUFFER, buffer.buffer.as_ref());
    let (stride, divisor) = (stride(layout) as i32, u32::from(layout.0 == Each::Instance));
    let mut offset = first as i32 * stride;
    for attribute in layout.1 {
        gl.enable_vertex_attrib_array(*location);
        match attribute {
            Attribute::Floats(count) => {
                let count = i32::from(*count);
                gl.vertex_attrib_pointer_with_i32(*location, count, Gl::FLOAT, false, stride, offset);
            }
            Attribute::Word => {
                gl.vertex_attrib_i_pointer_with_i32(*location, 1, Gl::UNSIGNED_INT, stride, offset);
            }
        }
        gl.vertex_attrib_divisor(*location, divisor);
        offset += attribute.size() as i32;
        *location += 1;
    }
}
