//! Iterated function systems: what they are, where they lie, how they are sampled and how one is turned
//! into another.
//!
//! An iterated function system ([`Ifs`]) is a list of affine maps ([`Affine2`]) that contract together.
//! It stands for its attractor, the one shape that is the union of its own images. A word of maps names a
//! piece of the shape ([`Word`]); [`Hull`] bounds it, [`ChaosGame`] and [`adaptive_cut`] sample it,
//! [`Morph`] changes one system into another by way of the polar decomposition ([`Polar2`]); [`candidates`] lists which
//! map may become which, and [`routes`] what other maps of the same shapes may be morphed instead.
//!
//! The same in space: [`Ifs3`], [`Bounds3`], [`ChaosGame3`], [`Morph3`]. A shape is moved by moving its parameters
//! ([`Pose`]), by hand or by key frames ([`Motion3`]).
//!
//! Conventions: y points up, angles are radians, counter-clockwise. Indices count from 0 in code and from 1
//! in messages. No panics on any input, no unsafe code, no web, no GPU.

mod animation;
mod bounds;
mod dimension;
mod error;
pub mod hash;
mod ifs;
mod intersection;
mod linear;
mod morph;
mod projection;
mod sample;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod testing3;

pub use animation::keyframes::{Course, Ease, Key3, Motion3, MotionError};
pub use animation::placement::Place3;
pub use bounds::bounds3::Bounds3;
pub use bounds::hull2::Hull;
pub use bounds::support_table3::Fan3;
pub use dimension::{Dim2, Dim3, Dimension};
pub use error::{IfsError, MAX_MAPS};
pub use ifs::contraction::{Contraction, Contraction3};
pub use ifs::fractal_dimension::{affinity_dimension, similarity_dimension};
pub use ifs::symmetry::symmetries;
pub use ifs::system::{Ifs, Ifs3};
pub use intersection::{Arrow, Intersection, MeetError, intersection};
pub use linear::affine::{Affine, Affine2, Affine3};
pub use linear::polar2::Polar2;
pub use linear::polar3::Polar3;
pub use linear::transform::TransformError;
pub use morph::along::along;
pub use morph::correspondence2::{Candidate, candidates};
pub use morph::interpolation::{Morph, Morph3};
pub use morph::options::{Kind, Mode, MorphError, MorphOptions};
pub use morph::pairing::{Pairing, pair};
pub use morph::route::{Route, RouteKind, routes};
pub use morph::turn3::Turn3;
pub use projection::epsilon::{EpsilonProjection, epsilon_projection};
pub use projection::parallel::{Plane, ProjectError, exact_projection, invariant_directions};
pub use sample::box_dimension::{BoxCount, box_dimension};
pub use sample::chaos_game::{ChaosGame, ChaosGame3};
pub use sample::cut2::{CutOutcome, adaptive_cut};
pub use sample::cut3::adaptive_cut3;
