//! Shaders and how they are fed.

use std::cell::OnceCell;

use web_sys::{WebGl2RenderingContext as Gl, WebGlProgram, WebGlShader};

use super::card::Card;
use crate::gpu::shaders::{Shader, Stage};
use crate::gpu::words::{Blend, Layout, OnTop, Recipe};

/// What draws. It is compiled when it first does: most are not needed at once, and some never.
#[derive(Debug)]
pub struct Pipeline {
    gl: Gl,
    shader: Shader,
    entries: [&'static str; 2],
    pub(super) buffers: Vec<Layout>,
    pub(super) points: bool,
    pub(super) on_top: Option<OnTop>,
    pub(super) blend: Option<Blend>,
    program: OnceCell<Option<Program>>,
}

/// What was compiled.
#[derive(Debug)]
pub(super) struct Program {
    pub program: WebGlProgram,
    /// The bindings of textures, one a texture unit.
    pub textures: Vec<u32>,
}

/// What is returned for a block that is not there, since nothing reads it.
const NO_BLOCK: u32 = u32::MAX;

impl Pipeline {
    pub fn new(card: &Card, recipe: &Recipe<'_>) -> Self {
        Self {
            gl: card.gl.clone(),
            shader: recipe.shader,
            entries: [recipe.vertex, recipe.fragment],
            buffers: recipe.buffers.to_vec(),
            points: recipe.points,
            on_top: recipe.on_top,
            blend: recipe.blend,
            program: OnceCell::new(),
        }
    }

    /// The program; `None` where the context is lost.
    pub(super) fn program(&self, card: &Card) -> Option<&Program> {
        self.program.get_or_init(|| self.link(card)).as_ref()
    }

    fn link(&self, card: &Card) -> Option<Program> {
        let gl = &card.gl;
        let stages = || self.shader.0.iter().filter(|stage| self.entries.contains(&stage.name));
        let program = gl.create_program()?;
        let mut shaders = Vec::new();
        for stage in stages() {
            let shader = compile(gl, stage, stage.name == self.entries[0])?;
            gl.attach_shader(&program, &shader);
            shaders.push(shader);
        }
        gl.link_program(&program);
        if !gl.get_program_parameter(&program, Gl::LINK_STATUS).is_truthy() {
            let told = shaders.iter().filter_map(|shader| gl.get_shader_info_log(shader));
            let words: Vec<_> = told.chain(gl.get_program_info_log(&program)).collect();
            card.fault(&format!("{:?}: {}", self.entries, words.join("\n")));
            return None;
        }
        shaders.iter().for_each(|shader| gl.delete_shader(Some(shader)));
        gl.use_program(Some(&program));
        let mut textures = Vec::new();
        for stage in stages() {
            for (name, binding) in stage.blocks {
                let index = gl.get_uniform_block_index(&program, name);
                if index != NO_BLOCK {
                    gl.uniform_block_binding(&program, index, *binding);
                }
            }
            for (name, binding) in stage.textures {
                let place = gl.get_uniform_location(&program, name);
                gl.uniform1i(place.as_ref(), textures.len() as i32);
                textures.push(*binding);
            }
        }
        Some(Program { program, textures })
    }
}

fn compile(gl: &Gl, stage: &Stage, vertex: bool) -> Option<WebGlShader> {
    let shader = gl.create_shader(if vertex { Gl::VERTEX_SHADER } else { Gl::FRAGMENT_SHADER })?;
    gl.shader_source(&shader, stage.text);
    gl.compile_shader(&shader);
    Some(shader)
}

impl Drop for Pipeline {
    fn drop(&mut self) {
        let program = self.program.get().and_then(Option::as_ref);
        self.gl.delete_program(program.map(|program| &program.program));
    }
}
