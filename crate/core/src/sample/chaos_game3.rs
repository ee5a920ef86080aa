//! The chaos game in space.

use glam::DVec3;

use crate::hash;
use crate::ifs::system::Ifs3;
use crate::sample::chaos_game2::table;

/// How many orbits run side by side, so that no step waits for the one before it.
const LANES: usize = 8;
/// Slots of the table that turns random bits into a map.
const SLOTS: usize = 4096;
/// Steps of each orbit before the first point is given out.
const STEPS_APART: usize = 24;

/// Points of an attractor of space, by Barnsley's chaos game: the twin of [`ChaosGame`](crate::ChaosGame).
///
/// Probabilities are kept to 1/4096, and no map gets less. The same system and seed give the same points on every
/// machine, however the calls are cut.
#[derive(Clone, Debug)]
pub struct ChaosGame3 {
    table: Box<[u8; SLOTS]>,
    /// Columns of the maps, then the translation, each filled up to four numbers, so that one step is a few operations
    /// on four lanes.
    columns: Box<[[[f32; 4]; 4]; 64]>,
    state: State,
    /// Points made but not given out yet: a call may ask for a number that is no multiple of 8.
    left: usize,
    pieces: [u8; LANES],
}

impl ChaosGame3 {
    /// A game on the maps of `ifs` with its probabilities.
    #[must_use]
    pub fn new(ifs: &Ifs3, seed: u32) -> Self {
        let mut columns = Box::new([[[0.0; 4]; 4]; 64]);
        for (columns, map) in columns.iter_mut().zip(ifs.maps()) {
            let m = map.linear;
            *columns = [m.x_axis, m.y_axis, m.z_axis, map.translation]
                .map(|v| [v.x as f32, v.y as f32, v.z as f32, 0.0]);
        }
        let start = ifs.maps()[0].fixed_point().unwrap_or(DVec3::ZERO).as_vec3();
        let orbit = [start.x, start.y, start.z, 0.0];
        let mut game = Self {
            table: table(ifs.probabilities()),
            columns,
            state: State { orbits: [orbit; LANES], key: hash::pcg(seed), step: 0 },
            left: 0,
            pieces: [0; LANES],
        };
        for _ in 0..STEPS_APART {
            game.advance();
        }
        game
    }

    /// Writes points as `x0, y0, z0, x1, ..` and for each the map of its last step: the attractorlet that it lies in.
    /// As many points are written as both slices have room for; their number is returned.
    pub fn fill(&mut self, positions: &mut [f32], pieces: &mut [u8]) -> usize {
        let count = (positions.len() / 3).min(pieces.len());
        let (positions, pieces) = (&mut positions[..3 * count], &mut pieces[..count]);
        let first = self.left.min(count);
        self.give(&mut positions[..3 * first], &mut pieces[..first]);
        let (positions, pieces) = (&mut positions[3 * first..], &mut pieces[first..]);
        let mut points = positions.chunks_exact_mut(3 * LANES);
        let mut letters = pieces.chunks_exact_mut(LANES);
        // In locals, so that the compiler keeps them in registers.
        let (table, columns) = (&*self.table, &*self.columns);
        let mut state = self.state;
        for (points, letters) in points.by_ref().zip(letters.by_ref()) {
            let chosen = state.advance(table, columns);
            for (point, orbit) in points.as_chunks_mut::<3>().0.iter_mut().zip(&state.orbits) {
                *point = [orbit[0], orbit[1], orbit[2]];
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
        for (i, (point, letter)) in points.chunks_exact_mut(3).zip(letters.iter_mut()).enumerate() {
            point.copy_from_slice(&self.state.orbits[from + i][..3]);
            *letter = self.pieces[from + i];
        }
        self.left -= letters.len();
    }

    fn advance(&mut self) {
        self.pieces = self.state.advance(&self.table, &self.columns);
    }
}

/// What changes from step to step.
#[derive(Clone, Copy, Debug)]
struct State {
    orbits: [[f32; 4]; LANES],
    key: u32,
    step: u32,
}

impl State {
    /// One step of all orbits: the map chosen for each.
    #[inline(always)]
    fn advance(&mut self, table: &[u8; SLOTS], columns: &[[[f32; 4]; 4]; 64]) -> [u8; LANES] {
        let mut letters = [0; LANES];
        for pair in 0..LANES / 2 {
            let bits = hash::pcg(self.key ^ self.step);
            self.step = self.step.wrapping_add(1);
            for (lane, bits) in [(2 * pair, bits), (2 * pair + 1, bits >> 16)] {
                let letter = table[bits as usize % SLOTS];
                let [a, b, c, t] = columns[usize::from(letter) % 64];
                let [x, y, z, _] = self.orbits[lane];
                self.orbits[lane] = std::array::from_fn(|k| (a[k] * x + b[k] * y) + (c[k] * z + t[k]));
                letters[lane] = letter;
            }
        }
        letters
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing3::any_ifs3;
    use crate::{Affine3, Bounds3};

    fn run(ifs: &Ifs3, seed: u32, calls: &[usize]) -> (Vec<f32>, Vec<u8>) {
        let mut game = ChaosGame3::new(ifs, seed);
        let (mut positions, mut pieces) = (Vec::new(), Vec::new());
        for &n in calls {
            let (mut p, mut i) = (vec![0.0; 3 * n], vec![0; n]);
            assert_eq!(game.fill(&mut p, &mut i), n);
            positions.append(&mut p);
            pieces.append(&mut i);
        }
        (positions, pieces)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(64)))]
        #[test]
        fn points_lie_in_the_ball_and_in_the_piece_they_name(ifs in any_ifs3(), seed in any::<u32>()) {
            let bounds = Bounds3::of(&ifs);
            let (positions, pieces) = run(&ifs, seed, &[500]);
            let slack = 1e-4 * (1.0 + bounds.radius + bounds.centre.length());
            for (p, i) in positions.chunks_exact(3).zip(pieces) {
                let p = DVec3::new(p[0].into(), p[1].into(), p[2].into());
                prop_assert!(p.distance(bounds.centre) <= bounds.radius + slack);
                prop_assert!(usize::from(i) < ifs.len());
                let map = ifs.maps()[usize::from(i)];
                prop_assert!(p.distance(map.apply(bounds.centre)) <= map.norm() * bounds.radius + slack);
            }
        }

        #[test]
        fn the_cut_into_calls_does_not_matter(ifs in any_ifs3(), calls in proptest::collection::vec(0_usize..20, 1..8)) {
            let total = calls.iter().sum();
            prop_assert_eq!(run(&ifs, 7, &calls), run(&ifs, 7, &[total]));
        }
    }

    #[test]
    fn maps_come_as_often_as_they_are_probable() {
        let maps = vec![Affine3::scaling(DVec3::splat(0.5)); 3];
        let ifs = Ifs3::new(maps).unwrap().with_probabilities(&[0.7, 0.3, 0.0]).unwrap();
        let (_, pieces) = run(&ifs, 5, &[100_000]);
        let share = |i| pieces.iter().filter(|&&p| p == i).count() as f64 / 100_000.0;
        assert!((share(0) - 0.7).abs() < 0.01 && (share(1) - 0.3).abs() < 0.01);
        assert!(share(2) > 0.0, "a map of probability 0 still shows");
    }
}
