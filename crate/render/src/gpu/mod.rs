//! Drawing with wgpu: in the browser, on WebGPU or WebGL2; and computing, on WebGPU or, for measuring, natively.
//!
//! [`Gpu`] is the one place that knows which of the two it is. A [`Stage`] draws an attractor on it, coarse
//! at once and complete after some frames. [`LocusGpu`] decides the samples of a connectedness locus.

#[cfg(target_arch = "wasm32")]
mod buffer;
#[cfg(target_arch = "wasm32")]
mod device;
#[cfg(target_arch = "wasm32")]
mod events;
#[cfg(feature = "webgpu")]
mod locus;
#[cfg(target_arch = "wasm32")]
mod passes;
#[cfg(target_arch = "wasm32")]
mod pipeline;
#[cfg(target_arch = "wasm32")]
mod pipelines;
#[cfg(target_arch = "wasm32")]
mod readback;
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
#[cfg(target_arch = "wasm32")]
mod texture;

#[cfg(target_arch = "wasm32")]
pub use device::{Canvas, Gpu, GpuError, Wanted};
#[cfg(target_arch = "wasm32")]
pub use events::{Event, Loss};
#[cfg(feature = "webgpu")]
pub use locus::{LocusError, LocusGpu, LocusJob};
#[cfg(target_arch = "wasm32")]
pub use passes::deformed::Make;
#[cfg(target_arch = "wasm32")]
pub use readback::ReadBack;
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
