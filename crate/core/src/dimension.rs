//! What the plane and space have in common, and where they differ.

mod plane;
mod space;

use std::fmt::Debug;
use std::iter::Sum;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::morph::options::Kind;

/// The plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dim2;

/// Space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dim3;

/// The plane ([`Dim2`]) or space ([`Dim3`]): what maps, systems and morphs need to know of it.
///
/// What is the same in both is written once, over this trait. Polar factors, hulls and ellipsoids are not the same, and
/// stay apart. Nobody else can implement it.
pub trait Dimension: sealed::Sealed + Copy + Debug + PartialEq + 'static {
    /// A point or a direction.
    type Vector: Copy
        + Debug
        + PartialEq
        + Add<Output = Self::Vector>
        + Sub<Output = Self::Vector>
        + Neg<Output = Self::Vector>
        + Mul<f64, Output = Self::Vector>
        + Div<f64, Output = Self::Vector>
        + for<'a> Sum<&'a Self::Vector>;
    /// A square matrix.
    type Matrix: Copy
        + Debug
        + PartialEq
        + Add<Output = Self::Matrix>
        + Sub<Output = Self::Matrix>
        + Mul<Output = Self::Matrix>
        + Mul<Self::Vector, Output = Self::Vector>
        + Mul<f64, Output = Self::Matrix>;
    /// All numbers of a map.
    type Row: Copy + AsRef<[f64]>;
    /// As many numbers as there are axes.
    type Scales: Copy + AsRef<[f64]>;
    /// How a map turns on its way in a morph.
    type Turn: Copy + Debug + PartialEq;

    /// The number of coordinates.
    const COORDINATES: usize;
    /// The origin.
    const ZERO: Self::Vector;
    /// The matrix that changes nothing.
    const IDENTITY: Self::Matrix;
    /// How far [`Dimension::norm`] may be off, relative to itself.
    const NORM_ERROR: f64;

    /// All numbers of a map, the rows of its matrix first.
    fn row(linear: Self::Matrix, translation: Self::Vector) -> Self::Row;
    /// The length of a vector.
    fn length(v: Self::Vector) -> f64;
    /// The largest coordinate of a vector, without its sign.
    fn size(v: Self::Vector) -> f64;
    /// The determinant.
    fn determinant(m: Self::Matrix) -> f64;
    /// The inverse; not finite where there is none.
    fn inverse(m: Self::Matrix) -> Self::Matrix;
    /// The operator norm.
    fn norm(m: Self::Matrix) -> f64;
    /// The singular values, the largest first.
    fn singular_values(m: Self::Matrix) -> Self::Scales;
    /// The largest and the least singular value, also of matrices whose squares vanish.
    fn extreme_scales(m: Self::Matrix) -> (f64, f64);
    /// The largest absolute value of an eigenvalue.
    fn spectral_radius(m: Self::Matrix) -> f64;
    /// The determinant; in the plane with all its digits, also of flat maps.
    fn full_determinant(m: Self::Matrix) -> f64;
    /// The spectral radius of a product of this determinant, whose norm may be off by so much through rounding; in the
    /// plane the least that it can be.
    fn certain_radius(m: Self::Matrix, determinant: f64, off: f64) -> f64;

    /// The matrix to coordinates in which maps of these linear parts shrink about as much as can be, and back from
    /// them. `plain` is the largest norm as they are, `least` the largest spectral radius.
    fn rounding(linear: &[Self::Matrix], plain: f64, least: f64) -> [Self::Matrix; 2];
    /// Probabilities in proportion to how large the pieces of maps of these linear parts are.
    fn probabilities(linear: &[Self::Matrix]) -> Vec<f64>;

    /// How a matrix turns into another, with so many extra whole turns, and how each stretches.
    fn turning(from: Self::Matrix, to: Self::Matrix, extra: i32) -> (Kind, Self::Turn, [Self::Matrix; 2]);
    /// The whole angle of a turn.
    fn angle(turn: &Self::Turn) -> f64;
    /// The orthogonal factor after the part `u` of a turn.
    fn turned(turn: &Self::Turn, kind: Kind, u: f64) -> Self::Matrix;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Dim2 {}
    impl Sealed for super::Dim3 {}
}
