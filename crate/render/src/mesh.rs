//! Surfaces around attractors of space: watertight, with a thickness, for 3-D printers and other programs.
//!
//! A [`Mesher`] covers the attractors with points, none farther from the next than a sample (`orbit`), and takes down
//! in a grid how far each sample is from the nearest (`field`). What is nearer than half the wall is inside: a thin
//! attractor becomes as thick as the wall, and a body grows by half of it. Naive surface nets (Gibson 1998) make the
//! surface. They are manifold only where no cell holds two sheets: `well_composed` sees to that first (Latecki 1997),
//! so that every edge has two triangles whatever the field. [`mod@file`] writes it.

mod field;
pub mod file;
mod mesher;
mod orbit;
mod surface;
mod well_composed;

pub use mesher::{
    LEAST_FINENESS, MOST_FINENESS, MOST_SAMPLES, MOST_TRIANGLES, MeshError, MeshOptions, Mesher,
};
pub use surface::Mesh;
