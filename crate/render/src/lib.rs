//! Pictures of attractors: on the CPU, complete, for thumbnails and as truth in tests; and by a graphics card, with
//! WebGPU or WebGL2, for the stage.
//!
//! A picture shows every pixel that a piece of the attractor reaches into, and no other. [`rasterize`]
//! makes one from an [`Ifs`](frond_core::Ifs).
//!
//! ```
//! use frond_core::{Affine2, Ifs};
//! use frond_render::{RasterOptions, rasterize};
//! use glam::{DMat2, DVec2};
//!
//! // Sierpinski's triangle: three maps, each of which halves the plane towards a corner.
//! let half = DMat2::from_diagonal(DVec2::splat(0.5));
//! let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
//! let ifs = Ifs::new(corners.map(|corner| Affine2::new(half, corner * 0.5)).to_vec())?;
//! let pixels = rasterize(&ifs, &RasterOptions { width: 64, height: 64, ..RasterOptions::default() })?;
//!
//! assert_eq!(pixels.len(), 64 * 64 * 4);
//! assert!(pixels.chunks(4).any(|pixel| pixel[3] == 255) && pixels.chunks(4).any(|pixel| pixel[3] == 0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # In which order to read it
//!
//! 1. `picture`: a [`Window`] of pixels and the [`View`] of the plane in it; a [`Colours`] makes colours of codes,
//!    [`tone`] light of densities.
//! 2. `pieces`: a [`Frame`] is the attractor brought into the unit disc by the smallest ellipse around its hull, so
//!    that a piece is a matrix, its size is read off the matrix, and its points fit an `f32` however far one zooms in.
//!    [`Letters`], the first of a piece's word, are its code.
//! 3. `coverage`: a [`Sweep`] walks down the tree of pieces and skips what is outside of the window or lit already.
//!    Where pieces overlap without end it goes over to a [`Flood`] of points on a grid.
//!    `splat` draws all but some pixels many times as quickly: [`Splats`] are points of a cloud that each piece places.
//!    [`rasterize`] draws them first, and is complete with what a sweep finds in the dark.
//!    [`rasterize_directed`] draws shapes of several states.
//! 4. A [`SplatPlan`] is the same for a graphics card that computes. A [`Plan`] is a picture as points that a card
//!    places as vertices; [`PlacedPoints`] tells which pixels they light, so that a sweep finds the others. A
//!    [`Density`] spreads samples after the measure, or on the processor carries the measure into pieces without
//!    chance, and its tones go by what the pieces in view tell of the masses of their pixels.
//! 5. [`bent`] draws what a [`Bend`](frond_deform::Bend) deforms: in pieces that are even in themselves.
//!    [`bent::draft_codes`] is a picture of points for each frame of what moves. `sheet` bends a photograph.
//! 6. [`solid`] is space: a [`Traversal`](solid::Traversal) leaves a depth buffer, which is shaded; points are splats.
//! 7. [`mesh`] makes a surface around shapes of space, watertight, and files of it.
//! 8. `gpu` draws on a card: a `Stage` chooses between passes, which share one `StageState`; `locus` decides the
//!    samples of a connectedness locus.
//!
//! Each shader in `shader/` has a twin of the same name and the same arithmetic, and tests that compare them. The twin
//! of `locus.wgsl` is in crate/locus. `screen.wgsl` and `solid/kept.wgsl` have none: they are what several shaders
//! share.
//!
//! # What it stands on
//!
//! - Burch and Hart, "Linear Fractal Shape Interpolation": the attractors, and colours by the first map.
//! - Fujimoto, Ohno, Muraoka and Chiba, "Fractal Deformation": what [`bent`] and `sheet` draw.
//! - Darwish and Abd-El-Wahab, "IFS Fractal Animation": what [`solid`] draws.
//! - Naka and Rushton, "S-potentials from colour units in the retina of fish" (1966), and Reinhard and Devlin, "Dynamic
//!   range reduction inspired by photoreceptor physiology" (2005): the tones of densities.
//! - Gibson, "Constrained Elastic Surface Nets" (1998), and Latecki, "3D well-composed pictures" (1997): [`mesh`].
//! - Greene, Kass and Miller, "Hierarchical Z-buffer visibility" (1993): how [`solid`] passes over what is hidden.

pub mod bent;
mod coverage;
mod density;
mod directed;
#[cfg(any(
    all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")),
    all(frond_card, not(target_arch = "wasm32"), feature = "webgpu")
))]
pub mod gpu;
pub mod mesh;
mod picture;
mod pieces;
mod plan;
mod points;
mod raster;
mod sheet;
pub mod solid;
mod splat;
#[cfg(test)]
mod testing;

pub use coverage::canvas::Hit;
pub use coverage::complete::codes;
pub use coverage::flood::{CloudPoint, Flood};
pub use coverage::sweep::{Progress, Sweep};
pub use density::Density;
pub use directed::{DirectedColours, DirectedOptions, rasterize_directed};
pub use picture::bitmap::Bitmap;
pub use picture::colour::Colours;
pub use picture::resolve::{resolve_codes, resolve_density, to_bytes};
pub use picture::tone;
pub use picture::view::View;
pub use picture::window::{Extent, PixelBox, Window};
pub use pieces::cut::{Piece, cut};
pub use pieces::frame::Frame;
pub use pieces::letters::{CODES, Code, KEPT, Letters, ShortCode};
pub use pieces::measure::Sample;
pub use plan::{Batch, Detail, PlacedPoints, Plan};
pub use points::{Instance, Vertex};
pub use raster::{
    MAX_SIDE, RasterOptions, RenderError, rasterize, rasterize_bent, rasterize_colours, rasterize_density,
    rasterize_unbent,
};
pub use sheet::{BentSheet, Level, Photo, PhotoError, Sheet, SheetOptions, draw_sheet};
pub use splat::{SplatPlan, Splats};
