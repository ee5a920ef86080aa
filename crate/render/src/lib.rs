//! Pictures of attractors: on the CPU, complete, for thumbnails and as truth in tests; and with wgpu, on
//! WebGPU or WebGL2, for the stage.
//!
//! A picture shows every pixel that a piece of the attractor reaches into, and no other. [`rasterize`]
//! makes one from an [`Ifs`](frond_core::Ifs).
//!
//! Both ways begin with a [`Frame`]: the attractor brought into the unit disc by the smallest ellipse around
//! its hull, so that a piece is a matrix, its size is read off the matrix, and its points fit an `f32`
//! whatever the size of the shape and however far one zooms in. A [`View`] takes it to the screen, in `f64`.
//!
//! - A [`Sweep`] walks down the tree of pieces and skips what is outside of the window or lit already. Where
//!   pieces overlap without end it goes over to a [`Flood`] of points on a grid.
//! - A lit pixel holds a code, the first [`Letters`] of its piece. A [`Look`] makes colours of codes.
//! - A [`Density`] spreads samples after the measure; [`tone`] makes light of it.
//! - What [`bent`] holds is drawn where a [`Bend`](frond_deform::Bend) takes it: in pieces that are even in themselves, as
//!   points that follow the mesh, or swept.
//!
//! Each shader in `shader/` has a twin with the same arithmetic, and tests that compare them. The twins are here, but for
//! that of the locus, which is in crate/locus: what runs on the card for it is `gpu::LocusGpu`.

pub mod bent;
mod coverage;
mod density;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")))]
pub mod gpu;
mod picture;
mod pieces;
mod plan;
mod points;
mod raster;
mod sheet;
pub mod solid;
#[cfg(test)]
mod testing;

pub use coverage::canvas::Hit;
pub use coverage::flood::{CloudPoint, Flood};
pub use coverage::sweep::{Progress, Sweep};
pub use density::Density;
pub use picture::bitmap::Bitmap;
pub use picture::colour::{Colouring, Look, OKABE_ITO, code_of_colour, pack_colour};
pub use picture::resolve::{picture_of_codes, picture_of_density, resolve_codes, resolve_density, to_bytes};
pub use picture::tone;
pub use picture::view::View;
pub use picture::window::{Extent, PixelBox, Window};
pub use pieces::cut::{Piece, cut, cut_at_random};
pub use pieces::frame::Frame;
pub use pieces::letters::{CODES, KEPT, Letters};
pub use pieces::measure::{MassPiece, Sample, Sampler, pieces_by_mass};
pub use plan::{Batch, Detail, Plan};
pub use points::{Instance, Vertex};
pub use raster::{MAX_SIDE, RasterOptions, RenderError, codes, rasterize};
pub use sheet::{BentSheet, Level, Photo, PhotoError, Sheet, SheetOptions, draw_sheet};
