//! How far every cell of a lattice is from the nearest marked one.

/// The Euclidean distance of each cell to the nearest that `marked` names, where the cells along axis k lie `pitch[k]`
/// apart; infinite where none is. The exact transform by lower envelopes of parabolas, one axis after the other, in
/// time proportional to the number of cells (Felzenszwalb and Huttenlocher 2012).
pub(crate) fn distances(size: [usize; 3], pitch: [f64; 3], marked: impl Fn(usize) -> bool) -> Vec<f64> {
    let count = size[0] * size[1] * size[2];
    let mut squared: Vec<f64> =
        (0..count).map(|cell| if marked(cell) { 0.0 } else { f64::INFINITY }).collect();
    let strides = [1, size[0], size[0] * size[1]];
    let mut line = Vec::new();
    let mut envelope = Envelope::default();
    for axis in 0..3 {
        let (length, stride) = (size[axis], strides[axis]);
        if length < 2 {
            continue;
        }
        for first in (0..count).filter(|cell| cell / stride % length == 0) {
            line.clear();
            line.extend((0..length).map(|i| squared[first + i * stride]));
            envelope.set(&line, pitch[axis]);
            for i in 0..length {
                squared[first + i * stride] = envelope.least(i, &line, pitch[axis]);
            }
        }
    }
    squared.into_iter().map(f64::sqrt).collect()
}

/// The parabolas `line[i] + (x - i pitch)^2` that are lowest somewhere, and from where on.
#[derive(Default)]
struct Envelope {
    lowest: Vec<(usize, f64)>,
    at: usize,
}

impl Envelope {
    fn set(&mut self, line: &[f64], pitch: f64) {
        self.lowest.clear();
        self.at = 0;
        let square = |i: usize| (i as f64 * pitch).powi(2);
        for i in (0..line.len()).filter(|&i| line[i].is_finite()) {
            let mut from = f64::NEG_INFINITY;
            while let Some(&(last, start)) = self.lowest.last() {
                // Where the two are equal.
                from = (line[i] + square(i) - line[last] - square(last))
                    / (2.0 * pitch * pitch * (i - last) as f64);
                if from > start {
                    break;
                }
                self.lowest.pop();
                from = f64::NEG_INFINITY;
            }
            self.lowest.push((i, from));
        }
    }

    /// The lowest value at `x`, which grows from call to call.
    fn least(&mut self, x: usize, line: &[f64], pitch: f64) -> f64 {
        while self.at + 1 < self.lowest.len() && self.lowest[self.at + 1].1 <= x as f64 {
            self.at += 1;
        }
        self.lowest
            .get(self.at)
            .map_or(f64::INFINITY, |&(i, _)| line[i] + ((x as f64 - i as f64) * pitch).powi(2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_those_that_a_search_finds() {
        for (size, pitch, every) in [
            ([9, 7, 5], [1.0, 1.0, 1.0], 37),
            ([11, 6, 1], [1.0, 2.5, 1.0], 13),
            ([1, 1, 8], [1.0, 1.0, 0.5], 5),
            ([4, 4, 4], [1.0; 3], 1),
            ([5, 5, 2], [1.0; 3], 1000),
        ] {
            let marked = |cell: usize| cell % every == every / 2;
            let place = |cell: usize| {
                let at = [cell % size[0], cell / size[0] % size[1], cell / size[0] / size[1]];
                [0, 1, 2].map(|k| at[k] as f64 * pitch[k])
            };
            let found = distances(size, pitch, marked);
            for (cell, &distance) in found.iter().enumerate() {
                let apart = |other| {
                    let (p, q) = (place(cell), place(other));
                    (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
                };
                let wanted = (0..found.len()).filter(|&c| marked(c)).map(apart).fold(f64::INFINITY, f64::min);
                assert!(distance == wanted || (distance - wanted).abs() < 1e-9, "{distance} {wanted}");
            }
        }
    }
}
