//! Linear algebra over the rationals.

use crate::number::rational::Rational;

/// A square matrix, row by row.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Matrix {
    size: usize,
    entries: Vec<Rational>,
}

impl Matrix {
    /// `None` where the number of entries is not the square of the size.
    pub fn new(size: usize, entries: Vec<Rational>) -> Option<Self> {
        (entries.len() == size * size).then_some(Self { size, entries })
    }

    pub fn from_columns(columns: &[Vec<Rational>]) -> Self {
        let size = columns.len();
        let entries = (0..size * size).map(|k| columns[k % size][k / size].clone()).collect();
        Self { size, entries }
    }

    pub fn identity(size: usize) -> Self {
        let entries = (0..size * size).map(|k| Rational::whole(i64::from(k / size == k % size))).collect();
        Self { size, entries }
    }

    pub const fn size(&self) -> usize {
        self.size
    }

    pub fn entries(&self) -> &[Rational] {
        &self.entries
    }

    pub fn row(&self, k: usize) -> &[Rational] {
        &self.entries[k * self.size..(k + 1) * self.size]
    }

    pub fn column(&self, k: usize) -> Vec<Rational> {
        (0..self.size).map(|row| self.entries[row * self.size + k].clone()).collect()
    }

    pub fn apply(&self, vector: &[Rational]) -> Vec<Rational> {
        (0..self.size).map(|k| dot(self.row(k), vector)).collect()
    }

    pub fn times(&self, other: &Self) -> Self {
        let columns: Vec<_> = (0..self.size).map(|k| self.apply(&other.column(k))).collect();
        Self::from_columns(&columns)
    }

    /// `None` where there is none.
    pub fn inverse(&self) -> Option<Self> {
        let mut space = Echelon::default();
        for k in 0..self.size {
            if space.insert(self.column(k)).is_some() {
                return None;
            }
        }
        let unit = |k: usize| (0..self.size).map(|j| Rational::whole(i64::from(j == k))).collect();
        let columns: Option<Vec<_>> = (0..self.size).map(|k| space.express(unit(k))).collect();
        Some(Self::from_columns(&columns?))
    }
}

pub(crate) fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    let pairs = a.iter().zip(b).filter(|(a, b)| !a.is_zero() && !b.is_zero());
    pairs.fold(Rational::ZERO, |sum, (a, b)| &sum + &(a * b))
}

pub(crate) fn sum(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

pub(crate) fn difference(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Vectors that do not depend on each other, in a form that tells how others depend on them.
#[derive(Default)]
pub(crate) struct Echelon {
    /// The place of a leading one, the vector, and how it is made of those that were inserted.
    rows: Vec<(usize, Vec<Rational>, Vec<Rational>)>,
}

impl Echelon {
    /// Takes one more vector in. `Some` where it depends on those before it: their factors.
    pub fn insert(&mut self, vector: Vec<Rational>) -> Option<Vec<Rational>> {
        let (rest, factors) = self.reduce(vector);
        let Some((place, scale)) = lead(&rest) else { return Some(factors) };
        let mut made: Vec<Rational> = factors.iter().map(|factor| -factor).collect();
        made.push(Rational::ONE);
        let scaled = |row: Vec<Rational>| row.iter().map(|x| x * &scale).collect();
        self.rows.push((place, scaled(rest), scaled(made)));
        None
    }

    /// How a vector is made of those that were inserted.
    pub fn express(&self, vector: Vec<Rational>) -> Option<Vec<Rational>> {
        let (rest, factors) = self.reduce(vector);
        lead(&rest).is_none().then_some(factors)
    }

    fn reduce(&self, mut vector: Vec<Rational>) -> (Vec<Rational>, Vec<Rational>) {
        let mut factors = vec![Rational::ZERO; self.rows.len()];
        for (place, row, made) in &self.rows {
            let factor = vector[*place].clone();
            if factor.is_zero() {
                continue;
            }
            for (x, r) in vector.iter_mut().zip(row).filter(|(_, r)| !r.is_zero()) {
                *x = &*x - &(&factor * r);
            }
            for (x, m) in factors.iter_mut().zip(made).filter(|(_, m)| !m.is_zero()) {
                *x = &*x + &(&factor * m);
            }
        }
        (vector, factors)
    }
}

fn lead(vector: &[Rational]) -> Option<(usize, Rational)> {
    let (place, first) = vector.iter().enumerate().find(|(_, x)| !x.is_zero())?;
    Some((place, first.inverse()?))
}
