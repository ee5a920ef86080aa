//! The chaos game in the plane. It stands apart from its twin in space: written once over both dimensions, the inner
//! loop took a third longer, since it was no longer compiled to steps of two orbits at a time.

use glam::DVec2;

use crate::hash;
use crate::ifs::system::Ifs;

/// How many orbits run side by side, so that no step waits for the one before it.
const LANES: usize = 8;
/// Slots of the table that turns random bits into a map.
const SLOTS: usize = 4096;
/// Steps of each orbit before the first point is given out: they part the orbits, which all begin at
/// one point of the attractor.
const STEPS_APART: usize = 24;

/// Points of the attractor, by Barnsley's chaos game: from a fixed point on, apply a map chosen at random
/// again and again.
///
/// Probabilities are kept to 1/4096, and no map gets less. The points are `f32`, as a GPU wants them. The
/// same system and seed give the same points on every machine, however the calls are cut: orbit k of 8
/// gives the points k, k + 8, k + 16 ..
#[derive(Clone, Debug)]
pub struct ChaosGame {
    table: Box<[u8; SLOTS]>,
    rows: Box<[[f32; 6]; 64]>,
    state: State,
    /// Points made but not given out yet: a call may ask for a number that is no multiple of 8.
    left: usize,
    pieces: [u8; LANES],
}

impl ChaosGame {
    /// A game on the maps of `ifs` with its probabilities.
    #[must_use]
    pub fn new(ifs: &Ifs, seed: u32) -> Self {
        let mut rows = Box::new([[0.0; 6]; 64]);
        for (row, map) in rows.iter_mut().zip(ifs.maps()) {
            *row = map.to_row().map(|x| x as f32);
        }
        let start = ifs.maps()[0].fixed_point().unwrap_or(DVec2::ZERO).as_vec2();
        let mut game = Self {
            table: table(ifs.probabilities()),
            rows,
            state: State { orbits: [start.to_array(); LANES], key: hash::pcg(seed), step: 0 },
            left: 0,
            pieces: [0; LANES],
        };
        for _ in 0..STEPS_APART {
            game.advance();
        }
        game
    }

    /// Writes points as `x0, y0, x1, y1, ..` and for each the map of its last step: the attractorlet that
    /// it lies in. As many points are written as both slices have room for; their number is returned.
    pub fn fill(&mut self, positions: &mut [f32], pieces: &mut [u8]) -> usize {
        let count = (positions.len() / 2).min(pieces.len());
        let (positions, pieces) = (&mut positions[..2 * count], &mut pieces[..count]);
        let first = self.left.min(count);
        self.give(&mut positions[..2 * first], &mut pieces[..first]);
        let (positions, pieces) = (&mut positions[2 * first..], &mut pieces[first..]);
        let mut points = positions.chunks_exact_mut(2 * LANES);
        let mut letters = pieces.chunks_exact_mut(LANES);
        // In locals, so that the compiler keeps them in registers.
        let (table, rows) = (&*self.table, &*self.rows);
        let mut state = self.state;
        for (points, letters) in points.by_ref().zip(letters.by_ref()) {
            let chosen = state.advance(table, rows);
            for (point, orbit) in points.as_chunks_mut::<2>().0.iter_mut().zip(&state.orbits) {
                *point = *orbit;
            }
            letters.copy_from_slice(&chosen);
        }
        self.state = state;
        let (points, letters) = (points.into_remainder(), letters.into_remainder());
        if !letters.is_empty() {
            self.advance();
            self.left = LANES;
            self.give(points, letters);
        }
        count
    }

    /// Hands out points of the last step that were left over.
    fn give(&mut self, points: &mut [f32], letters: &mut [u8]) {
        let from = LANES - self.left;
        for (i, (point, letter)) in points.chunks_exact_mut(2).zip(letters.iter_mut()).enumerate() {
            point.copy_from_slice(&self.state.orbits[from + i]);
            *letter = self.pieces[from + i];
        }
        self.left -= letters.len();
    }

    fn advance(&mut self) {
        self.pieces = self.state.advance(&self.table, &self.rows);
    }
}

/// What changes from step to step.
#[derive(Clone, Copy, Debug)]
struct State {
    orbits: [[f32; 2]; LANES],
    key: u32,
    step: u32,
}

impl State {
    /// One step of all orbits: the map chosen for each.
    #[inline(always)]
    fn advance(&mut self, table: &[u8; SLOTS], rows: &[[f32; 6]; 64]) -> [u8; LANES] {
        let mut letters = [0; LANES];
        for pair in 0..LANES / 2 {
            let bits = hash::pcg(self.key ^ self.step);
            self.step = self.step.wrapping_add(1);
            for (lane, bits) in [(2 * pair, bits), (2 * pair + 1, bits >> 16)] {
                let letter = table[bits as usize % SLOTS];
                let [a, b, c, d, e, f] = rows[usize::from(letter) % 64];
                let [x, y] = self.orbits[lane];
                self.orbits[lane] = [a * x + (b * y + e), c * x + (d * y + f)];
                letters[lane] = letter;
            }
        }
        letters
    }
}

/// Each map as often as it is probable, at least once.
pub(crate) fn table(probabilities: &[f64]) -> Box<[u8; SLOTS]> {
    let free = (SLOTS - probabilities.len()) as f64;
    let mut table = Box::new([0; SLOTS]);
    let (mut sum, mut from) = (0.0, 0);
    for (i, p) in probabilities.iter().enumerate() {
        sum += p;
        let to = if i + 1 == probabilities.len() { SLOTS } else { (sum * free) as usize + i + 1 };
        let to = to.clamp(from, SLOTS);
        table[from..to].fill(i as u8);
        from = to;
    }
    table
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::any_ifs;
    use crate::{Affine2, Hull};

    fn run(ifs: &Ifs, seed: u32, calls: &[usize]) -> (Vec<f32>, Vec<u8>) {
        let mut game = ChaosGame::new(ifs, seed);
        let (mut positions, mut pieces) = (Vec::new(), Vec::new());
        for &n in calls {
            let (mut p, mut i) = (vec![0.0; 2 * n], vec![0; n]);
            assert_eq!(game.fill(&mut p, &mut i), n);
            positions.append(&mut p);
            pieces.append(&mut i);
        }
        (positions, pieces)
    }

    proptest! {
        #[test]
        fn points_lie_in_the_hull_and_in_the_piece_they_name(ifs in any_ifs(), seed in any::<u32>()) {
            let hull = Hull::of(&ifs);
            let (positions, pieces) = run(&ifs, seed, &[500]);
            let slack = 1e-4 * (1.0 + hull.radius() + hull.centre().length());
            for (p, i) in positions.chunks_exact(2).zip(pieces) {
                let p = DVec2::new(p[0].into(), p[1].into());
                prop_assert!(p.distance(hull.centre()) <= hull.radius() + slack);
                prop_assert!(usize::from(i) < ifs.len());
                let map = ifs.maps()[usize::from(i)];
                prop_assert!(p.distance(map.apply(hull.centre())) <= map.norm() * hull.radius() + slack);
            }
        }

        #[test]
        fn the_cut_into_calls_does_not_matter(ifs in any_ifs(), calls in proptest::collection::vec(0_usize..20, 1..8)) {
            let total = calls.iter().sum();
            prop_assert_eq!(run(&ifs, 7, &calls), run(&ifs, 7, &[total]));
        }
    }

    #[test]
    fn maps_come_as_often_as_they_are_probable() {
        let maps = vec![Affine2::similitude(0.5, 0.0, DVec2::X); 3];
        let ifs = Ifs::new(maps).unwrap().with_probabilities(&[0.7, 0.3, 0.0]).unwrap();
        let (_, pieces) = run(&ifs, 5, &[100_000]);
        let share = |i| pieces.iter().filter(|&&p| p == i).count() as f64 / 100_000.0;
        assert!((share(0) - 0.7).abs() < 0.01 && (share(1) - 0.3).abs() < 0.01);
        assert!(share(2) > 0.0, "a map of probability 0 still shows");
    }
}
