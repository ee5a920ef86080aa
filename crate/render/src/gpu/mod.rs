//! Drawing in the browser, by WebGPU (wgpu) or WebGL2, and computing, by WebGPU; both natively, too, to test and to
//! measure what this machine's own card does: compiled with `--cfg frond_card`, and drawn where nobody sees it.
//!
//! A [`Stage`] draws an attractor, coarse at once and complete after some frames. It and its passes speak of buffers,
//! textures and pipelines (`words`) and of what is drawn with them (`pass`). `webgpu` and `webgl2` carry it out:
//! `interface` is the one of them that this is compiled for, and [`Gpu`] opens it. [`LocusGpu`] decides the samples of
//! a connectedness locus.

mod canvas;
mod device;
mod events;
mod interface;
#[cfg(feature = "webgpu")]
mod locus;
mod pass;
mod passes;
mod pipelines;
mod shaders;
mod sheet;
mod solid;
mod stage;
mod state;
mod target;
#[cfg(not(feature = "webgpu"))]
mod webgl2;
#[cfg(feature = "webgpu")]
mod webgpu;
mod words;

pub use canvas::Canvas;
pub use device::{Gpu, GpuError, Wanted};
pub use events::{Event, Loss};
pub use interface::ReadBack;
#[cfg(feature = "webgpu")]
pub use locus::{Deciding, LocusError, LocusGpu, LocusJob};
pub use passes::deformed::Make;
pub use solid::{Drawn3, Stage3, Uniforms3};
pub use stage::{Drawn, Stage};
pub use state::Style;

/// Whether the processor stands in for a graphics card. WebGPU says so; WebGL gives a name.
fn is_software(said: bool, names: &str) -> bool {
    const NAMES: [&str; 4] = ["swiftshader", "llvmpipe", "software", "basic render"];
    let names = names.to_ascii_lowercase();
    said || NAMES.iter().any(|name| names.contains(name))
}
