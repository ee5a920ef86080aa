//! Echoes: where F is made of copies by two maps, it is also made, in part, of copies by one after the inverse of
//! another.

use serde::Serialize;

/// One map of a composition.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Serialize)]
pub struct Letter {
    /// Index of the cluster.
    pub cluster: usize,
    /// Whether it is undone.
    pub inverse: bool,
}

/// The longest compositions.
const LONGEST_COMPOSITION: usize = 5;

/// The most compositions.
const MOST_COMPOSITIONS: usize = 20_000;

/// A cluster is an echo where it is this many bins from a composition, or nearer.
const ECHO_BINS: f64 = 1.5;

/// The compositions of some maps.
#[derive(Debug, Default)]
pub(super) struct Words {
    letters: Vec<(Letter, [f64; 5])>,
    words: Vec<(Vec<Letter>, [f64; 5])>,
}

/// p after q.
fn after([a, b, c, d, e]: [f64; 5], q: [f64; 5]) -> [f64; 5] {
    [a * q[0], b * q[0] + c * q[1], c * q[2], a * q[3] + d, b * q[3] + c * q[4] + e]
}

fn inverse([a, b, c, d, e]: [f64; 5]) -> [f64; 5] {
    [1.0 / a, -b / (a * c), 1.0 / c, -d / a, (b * d / a - e) / c]
}

impl Words {
    /// Takes one map more.
    pub fn add(&mut self, cluster: usize, map: [f64; 5]) {
        if map[0].abs() < 1e-3 || map[2].abs() < 1e-3 {
            return;
        }
        self.letters.push((Letter { cluster, inverse: false }, map));
        self.letters.push((Letter { cluster, inverse: true }, inverse(map)));
        self.words = self.letters.iter().map(|&(letter, map)| (vec![letter], map)).collect();
        let mut from = 0;
        for _ in 1..LONGEST_COMPOSITION {
            let until = self.words.len();
            if (until - from) * self.letters.len() > MOST_COMPOSITIONS {
                break;
            }
            for at in from..until {
                for &(letter, map) in &self.letters {
                    let (word, sum) = &self.words[at];
                    let undone = word
                        .last()
                        .is_some_and(|last| last.cluster == letter.cluster && last.inverse != letter.inverse);
                    if !undone {
                        let word = word.iter().copied().chain([letter]).collect();
                        let sum = after(*sum, map);
                        self.words.push((word, sum));
                    }
                }
            }
            from = until;
        }
    }

    /// The shortest composition that is the map, to bins.
    pub fn find(&self, map: [f64; 5], quanta: [f64; 5]) -> Option<Vec<Letter>> {
        let near = |sum: &[f64; 5]| (0..5).all(|i| (sum[i] - map[i]).abs() <= ECHO_BINS * quanta[i]);
        self.words.iter().find(|(word, sum)| word.len() > 1 && near(sum)).map(|(word, _)| word.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inverse_undoes() {
        let map = [-0.5, 0.746, 0.4, 0.25, 0.1];
        for (x, one) in after(map, inverse(map)).into_iter().zip([1.0, 0.0, 1.0, 0.0, 0.0]) {
            assert!((x - one).abs() < 1e-12);
        }
    }

    #[test]
    fn compositions_are_found_and_others_are_not() {
        let (one, two) = ([0.5, 0.746, 0.5, -0.5, 0.246], [0.5, -0.199, -0.6, 0.5, 0.189]);
        let mut words = Words::default();
        words.add(0, one);
        assert_eq!(words.find(two, [0.01; 5]), None);
        words.add(1, two);
        let echo = after(after(one, inverse(two)), one);
        let word = words.find(echo, [1e-6; 5]).unwrap();
        let letters: Vec<_> = word.iter().map(|letter| (letter.cluster, letter.inverse)).collect();
        assert_eq!(letters, [(0, false), (1, true), (0, false)]);
        assert_eq!(words.find(one, [1e-6; 5]), None, "a map is no echo of itself");
    }
}
