//! Iterated function systems: what they are, where they lie, how they are sampled and how one is turned
//! into another.
//!
//! An iterated function system ([`Ifs`]) is a list of affine maps ([`Affine2`]) that contract together.
//! It stands for its attractor, the one shape that is the union of its own images. A word of maps names a
//! piece of the shape ([`Word`]); [`Hull`] bounds it, [`ChaosGame`] and [`adaptive_cut`] sample it,
//! [`Morph`] changes one system into another by way of the polar decomposition ([`Polar2`]); [`candidates`] lists which
//! map may become which, and [`routes`] what other maps of the same shapes may be morphed instead.
//!
//! Conventions: y points up, angles are radians, counter-clockwise. Indices count from 0 in code and from 1
//! in messages. No panics on any input, no unsafe code, no web, no GPU.

mod address;
mod affine2;
mod affine3;
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
mod symmetry;
#[cfg(test)]
mod testing;

pub use address::{Word, address_near};
pub use affine2::Affine2;
pub use affine3::Affine3;
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
pub use symmetry::symmetries;
