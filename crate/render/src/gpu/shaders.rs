//! The shaders, as build.rs has them for each interface.

#[cfg(not(feature = "webgpu"))]
pub(super) use glsl::*;
#[cfg(feature = "webgpu")]
pub(super) use wgsl::*;

/// For WebGPU: their text.
#[cfg(feature = "webgpu")]
mod wgsl {
    #[derive(Clone, Copy, Debug)]
    pub struct Shader(pub &'static str);

    include!(concat!(env!("OUT_DIR"), "/webgpu.rs"));
}

/// For WebGL2: a text for each stage.
#[cfg(not(feature = "webgpu"))]
mod glsl {
    #[derive(Clone, Copy, Debug)]
    pub struct Shader(pub &'static [Stage]);

    #[derive(Clone, Copy, Debug)]
    pub struct Stage {
        /// As WGSL calls it.
        pub name: &'static str,
        pub text: &'static str,
        /// What its blocks of numbers are called here, each with its binding in WGSL.
        pub blocks: &'static [(&'static str, u32)],
        /// The same of its textures.
        pub textures: &'static [(&'static str, u32)],
    }

    include!(concat!(env!("OUT_DIR"), "/webgl2.rs"));
}
