//! Systems of integer matrices, of which an invariant subspace is seen.
//!
//! A matrix S with an eigenvalue x acts on `Q^n`. The left eigenvector v of S, with entries in Q(x), sends each vector
//! to the number `v u`, and S to multiplication by x. A matrix with `v M = m v` becomes multiplication by m; one with
//! `v M = m v*`, where v* is conjugated, multiplication of the conjugate.

use std::sync::Arc;

use crate::error::ExactError;
use crate::number::field::{Element, Field, LARGEST_FIELD};
use crate::number::matrix::{Echelon, Matrix};
use crate::number::polynomial::Polynomial;
use crate::number::rational::Rational;
use crate::number::roots::ComplexInterval;
use crate::system::build::{FieldMap, System};

/// A map of vectors of rationals: a matrix, row by row, and a shift.
#[derive(Clone, Debug)]
pub struct VectorMap {
    /// The state whose copy this is.
    pub from: usize,
    /// The matrix, row by row.
    pub matrix: Vec<Rational>,
    /// The shift.
    pub shift: Vec<Rational>,
}

const LARGEST_MATRIX: usize = 32;

impl System {
    /// The system that maps of vectors of rationals make on the eigenspace of a matrix.
    ///
    /// # Errors
    /// Where the eigenvalue is none or not simple, a map does not keep the subspace, or all is too large.
    pub fn projected(
        generator: &[Rational],
        eigenvalue: ComplexInterval,
        states: &[Vec<VectorMap>],
    ) -> Result<Self, ExactError> {
        let size = generator.len().isqrt();
        if size > LARGEST_MATRIX {
            return Err(ExactError::TooMany { count: size, most: LARGEST_MATRIX });
        }
        let generator = Matrix::new(size, generator.to_vec()).ok_or(ExactError::Malformed)?;
        if size == 0 {
            return Err(ExactError::Malformed);
        }
        let minimal = minimal_polynomial(&generator);
        let field = Arc::new(Field::of_root_up_to(&minimal, eigenvalue, LARGEST_FIELD)?);
        let vector = left_eigenvector(&field, &generator)?;
        let image = |column: &[Rational]| {
            vector.iter().zip(column).filter(|(_, x)| !x.is_zero()).fold(field.zero(), |sum, (v, x)| {
                field.plus(&sum, &Element(v.0.iter().map(|c| c * x).collect()))
            })
        };
        let pivot = vector.iter().position(|v| !field.is_zero(v)).ok_or(ExactError::NotSimple)?;
        let conjugated: Option<Vec<Element>> = vector.iter().map(|v| field.conjugate(v)).collect();
        let mut made = Vec::new();
        for (state, maps) in states.iter().enumerate() {
            let mut all = Vec::new();
            for (k, map) in maps.iter().enumerate() {
                let matrix = Matrix::new(size, map.matrix.clone()).ok_or(ExactError::Malformed)?;
                if map.shift.len() != size {
                    return Err(ExactError::Malformed);
                }
                let moved: Vec<Element> = (0..size).map(|k| image(&matrix.column(k))).collect();
                let factor = |of: &[Element]| {
                    let factor = field.times(&moved[pivot], &field.inverse(&of[pivot])?);
                    of.iter().zip(&moved).all(|(v, m)| field.times(&factor, v) == *m).then_some(factor)
                };
                let plain = factor(&vector).map(|factor| (factor, false));
                let mirrored =
                    || conjugated.as_deref().and_then(factor).map(|factor| (factor, !field.is_real()));
                let found = plain.or_else(mirrored);
                let (factor, is_conjugated) = found.ok_or(ExactError::NotInvariant { state, map: k })?;
                all.push(FieldMap { from: map.from, factor, shift: image(&map.shift), is_conjugated });
            }
            made.push(all);
        }
        Self::of_numbers(&field, &made)
    }
}

/// A polynomial with all eigenvalues for roots: of the powers of a matrix, as long vectors.
fn minimal_polynomial(matrix: &Matrix) -> Polynomial {
    let (mut space, mut power) = (Echelon::default(), Matrix::identity(matrix.size()));
    loop {
        let entries = (0..matrix.size()).flat_map(|k| power.row(k).to_vec()).collect();
        if let Some(factors) = space.insert(entries) {
            let mut all: Vec<Rational> = factors.iter().map(|factor| -factor).collect();
            all.push(Rational::ONE);
            return Polynomial::new(all);
        }
        power = power.times(matrix);
    }
}

/// The one v with `v S = x v`, by elimination over the field.
fn left_eigenvector(field: &Field, matrix: &Matrix) -> Result<Vec<Element>, ExactError> {
    let n = matrix.size();
    // The rows of (S - x)^T, of which v is in the kernel.
    let mut rows: Vec<Vec<Element>> = (0..n)
        .map(|i| {
            let entry = |j: usize| {
                let entry = field.rational(matrix.row(j)[i].clone());
                if i == j { field.minus(&entry, &field.generator()) } else { entry }
            };
            (0..n).map(entry).collect()
        })
        .collect();
    let mut pivots: Vec<usize> = Vec::new();
    let mut free = None;
    for column in 0..n {
        let done = pivots.len();
        let Some(pivot) = (done..n).find(|&k| !field.is_zero(&rows[k][column])) else {
            if free.replace(column).is_some() {
                return Err(ExactError::NotSimple);
            }
            continue;
        };
        rows.swap(done, pivot);
        let inverse = field.inverse(&rows[done][column]).ok_or(ExactError::NotSimple)?;
        let scaled: Vec<Element> = rows[done].iter().map(|x| field.times(x, &inverse)).collect();
        for (k, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != done) {
            let factor = row[column].clone();
            if k != done && !field.is_zero(&factor) {
                for (x, s) in row.iter_mut().zip(&scaled) {
                    *x = field.minus(x, &field.times(&factor, s));
                }
            }
        }
        rows[done] = scaled;
        pivots.push(column);
    }
    let free = free.ok_or(ExactError::NotSimple)?;
    let mut vector = vec![field.zero(); n];
    vector[free] = field.one();
    for (row, &column) in rows.iter().zip(&pivots) {
        vector[column] = field.minus(&field.zero(), &row[free]);
    }
    Ok(vector)
}
