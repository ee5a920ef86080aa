//! The chaos game of a graph-directed system.

use glam::DVec2;

use crate::directed::reach;
use crate::directed::system::DirectedIfs;
use crate::hash;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::sample::chaos_game2::ChaosGame;

/// Points of a state of a graph-directed system, by a chaos game in which every state has a point of its own: state
/// after state takes the point of a state that it copies, by a map that is chosen at random.
///
/// For a system of one state it is the [`ChaosGame`], bit by bit. The same system and seed give the same points
/// on every machine, however the calls are cut.
#[derive(Clone, Debug)]
pub struct DirectedGame {
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    One(Box<ChaosGame>),
    Several(Several),
}

#[derive(Clone, Debug)]
struct Several {
    /// The states that the shape is made of, itself last.
    turns: Vec<Turn>,
    points: Vec<DVec2>,
    key: u32,
    step: u32,
}

/// A state whose turn it is.
#[derive(Clone, Debug)]
struct Turn {
    state: usize,
    /// The sums of the probabilities of its maps, what each copies, and how.
    maps: Vec<(f64, usize, Affine2)>,
}

/// Rounds of all states before the first point is given out: they part points that begin together.
const ROUNDS_BEFORE: usize = 64;

impl DirectedGame {
    /// A game for the points of a state; `None` where there is no such state.
    #[must_use]
    pub fn new(system: &DirectedIfs, state: usize, seed: u32) -> Option<Self> {
        if state >= system.len() {
            return None;
        }
        if let [maps] = system.states() {
            let ifs = Ifs::new(maps.iter().map(|part| part.map).collect()).ok()?;
            let ifs = ifs.with_probabilities(&system.probabilities()[0]).ok()?;
            return Some(Self { kind: Kind::One(Box::new(ChaosGame::new(&ifs, seed))) });
        }
        let seen = reach::reached(system.states(), state);
        let others = (0..system.len()).filter(|&other| seen[other] && other != state);
        let turn = |state: usize| {
            let mut sum = 0.0;
            let probabilities = &system.probabilities()[state];
            let maps = system.states()[state].iter().zip(probabilities).map(|(part, p)| {
                sum += p;
                (sum, part.from, part.map)
            });
            Turn { state, maps: maps.collect() }
        };
        let turns = others.chain([state]).map(turn).collect();
        let mut game = Several { turns, points: system.points(), key: hash::pcg(seed), step: 0 };
        for _ in 0..ROUNDS_BEFORE {
            game.round();
        }
        Some(Self { kind: Kind::Several(game) })
    }

    /// Writes points as `x0, y0, x1, y1, ..` and for each the map of its last step. As many are written as both slices
    /// have room for; their number is returned.
    pub fn fill(&mut self, positions: &mut [f32], pieces: &mut [u8]) -> usize {
        let game = match &mut self.kind {
            Kind::One(game) => return game.fill(positions, pieces),
            Kind::Several(game) => game,
        };
        let points = positions.as_chunks_mut::<2>().0;
        let count = points.len().min(pieces.len());
        for (point, piece) in points.iter_mut().zip(pieces) {
            let (at, map) = game.round();
            *point = at.as_vec2().to_array();
            *piece = map as u8;
        }
        count
    }
}

impl Several {
    /// One turn of every state: the new point of the last, and the map that led to it.
    fn round(&mut self) -> (DVec2, usize) {
        let mut last = (DVec2::ZERO, 0);
        for Turn { state, maps } in &self.turns {
            let chance = f64::from(hash::unit(hash::pcg(self.key ^ self.step)));
            self.step = self.step.wrapping_add(1);
            let chosen = maps.iter().position(|(sum, ..)| chance < *sum).unwrap_or(maps.len() - 1);
            let (_, from, map) = maps[chosen];
            self.points[*state] = map.apply(self.points[from]);
            last = (self.points[*state], chosen);
        }
        last
    }
}
