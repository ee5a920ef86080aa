//! Polynomials of the plane, and their means over a self-similar shape.

use frond_core::{Affine2, Ifs};
use glam::{DMat2, DVec2};

/// The monomials x^i y^j up to a total degree, lowest first, and in a degree the powers of x first.
pub(crate) const fn monomials(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// Where x^i y^j stands among them.
pub(crate) const fn slot(i: usize, j: usize) -> usize {
    (i + j) * (i + j + 1) / 2 + j
}

/// The means of the monomials over a shape, its moments, one after another: that of 1 is 1. Its points are
/// counted as the chaos game throws them: the invariant measure of its maps and probabilities (Hutchinson 1981).
///
/// The mean of a polynomial over the shape is that of its means over the pieces, which are means of polynomials of no
/// higher degree over the shape again: from the lowest degree on, the moments solve a linear system for each degree.
/// Because the maps contract together, each system has one solution. The maps are those of the shape in some
/// coordinates, best in such that its middle is the origin and its size about 1.
pub(crate) fn of_shape(maps: &[Substitution], probabilities: &[f64]) -> Vec<f64> {
    let Some(mut mean) = maps.first().cloned() else { return vec![1.0] };
    mean.rows.fill(0.0);
    for (map, p) in maps.iter().zip(probabilities) {
        mean.rows.iter_mut().zip(&map.rows).for_each(|(sum, number)| *sum += p * number);
    }
    let mut moments = vec![1.0];
    for n in 1..=mean.degree {
        let from = moments.len();
        let equation = |j: usize| -> Vec<f64> {
            let (known, own) = mean.row(n, j).split_at(from);
            let left = own.iter().enumerate().map(|(k, number)| f64::from(u8::from(k == j)) - number);
            left.chain([dot(known, &moments)]).collect()
        };
        let solved = solve((0..=n).map(equation).collect());
        moments.extend(solved);
    }
    moments
}

/// The middle of a shape, its points counted as the chaos game throws them, where it can be had.
pub(crate) fn centroid(ifs: &Ifs) -> Option<DVec2> {
    let mean = ifs
        .maps()
        .iter()
        .zip(ifs.probabilities())
        .fold(Affine2::new(DMat2::ZERO, DVec2::ZERO), |sum, (map, &p)| {
            Affine2::new(sum.linear + map.linear * p, sum.translation + map.translation * p)
        });
    mean.fixed_point().filter(|point| point.is_finite())
}

/// What a map makes of the monomials: for each the polynomial that it becomes, which is of no higher degree.
#[derive(Clone)]
pub(crate) struct Substitution {
    degree: usize,
    rows: Vec<f64>,
    /// Where the rows of each degree begin.
    starts: Vec<usize>,
}

impl Substitution {
    pub fn new(map: &Affine2, degree: usize) -> Self {
        let size = |n: usize| (n + 1) * monomials(n);
        let starts: Vec<usize> =
            (0..=degree).scan(0, |end, n| Some(std::mem::replace(end, *end + size(n)))).collect();
        let mut rows = vec![0.0; starts[degree] + size(degree)];
        rows[0] = 1.0;
        let [a, b, c, d, e, f] = map.to_row();
        for n in 1..=degree {
            for j in 0..=n {
                // One factor more than a monomial of one degree less: x, or y where there is no x.
                let (part, [x, y, one]) = if j < n { (j, [a, b, e]) } else { (n - 1, [c, d, f]) };
                let (before, row) = rows.split_at_mut(starts[n] + j * monomials(n));
                let before = &before[starts[n - 1] + part * monomials(n - 1)..][..monomials(n - 1)];
                for m in 0..n {
                    let (here, next) = (slot(m, 0), slot(m + 1, 0));
                    for (l, number) in before[here..next].iter().enumerate() {
                        row[here + l] += one * number;
                        row[next + l] += x * number;
                        row[next + l + 1] += y * number;
                    }
                }
            }
        }
        Self { degree, rows, starts }
    }

    /// What becomes of x^(n - j) y^j.
    fn row(&self, n: usize, j: usize) -> &[f64] {
        &self.rows[self.starts[n] + j * monomials(n)..][..monomials(n)]
    }

    /// The moments of the images of several sets: given and found for each monomial those of all sets, `stride` apart.
    pub fn images(&self, moments: &[f64], sets: usize, images: &mut [f64], stride: usize) {
        for (n, j) in (0..=self.degree).flat_map(|n| (0..=n).map(move |j| (n, j))) {
            let image = &mut images[slot(n - j, j) * stride..][..sets];
            for (number, moments) in self.row(n, j).iter().zip(moments.chunks_exact(sets)) {
                image.iter_mut().zip(moments).for_each(|(sum, moment)| *sum += number * moment);
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The solution of a linear system, each equation with its right side at the end: Gauss, with the largest pivot.
fn solve(mut system: Vec<Vec<f64>>) -> Vec<f64> {
    let count = system.len();
    for column in 0..count {
        let size = |row: &usize| system[*row][column].abs();
        let pivot = (column..count).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(column);
        system.swap(column, pivot);
        let (above, below) = system.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let ratio = row[column] / pivot[column];
            row.iter_mut().zip(pivot).skip(column).for_each(|(number, above)| *number -= ratio * above);
        }
    }
    let mut found = vec![0.0; count];
    for row in (0..count).rev() {
        let known = dot(&system[row][row + 1..count], &found[row + 1..]);
        found[row] = (system[row][count] - known) / system[row][row];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moments(maps: &[Affine2], degree: usize) -> Vec<f64> {
        let share = 1.0 / maps.len() as f64;
        let maps: Vec<_> = maps.iter().map(|map| Substitution::new(map, degree)).collect();
        of_shape(&maps, &vec![share; maps.len()])
    }

    #[test]
    fn the_moments_of_a_square_and_a_gasket_are_those_of_the_books() {
        let at = |corners: &[DVec2], s: f64| -> Vec<Affine2> {
            corners.iter().map(|&c| Affine2::similitude(s, 0.0, c * (1.0 - s))).collect()
        };
        let square = at(&[DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE], 0.5);
        let found = moments(&square, 6);
        for (i, j) in (0..=6).flat_map(|n| (0..=n).map(move |j| (n - j, j))) {
            let wanted = 1.0 / ((i + 1) * (j + 1)) as f64;
            assert!((found[slot(i, j)] - wanted).abs() < 1e-14, "{i} {j}: {}", found[slot(i, j)]);
        }
        // The Cantor set: mean 1/2, variance 1/8.
        let cantor = at(&[DVec2::ZERO, DVec2::X], 1.0 / 3.0);
        let found = moments(&cantor, 2);
        assert!((found[slot(1, 0)] - 0.5).abs() < 1e-15 && (found[slot(2, 0)] - 0.375).abs() < 1e-15);
        // A gasket: E[x] = 1/3, 3 E[x^2] = 3/4 E[x^2] + E[x] / 2 + 1/4 and 3 E[x y] = 3/4 E[x y] + (E[x] + E[y]) / 4.
        let gasket = at(&[DVec2::ZERO, DVec2::X, DVec2::Y], 0.5);
        let found = moments(&gasket, 2);
        assert!(
            (found[slot(2, 0)] - 5.0 / 27.0).abs() < 1e-15 && (found[slot(1, 1)] - 2.0 / 27.0).abs() < 1e-15
        );
    }
}
