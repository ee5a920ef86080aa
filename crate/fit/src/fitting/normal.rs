//! Least squares with few numbers in each row.

/// The most rounds of conjugate gradients.
const MOST_ROUNDS: usize = 120;

/// How small, in parts of the first, the rest is made. A step of Levenberg and Marquardt needs no more digits.
const ENOUGH: f64 = 1e-4;

/// Rows a x = b that are to hold as well as they can. Each belongs to a group, whose rows have much the same unknowns.
pub(crate) struct Rows {
    size: usize,
    groups: Vec<Vec<usize>>,
    starts: Vec<usize>,
    places: Vec<u32>,
    values: Vec<f64>,
    right: Vec<f64>,
}

impl Rows {
    /// None yet, for so many unknowns and groups.
    pub fn new(size: usize, groups: usize) -> Self {
        let groups = vec![Vec::new(); groups];
        Self { size, groups, starts: vec![0], places: Vec::new(), values: Vec::new(), right: Vec::new() }
    }

    pub fn add(&mut self, group: usize, row: &[(usize, f64)], right: f64) {
        self.groups[group].push(self.right.len());
        self.places.extend(row.iter().map(|entry| entry.0 as u32));
        self.values.extend(row.iter().map(|entry| entry.1));
        self.starts.push(self.places.len());
        self.right.push(right);
    }

    /// How many numbers there are.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// The normal equations, one small matrix a group.
    #[inline(never)]
    pub fn normal(&self) -> Normal {
        let mut weights = vec![0.0; self.size];
        let mut right = vec![0.0; self.size];
        let mut local = vec![u32::MAX; self.size];
        let mut here: Vec<usize> = Vec::new();
        let mut groups = Vec::with_capacity(self.groups.len());
        for rows in &self.groups {
            let range = |row: usize| self.starts[row]..self.starts[row + 1];
            let mut places: Vec<u32> = Vec::new();
            for &place in rows.iter().flat_map(|&row| &self.places[range(row)]) {
                if local[place as usize] == u32::MAX {
                    local[place as usize] = places.len() as u32;
                    places.push(place);
                }
            }
            let many = places.len();
            let mut matrix = vec![0.0; many * many];
            for &row in rows {
                let (at, values) = (&self.places[range(row)], &self.values[range(row)]);
                here.clear();
                here.extend(at.iter().map(|&place| local[place as usize] as usize));
                for (k, (&place, &x)) in at.iter().zip(values).enumerate() {
                    right[place as usize] += x * self.right[row];
                    let line = &mut matrix[here[k] * many..][..many];
                    for (&j, &y) in here[..=k].iter().zip(values) {
                        line[j] += x * y;
                    }
                }
            }
            // Each pair was added on one side of the diagonal.
            for i in 0..many {
                for j in 0..i {
                    let both = matrix[i * many + j] + matrix[j * many + i];
                    (matrix[i * many + j], matrix[j * many + i]) = (both, both);
                }
            }
            for (i, &place) in places.iter().enumerate() {
                weights[place as usize] += matrix[i * many + i];
                local[place as usize] = u32::MAX;
            }
            groups.push(Group { places, matrix });
        }
        Normal { weights, right, groups }
    }
}

/// What the rows of a group come to.
struct Group {
    places: Vec<u32>,
    matrix: Vec<f64>,
}

/// Normal equations as a sum over groups.
pub(crate) struct Normal {
    /// Their diagonal.
    weights: Vec<f64>,
    right: Vec<f64>,
    groups: Vec<Group>,
}

impl Normal {
    /// The matrix times x.
    fn times(&self, x: &[f64], image: &mut [f64]) {
        let mut here: Vec<f64> = Vec::new();
        image.fill(0.0);
        for Group { places, matrix } in &self.groups {
            here.clear();
            here.extend(places.iter().map(|&place| x[place as usize]));
            for (line, &place) in matrix.chunks_exact(places.len().max(1)).zip(places) {
                image[place as usize] += dot(line, &here);
            }
        }
    }

    /// The least squares, where each unknown pays for its size: a share `damping` of what it weighs in the rows, and of
    /// the mean of that. By conjugate gradients (Björck, "Numerical methods for least squares problems", 1996, section
    /// 7.4). None where something is not finite. How many products are summed is added to `work`.
    #[inline(never)]
    pub fn solve(&self, damping: f64, work: &mut u64) -> Option<Vec<f64>> {
        let n = self.weights.len();
        let mean = self.weights.iter().sum::<f64>() / n.max(1) as f64;
        let ridge: Vec<f64> = self
            .weights
            .iter()
            .map(|w| damping * w + (1e-9 + 1e-3 * damping) * mean + f64::MIN_POSITIVE)
            .collect();
        let scale: Vec<f64> = self.weights.iter().zip(&ridge).map(|(w, r)| 1.0 / (w + r)).collect();
        let mut rest = self.right.clone();
        let mut x = vec![0.0; n];
        let mut along: Vec<f64> = rest.iter().zip(&scale).map(|(r, s)| r * s).collect();
        let mut norm: f64 = rest.iter().zip(&along).map(|(r, z)| r * z).sum();
        let aim = norm * ENOUGH * ENOUGH;
        let mut image = vec![0.0; n];
        let products: u64 = self.groups.iter().map(|group| group.matrix.len() as u64).sum();
        for _ in 0..MOST_ROUNDS.min(2 * n) {
            if norm.is_nan() || norm <= aim {
                break;
            }
            self.times(&along, &mut image);
            *work += products;
            let mut steep = 0.0;
            for i in 0..n {
                image[i] += ridge[i] * along[i];
                steep += image[i] * along[i];
            }
            let step = norm / steep;
            if !step.is_finite() {
                break;
            }
            let mut next = 0.0;
            for i in 0..n {
                x[i] += step * along[i];
                rest[i] -= step * image[i];
                next += rest[i] * rest[i] * scale[i];
            }
            let turn = next / norm;
            norm = next;
            for i in 0..n {
                along[i] = rest[i] * scale[i] + turn * along[i];
            }
        }
        x.iter().all(|value| value.is_finite()).then_some(x)
    }
}

/// Four sums side by side, which processors add up at once.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (fours_a, fours_b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = fours_a.remainder().iter().zip(fours_b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in fours_a.zip(fours_b) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_points_is_found() {
        let mut rows = Rows::new(2, 3);
        for i in 0..20 {
            let x = f64::from(i) - 4.0;
            rows.add(
                i as usize % 3,
                &[(0, x), (1, 1.0)],
                3.0 * x - 2.0 + if i % 2 == 0 { 0.1 } else { -0.1 },
            );
        }
        let found = rows.normal().solve(0.0, &mut 0).unwrap();
        assert!((found[0] - 3.0).abs() < 0.02 && (found[1] + 2.0).abs() < 0.05, "{found:?}");
        // Damped, it goes less far.
        assert!(rows.normal().solve(10.0, &mut 0).unwrap()[0] < 0.5);
        assert_eq!(rows.entries(), 40);
    }

    #[test]
    fn groups_come_to_what_all_rows_do() {
        let row = |i: u32| [(i % 3, f64::from(i % 5) - 1.5), (3, 1.0 + f64::from(i)), (4 - i % 2, 0.5)];
        let [mut one, mut many] = [Rows::new(5, 1), Rows::new(5, 3)];
        for i in 0..12 {
            let mut entries: Vec<(usize, f64)> = Vec::new();
            for (place, value) in row(i) {
                if entries.iter().all(|entry| entry.0 != place as usize) {
                    entries.push((place as usize, value));
                }
            }
            one.add(0, &entries, f64::from(i % 7));
            many.add(i as usize % 3, &entries, f64::from(i % 7));
        }
        let x = [0.3, -1.0, 2.0, 0.7, -0.2];
        let (mut by_one, mut by_many) = ([0.0; 5], [9.0; 5]);
        one.normal().times(&x, &mut by_one);
        many.normal().times(&x, &mut by_many);
        // By hand: each row's share, back along the row.
        let mut by_rows = [0.0; 5];
        for row in 0..12 {
            let range = one.starts[row]..one.starts[row + 1];
            let entries = || one.places[range.clone()].iter().zip(&one.values[range.clone()]);
            let y: f64 = entries().map(|(&place, value)| value * x[place as usize]).sum();
            entries().for_each(|(&place, value)| by_rows[place as usize] += value * y);
        }
        for ((a, b), c) in by_one.iter().zip(by_many).zip(by_rows) {
            assert!((a - c).abs() < 1e-9 && (b - c).abs() < 1e-9, "{a} {b} {c}");
        }
        assert!(
            (dot(&x, &x) - x.iter().map(|x| x * x).sum::<f64>()).abs() < 1e-12,
            "five numbers, one behind four"
        );
    }

    #[test]
    fn nothing_known_is_no_step() {
        assert_eq!(Rows::new(3, 0).normal().solve(1.0, &mut 0), Some(vec![0.0; 3]));
        let mut rows = Rows::new(1, 1);
        rows.add(0, &[(0, f64::NAN)], 1.0);
        assert_eq!(rows.normal().solve(1.0, &mut 0).filter(|x| x[0] != 0.0), None);
    }
}
