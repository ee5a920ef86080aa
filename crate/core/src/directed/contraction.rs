//! Whether the ways round through a graph contract together, and coordinates in which they are seen to.

use std::collections::VecDeque;

use glam::{DMat2, DVec2};

use crate::dimension::{Dim2, Dimension};
use crate::directed::error::DirectedError;
use crate::directed::levels::{self, Weight};
use crate::directed::map::DirectedMap;
use crate::ifs::contraction::Contraction;
use crate::ifs::ellipse;
use crate::linear::affine::Affine2;
use crate::linear::svd2::{full_determinant, singular_values};

/// A proof, up to rounding, that a graph-directed system has an attractor: coordinates of its own for each state, and
/// a finite set of blocks (ways through the graph) that shrink distances between them by `factor` or less, and of
/// which every endless way is composed.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectedContraction {
    /// The coordinates of each state.
    pub discs: Vec<StateDisc>,
    /// The largest norm of a block between round coordinates, below 1.
    pub factor: f64,
    /// The number of maps of the longest block: 1 where the blocks are the maps themselves.
    pub length: usize,
}

/// Coordinates in which a state lies in a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateDisc {
    /// Takes an ellipse to the unit disc; of states that copy each other these are of sizes that fit.
    pub to_round: DMat2,
    /// Its inverse.
    pub from_round: DMat2,
    /// The centre, in coordinates of the shape, of a disc in round coordinates that holds it.
    pub centre: DVec2,
    /// The radius of that disc, in round coordinates.
    pub radius: f64,
}

/// A way through the graph: where it leads from and into, and its map.
#[derive(Clone, Copy, Debug)]
struct Block {
    into: usize,
    from: usize,
    map: Affine2,
}

/// Round coordinates of each state, and back.
type Round = Vec<[DMat2; 2]>;

/// A way round of this spectral radius or more is said not to contract.
const NEUTRAL_RADIUS: f64 = 1.0 - 1e-10;
/// Maps that shrink at least so much in some coordinates are their own blocks.
const SHRINKING_LOG: f64 = -1e-9;
/// Scales are not chosen for maps to shrink faster than this.
const FASTEST_LOG: f64 = -2.0;
/// Where maps shrink as much as this, the plane's own coordinates are good enough.
const PLAIN_NORM: f64 = 0.95;
/// How many ways may be looked at before giving up, and how long they may be.
const MOST_WAYS: usize = 40_000;
const MOST_STEPS: usize = 48;
/// Rounds of weighing the maps, in the search for ellipses.
const WEIGHINGS: i32 = 60;
/// Rounds in which discs are made smaller.
const DISC_ROUNDS: usize = 300;

impl DirectedContraction {
    /// The coordinates of a system of one state.
    pub(crate) fn of_one(found: &Contraction) -> Self {
        let &Contraction { to_round, from_round, factor, length, centre, radius } = found;
        Self { discs: vec![StateDisc { to_round, from_round, centre, radius }], factor, length }
    }

    /// Finds coordinates and blocks in which the maps of a checked system contract.
    pub(crate) fn find(states: &[Vec<DirectedMap>]) -> Result<Self, DirectedError> {
        let blocks = blocks_of(states);
        let plain: Round = vec![[DMat2::IDENTITY; 2]; states.len()];
        let factor = worst_norm(&blocks, &plain);
        if factor < PLAIN_NORM {
            return Self::with_blocks(states, &blocks, &plain, factor, 1);
        }
        // The same coordinates everywhere, but for scales.
        let (round, most) = scaled(&blocks, &plain);
        if most < SHRINKING_LOG {
            let factor = worst_norm(&blocks, &round);
            return Self::with_blocks(states, &blocks, &round, factor, 1);
        }
        refuse_steepest(states, &blocks, &plain)?;
        let (round, most) = best_ellipses(&blocks, round, most);
        let factor = worst_norm(&blocks, &round);
        if most < SHRINKING_LOG && factor < 1.0 {
            return Self::with_blocks(states, &blocks, &round, factor, 1);
        }
        refuse_steepest(states, &blocks, &round)?;
        Self::search(states, &round)
    }

    /// What can be told without a search: refuses a way round that is seen not to contract.
    pub(crate) fn refuse_obvious(states: &[Vec<DirectedMap>]) -> Result<(), DirectedError> {
        let plain: Round = vec![[DMat2::IDENTITY; 2]; states.len()];
        refuse_steepest(states, &blocks_of(states), &plain)
    }

    /// Gripenberg's search: a way is prolonged until its norm is below 1.
    fn search(states: &[Vec<DirectedMap>], round: &Round) -> Result<Self, DirectedError> {
        let start = |into: usize| (Block { into, from: into, map: Affine2::IDENTITY }, 1.0, 0.0, Vec::new());
        let mut open: VecDeque<_> = (0..states.len()).map(start).collect();
        let mut blocks = Vec::new();
        let (mut factor, mut length, mut seen) = (0.0_f64, 1, 0);
        // Breadth first, so that short ways round that do not contract are met before long ones.
        while let Some((prefix, area, off, steps)) = open.pop_front() {
            for (k, part) in states[prefix.from].iter().enumerate() {
                seen += 1;
                if seen > MOST_WAYS || steps.len() >= MOST_STEPS {
                    return Err(DirectedError::Unproved);
                }
                let block = Block { into: prefix.into, from: part.from, map: prefix.map * part.map };
                let mut way: Vec<(usize, usize)> = steps.clone();
                way.push((prefix.from, k));
                let norm = norm_between(&block, round);
                if norm < 0.99 {
                    factor = factor.max(norm);
                    length = length.max(way.len());
                    blocks.push(block);
                    continue;
                }
                let area = area * full_determinant(part.map.linear);
                let off = (off + 8.0 * f64::EPSILON * prefix.map.norm()) * part.map.norm();
                if block.into == block.from {
                    let radius = Dim2::certain_radius(block.map.linear, area, off);
                    if radius >= NEUTRAL_RADIUS {
                        return Err(no_attractor(way, radius));
                    }
                }
                open.push_back((block, area, off, way));
            }
        }
        Self::with_blocks(states, &blocks, round, factor, length)
    }

    fn with_blocks(
        states: &[Vec<DirectedMap>],
        blocks: &[Block],
        round: &Round,
        factor: f64,
        length: usize,
    ) -> Result<Self, DirectedError> {
        let centres = centres(states);
        let reach: Vec<(Block, f64, f64)> = blocks
            .iter()
            .map(|block| {
                let [to, _] = round[block.into];
                let shift = (to * (block.map.apply(centres[block.from]) - centres[block.into])).length();
                // Rounded up, but not above what is known of all blocks.
                (*block, shift, (norm_between(block, round) * (1.0 + 1e-14)).min(factor))
            })
            .collect();
        // One radius that will do for all, then less of it where less is enough: each step maps discs into themselves.
        let largest = reach.iter().map(|(_, shift, _)| *shift).fold(0.0, f64::max);
        let mut radii = vec![largest / (1.0 - factor); states.len()];
        for _ in 0..DISC_ROUNDS {
            let mut next = vec![0.0_f64; states.len()];
            for (block, shift, norm) in &reach {
                next[block.into] = next[block.into].max(shift + norm * radii[block.from]);
            }
            let settled = next.iter().zip(&radii).all(|(new, old)| *new >= old * (1.0 - 1e-6));
            for (radius, new) in radii.iter_mut().zip(next) {
                *radius = radius.min(new);
            }
            if settled {
                break;
            }
        }
        let disc = |state: usize| StateDisc {
            to_round: round[state][0],
            from_round: round[state][1],
            centre: centres[state],
            radius: radii[state] * (1.0 + 1e-12),
        };
        let discs: Vec<StateDisc> = (0..states.len()).map(disc).collect();
        // Maps on no way round may be so large that there is no number for what follows of them.
        if discs.iter().all(StateDisc::is_finite) {
            Ok(Self { discs, factor, length })
        } else {
            Err(DirectedError::Unproved)
        }
    }
}

impl StateDisc {
    fn is_finite(&self) -> bool {
        let coordinates = [self.to_round, self.from_round].iter().all(|m| m.is_finite() && *m != DMat2::ZERO);
        coordinates && self.centre.is_finite() && self.radius.is_finite()
    }
}

/// The maps, state after state.
fn blocks_of(states: &[Vec<DirectedMap>]) -> Vec<Block> {
    let states = states.iter().enumerate();
    let of = |(into, maps): (usize, &Vec<DirectedMap>)| -> Vec<Block> {
        maps.iter().map(|part| Block { into, from: part.from, map: part.map }).collect()
    };
    states.flat_map(of).collect()
}

fn norm_between(block: &Block, round: &Round) -> f64 {
    singular_values(round[block.into][0] * block.map.linear * round[block.from][1]).0
}

fn worst_norm(blocks: &[Block], round: &Round) -> f64 {
    blocks.iter().map(|block| norm_between(block, round)).fold(0.0, f64::max)
}

fn weights(blocks: &[Block], round: &Round) -> Vec<Weight> {
    let weight = |block: &Block| Weight {
        into: block.into,
        from: block.from,
        log: levels::log(norm_between(block, round)),
    };
    blocks.iter().map(weight).collect()
}

/// The coordinates once more, each scaled so that every map shrinks by about as much as the way round that shrinks
/// least; and the logarithm of that.
fn scaled(blocks: &[Block], round: &Round) -> (Round, f64) {
    let weights = weights(blocks, round);
    let Some((mean, _)) = levels::steepest(round.len(), &weights) else { return (round.clone(), 0.0) };
    if mean >= SHRINKING_LOG {
        return (round.clone(), mean);
    }
    // A little more than must be keeps scales that nothing asks for from running off.
    let most = (0.98 * mean).max(FASTEST_LOG);
    let scales = levels::scales(round.len(), &weights, most);
    let scaled = round.iter().zip(scales).map(|([to, from], log)| [*to * log.exp(), *from * (-log).exp()]);
    (scaled.collect(), most)
}

/// Refuses a system whose steepest way round does not contract, which settles most bad cases at once.
fn refuse_steepest(
    states: &[Vec<DirectedMap>],
    blocks: &[Block],
    round: &Round,
) -> Result<(), DirectedError> {
    let Some((_, arrows)) = levels::steepest(round.len(), &weights(blocks, round)) else { return Ok(()) };
    // Blocks are in the order of states.
    let first: Vec<usize> = states
        .iter()
        .scan(0, |sum, maps| {
            let first = *sum;
            *sum += maps.len();
            Some(first)
        })
        .collect();
    let (mut map, mut area, mut off) = (Affine2::IDENTITY, 1.0, 0.0);
    let mut cycle = Vec::new();
    for &arrow in &arrows {
        let block = &blocks[arrow];
        off = (off + 8.0 * f64::EPSILON * map.norm()) * block.map.norm();
        map = map * block.map;
        area *= full_determinant(block.map.linear);
        cycle.push((block.into, arrow - first[block.into]));
    }
    let radius = Dim2::certain_radius(map.linear, area, off);
    if radius >= NEUTRAL_RADIUS {
        return Err(no_attractor(cycle, radius));
    }
    Ok(())
}

/// The way round, told from its lowest state on.
fn no_attractor(mut cycle: Vec<(usize, usize)>, factor: f64) -> DirectedError {
    let first = (0..cycle.len()).min_by_key(|&k| cycle[k]).unwrap_or(0);
    cycle.rotate_left(first);
    DirectedError::NoAttractor { cycle, factor }
}

/// Coordinates in which the maps shrink as much as can be found: those of one ellipse for all states, or of one for
/// each.
///
/// The latter as in Lyapunov's equation: the form of a state is a weighted sum of those of the states it is copied
/// into, with more weight on maps that stretch more.
fn best_ellipses(blocks: &[Block], plain: Round, most: f64) -> (Round, f64) {
    let mut best = (plain, most);
    let linear: Vec<DMat2> = blocks.iter().map(|block| block.map.linear).collect();
    let shared = ellipse::best(&linear, worst_norm(blocks, &best.0));
    let tried = scaled(blocks, &vec![shared; best.0.len()]);
    if tried.1 < best.1 {
        best = tried;
    }
    let states = best.0.len();
    let copies: Vec<f64> = (0..states)
        .map(|state| blocks.iter().filter(|block| block.from == state).count().max(1) as f64)
        .collect();
    for target in [0.5_f64, 0.8, 0.95, 1.0] {
        let mut weights: Vec<f64> = blocks.iter().map(|block| 1.0 / copies[block.from]).collect();
        let mut forms = vec![DMat2::IDENTITY; states];
        for round in 0..WEIGHINGS {
            // Less and less of a disc, so that thin ellipses are found, and no singular map makes one that is flat.
            let mut next = vec![DMat2::IDENTITY * (1e-2 * 0.7_f64.powi(round)); states];
            for (block, weight) in blocks.iter().zip(&weights) {
                let m = block.map.linear;
                next[block.from] += m.transpose() * forms[block.into] * m * (weight / (target * target));
            }
            let size = next.iter().map(trace).fold(0.0, f64::max);
            for (form, new) in forms.iter_mut().zip(next) {
                *form = *form * 0.3 + new * (0.7 / size);
            }
            let Some(round_forms) = forms.iter().map(|form| cholesky(*form)).collect::<Option<Round>>()
            else {
                break;
            };
            let tried = scaled(blocks, &round_forms);
            let norms: Vec<f64> = blocks.iter().map(|block| norm_between(block, &tried.0)).collect();
            if tried.1 < best.1 {
                best = tried;
            }
            let keen = 2.0 + f64::from(round) / 4.0;
            let worst = norms.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
            let mut sums = vec![f64::MIN_POSITIVE; states];
            for ((block, weight), norm) in blocks.iter().zip(&mut weights).zip(&norms) {
                *weight = weight.sqrt() * (norm / worst).powf(keen) + 1e-6;
                sums[block.from] += *weight;
            }
            for (block, weight) in blocks.iter().zip(&mut weights) {
                *weight = *weight / sums[block.from] + 1e-4;
            }
        }
    }
    best
}

fn trace(m: &DMat2) -> f64 {
    m.x_axis.x + m.y_axis.y
}

/// The coordinates in which the ellipse `x . form x = 1` is round, of size 1, and back; `None` where it is too thin.
fn cholesky(form: DMat2) -> Option<[DMat2; 2]> {
    let form = form * (1.0 / trace(&form));
    let a = form.x_axis.x.sqrt();
    let b = form.y_axis.x / a;
    let d = (form.y_axis.y - b * b).sqrt();
    let to = DMat2::from_cols(DVec2::new(a, 0.0), DVec2::new(b, d));
    let from = to.inverse();
    (to.is_finite() && from.is_finite() && a.min(d) > 1e-7 * a.max(d)).then_some([to, from])
}

/// A point for each state near its middle: the mean of the images of those that it copies, each map weighed alike.
fn centres(states: &[Vec<DirectedMap>]) -> Vec<DVec2> {
    let mut centres = vec![DVec2::ZERO; states.len()];
    for _ in 0..DISC_ROUNDS {
        let mut moved = 0.0_f64;
        for (state, maps) in states.iter().enumerate() {
            let sum: DVec2 = maps.iter().map(|part| part.map.apply(centres[part.from])).sum();
            let mean = sum / maps.len() as f64;
            if mean.is_finite() && mean.length() < 1e120 {
                moved = moved.max((mean - centres[state]).length() / (1e-300 + mean.length()));
                centres[state] = mean;
            }
        }
        if moved < 1e-12 {
            break;
        }
    }
    centres
}
