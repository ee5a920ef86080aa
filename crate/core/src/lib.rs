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

mod address;
mod affine2;
mod affine3;
mod along;
mod chaos;
mod contraction;
mod correspond;
mod cut;
mod dimension;
mod error;
pub mod hash;
mod hull;
mod ifs;
mod morph;
mod pairing;
mod polar2;
mod polar3;
mod route;
mod size3;
mod space;
mod symmetry;
#[cfg(test)]
mod testing;
mod transform;

pub use address::{Word, address_near};
pub use affine2::Affine2;
pub use affine3::Affine3;
pub use along::along;
pub use chaos::ChaosGame;
pub use contraction::{Contraction, word_radius};
pub use correspond::{Candidate, candidates};
pub use cut::{CutOutcome, adaptive_cut};
pub use dimension::{affinity_dimension, similarity_dimension};
pub use error::{IfsError, MAX_MAPS};
pub use hull::Hull;
pub use ifs::Ifs;
pub use morph::{Kind, Mode, Morph, MorphError, MorphOptions};
pub use pairing::{Pairing, pair};
pub use polar2::Polar2;
pub use polar3::Polar3;
pub use route::{Route, RouteKind, routes};
pub use space::{
    Bounds3, BoxCount, ChaosGame3, Conjugate, Contraction3, Course, Ease, Fan3, Ifs3, Key3, Morph3, Motion3,
    MotionError, Place3, Pose, Turn3, adaptive_cut3, affinity_dimension3, box_dimension,
    similarity_dimension3, word_map3,
};
pub use symmetry::symmetries;
pub use transform::TransformError;
