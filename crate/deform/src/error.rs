//! Why a bend cannot be made.

use frond_core::IfsError;
use thiserror::Error;

use crate::mesh::MeshError;

/// What is wrong with a bend.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum BendError {
    /// The shape is none: no maps, too many, or such that nothing is left of them.
    #[error(transparent)]
    Shape(#[from] IfsError),
    /// The mesh, or where it is to be moved.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The locality or the detail is NaN, infinite or negative.
    #[error(
        "Locality (kb) and detail (ke) are numbers from 0 on. Give kb and ke such values, kb at most ke."
    )]
    Depth,
    /// The locality is larger than the detail.
    #[error("Locality cannot exceed detail: kb is {kb} and ke is {ke}. Make kb smaller or ke larger.")]
    Locality {
        /// The locality that was asked for.
        kb: f64,
        /// The detail that was asked for.
        ke: f64,
    },
    /// The roughness is NaN, infinite or negative.
    #[error("Roughness (delta) is a number from 0 on: 0 is smooth, above 1 the smallest parts move most.")]
    Roughness,
    /// Not a power of 4 of points, or points that are not finite.
    #[error(
        "A closed curve is bent through 4, 16, 64 .. 262144 finite points of it, and there are {count}. Sample it so."
    )]
    Ring {
        /// How many there are.
        count: usize,
    },
    /// Not one colour for each control point, or a colour that is none.
    #[error("The colours must be {wanted} triples of numbers from 0 to 1, one for each control point.")]
    Tint {
        /// As many as control points.
        wanted: usize,
    },
}

impl BendError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Shape(error) => error.code(),
            Self::Mesh(error) => error.code(),
            Self::Depth => "bend-depth",
            Self::Locality { .. } => "bend-locality",
            Self::Roughness => "bend-roughness",
            Self::Ring { .. } => "bend-ring",
            Self::Tint { .. } => "bend-tint",
        }
    }
}
