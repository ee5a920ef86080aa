//! Least squares with few numbers in each row.

/// The most rounds of conjugate gradients.
const MOST_ROUNDS: usize = 120;

/// How small, in parts of the first, the rest is made. A step of Levenberg and Marquardt needs no more digits.
const ENOUGH: f64 = 1e-4;

/// Rows a x = b that are to hold as well as they can.
pub(crate) struct Rows {
    size: usize,
    starts: Vec<usize>,
    places: Vec<u32>,
    values: Vec<f64>,
    right: Vec<f64>,
}

impl Rows {
    /// None yet, for so many unknowns.
    pub fn new(size: usize) -> Self {
        Self { size, starts: vec![0], places: Vec::new(), values: Vec::new(), right: Vec::new() }
    }

    pub fn add(&mut self, row: &[(usize, f64)], right: f64) {
        self.places.extend(row.iter().map(|entry| entry.0 as u32));
        self.values.extend(row.iter().map(|entry| entry.1));
        self.starts.push(self.places.len());
        self.right.push(right);
    }

    /// How many numbers there are.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        let range = self.starts[i]..self.starts[i + 1];
        self.places[range.clone()].iter().map(|&p| p as usize).zip(self.values[range].iter().copied())
    }

    /// Adds the transpose times y.
    fn back(&self, y: &[f64], x: &mut [f64]) {
        for (i, &y) in y.iter().enumerate() {
            for (place, value) in self.row(i) {
                x[place] += value * y;
            }
        }
    }

    /// The least squares, where each unknown pays for its size: a share `damping` of what it weighs in the rows, and of
    /// the mean of that. By conjugate gradients on the normal equations, which are never written down (Björck,
    /// "Numerical methods for least squares problems", 1996, section 7.4).
    pub fn solve(&self, damping: f64) -> Option<Vec<f64>> {
        let n = self.size;
        let mut weights = vec![0.0; n];
        for (place, value) in self.places.iter().zip(&self.values) {
            weights[*place as usize] += value * value;
        }
        let mean = weights.iter().sum::<f64>() / n.max(1) as f64;
        let ridge: Vec<f64> = weights
            .iter()
            .map(|w| damping * w + (1e-9 + 1e-3 * damping) * mean + f64::MIN_POSITIVE)
            .collect();
        let scale: Vec<f64> = weights.iter().zip(&ridge).map(|(w, r)| 1.0 / (w + r)).collect();
        let mut rest = vec![0.0; n];
        self.back(&self.right, &mut rest);
        let mut x = vec![0.0; n];
        let mut along: Vec<f64> = rest.iter().zip(&scale).map(|(r, s)| r * s).collect();
        let mut norm: f64 = rest.iter().zip(&along).map(|(r, z)| r * z).sum();
        let aim = norm * ENOUGH * ENOUGH;
        let mut image = vec![0.0; n];
        for _ in 0..MOST_ROUNDS.min(2 * n) {
            if norm.is_nan() || norm <= aim {
                break;
            }
            image.fill(0.0);
            let mut steep = 0.0;
            for i in 0..self.right.len() {
                let y: f64 = self.row(i).map(|(place, value)| value * along[place]).sum();
                steep += y * y;
                for (place, value) in self.row(i) {
                    image[place] += value * y;
                }
            }
            for i in 0..n {
                image[i] += ridge[i] * along[i];
                steep += ridge[i] * along[i] * along[i];
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_points_is_found() {
        let mut rows = Rows::new(2);
        for i in 0..20 {
            let x = f64::from(i) - 4.0;
            rows.add(&[(0, x), (1, 1.0)], 3.0 * x - 2.0 + if i % 2 == 0 { 0.1 } else { -0.1 });
        }
        let found = rows.solve(0.0).unwrap();
        assert!((found[0] - 3.0).abs() < 0.02 && (found[1] + 2.0).abs() < 0.05, "{found:?}");
        // Damped, it goes less far.
        assert!(rows.solve(10.0).unwrap()[0] < 0.5);
        assert_eq!(rows.entries(), 40);
    }

    #[test]
    fn nothing_known_is_no_step() {
        assert_eq!(Rows::new(3).solve(1.0), Some(vec![0.0; 3]));
        let mut rows = Rows::new(1);
        rows.add(&[(0, f64::NAN)], 1.0);
        assert_eq!(rows.solve(1.0).filter(|x| x[0] != 0.0), None);
    }
}
