//! Fractal deformation: pull one corner of a grid, and every part at every scale answers.
//!
#![doc = include_str!("../picture.svg")]
//!
//! After Fujimoto, Ohno, Muraoka and Chiba, "Fractal Deformation Using Displacement Vectors Based on Extended
//! Iterated Shuffle Transformation". Every point of a self-similar shape has a code, the letters of the pieces
//! that hold it, from the largest on. A [`Mesh`] gives each point a displacement; [`shuffle`] reverses a block
//! of the code, kb + 1 to ke, and so gives a point the displacement of another one. [`Field`] superposes the
//! shuffles of all depths, each weighed by a power of the roughness delta ([`weights`]):
//!
//! - kb, the locality: 0 scatters the displacement all over; kb = ke leaves it where it is, which is the plain
//!   deformation by a grid;
//! - ke, the detail: how small the parts are that still answer on their own;
//! - delta, the roughness: how much the small parts answer.
//!
//! A [`Bend`] is all of this at one moment, with pieces kept together ([`Continuity`]), reached letter by letter with a
//! [`Cursor`] and fast enough for every frame; a [`Skin`] moves points with the mesh at one price whatever ke.
//!
//! A [`Bend3`] does the same in space, by a [`Mesh3`] over a box: the formulas hold in any dimension, and what is the
//! same line for line is written once. Where pieces meet in corners ([`Corners3`]: the gasket tetrahedron, Menger's
//! sponge) nothing tears, and each piece has a ball that holds it, bent.
//!
//! A [`RingBend`] does the same to a closed curve, whose code is its parameter in base 4.
//!
//! [`Spin`] turns the displacement with the piece. [`Cube`] gives codes to the points of a unit square, so that
//! pictures can be bent like attractors.
//!
//! # In which order to read it
//!
//! 1. `mesh`: the control points and what they displace.
//! 2. `shuffle`: codes, their shuffle, the weights of the depths, and [`Field`], the formulas as they stand in the
//!    paper; then the same terms computed level by level and place by place.
//! 3. `continuity`: what keeps neighbouring pieces together. Corners that pieces share, a grid that each level is
//!    splatted into, or the paper's own averages.
//! 4. `bend`: all of it at one moment, with its `settings`; `skin` and `follow` for a mesh that moves; `ring` for
//!    curves.
//! 5. `mesh3`, `continuity/corners3`, `continuity/lattice3`, `bend3`: the same in space.
//!
//! # What it stands on
//!
//! Fujimoto, Ohno, Muraoka and Chiba (above); Sederberg and Parry (1986) for a lattice in space; Wachspress coordinates
//! inside of corners; Delaunay triangulation for the paper's own repair.

mod bend;
mod bend3;
mod bernstein;
mod continuity;
mod error;
mod follow;
mod mesh;
mod mesh3;
mod region;
mod ring;
mod room3;
mod settings;
mod shuffle;
mod skin;
#[cfg(test)]
mod testing;

pub use bend::Bend;
pub use bend3::{Bend3, Piece3, Settings3};
pub use continuity::cells::Level;
pub use continuity::corners::Corners;
pub use continuity::corners3::Corners3;
pub use continuity::lattice::Lattice;
pub use error::BendError;
/// Vectors and matrices, of the version that the interface is written in.
pub use glam;
pub use mesh::{Mesh, MeshError};
pub use mesh3::Mesh3;
pub use ring::RingBend;
pub use room3::Room3;
pub use settings::{Continuity, Roughness, Settings, Tint};
pub use shuffle::code::{MAX_SYMBOLS, permutation, shuffle, step};
pub use shuffle::cube::Cube;
pub use shuffle::cursor::Cursor;
pub use shuffle::field::{Displacement, Field, Place};
pub use shuffle::spin::{Spin, Turning};
pub use shuffle::weight::weights;
pub use skin::{Pull, Skin, Turns};

/// Runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
