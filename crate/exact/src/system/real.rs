//! Matrices and points of at most three real coordinates, in intervals.

use crate::number::interval::Interval;

pub(crate) const MOST_DIMENSIONS: usize = 3;

/// A point. Coordinates beyond the dimension are zero.
pub(crate) type Point = [Interval; MOST_DIMENSIONS];

pub(crate) const ORIGIN: Point = [Interval::ZERO; MOST_DIMENSIONS];

/// A matrix that acts on points. What is beyond the dimension is zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Square {
    pub dimension: usize,
    pub rows: [[Interval; MOST_DIMENSIONS]; MOST_DIMENSIONS],
}

impl Square {
    pub fn from_fn(dimension: usize, entry: impl Fn(usize, usize) -> Interval) -> Self {
        let mut rows = [[Interval::ZERO; MOST_DIMENSIONS]; MOST_DIMENSIONS];
        for (i, row) in rows.iter_mut().enumerate().take(dimension) {
            for (j, x) in row.iter_mut().enumerate().take(dimension) {
                *x = entry(i, j);
            }
        }
        Self { dimension, rows }
    }

    pub fn identity(dimension: usize) -> Self {
        Self::from_fn(dimension, |i, j| if i == j { Interval::ONE } else { Interval::ZERO })
    }

    pub fn times(&self, other: &Self) -> Self {
        Self::from_fn(self.dimension, |i, j| {
            (0..self.dimension).fold(Interval::ZERO, |sum, k| sum + self.rows[i][k] * other.rows[k][j])
        })
    }

    pub fn apply(&self, point: &Point) -> Point {
        let mut image = ORIGIN;
        for (x, row) in image.iter_mut().zip(&self.rows).take(self.dimension) {
            *x = (0..self.dimension).fold(Interval::ZERO, |sum, k| sum + row[k] * point[k]);
        }
        image
    }

    pub fn transposed(&self) -> Self {
        Self::from_fn(self.dimension, |i, j| self.rows[j][i])
    }

    pub fn determinant(&self) -> Interval {
        let m = &self.rows;
        match self.dimension {
            1 => m[0][0],
            2 => m[0][0] * m[1][1] - m[0][1] * m[1][0],
            _ => (0..3).fold(Interval::ZERO, |sum, k| sum + m[0][k] * self.cofactor(0, k)),
        }
    }

    fn cofactor(&self, row: usize, column: usize) -> Interval {
        let m = &self.rows;
        match self.dimension {
            1 => Interval::ONE,
            2 => {
                let minor = m[1 - row][1 - column];
                if (row + column) % 2 == 1 { -minor } else { minor }
            }
            _ => {
                let (r, s) = ((row + 1) % 3, (row + 2) % 3);
                let (c, d) = ((column + 1) % 3, (column + 2) % 3);
                m[r][c] * m[s][d] - m[r][d] * m[s][c]
            }
        }
    }

    pub fn inverse(&self) -> Self {
        let determinant = self.determinant();
        Self::from_fn(self.dimension, |i, j| self.cofactor(j, i) / determinant)
    }

    /// The product of the transpose with this.
    pub fn gram(&self) -> Self {
        self.transposed().times(self)
    }

    /// A bound of what it stretches lengths by. For the symmetric S of [`Square::gram`], the largest sum of a row of
    /// |S^k| bounds the k-th power of the square of the norm, ever better.
    pub fn norm(&self) -> f64 {
        let mut power = self.gram();
        // No entry of the diagonal is more than the square of the norm: of a similarity the first bound is that.
        let most = (0..self.dimension).map(|k| power.rows[k][k].lower()).fold(0.0, f64::max);
        if power.largest_row() <= most * (1.0 + 1e-12) {
            return self.quick_norm();
        }
        let (mut scale, mut exponent) = (Interval::ONE, Interval::ONE);
        let mut least = f64::INFINITY;
        for _ in 0..7 {
            let size = power.largest_row();
            if !size.is_finite() || size == 0.0 {
                break;
            }
            let bound = (scale * Interval::point(size)).power(exponent);
            least = least.min(bound.sqrt().upper());
            let divisor = Interval::point(size);
            let scaled = Self::from_fn(self.dimension, |i, j| power.rows[i][j] / divisor);
            power = scaled.times(&scaled);
            scale = (scale * divisor).square();
            exponent = exponent / Interval::point(2.0);
            if !scale.upper().is_finite() || scale.lower() <= 0.0 {
                break;
            }
        }
        if least.is_finite() { least } else { power.largest_row().sqrt().next_up() }
    }

    /// As [`Square::norm`], by one step: exact for similarities.
    pub fn quick_norm(&self) -> f64 {
        self.gram().largest_row().sqrt().next_up()
    }

    fn largest_row(&self) -> f64 {
        let rows = self.rows.iter().take(self.dimension);
        rows.map(|row| row.iter().fold(Interval::ZERO, |sum, x| sum + x.abs()).upper()).fold(0.0, f64::max)
    }
}

pub(crate) fn plus(a: &Point, b: &Point) -> Point {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn distance(a: &Point, b: &Point) -> Interval {
    let squares = (0..MOST_DIMENSIONS).map(|k| (a[k] - b[k]).square());
    squares.fold(Interval::ZERO, |sum, square| sum + square).sqrt()
}
