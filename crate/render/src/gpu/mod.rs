//! Drawing in the browser, by WebGPU (wgpu) or WebGL2; and computing, by WebGPU or, for measuring, natively.
//!
//! A [`Stage`] draws an attractor, coarse at once and complete after some frames. It and its passes speak of buffers,
//! textures and pipelines (`words`) and of what is drawn with them (`pass`). `webgpu` and `webgl2` carry it out:
//! `interface` is the one of them that this is compiled for, and [`Gpu`] opens it. [`LocusGpu`] decides the samples of
//! a connectedness locus.

#[cfg(target_arch = "wasm32")]
mod canvas;
#[cfg(target_arch = "wasm32")]
mod device;
#[cfg(target_arch = "wasm32")]
mod events;
#[cfg(target_arch = "wasm32")]
mod interface;
#[cfg(feature = "webgpu")]
mod locus;
#[cfg(target_arch = "wasm32")]
mod pass;
#[cfg(target_arch = "wasm32")]
mod passes;
#[cfg(target_arch = "wasm32")]
mod pipelines;
#[cfg(target_arch = "wasm32")]
mod shaders;
#[cfg(target_arch = "wasm32")]
mod sheet;
#[cfg(target_arch = "wasm32")]
mod solid;
#[cfg(target_arch = "wasm32")]
mod stage;
#[cfg(target_arch = "wasm32")]
mod state;
#[cfg(target_arch = "wasm32")]
mod target;
#[cfg(all(target_arch = "wasm32", not(feature = "webgpu")))]
mod webgl2;
#[cfg(all(target_arch = "wasm32", feature = "webgpu"))]
mod webgpu;
#[cfg(target_arch = "wasm32")]
mod words;

#[cfg(target_arch = "wasm32")]
pub use canvas::Canvas;
#[cfg(target_arch = "wasm32")]
pub use device::{Gpu, GpuError, Wanted};
#[cfg(target_arch = "wasm32")]
pub use events::{Event, Loss};
#[cfg(target_arch = "wasm32")]
pub use interface::ReadBack;
#[cfg(feature = "webgpu")]
pub use locus::{LocusError, LocusGpu, LocusJob};
#[cfg(target_arch = "wasm32")]
pub use passes::deformed::Make;
#[cfg(target_arch = "wasm32")]
pub use solid::{Drawn3, Stage3, Uniforms3};
#[cfg(target_arch = "wasm32")]
pub use stage::{Drawn, Stage};
#[cfg(target_arch = "wasm32")]
pub use state::Style;

/// Whether the processor stands in for a graphics card. WebGPU says so; WebGL gives a name.
fn is_software(said: bool, names: &str) -> bool {
    const NAMES: [&str; 4] = ["swiftshader", "llvmpipe", "software", "basic render"];
    let names = names.to_ascii_lowercase();
    said || NAMES.iter().any(|name| names.contains(name))
}
