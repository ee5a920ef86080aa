//! The space that a system acts on: vectors of rationals, and where they are among real points.

use crate::error::ExactError;
use crate::number::interval::Interval;
use crate::number::matrix::Matrix;
use crate::number::rational::Rational;
use crate::system::real::{MOST_DIMENSIONS, ORIGIN, Point, Square};

/// `Q^n` with a map into real space that sends different vectors to different points, and whose image spans all.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    /// For each real coordinate what the unit vectors contribute.
    rows: Vec<Vec<Interval>>,
    /// Unit vectors whose images are a basis.
    basis: Vec<usize>,
    inverse: Square,
}

impl Space {
    pub fn new(rows: Vec<Vec<Interval>>) -> Result<Self, ExactError> {
        let (dimension, size) = (rows.len(), rows.first().map_or(0, Vec::len));
        if dimension == 0 || dimension > MOST_DIMENSIONS {
            return Err(ExactError::TooMany { count: dimension, most: MOST_DIMENSIONS });
        }
        // Each next unit vector is the one that is farthest from what those before it span.
        let mut rest: Vec<Vec<f64>> =
            (0..size).map(|k| rows.iter().map(|row| row[k].middle()).collect()).collect();
        let mut basis = Vec::new();
        for _ in 0..dimension {
            let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
            let farthest = (0..size).max_by(|&a, &b| length(&rest[a]).total_cmp(&length(&rest[b])));
            let Some(k) = farthest else { return Err(ExactError::Malformed) };
            let direction = rest[k].clone();
            let square = length(&direction);
            for v in &mut rest {
                let along = v.iter().zip(&direction).map(|(a, b)| a * b).sum::<f64>() / square;
                v.iter_mut().zip(&direction).for_each(|(x, d)| *x -= along * d);
            }
            basis.push(k);
        }
        let inverse = Square::from_fn(dimension, |i, j| rows[i][basis[j]]).inverse();
        Ok(Self { rows, basis, inverse })
    }

    /// The same space in other real coordinates.
    pub fn transformed(&self, by: &Square) -> Result<Self, ExactError> {
        let size = self.size();
        let rows = (0..self.dimension()).map(|i| {
            let entry = |k: usize| {
                (0..self.dimension()).fold(Interval::ZERO, |sum, j| sum + by.rows[i][j] * self.rows[j][k])
            };
            (0..size).map(entry).collect()
        });
        Self::new(rows.collect())
    }

    pub const fn dimension(&self) -> usize {
        self.rows.len()
    }

    pub fn size(&self) -> usize {
        self.rows[0].len()
    }

    /// Where a vector is.
    pub fn point(&self, vector: &[Rational]) -> Point {
        let mut point = ORIGIN;
        for (k, x) in vector.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
            let x = x.enclosure();
            for (coordinate, row) in point.iter_mut().zip(&self.rows) {
                *coordinate = *coordinate + row[k] * x;
            }
        }
        point
    }

    /// How a matrix acts on real points.
    pub fn action(&self, matrix: &Matrix) -> Square {
        let images: Vec<Point> = self.basis.iter().map(|&k| self.point(&matrix.column(k))).collect();
        Square::from_fn(self.dimension(), |i, j| images[j][i]).times(&self.inverse)
    }
}
