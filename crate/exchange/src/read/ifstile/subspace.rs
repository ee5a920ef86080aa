//! `$subspace=[M, i, j, ..]`: the part of a space that is drawn, by the real Jordan cells of a matrix.
//!
//! Cells are numbered by their eigenvalues that are real or lie above the real axis, as [`super::roots::roots`] orders
//! them. A real one is a line, a pair a plane. A point is projected onto the chosen cells by left eigenvectors, so that
//! what acts on the space and leaves the other cells in themselves acts on the part, too.

use num_bigint::BigInt;
use num_rational::Ratio;

use super::affine::Affine;
use super::fixed::{Complex, Fixed};
use super::number::{Number, Outcome};
use super::rational::Rational;
use super::roots::{Root, roots};
use crate::ambient::{Cell, Subspace};

/// What is drawn has no more dimensions.
pub const MOST_DRAWN: usize = 3;

/// Onto the chosen part.
pub struct Projection {
    /// A functional for each dimension of the part.
    rows: Vec<Vec<Fixed>>,
    /// The inverse of their products with each other.
    products: Vec<Vec<Fixed>>,
    pub subspace: Subspace,
}

/// The linear part, row by row, and the shift.
pub type Drawn = (Vec<f64>, Vec<f64>);

impl Projection {
    /// Chooses cells of a matrix, whose characteristic polynomial is given.
    pub fn new(matrix: &Affine, polynomial: &[Rational], chosen: &[i64]) -> Result<Self, String> {
        let rational: Vec<Rational> =
            matrix.matrix.iter().map(Number::rational).collect::<Result<_, _>>().map_err(String::from)?;
        let found = roots(polynomial).ok_or(
            "The eigenvalues of the matrix of $subspace cannot be found: its numbers are too large.",
        )?;
        let cells: Vec<(usize, usize)> = found
            .iter()
            .enumerate()
            .flat_map(|(k, root)| {
                cell_sizes(&rational, matrix.size, root).into_iter().map(move |size| (k, size))
            })
            .collect();
        let mut taken: Vec<usize> = Vec::new();
        for &index in chosen {
            let at = usize::try_from(index).ok().filter(|&at| at < cells.len()).ok_or_else(|| {
                match cells.len() - 1 {
                    0 => format!("$subspace asks for cell {index} of its matrix, whose only cell is 0. Choose it."),
                    last => format!(
                        "$subspace asks for cell {index} of its matrix, whose cells are 0 to {last}. Choose among them."
                    ),
                }
            })?;
            if taken.contains(&at) {
                return Err(format!("$subspace names cell {index} twice. Name it once."));
            }
            taken.push(at);
        }
        let size_of = |at: usize| cells[at].1 * if found[cells[at].0].real { 1 } else { 2 };
        let size: usize = taken.iter().map(|&at| size_of(at)).sum();
        if size == 0 || size > MOST_DRAWN {
            let sizes: Vec<String> = (0..cells.len()).map(|at| format!("{at} has {}", size_of(at))).collect();
            return Err(format!(
                "The cells of $subspace have {size} dimensions together, and 1 to {MOST_DRAWN} are drawn. Choose others: cell {}.",
                sizes.join(", ")
            ));
        }
        let mut rows = Vec::new();
        let mut done: Vec<usize> = Vec::new();
        for &at in &taken {
            let of = cells[at].0;
            if done.contains(&of) {
                continue;
            }
            done.push(of);
            let all: Vec<usize> = (0..cells.len()).filter(|&one| cells[one].0 == of).collect();
            let mine: Vec<usize> = (0..all.len()).filter(|&k| taken.contains(&all[k])).collect();
            rows.extend(functionals(&rational, matrix.size, &found[of], cells[all[0]].1, &mine, all.len())?);
        }
        let products =
            inverse(&gram(&rows)).ok_or("The cells of $subspace are not independent. Choose others.")?;
        let ratios = |list: &[Rational]| list.iter().map(Rational::ratio).collect::<Vec<Ratio<BigInt>>>();
        let cell = |&at: &usize| {
            let (root, size) = (&found[cells[at].0], cells[at].1);
            Cell {
                polynomial: ratios(&root.factor),
                re: root.value.re.ratio(),
                im: root.value.im.ratio(),
                radius: root.radius.ratio(),
                size,
            }
        };
        let cells = taken.iter().map(cell).collect();
        Ok(Self { rows, products, subspace: Subspace { matrix: ratios(&rational), cells } })
    }

    /// What a map does to the part; none where it mixes it with the rest of the space.
    pub fn project(&self, map: &Affine) -> Option<Drawn> {
        let size = map.size;
        let exact = map.matrix.iter().all(|x| x.exact().is_some());
        let fixed = |x: &Number| match x {
            Number::Exact(x) => Fixed::of(x),
            other => Fixed::of_double(other.double().unwrap_or(0.0)),
        };
        let matrix: Vec<Fixed> = map.matrix.iter().map(fixed).collect();
        let shift: Vec<Fixed> = map.shift.iter().map(fixed).collect();
        let moved: Vec<Vec<Fixed>> = self
            .rows
            .iter()
            .map(|row| {
                (0..size).map(|k| sum((0..size).map(|j| row[j].times(&matrix[j * size + k])))).collect()
            })
            .collect();
        // In the coordinates of the part: moved = acts rows.
        let products: Vec<Vec<Fixed>> =
            moved.iter().map(|one| self.rows.iter().map(|row| dot(one, row)).collect()).collect();
        let acts = multiplied(&products, &self.products);
        let mut scale = Fixed::one();
        let mut off = Fixed::zero();
        for (k, one) in moved.iter().enumerate() {
            for (j, x) in one.iter().enumerate() {
                let back = sum(acts[k].iter().zip(&self.rows).map(|(factor, row)| factor.times(&row[j])));
                off = off.max(x.minus(&back).abs());
                scale = scale.max(x.abs());
            }
        }
        // Doubles have 52 digits behind the point, and some are lost on the way.
        let near = Fixed::tiny(if exact { 120 } else { 30 });
        if off > near.times(&scale) {
            return None;
        }
        // What is left of numbers that are 0 is none.
        let rounded = |x: &Fixed| if x.abs() < Fixed::tiny(200) { 0.0 } else { x.to_double() };
        let matrix = acts.iter().flatten().map(rounded).collect();
        let shift = self.rows.iter().map(|row| rounded(&dot(row, &shift))).collect();
        Some((matrix, shift))
    }
}

/// The characteristic polynomial of a matrix, whose doubles mean what they are.
pub fn polynomial(matrix: &Affine) -> Outcome<Vec<Rational>> {
    let exact = matrix.matrix.iter().map(|x| x.rational().map(Number::Exact)).collect::<Outcome<_>>()?;
    let lower = Affine { matrix: exact, ..matrix.clone() }.characteristic()?;
    let mut polynomial: Vec<Rational> = lower.iter().map(Number::rational).collect::<Outcome<_>>()?;
    polynomial.push(Rational::ONE);
    Ok(polynomial)
}

fn sum(of: impl Iterator<Item = Fixed>) -> Fixed {
    of.fold(Fixed::zero(), |sum, x| sum.plus(&x))
}

fn dot(one: &[Fixed], other: &[Fixed]) -> Fixed {
    sum(one.iter().zip(other).map(|(x, y)| x.times(y)))
}

fn gram(rows: &[Vec<Fixed>]) -> Vec<Vec<Fixed>> {
    rows.iter().map(|one| rows.iter().map(|other| dot(one, other)).collect()).collect()
}

fn multiplied(one: &[Vec<Fixed>], other: &[Vec<Fixed>]) -> Vec<Vec<Fixed>> {
    let columns = other.first().map_or(0, Vec::len);
    let entry = |row: &[Fixed], k: usize| sum(row.iter().zip(other).map(|(x, line)| x.times(&line[k])));
    one.iter().map(|row| (0..columns).map(|k| entry(row, k)).collect()).collect()
}

/// The inverse of a matrix of products, which is symmetric and positive.
fn inverse(of: &[Vec<Fixed>]) -> Option<Vec<Vec<Fixed>>> {
    let size = of.len();
    let mut left = of.to_vec();
    let mut right: Vec<Vec<Fixed>> = (0..size)
        .map(|row| (0..size).map(|k| if row == k { Fixed::one() } else { Fixed::zero() }).collect())
        .collect();
    for k in 0..size {
        if left[k][k].abs() < Fixed::tiny(100) {
            return None;
        }
        let under = left[k][k].clone();
        for list in [&mut left, &mut right] {
            for x in &mut list[k] {
                *x = x.over(&under)?;
            }
        }
        for row in (0..size).filter(|&row| row != k) {
            let factor = left[row][k].clone();
            for list in [&mut left, &mut right] {
                let lead = list[k].clone();
                for (x, y) in list[row].iter_mut().zip(&lead) {
                    *x = x.minus(&factor.times(y));
                }
            }
        }
    }
    Some(right)
}

/// The sizes of the Jordan cells of a root, the largest first: by how the kernels of the powers of its factor grow.
fn cell_sizes(matrix: &[Rational], size: usize, root: &Root) -> Vec<usize> {
    if root.multiplicity == 1 {
        return vec![1];
    }
    let degree = root.factor.len() - 1;
    let mut value = vec![Rational::ZERO; size * size];
    for coefficient in root.factor.iter().rev() {
        value = product(&value, matrix, size);
        (0..size).for_each(|k| value[k * (size + 1)] = value[k * (size + 1)].plus(coefficient));
    }
    let (mut power, mut before, mut counts) = (value.clone(), 0, Vec::new());
    // How many cells are at least so large.
    while before < root.multiplicity * degree && counts.len() < size {
        let now = size - rank(power.clone(), size);
        counts.push((now - before) / degree);
        before = now;
        power = product(&power, &value, size);
    }
    let of = |cell: usize| counts.iter().filter(|&&count| count > cell).count();
    (0..counts.first().copied().unwrap_or(0)).map(of).collect()
}

fn product(one: &[Rational], other: &[Rational], size: usize) -> Vec<Rational> {
    let mut all = vec![Rational::ZERO; size * size];
    for row in 0..size {
        for k in 0..size {
            let x = &one[row * size + k];
            for column in (0..size).filter(|_| !x.is_zero()) {
                let sum = &mut all[row * size + column];
                *sum = sum.plus(&x.times(&other[k * size + column]));
            }
        }
    }
    all
}

fn rank(mut of: Vec<Rational>, size: usize) -> usize {
    let mut rank = 0;
    for column in 0..size {
        let Some(pivot) = (rank..size).find(|row| !of[row * size + column].is_zero()) else { continue };
        (0..size).for_each(|k| of.swap(pivot * size + k, rank * size + k));
        let Some(inverse) = of[rank * size + column].inverse() else { continue };
        for row in rank + 1..size {
            let factor = of[row * size + column].times(&inverse);
            for k in (column..size).filter(|_| !factor.is_zero()) {
                of[row * size + k] = of[row * size + k].minus(&factor.times(&of[rank * size + k]));
            }
        }
        rank += 1;
    }
    rank
}

/// The functionals of chosen cells of one root. Alone, the first of its coordinates is 1; of several, all chosen, they
/// are orthonormal.
fn functionals(
    matrix: &[Rational],
    size: usize,
    root: &Root,
    largest: usize,
    chosen: &[usize],
    count: usize,
) -> Result<Vec<Vec<Fixed>>, String> {
    let whole = chosen.len() == count;
    if !whole && largest > 1 {
        return Err("Of an eigenvalue with a Jordan cell that is not diagonal, $subspace is read with all cells or none."
            .into());
    }
    // (M - root)^largest, transposed.
    let shifted: Vec<Complex> = (0..size * size)
        .map(|k| {
            let x = Complex::real(Fixed::of(&matrix[k % size * size + k / size]));
            if k.is_multiple_of(size + 1) { x.minus(&root.value) } else { x }
        })
        .collect();
    let mut power = shifted.clone();
    for _ in 1..largest {
        power = complex_product(&power, &shifted, size);
    }
    let basis = kernel(power, size, root.multiplicity)
        .ok_or("The cells of $subspace cannot be told apart: its eigenvalues are too near to each other.")?;
    if root.real {
        let rows: Vec<Vec<Fixed>> =
            basis.into_iter().map(|row| row.into_iter().map(|x| x.re).collect()).collect();
        return Ok(if whole && count > 1 || largest > 1 {
            orthonormal(rows)
        } else {
            chosen.iter().map(|&k| rows[k].clone()).collect()
        });
    }
    let parts = |row: &[Complex]| {
        [row.iter().map(|x| x.re.clone()).collect(), row.iter().map(|x| x.im.clone()).collect()]
    };
    Ok(chosen.iter().flat_map(|&k| parts(&basis[k])).collect())
}

fn complex_product(one: &[Complex], other: &[Complex], size: usize) -> Vec<Complex> {
    (0..size * size)
        .map(|at| {
            (0..size).fold(Complex::zero(), |sum, k| {
                sum.plus(&one[at / size * size + k].times(&other[k * size + at % size]))
            })
        })
        .collect()
}

/// A basis of the kernel of a matrix, which has so many dimensions: reduced, so that each vector begins with a 1 where
/// the others have 0.
fn kernel(mut of: Vec<Complex>, size: usize, dimensions: usize) -> Option<Vec<Vec<Complex>>> {
    let rank = size.checked_sub(dimensions)?;
    let mut columns: Vec<usize> = (0..size).collect();
    for k in 0..rank {
        let (mut best, mut place) = (Fixed::zero(), (k, k));
        for row in k..size {
            for (at, &column) in columns.iter().enumerate().skip(k) {
                let weight = of[row * size + column].square();
                if weight > best {
                    (best, place) = (weight, (row, at));
                }
            }
        }
        if best < Fixed::tiny(160) {
            return None;
        }
        columns.swap(k, place.1);
        (0..size).for_each(|column| of.swap(k * size + column, place.0 * size + column));
        let pivot = of[k * size + columns[k]].clone();
        for column in 0..size {
            of[k * size + column] = of[k * size + column].over(&pivot)?;
        }
        for row in (0..size).filter(|&row| row != k) {
            let factor = of[row * size + columns[k]].clone();
            for column in 0..size {
                of[row * size + column] =
                    of[row * size + column].minus(&factor.times(&of[k * size + column]));
            }
        }
    }
    let left = (rank..size).flat_map(|row| &of[row * size..(row + 1) * size]).map(Complex::square).max();
    if left.is_some_and(|left| left > Fixed::tiny(160)) {
        return None;
    }
    let mut basis: Vec<Vec<Complex>> = columns[rank..]
        .iter()
        .map(|&free| {
            let mut row = vec![Complex::zero(); size];
            row[free] = Complex::real(Fixed::one());
            for k in 0..rank {
                row[columns[k]] = Complex::zero().minus(&of[k * size + free]);
            }
            row
        })
        .collect();
    let mut done = 0;
    for column in 0..size {
        let found = (done..basis.len()).max_by_key(|&row| basis[row][column].square());
        let Some(found) = found.filter(|&row| basis[row][column].square() > Fixed::tiny(160)) else {
            continue;
        };
        basis.swap(done, found);
        let first = basis[done][column].clone();
        for x in &mut basis[done] {
            *x = x.over(&first)?;
        }
        let lead = basis[done].clone();
        for (_, row) in basis.iter_mut().enumerate().filter(|(row, _)| *row != done) {
            let factor = row[column].clone();
            for (x, y) in row.iter_mut().zip(&lead) {
                *x = x.minus(&factor.times(y));
            }
        }
        done += 1;
    }
    Some(basis)
}

/// By Gram and Schmidt.
fn orthonormal(rows: Vec<Vec<Fixed>>) -> Vec<Vec<Fixed>> {
    let mut done: Vec<Vec<Fixed>> = Vec::new();
    for mut row in rows {
        for before in &done {
            let along = dot(&row, before);
            row = row.iter().zip(before).map(|(x, y)| x.minus(&along.times(y))).collect();
        }
        let length = dot(&row, &row).root();
        done.push(row.iter().map(|x| x.over(&length).unwrap_or_else(Fixed::zero)).collect());
    }
    done
}
