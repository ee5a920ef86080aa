//! The chaos game, written once for the plane and for space, as a macro: of a generic type the inner loop took a third
//! longer, since it was no longer compiled to steps of two orbits at a time.

/// How many orbits run side by side, so that no step waits for the one before it.
pub(super) const LANES: usize = 8;
/// Slots of the table that turns random bits into a map.
pub(super) const SLOTS: usize = 4096;
/// Steps of each orbit before the first point is given out: they part the orbits, which all begin at
/// one point of the attractor.
pub(super) const STEPS_APART: usize = 24;

/// Each map as often as it is probable, at least once.
pub(super) fn table(probabilities: &[f64]) -> Box<[u8; SLOTS]> {
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

/// The game on an `$ifs`, whose points have `$coordinates` numbers. The file that asks for it has two types and two
/// functions: `Map` and `Orbit`, a map and a point as a step wants them; `start`, the maps and a point of the
/// attractor; and `step`, from one point to the next.
macro_rules! chaos_game {
    ($(#[$about:meta])* $game:ident, $ifs:ty, $coordinates:literal) => {
        $(#[$about])*
        #[derive(Clone, Debug)]
        pub struct $game {
            table: Box<[u8; SLOTS]>,
            maps: Box<[Map; 64]>,
            state: State,
            /// Points made but not given out yet: a call may ask for a number that is no multiple of 8.
            left: usize,
            pieces: [u8; LANES],
        }

        impl $game {
            /// A game on the maps of `ifs` with its probabilities.
            #[must_use]
            pub fn new(ifs: &$ifs, seed: u32) -> Self {
                let (maps, orbit) = start(ifs);
                let state = State { orbits: [orbit; LANES], key: hash::pcg(seed), step: 0 };
                let table = table(ifs.probabilities());
                let mut game = Self { table, maps, state, left: 0, pieces: [0; LANES] };
                for _ in 0..STEPS_APART {
                    game.advance();
                }
                game
            }

            /// Writes points as `x0, y0, .., x1, y1, ..` and for each the map of its last step: the attractorlet that
            /// it lies in. As many points are written as both slices have room for; their number is returned.
            pub fn fill(&mut self, positions: &mut [f32], pieces: &mut [u8]) -> usize {
                let count = (positions.len() / $coordinates).min(pieces.len());
                let (positions, pieces) = (&mut positions[..$coordinates * count], &mut pieces[..count]);
                let first = self.left.min(count);
                self.give(&mut positions[..$coordinates * first], &mut pieces[..first]);
                let (positions, pieces) = (&mut positions[$coordinates * first..], &mut pieces[first..]);
                let mut points = positions.chunks_exact_mut($coordinates * LANES);
                let mut letters = pieces.chunks_exact_mut(LANES);
                // In locals, so that the compiler keeps them in registers.
                let (table, maps) = (&*self.table, &*self.maps);
                let mut state = self.state;
                for (points, letters) in points.by_ref().zip(letters.by_ref()) {
                    let chosen = state.advance(table, maps);
                    for (point, orbit) in points.as_chunks_mut::<$coordinates>().0.iter_mut().zip(&state.orbits) {
                        *point = std::array::from_fn(|k| orbit[k]);
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
                for (i, (point, letter)) in points.chunks_exact_mut($coordinates).zip(letters.iter_mut()).enumerate() {
                    point.copy_from_slice(&self.state.orbits[from + i][..$coordinates]);
                    *letter = self.pieces[from + i];
                }
                self.left -= letters.len();
            }

            fn advance(&mut self) {
                self.pieces = self.state.advance(&self.table, &self.maps);
            }
        }

        /// What changes from step to step.
        #[derive(Clone, Copy, Debug)]
        struct State {
            orbits: [Orbit; LANES],
            key: u32,
            step: u32,
        }

        impl State {
            /// One step of all orbits: the map chosen for each.
            #[inline(always)]
            fn advance(&mut self, table: &[u8; SLOTS], maps: &[Map; 64]) -> [u8; LANES] {
                let mut letters = [0; LANES];
                for pair in 0..LANES / 2 {
                    let bits = hash::pcg(self.key ^ self.step);
                    self.step = self.step.wrapping_add(1);
                    for (lane, bits) in [(2 * pair, bits), (2 * pair + 1, bits >> 16)] {
                        let letter = table[bits as usize % SLOTS];
                        self.orbits[lane] = step(maps[usize::from(letter) % 64], self.orbits[lane]);
                        letters[lane] = letter;
                    }
                }
                letters
            }
        }
    };
}
pub(super) use chaos_game;
