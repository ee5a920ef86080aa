//! Affine maps of a space of any dimension, in numbers that are exact where they can be.

use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{One, Zero};

use super::number::{Number, Outcome, TOO_LARGE};
use super::rational::Rational;

/// The most dimensions of a program.
pub const MAX_DIMENSION: usize = 12;
const SINGULAR: &str = "A map that has no inverse is inverted: it makes its space flat. Choose another.";

/// The longest common denominator of a matrix whose characteristic polynomial is asked for.
const MOST_COMMON_BITS: u64 = 512;

/// `x' = matrix x + shift`; the matrix row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Affine {
    pub size: usize,
    pub matrix: Vec<Number>,
    pub shift: Vec<Number>,
}

impl Affine {
    pub fn scaling(size: usize, factor: &Number) -> Outcome<Self> {
        let factor = factor.entry()?;
        let entry = |k: usize| if k.is_multiple_of(size + 1) { factor.clone() } else { Number::ZERO };
        Ok(Self { size, matrix: (0..size * size).map(entry).collect(), shift: vec![Number::ZERO; size] })
    }

    pub fn identity(size: usize) -> Self {
        let entry = |k: usize| if k.is_multiple_of(size + 1) { Number::ONE } else { Number::ZERO };
        Self { size, matrix: (0..size * size).map(entry).collect(), shift: vec![Number::ZERO; size] }
    }

    pub fn translation(shift: &[Number]) -> Outcome<Self> {
        let shift = shift.iter().map(Number::entry).collect::<Outcome<Vec<_>>>()?;
        Ok(Self { size: shift.len(), matrix: Self::identity(shift.len()).matrix, shift })
    }

    pub fn linear(size: usize, matrix: &[Number]) -> Outcome<Self> {
        let matrix = matrix.iter().map(Number::entry).collect::<Outcome<Vec<_>>>()?;
        Ok(Self { size, matrix, shift: vec![Number::ZERO; size] })
    }

    /// The matrix with these last columns of 1, x, x² .. in Q\[x\] modulo the polynomial whose lower coefficients are
    /// given, the lowest first.
    pub fn companion(lower: &[Number]) -> Outcome<Self> {
        let size = lower.len();
        let mut matrix = vec![Number::ZERO; size * size];
        for (row, coefficient) in lower.iter().enumerate() {
            if row > 0 {
                matrix[row * size + row - 1] = Number::ONE;
            }
            matrix[row * size + size - 1] = coefficient.entry()?.negated();
        }
        Ok(Self { size, matrix, shift: vec![Number::ZERO; size] })
    }

    /// The coordinates in reverse.
    pub fn exchange(size: usize) -> Self {
        let entry = |k: usize| if k / size + k % size + 1 == size { Number::ONE } else { Number::ZERO };
        Self { size, matrix: (0..size * size).map(entry).collect(), shift: vec![Number::ZERO; size] }
    }

    pub fn diagonal(entries: &[Number]) -> Outcome<Self> {
        let size = entries.len();
        let mut map = Self::identity(size);
        for (k, entry) in entries.iter().enumerate() {
            map.matrix[k * (size + 1)] = entry.entry()?;
        }
        Ok(map)
    }

    /// How many numbers of it are long, in words: products of long ones take longer.
    pub fn words(&self) -> usize {
        self.matrix.iter().chain(&self.shift).map(Number::words).max().unwrap_or(1)
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Self) -> Outcome<Self> {
        let size = self.size;
        let mut map = Self { size, matrix: vec![Number::ZERO; size * size], shift: self.shift.clone() };
        for row in 0..size {
            for k in 0..size {
                let x = &self.matrix[row * size + k];
                if x.is_zero() {
                    continue;
                }
                for column in 0..size {
                    let y = &inner.matrix[k * size + column];
                    if !y.is_zero() {
                        let sum = &mut map.matrix[row * size + column];
                        *sum = sum.plus(&x.times(y)?)?;
                    }
                }
                if !inner.shift[k].is_zero() {
                    map.shift[row] = map.shift[row].plus(&x.times(&inner.shift[k])?)?;
                }
            }
        }
        Ok(map)
    }

    /// The sum of what both make of each point.
    pub fn plus(&self, other: &Self) -> Outcome<Self> {
        let sums = |one: &[Number], other: &[Number]| {
            one.iter().zip(other).map(|(x, y)| x.plus(y)).collect::<Outcome<Vec<_>>>()
        };
        Ok(Self {
            size: self.size,
            matrix: sums(&self.matrix, &other.matrix)?,
            shift: sums(&self.shift, &other.shift)?,
        })
    }

    pub fn negated(&self) -> Self {
        let negated = |list: &[Number]| list.iter().map(Number::negated).collect();
        Self { size: self.size, matrix: negated(&self.matrix), shift: negated(&self.shift) }
    }

    pub fn is_identity(&self) -> bool {
        *self == Self::identity(self.size)
    }

    /// By Gauss and Jordan.
    pub fn inverse(&self) -> Outcome<Self> {
        let size = self.size;
        let mut left = self.matrix.clone();
        let mut right = Self::identity(size).matrix;
        for column in 0..size {
            // The largest pivot of doubles; of exact numbers any.
            let mut pivot: Option<(usize, f64)> = None;
            for row in column..size {
                let x = &left[row * size + column];
                let weight = match x {
                    x if x.is_zero() => continue,
                    Number::Real(x) => x.abs(),
                    _ => f64::INFINITY,
                };
                if pivot.is_none_or(|(_, best)| weight > best) {
                    pivot = Some((row, weight));
                }
            }
            let Some((row, weight)) = pivot else { return Err(SINGULAR) };
            let scale = self.matrix.iter().map(|x| x.double().unwrap_or(0.0).abs()).fold(0.0, f64::max);
            if weight <= 1e-13 * scale {
                return Err(SINGULAR);
            }
            for k in 0..size {
                left.swap(row * size + k, column * size + k);
                right.swap(row * size + k, column * size + k);
            }
            let under = left[column * size + column].clone();
            for k in 0..size {
                left[column * size + k] = left[column * size + k].over(&under)?;
                right[column * size + k] = right[column * size + k].over(&under)?;
            }
            for row in 0..size {
                let factor = left[row * size + column].clone();
                if row == column || factor.is_zero() {
                    continue;
                }
                for list in [&mut left, &mut right] {
                    for k in 0..size {
                        let part = factor.times(&list[column * size + k])?;
                        list[row * size + k] = list[row * size + k].minus(&part)?;
                    }
                }
            }
        }
        let linear = Self { size, matrix: right, shift: vec![Number::ZERO; size] };
        let back = Self { shift: self.shift.iter().map(Number::negated).collect(), ..Self::identity(size) };
        linear.after(&back)
    }

    /// The lower coefficients of the characteristic polynomial of its matrix, the lowest first (Faddeev and
    /// Le Verrier).
    pub fn characteristic(&self) -> Outcome<Vec<Number>> {
        let size = self.size;
        if let Some(exact) = self.matrix.iter().map(Number::exact).collect::<Option<Vec<_>>>() {
            return of_fractions(&exact, size);
        }
        let matrix = Self { shift: vec![Number::ZERO; size], ..self.clone() };
        let mut lower = vec![Number::ZERO; size];
        let mut sum = Self { matrix: vec![Number::ZERO; size * size], ..matrix.clone() };
        let mut last = Number::ONE;
        for k in 1..=size {
            sum = matrix.after(&sum)?;
            for row in 0..size {
                sum.matrix[row * (size + 1)] = sum.matrix[row * (size + 1)].plus(&last)?;
            }
            let product = matrix.after(&sum)?;
            let mut trace = Number::ZERO;
            for row in 0..size {
                trace = trace.plus(&product.matrix[row * (size + 1)])?;
            }
            last = trace.negated().over(&Number::whole(i64::try_from(k).unwrap_or(1)))?;
            lower[size - k] = last.clone();
        }
        Ok(lower)
    }
}

/// The same of fractions, in whole numbers: those times their common denominator.
fn of_fractions(matrix: &[&Rational], size: usize) -> Outcome<Vec<Number>> {
    let ratios: Vec<_> = matrix.iter().map(|x| x.ratio()).collect();
    let mut common = BigInt::one();
    for ratio in &ratios {
        if !(&common % ratio.denom()).is_zero() {
            // What of the denominator is not in the common one yet.
            let more = Ratio::new(common.clone(), ratio.denom().clone());
            common *= more.denom();
        }
        if common.bits() > MOST_COMMON_BITS {
            return Err(TOO_LARGE);
        }
    }
    let matrix: Vec<BigInt> = ratios.iter().map(|x| x.numer() * (&common / x.denom())).collect();
    if matrix.iter().any(|x| x.bits() > 2 * MOST_COMMON_BITS) {
        return Err(TOO_LARGE);
    }
    let after = |other: &[BigInt]| -> Vec<BigInt> {
        let entry = |row: usize, column: usize| {
            (0..size).map(|k| &matrix[row * size + k] * &other[k * size + column]).sum()
        };
        (0..size * size).map(|at| entry(at / size, at % size)).collect()
    };
    let mut lower = vec![Number::ZERO; size];
    let mut product = vec![BigInt::zero(); size * size];
    let (mut last, mut power) = (BigInt::one(), BigInt::one());
    for k in 1..=size {
        for row in 0..size {
            product[row * (size + 1)] += &last;
        }
        product = after(&product);
        let trace: BigInt = (0..size).map(|row| &product[row * (size + 1)]).sum();
        // This leaves no rest.
        last = -trace / k;
        power *= &common;
        lower[size - k] = Number::Exact(Rational::of(Ratio::new(last.clone(), power.clone()))).checked()?;
    }
    Ok(lower)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(list: &[i64]) -> Vec<Number> {
        list.iter().map(|&x| Number::whole(x)).collect()
    }

    #[test]
    fn a_companion_matrix_has_its_polynomial() {
        let lower = whole(&[7, -3, 0, 2, 5]);
        let map = Affine::companion(&lower).unwrap();
        assert_eq!(map.characteristic().unwrap(), lower);
        let inverse = map.inverse().unwrap();
        assert!(map.after(&inverse).unwrap().is_identity());
        assert!(Affine::companion(&whole(&[0, 1])).unwrap().inverse().is_err());
    }

    #[test]
    fn an_inverse_undoes_the_shift() {
        let map = Affine::translation(&whole(&[1, -2])).unwrap();
        let map = map.after(&Affine::linear(2, &whole(&[2, 1, 0, 3])).unwrap()).unwrap();
        for both in [map.after(&map.inverse().unwrap()), map.inverse().unwrap().after(&map)] {
            assert!(both.unwrap().is_identity());
        }
    }
}
