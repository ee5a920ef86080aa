//! Drawing with wgpu: in the browser, on WebGPU or WebGL2.
//!
//! [`Gpu`] is the one place that knows which of the two it is. A [`Stage`] draws an attractor on it, coarse
//! at once and complete after some frames.

mod buffer;
mod device;
mod events;
mod pipelines;
mod planned;
mod readback;
mod stage;
mod swept;
mod target;
mod weighed;
mod work;

pub use device::{Canvas, Gpu, GpuError, Wanted};
pub use events::{Event, Loss};
pub use readback::ReadBack;
pub use stage::{Drawn, Stage, Style};
