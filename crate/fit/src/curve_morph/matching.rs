//! Two curves get as many knots, each with its partner.

use glam::DVec2;

use super::dtw::align;
use super::knot_ring::Ring;
use super::morphed_curve::MorphedCurve;

/// Corners of the polylines that are aligned.
const MOST_VERTICES: usize = 4000;

/// Knots farther apart than this, in parts of the curve, are no partners.
const MOST_APART: f64 = 0.03;

/// A knot of the common structure: its index on each curve where it is one there.
#[derive(Clone, Copy, Debug, Default)]
struct Shared {
    knots: [Option<usize>; 2],
    /// Where it is on each, the second above 1 where that went round.
    t: [f64; 2],
}

/// Both curves with as many knots, in the same order.
pub(super) fn share(a: Ring, b: Ring) -> [Ring; 2] {
    let mut rings = [a, b];
    let alone = rings.each_ref().map(|ring| {
        let places = ring.places();
        MorphedCurve::new(&[ring.clone(), ring.clone()], &[places.clone(), places], 0.0)
    });
    let lines = alone.each_ref().map(|morphed| morphed.trace(morphed.size / 400.0, None, MOST_VERTICES));
    let path = align(&lines[0], &lines[1]);
    let list = merge(&rings, &alone, &path);
    let total = list.len();
    for side in 0..2 {
        let count = rings[side].knots.len();
        let places = &alone[side].places;
        // Behind which knot each of the others comes.
        let mut wanted: Vec<Vec<(f64, DVec2)>> = vec![Vec::new(); count];
        let start = list.iter().position(|shared| shared.knots[side] == Some(0)).unwrap_or(0);
        let mut edge = 0;
        for k in 0..total {
            let shared = &list[(start + k) % total];
            if let Some(knot) = shared.knots[side] {
                edge = knot;
                continue;
            }
            let t = shared.t[side].rem_euclid(1.0);
            let (low, high) = (places[edge], places[edge + 1]);
            let share = if high > low { ((t - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
            // At the very end the place has gone round.
            let share = if t < low && low - t > 0.5 { 1.0 } else { share };
            wanted[edge]
                .push((share, alone[side].value(low + share * (high - low), 1e-9 * alone[side].size, 4096)));
        }
        for edge in (0..count).rev() {
            rings[side].open(edge, &wanted[edge]);
        }
        rings[side].rotate((total - start) % total);
    }
    rings
}

/// The angle by which a ring turns at a knot, in half turns.
fn turn(ring: &Ring, knot: usize) -> f64 {
    let before = ring.chord((knot + ring.knots.len() - 1) % ring.knots.len());
    let turn = before.angle_to(ring.chord(knot)) / std::f64::consts::PI;
    if turn.is_finite() { turn } else { 0.0 }
}

/// Where a place of the first curve is on the way; with `back`, a place of the second. The answer is for the same lap.
fn along(path: &[(f64, f64)], place: f64, back: bool) -> f64 {
    let key = |pair: &(f64, f64)| if back { pair.1 } else { pair.0 };
    let value = |pair: &(f64, f64)| if back { pair.0 } else { pair.1 };
    let (Some(first), Some(_)) = (path.first(), path.last()) else { return place };
    let laps = (place - key(first)).floor();
    let place = place - laps;
    let after = path.partition_point(|pair| key(pair) <= place).clamp(1, path.len() - 1);
    let (a, b) = (&path[after - 1], &path[after]);
    let long = key(b) - key(a);
    let share = if long > 0.0 { ((place - key(a)) / long).clamp(0.0, 1.0) } else { 0.0 };
    value(a) + share * (value(b) - value(a)) + laps
}

/// Pairs of knots that are partners, in order on both curves, the first at its place in the first lap.
fn partners(rings: &[Ring; 2], alone: &[MorphedCurve; 2], path: &[(f64, f64)]) -> Vec<(usize, usize)> {
    let turns = rings.each_ref().map(|ring| (0..ring.knots.len()).map(|k| turn(ring, k)).collect::<Vec<_>>());
    let apart = |x: f64, y: f64| {
        let d = (x - y).rem_euclid(1.0);
        d.min(1.0 - d)
    };
    let mut offers = Vec::new();
    for i in 0..rings[0].knots.len() {
        let there = along(path, alone[0].places[i], false);
        for j in 0..rings[1].knots.len() {
            let far = apart(there, alone[1].places[j]) / MOST_APART;
            let differ = turns[0][i] - turns[1][j];
            let sharp = turns[0][i].abs().min(turns[1][j].abs());
            offers.push((far * far + 4.0 * differ * differ - 0.5 * sharp, far, i, j));
        }
    }
    offers.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut chosen: Vec<(usize, usize)> = Vec::new();
    for &(_, far, i, j) in &offers {
        if !chosen.is_empty() && far > 1.0 {
            continue;
        }
        // In order round both, seen from the first pair that was chosen.
        let Some(&(i0, j0)) = chosen.first() else {
            chosen.push((i, j));
            continue;
        };
        let (n, m) = (rings[0].knots.len(), rings[1].knots.len());
        let seen = |i: usize, j: usize| ((i + n - i0) % n, (j + m - j0) % m);
        let (x, y) = seen(i, j);
        let agrees = chosen.iter().all(|&(k, l)| {
            let (u, v) = seen(k, l);
            (x < u && y < v) || (x > u && y > v)
        });
        if agrees {
            chosen.push((i, j));
        }
    }
    let n = rings[0].knots.len();
    let first = chosen.first().map_or(0, |pair| pair.0);
    chosen.sort_by_key(|&(i, _)| (i + n - first) % n);
    chosen
}

/// The knots of both in one order, partners as one.
fn merge(rings: &[Ring; 2], alone: &[MorphedCurve; 2], path: &[(f64, f64)]) -> Vec<Shared> {
    let pairs = partners(rings, alone, path);
    let (n, m) = (rings[0].knots.len(), rings[1].knots.len());
    let mut list = Vec::new();
    for (k, &(i, j)) in pairs.iter().enumerate() {
        let (next_i, next_j) = pairs[(k + 1) % pairs.len()];
        // How many knots there are up to the next partners.
        let steps = |from: usize, to: usize, count: usize| {
            let steps = (to + count - from) % count;
            if steps == 0 { count } else { steps }
        };
        let (many_i, many_j) = (steps(i, next_i, n), steps(j, next_j, m));
        let place = |side: usize, from: usize, step: usize| {
            let count = rings[side].knots.len();
            let at = from + step;
            alone[side].places[at % count] + (at / count) as f64
        };
        let (a0, a1) = (place(0, i, 0), place(0, i, many_i));
        let (b0, b1) = (place(1, j, 0), place(1, j, many_j));
        // The way between the two pairs, in their laps.
        let mut piece = vec![(a0, b0)];
        let lap = (along(path, a0, false) - b0).round();
        for shift in -2..=2 {
            for &(a, b) in path {
                let (a, b) = (a + f64::from(shift), b + f64::from(shift) - lap);
                let last = piece[piece.len() - 1];
                if a > last.0 && a < a1 && b > last.1 && b < b1 {
                    piece.push((a, b));
                }
            }
        }
        piece.push((a1, b1));
        list.push(Shared { knots: [Some(i), Some(j)], t: [a0, b0] });
        let inside = |place: f64, back: bool| inside(&piece, place, back);
        let mut between: Vec<Shared> = Vec::new();
        for step in 1..many_i {
            let t = place(0, i, step);
            between.push(Shared { knots: [Some((i + step) % n), None], t: [t, inside(t, false)] });
        }
        for step in 1..many_j {
            let t = place(1, j, step);
            between.push(Shared { knots: [None, Some((j + step) % m)], t: [inside(t, true), t] });
        }
        // Stable, so that knots of one curve at one place stay in order.
        between.sort_by(|x, y| (x.t[0] + x.t[1]).total_cmp(&(y.t[0] + y.t[1])));
        list.append(&mut between);
    }
    list
}

/// The other side of a place on a piece of the way.
fn inside(piece: &[(f64, f64)], place: f64, back: bool) -> f64 {
    let key = |pair: &(f64, f64)| if back { pair.1 } else { pair.0 };
    let value = |pair: &(f64, f64)| if back { pair.0 } else { pair.1 };
    let after = piece.partition_point(|pair| key(pair) <= place).clamp(1, piece.len() - 1);
    let (a, b) = (&piece[after - 1], &piece[after]);
    let long = key(b) - key(a);
    let share = if long > 0.0 { ((place - key(a)) / long).clamp(0.0, 1.0) } else { 0.0 };
    value(a) + share * (value(b) - value(a))
}
