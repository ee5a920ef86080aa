//! The exact system behind maps that were computed: rational maps of a space, and an invariant part of it.

use num_bigint::BigInt;
use num_rational::Ratio;

/// Rational maps of Q^dim, before they were taken to a subspace and rounded.
#[derive(Clone, Debug, PartialEq)]
pub struct Ambient {
    /// The dimensions of the space.
    pub dim: usize,
    /// The part of it that is drawn; all of it where there is none.
    pub subspace: Option<Subspace>,
    /// The maps of each state; the first state is the shape. A system has one.
    pub states: Vec<Vec<AmbientMap>>,
}

/// `x' = matrix x + shift`, a copy of a state.
#[derive(Clone, Debug, PartialEq)]
pub struct AmbientMap {
    /// The state that is copied, from 0.
    pub from: usize,
    /// The matrix, row by row.
    pub matrix: Vec<Ratio<BigInt>>,
    /// The translation.
    pub shift: Vec<Ratio<BigInt>>,
}

/// An invariant subspace, by the Jordan cells of a matrix: what is left when the space is projected along the other
/// cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Subspace {
    /// The matrix, row by row.
    pub matrix: Vec<Ratio<BigInt>>,
    /// Its cells that are drawn.
    pub cells: Vec<Cell>,
}

/// A real Jordan cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The monic factor of the characteristic polynomial whose root it belongs to, the constant first. It is
    /// irreducible wherever a factor of it was found.
    pub polynomial: Vec<Ratio<BigInt>>,
    /// The real part of the root, within `radius`.
    pub re: Ratio<BigInt>,
    /// Its imaginary part, 0 or positive. A pair of conjugate roots is one cell.
    pub im: Ratio<BigInt>,
    /// No other root of the polynomial is so near.
    pub radius: Ratio<BigInt>,
    /// How often the root stands in the cell: 1 where the matrix is diagonal there.
    pub size: usize,
}
