//! Iterated function systems: what they are, where they lie, how they are sampled and how one is turned into another.
//!
//! An iterated function system ([`Ifs`]) is a list of affine maps ([`Affine2`]) that contract together. It stands for
//! its attractor, the one shape that is the union of its own images. What is the same in the plane and in space is
//! written once, over [`Dimension`]: `Ifs` alone is one of the plane, [`Ifs3`] one of space.
//!
#![doc = include_str!("../picture.svg")]
//!
//! ```
//! use frond_core::{Affine2, ChaosGame, Ifs, Morph, MorphOptions};
//! use glam::DVec2;
//!
//! let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.75_f64.sqrt())];
//! let gasket = corners.map(|corner| Affine2::similitude(0.5, 0.0, corner * 0.5));
//! let turned = gasket.map(|map| map * Affine2::similitude(1.0, 0.5, DVec2::ZERO));
//!
//! // Halfway in both parameters: a system, and points of its attractor.
//! let morph = Morph::new(&gasket, &turned, &MorphOptions::default())?;
//! let between = Ifs::new(morph.at(0.5, 0.5))?;
//! let (mut points, mut pieces) = ([0.0; 2000], [0; 1000]);
//! assert_eq!(ChaosGame::new(&between, 1).fill(&mut points, &mut pieces), 1000);
//! assert!(pieces.contains(&0) && pieces.contains(&2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The order in which to read it
//!
//! 1. `linear/`: [`Affine`] maps, their polar factors ([`Polar2`], [`Polar3`]) and singular values.
//! 2. `ifs/`: [`Ifs`], why it has an attractor ([`Contraction`]), its dimensions ([`similarity_dimension`]), its
//!    symmetries. `dimension/` says what the plane and space differ in.
//! 3. `bounds/`: where the attractor lies ([`Hull`], [`Bounds3`], [`SupportTable3`]).
//! 4. `sample/`: its points ([`ChaosGame`]) and its pieces of one size ([`adaptive_cut`]).
//! 5. `morph/`: the family between two systems ([`Morph`]), which map becomes which ([`pair`], [`candidates`]) and what
//!    other maps of the same shapes may be morphed instead ([`routes`]).
//! 6. `directed/`: several shapes that are made of copies of each other ([`DirectedIfs`]), their points and pieces, and
//!    the way between two such systems ([`DirectedMorph`]).
//! 7. `digits/`: shapes on a grid ([`DigitSystem`]), and what two of them share as such a system, found in whole
//!    numbers ([`grid_intersection`]).
//! 8. `animation/`: key frames ([`Motion3`]) and places ([`Place3`]). `projection/` and `intersection`: shadows of
//!    shapes of space ([`exact_projection`]), where two shapes meet ([`intersection()`]), and how far they are from
//!    each other ([`hausdorff_distance`]). [`closed_form`]: which fractions and roots doubles come near.
//!
//! # The papers
//!
//! Hutchinson 1981 and Falconer 1988 for systems and their dimensions; Mauldin & Williams 1988 for graph-directed ones;
//! Burch & Hart 1997 for the morph; Darwish & Abd-El-Wahab for what is moved and projected.
//!
//! Conventions: y points up, angles are radians, counter-clockwise. Indices count from 0 in code and from 1
//! in messages. No panics on any input, no unsafe code, no web, no GPU.

mod animation;
mod bounds;
pub mod closed_form;
mod digits;
mod dimension;
mod directed;
mod error;
pub mod hash;
mod hausdorff;
mod ifs;
mod intersection;
mod linear;
mod morph;
mod order;
mod projection;
mod sample;
mod sort;
/// What Frond's other crates use as well. It may change at any time.
#[doc(hidden)]
pub mod shared {
    pub use crate::order::{Ranked, Total};
    pub use crate::sort::{is_permutation, sort_indices};
}
#[cfg(test)]
mod testing;
#[cfg(test)]
mod testing3;

pub use animation::keyframes::{Course, Ease, Key3, Motion3, MotionError};
pub use animation::placement::Place3;
pub use bounds::bounds3::Bounds3;
pub use bounds::hull2::Hull;
pub use bounds::support_table3::SupportTable3;
pub use digits::error::DigitError;
pub use digits::intersection::{AddressCount, GridIntersection, GridState};
pub use digits::product::grid_intersection;
pub use digits::system::DigitSystem;
pub use dimension::{Dim2, Dim3, Dimension};
pub use directed::chaos_game::DirectedGame;
pub use directed::contraction::{DirectedContraction, StateDisc};
pub use directed::cut::{DirectedPiece, directed_cut};
pub use directed::dimension::directed_dimension;
pub use directed::error::{DirectedError, MAX_STATES, MOST_FOUND_MAPS, MOST_FOUND_STATES};
pub use directed::map::DirectedMap;
pub use directed::morph::{DirectedMorph, DirectedMorphError};
pub use directed::system::DirectedIfs;
pub use error::{IfsError, MAX_MAPS};
/// Vectors and matrices, of the version that the interface is written in.
pub use glam;
pub use hausdorff::{HausdorffDistance, HausdorffOptions, hausdorff_distance};
pub use ifs::contraction::{Contraction, Contraction3};
pub use ifs::fractal_dimension::{affinity_dimension, similarity_dimension};
pub use ifs::system::{Ifs, Ifs3};
pub use intersection::{Arrow, Intersection, IntersectionError, intersection};
pub use linear::affine::{Affine, Affine2, Affine3};
pub use linear::polar2::Polar2;
pub use linear::polar3::Polar3;
pub use linear::transform::TransformError;
pub use morph::along::along;
pub use morph::correspondence2::{Candidate, candidates};
pub use morph::interpolation::{Morph, Morph3};
pub use morph::options::{HalfTurns, Kind, Mode, MorphError, MorphOptions};
pub use morph::pairing::{Pairing, pair, probabilities_between};
pub use morph::route::{Route, RouteKind, routes};
pub use morph::turn3::Turn3;
pub use morph::ways::ways;
pub use morph::zipper::{Joints, joints};
pub use projection::epsilon::{EpsilonFrame, EpsilonProjection, epsilon_projection};
pub use projection::parallel::{Plane, ProjectError, exact_projection, invariant_directions};
pub use sample::adaptive_cut2::{CutOutcome, adaptive_cut};
pub use sample::adaptive_cut3::adaptive_cut3;
pub use sample::box_dimension::{BoxCount, box_dimension};
pub use sample::chaos_game2::ChaosGame;
pub use sample::chaos_game3::ChaosGame3;
pub use sample::colouring::Colouring;

/// Runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
