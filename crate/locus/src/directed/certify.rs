//! Whether the shapes of a morph between graph-directed systems stay in one piece all the way.

use frond_core::{Affine2, DirectedIfs, DirectedMap, DirectedMorph, Hull, Mode};
use glam::DVec2;

use crate::directed::connectedness::directed_connectedness;
use crate::directed::shared_points::{Arrows, Meeting, Shared, closed};
use crate::directed::tied::tied;
use crate::exact::address::Address;
use crate::exact::quadratic::QuadraticSystem;
use crate::exact::recognise;
use crate::magnification::Magnification;
use crate::verdict::{Options, Verdict};

/// What was shown of all of a way from (0, 0) to (1, 1), both parameters alike.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectedCertificate {
    /// Of every state on the way.
    pub states: Vec<StateOnTheWay>,
    /// Readings of numbers that exact proofs hang on; empty where nothing has to be assumed.
    pub assuming: Vec<String>,
    /// Moments that were looked at, beside exact proofs.
    pub moments: usize,
}

/// What was shown of a state, for every moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StateOnTheWay {
    /// It is connected at every moment: its pieces share points that stay shared, in exact arithmetic.
    Connected,
    /// At every moment its pieces hold together by gaps no wider than this part of its diameter, and so does
    /// everything that it is made of.
    Within(f64),
    /// Neither was shown; the first moment where it was not.
    Open(f64),
}

/// How finely a way is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectedCertifyOptions {
    /// The widest gap that is asked about, relative to the diameter.
    pub epsilon: f64,
    /// The most moments to look at.
    pub moments: usize,
    /// The most pairs of pieces at each.
    pub budget: usize,
    /// The most pairs of pieces in all.
    pub work: usize,
}

impl Default for DirectedCertifyOptions {
    fn default() -> Self {
        Self { epsilon: 1.0 / 200.0, moments: 400, budget: 100_000, work: 1_000_000 }
    }
}

/// Looks for a proof that shapes stay in one piece from (0, 0) to (1, 1), along u = v.
///
/// *Exactly.* Let all maps move on straight lines: the mode is linear, or the linear parts are the same at both ends.
/// A point at the end of a way that repeats stays where it is if it, and each further point round that way, is at the
/// same place at both ends: an equation that is affine in t and holds at 0 and at 1 holds between. Its image moves on
/// a straight line, or stays too; and so on along a way, as long as one map that moves is all that moves it. Two pieces
/// that share such points at both ends share them always, by the same argument; and where the linear parts
/// stay, all ends of ways that repeat move on straight lines, so that any two that are one at both ends are one always.
/// That all maps between contract is asked for in coordinates that suit both ends. If such points join the pieces
/// of every state of a set that copies none but its own, all of these are connected at every moment (as
/// [`directed_connectedness`] says).
///
/// Where a plant becomes an outline all this holds of two points that every state has, 0 and (0, 1), and is seen at
/// once, however many maps there are.
///
/// *Within epsilon.* At a moment the pieces of a state come within some distance of each other. From there to another
/// moment attractors move by at most `m = max over maps of the step of the map over the other's state, over 1 - f` in
/// coordinates in which all maps shrink by f (as Hutchinson 1981), so that no gap grows by more than 2 m. Moments are
/// put closer until the bounds meet. What is said is up to rounding of these bounds.
#[must_use]
pub fn certify_directed(morph: &DirectedMorph, options: &DirectedCertifyOptions) -> DirectedCertificate {
    let ends = [0.0, 1.0].map(|t| DirectedIfs::new(morph.at(t, t)));
    let count = morph.states().len();
    let [Ok(first), Ok(last)] = ends else {
        return DirectedCertificate {
            states: vec![StateOnTheWay::Open(0.0); count],
            assuming: Vec::new(),
            moments: 0,
        };
    };
    let straight = morph.mode() == Mode::Linear && contract_between(&first, &last);
    let tied = closed(&first, &if straight { tied(&first, &last) } else { vec![false; count] });
    if tied.first() == Some(&true) {
        let states =
            tied.iter().map(|tied| if *tied { StateOnTheWay::Connected } else { StateOnTheWay::Open(0.0) });
        return DirectedCertificate { states: states.collect(), assuming: Vec::new(), moments: 0 };
    }
    let (exact, assuming) = exactly(morph, &first, &last);
    let mut states: Vec<StateOnTheWay> = exact
        .iter()
        .map(|&exact| if exact { StateOnTheWay::Connected } else { StateOnTheWay::Within(options.epsilon) })
        .collect();
    let mut moments = 0;
    if exact.iter().any(|exact| !exact) {
        let open = walk(morph, &first, options, &mut moments);
        let held = closed(&first, &open.iter().map(Option::is_none).collect::<Vec<bool>>());
        let earliest = open.iter().flatten().copied().fold(1.0, f64::min);
        for (k, state) in states.iter_mut().enumerate() {
            if matches!(state, StateOnTheWay::Within(_)) && !held[k] {
                *state = StateOnTheWay::Open(open[k].unwrap_or(earliest));
            }
        }
    }
    DirectedCertificate { states, assuming, moments }
}

/// The states that are connected at every moment, and under which readings of numbers.
fn exactly(morph: &DirectedMorph, first: &DirectedIfs, last: &DirectedIfs) -> (Vec<bool>, Vec<String>) {
    let none = (vec![false; first.len()], Vec::new());
    let pairs = || first.states().iter().flatten().zip(last.states().iter().flatten());
    let kept = pairs().all(|(a, b)| a.map.linear == b.map.linear);
    let straight = kept || morph.mode() == Mode::Linear;
    let (Some(from), Some(to)) = (Arrows::of(first), Arrows::of(last)) else { return none };
    if !straight || !contract_between(first, last) {
        return none;
    }
    let diameters: Vec<f64> = Hull::of_states(first).iter().map(Hull::diameter).collect();
    let proposed = from.proposed(&diameters);
    let check = |systems: [&QuadraticSystem; 2], assuming: Vec<String>| {
        let same = |way: &Address| systems[0].point_in(systems[1], way);
        let stays = |letter: u8| from.maps[usize::from(letter)] == to.maps[usize::from(letter)];
        let straight = |way: &Address| {
            // Every turn of what repeats is a point of its own.
            let turned = |k: usize| {
                let mut repeat = way.repeat.clone();
                repeat.rotate_left(k);
                Address { head: Vec::new(), repeat }
            };
            if !(0..way.repeat.len()).all(|k| same(&turned(k))) {
                return false;
            }
            // From there on a point that stays, by a map that moves, goes straight: and stays if it is where it was.
            let mut moves = false;
            (0..way.head.len()).rev().all(|k| {
                let rest = Address { head: way.head[k..].to_vec(), repeat: way.repeat.clone() };
                let still = stays(way.head[k]);
                let fine = still || !moves;
                moves = moves || !(still || same(&rest));
                fine
            })
        };
        let holds = |meeting: &Meeting| {
            let [a, b] = &meeting.ways;
            // Where the linear parts stay, all ways do.
            (kept || (straight(a) && straight(b))) && systems.iter().all(|system| system.coincide(a, b))
        };
        Shared::checked(&[first, last], &proposed, holds, assuming)
    };
    let given = [&from.maps, &to.maps].map(|maps| QuadraticSystem::as_given(maps));
    if let [Some(a), Some(b)] = &given {
        let shared = check([a, b], Vec::new());
        let proved = closed(first, &shared.joined);
        if proved.iter().any(|proved| *proved) {
            return (proved, Vec::new());
        }
    }
    // All numbers of both ends at once, so that roots are read alike.
    let all: Vec<_> = from.maps.iter().chain(&to.maps).copied().collect();
    let Some(read) = recognise::read(&all) else { return none };
    let half = from.maps.len();
    let (a, b) = (read.system.part(0..half), read.system.part(half..2 * half));
    let shared = check([&a, &b], read.assuming.clone());
    let proved = closed(first, &shared.joined);
    if proved.iter().any(|proved| *proved) { (proved, shared.assuming) } else { none }
}

/// Whether there are coordinates in which the maps of both ends contract, and so, as norms are convex, all that lie
/// straight between them. A map that no way leads back from contracts in suitable ones, whatever it is.
fn contract_between(first: &DirectedIfs, last: &DirectedIfs) -> bool {
    let norm = |m| Affine2::new(m, DVec2::ZERO).norm();
    let reached: Vec<Vec<bool>> = (0..first.len()).map(|state| first.reached(state)).collect();
    [first, last].into_iter().any(|own| {
        let discs = &own.contraction().discs;
        let shrinks = |(into, maps): (usize, &Vec<DirectedMap>)| {
            maps.iter().all(|part| {
                !reached[part.from][into]
                    || norm(discs[into].to_round * part.map.linear * discs[part.from].from_round) < 1.0 - 1e-9
            })
        };
        [first, last].into_iter().all(|end| end.states().iter().enumerate().all(shrinks))
    })
}

/// Moments closer than this are not looked at.
const LEAST_STEP: f64 = 1e-6;

/// For each state the first moment from which no bound could be shown; `None` where there is one for all of the way.
/// `graph` says what states are made of.
fn walk(
    morph: &DirectedMorph,
    graph: &DirectedIfs,
    options: &DirectedCertifyOptions,
    moments: &mut usize,
) -> Vec<Option<f64>> {
    let count = morph.states().len();
    let mut open: Vec<Option<f64>> = vec![None; count];
    // Of sizes whose squares vanish or overflow nothing is bounded.
    if [0.0, 1.0].iter().any(|&t| Magnification::of_states(&morph.at(t, t)).is_some()) {
        return vec![Some(0.0); count];
    }
    let mut from = 0.0_f64;
    let mut step = 1.0 / 16.0;
    let mut work = 0_usize;
    // Finer than what is asked about, so that there is room to move.
    let look = Options { epsilon: 0.25 * options.epsilon, budget: options.budget };
    while from < 1.0 {
        let at = (from + step).min(1.0);
        let reach = 0.5 * (at - from);
        let middle = from + reach;
        if *moments >= options.moments || work >= options.work || step < LEAST_STEP {
            open.iter_mut().for_each(|open| *open = open.or(Some(from)));
            return open;
        }
        *moments += 1;
        let Ok(system) = DirectedIfs::new(morph.at(middle, middle)) else {
            open.iter_mut().for_each(|open| *open = open.or(Some(from)));
            return open;
        };
        let turns: Vec<f64> = morph.turns().iter().map(|turn| turn.abs() * reach).collect();
        let moved = movement(&system, &[from, at].map(|t| morph.at(t, t)), &turns);
        let found = directed_connectedness(&system, &look);
        work += found.iter().map(|state| state.nodes).sum::<usize>();
        let hold = found.iter().map(|state| state.verdict.holds()).collect::<Vec<bool>>();
        let fits = |state: usize| {
            let near = if found[state].verdict == Verdict::Connected { 0.0 } else { look.epsilon };
            let Some(moved) = &moved else { return false };
            let least = found[state].diameter - 2.0 * moved[state];
            near * found[state].diameter + 2.0 * moved[state] <= options.epsilon * least
        };
        let good: Vec<bool> =
            (0..count).map(|state| open[state].is_some() || (hold[state] && fits(state))).collect();
        if good.iter().all(|good| *good) {
            from = at;
            step = (step * 1.5).min(1.0 / 16.0);
            continue;
        }
        // What does not hold here will not with shorter steps.
        for state in 0..count {
            if !hold[state] && open[state].is_none() {
                open[state] = Some(middle);
            }
        }
        let lasts: Vec<bool> = open.iter().map(Option::is_none).collect();
        if closed(graph, &lasts).first() != Some(&true) {
            open.iter_mut().for_each(|open| *open = open.or(Some(middle)));
            return open;
        }
        if (0..count).any(|state| open[state].is_none() && !fits(state)) {
            step *= 0.5;
        }
    }
    open
}

/// How far each state may move until any moment between two others, in the plane; `None` where there is no bound.
/// `turns` are the angles that the maps turn by meanwhile.
///
/// With `M = R S` in the middle and `M' = R' S'` at an end, S moves on a straight line, and `|S' - S| <= |M' - M| +
/// angle |M|`: so no map between is farther from M than `|M' - M| + 2 angle max(|M|, |M'|)`.
fn movement(system: &DirectedIfs, ends: &[Vec<Vec<DirectedMap>>], turns: &[f64]) -> Option<Vec<f64>> {
    let contraction = system.contraction();
    if contraction.length != 1 {
        return None;
    }
    let norm = |m| Affine2::new(m, DVec2::ZERO).norm();
    let mut turns = turns.iter();
    let (mut worst, mut factor) = (0.0_f64, contraction.factor);
    for (state, maps) in system.states().iter().enumerate() {
        let disc = &contraction.discs[state];
        for (k, part) in maps.iter().enumerate() {
            let inner = &contraction.discs[part.from];
            let turn = turns.next().copied().unwrap_or(0.0);
            let (mut shift, mut bend) = (0.0_f64, 0.0_f64);
            for end in ends {
                let end = end[state][k].map;
                let round = norm(disc.to_round * (end.linear - part.map.linear) * inner.from_round);
                let size = part.map.norm().max(end.norm());
                let turned = 2.0 * turn * size;
                let step = end.translation - part.map.translation;
                shift = shift.max((disc.to_round * step).length());
                bend = bend.max(round + norm(disc.to_round) * turned * norm(inner.from_round));
            }
            // About the middle of the disc that is copied, which need not be 0.
            let away = norm(inner.to_round) * inner.centre.length() + inner.radius;
            worst = worst.max(shift + bend * away);
            factor = factor.max(norm(disc.to_round * part.map.linear * inner.from_round) + bend);
        }
    }
    let moved = worst / (1.0 - factor);
    let fits = factor < 1.0 && moved.is_finite();
    fits.then(|| contraction.discs.iter().map(|disc| moved * norm(disc.from_round)).collect())
}
