//! Coordinates in which maps are similitudes, where there are such.
//!
//! A subspace with several real cells has no coordinates of its own. Where all maps scale lengths of some inner product
//! alike, this one is taken: it solves Aᵀ Q A = r² Q for all matrices A with their ratios r.

/// The new coordinates by the old ones, and back, row by row; none where the maps are similitudes as they are, or are
/// not in any coordinates.
pub fn similar(matrices: &[&[f64]], size: usize) -> Option<(Vec<f64>, Vec<f64>)> {
    if size < 2 || matrices.iter().all(|matrix| misfit(matrix, size) < 1e-12) {
        return None;
    }
    // The entries of a symmetric matrix.
    let pairs: Vec<(usize, usize)> = (0..size).flat_map(|i| (i..size).map(move |j| (i, j))).collect();
    let count = pairs.len();
    let mut normal = vec![0.0; count * count];
    for matrix in matrices {
        let square = determinant(matrix, size).abs().powf(2.0 / size as f64);
        if square < 1e-12 {
            continue;
        }
        for &(row, column) in &pairs {
            // How the entry at (row, column) of Aᵀ Q A / r² - Q depends on each entry of Q.
            let line: Vec<f64> = pairs
                .iter()
                .map(|&(i, j)| {
                    let at = |k: usize, of: usize| matrix[k * size + of];
                    let mut x = at(i, row) * at(j, column);
                    if i != j {
                        x += at(j, row) * at(i, column);
                    }
                    x / square - f64::from(u8::from((i, j) == (row, column)))
                })
                .collect();
            for (k, x) in line.iter().enumerate() {
                for (j, y) in line.iter().enumerate() {
                    normal[k * count + j] += x * y;
                }
            }
        }
    }
    let (values, vectors) = eigen(normal, count);
    let largest = values.iter().copied().fold(1.0, f64::max);
    // Of all solutions the one next to the usual inner product.
    let mut found = vec![0.0; count];
    for (k, &value) in values.iter().enumerate() {
        if value <= 1e-18 * largest {
            let column = |j: usize| vectors[j * count + k];
            let along: f64 =
                pairs.iter().enumerate().filter(|(_, (i, j))| i == j).map(|(j, _)| column(j)).sum();
            (0..count).for_each(|j| found[j] += along * column(j));
        }
    }
    let mut form = vec![0.0; size * size];
    for (&(i, j), x) in pairs.iter().zip(&found) {
        form[i * size + j] = *x;
        form[j * size + i] = *x;
    }
    let lower = cholesky(&form, size)?;
    // x becomes Lᵀ x, up to a scale that keeps the first coordinate.
    let unit = lower[0];
    let to: Vec<f64> = (0..size * size).map(|k| lower[k % size * size + k / size] / unit).collect();
    let back = upper_inverse(&to, size);
    let acts = |matrix: &[f64]| product(&product(&to, matrix, size), &back, size);
    matrices.iter().all(|matrix| misfit(&acts(matrix), size) < 1e-9).then_some((to, back))
}

/// How far a matrix is from a similitude, relative to itself.
fn misfit(matrix: &[f64], size: usize) -> f64 {
    let column =
        |k: usize, j: usize| (0..size).map(|i| matrix[i * size + k] * matrix[i * size + j]).sum::<f64>();
    let mean = (0..size).map(|k| column(k, k)).sum::<f64>() / size as f64;
    if mean == 0.0 {
        return 0.0;
    }
    let off = |k: usize, j: usize| column(k, j) - if k == j { mean } else { 0.0 };
    (0..size * size).map(|at| off(at / size, at % size).abs()).fold(0.0, f64::max) / mean
}

pub fn product(one: &[f64], other: &[f64], size: usize) -> Vec<f64> {
    let entry = |at: usize| (0..size).map(|k| one[at / size * size + k] * other[k * size + at % size]).sum();
    (0..size * size).map(entry).collect()
}

fn determinant(of: &[f64], size: usize) -> f64 {
    match size {
        2 => of[0] * of[3] - of[1] * of[2],
        _ => {
            of[0] * (of[4] * of[8] - of[5] * of[7]) - of[1] * (of[3] * of[8] - of[5] * of[6])
                + of[2] * (of[3] * of[7] - of[4] * of[6])
        }
    }
}

/// A positive symmetric matrix as L Lᵀ; none where it is not positive.
fn cholesky(of: &[f64], size: usize) -> Option<Vec<f64>> {
    let mut lower = vec![0.0; size * size];
    for row in 0..size {
        for column in 0..=row {
            let known: f64 = (0..column).map(|k| lower[row * size + k] * lower[column * size + k]).sum();
            let rest = of[row * size + column] - known;
            lower[row * size + column] = if row == column {
                if rest < 1e-9 {
                    return None;
                }
                rest.sqrt()
            } else {
                rest / lower[column * size + column]
            };
        }
    }
    Some(lower)
}

fn upper_inverse(of: &[f64], size: usize) -> Vec<f64> {
    let mut inverse = vec![0.0; size * size];
    for column in 0..size {
        for row in (0..=column).rev() {
            let known: f64 =
                (row + 1..=column).map(|k| of[row * size + k] * inverse[k * size + column]).sum();
            let wanted = if row == column { 1.0 } else { 0.0 };
            inverse[row * size + column] = (wanted - known) / of[row * size + row];
        }
    }
    inverse
}

/// Eigenvalues of a symmetric matrix, and its eigenvectors as columns (Jacobi).
fn eigen(mut of: Vec<f64>, size: usize) -> (Vec<f64>, Vec<f64>) {
    let mut vectors: Vec<f64> =
        (0..size * size).map(|k| if k.is_multiple_of(size + 1) { 1.0 } else { 0.0 }).collect();
    for _ in 0..60 {
        for p in 0..size {
            for q in p + 1..size {
                let off = of[p * size + q];
                if off == 0.0 {
                    continue;
                }
                let ratio = (of[q * size + q] - of[p * size + p]) / (2.0 * off);
                let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
                let cosine = 1.0 / tangent.hypot(1.0);
                let sine = tangent * cosine;
                for k in 0..size {
                    let (x, y) = (of[k * size + p], of[k * size + q]);
                    (of[k * size + p], of[k * size + q]) = (cosine * x - sine * y, sine * x + cosine * y);
                }
                for k in 0..size {
                    let (x, y) = (of[p * size + k], of[q * size + k]);
                    (of[p * size + k], of[q * size + k]) = (cosine * x - sine * y, sine * x + cosine * y);
                    let (x, y) = (vectors[k * size + p], vectors[k * size + q]);
                    (vectors[k * size + p], vectors[k * size + q]) =
                        (cosine * x - sine * y, sine * x + cosine * y);
                }
            }
        }
    }
    ((0..size).map(|k| of[k * (size + 1)]).collect(), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_of_a_skewed_lattice_become_turns() {
        // The turn by 60 degrees in a basis of the triangular lattice, and a shrunken turn by 120.
        let turn = [0.0, -1.0, 1.0, 1.0];
        let half: Vec<f64> = product(&turn, &turn, 2).iter().map(|x| x / 2.0).collect();
        let (to, back) = similar(&[&turn, &half], 2).unwrap();
        let acts = product(&product(&to, &turn, 2), &back, 2);
        let root = 3.0_f64.sqrt() / 2.0;
        for (x, wanted) in acts.iter().zip([0.5, -root, root, 0.5]) {
            assert!((x - wanted).abs() < 1e-12, "{acts:?}");
        }
        assert!(similar(&[&[0.5, 0.0, 0.0, 0.25]], 2).is_none());
        assert!(similar(&[&[0.5, 0.0, 0.0, 0.5]], 2).is_none());
    }
}
