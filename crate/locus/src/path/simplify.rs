//! From a chain of cells to a few waypoints.

use glam::DVec3;

use crate::path::field::{Field, Terms};

/// Waypoints, ends included, that a person takes in at a glance: more are drawn only where they save much.
const POINTS_AT_A_GLANCE: usize = 6;
/// Corners looked at.
const MOST_CORNERS: usize = 96;

/// The cells of a polygon with few corners along `way`, its first and its last cell among them, at most `most` in
/// all: one that costs little in the field, with a toll on each waypoint and on how sharply it turns there.
///
/// No leg breaks the terms. If `most` is too few for that, more are kept.
pub(crate) fn simplify(field: &Field, way: &[usize], terms: Terms, most: usize) -> Vec<usize> {
    // Corners are only looked for at some of the cells: a chain may have many hundred.
    let stride = way.len().div_ceil(MOST_CORNERS).max(1);
    let mut corners: Vec<usize> = way.iter().copied().step_by(stride).collect();
    if let Some(&end) = way.last().filter(|_| !(way.len() - 1).is_multiple_of(stride)) {
        corners.push(end);
    }
    let count = corners.len();
    let legs: Vec<f64> = (0..count * count)
        .map(|k| {
            if k / count < k % count {
                leg(field, corners[k / count], corners[k % count], terms)
            } else {
                0.0
            }
        })
        .collect();
    let directions: Vec<DVec3> = (0..count * count)
        .map(|k| {
            let between = field.lattice.place(corners[k % count]) - field.lattice.place(corners[k / count]);
            between.normalize_or_zero()
        })
        .collect();
    // A waypoint must save so much of the way, or of the closeness to what is broken, to be worth having: it is
    // one more thing on the screen to understand.
    let first = field.side() / 40.0;
    let mut toll = first;
    loop {
        let kept = cheapest_chain(count, &legs, &directions, toll);
        let found = kept.len() > 1 || count == 1;
        let fits =
            kept.len() <= POINTS_AT_A_GLANCE || toll >= 6.0 * first && kept.len() <= most || toll > 1e6;
        if found && fits {
            let kept = kept.into_iter().map(|k| corners[k]).collect();
            return relaxed(field, kept, terms, first);
        }
        if toll > 1e6 {
            return way.to_vec();
        }
        toll *= 2.0;
    }
}

/// What turning from one direction into another costs.
fn bend(before: DVec3, after: DVec3, toll: f64) -> f64 {
    toll * (1.0 + 0.5 * (1.0 - before.dot(after)))
}

/// The chain from the first to the last corner that costs least; empty if there is none. A state is a leg, since
/// what a corner costs depends on both of its legs.
fn cheapest_chain(count: usize, legs: &[f64], directions: &[DVec3], toll: f64) -> Vec<usize> {
    if count < 2 {
        return (0..count).collect();
    }
    let mut cost = vec![f64::INFINITY; count * count];
    let mut before = vec![0; count * count];
    cost[1..count].copy_from_slice(&legs[1..count]);
    for middle in 1..count {
        for to in middle + 1..count {
            let leg = legs[middle * count + to];
            if leg.is_infinite() {
                continue;
            }
            for from in 0..middle {
                let so_far = cost[from * count + middle];
                if so_far + leg + toll < cost[middle * count + to] {
                    let turn = bend(directions[from * count + middle], directions[middle * count + to], toll);
                    let total = so_far + leg + turn;
                    if total < cost[middle * count + to] {
                        cost[middle * count + to] = total;
                        before[middle * count + to] = from;
                    }
                }
            }
        }
    }
    let last = count - 1;
    let ended = |from: usize| cost[from * count + last];
    let Some(mut from) = (0..last).min_by(|&a, &b| ended(a).total_cmp(&ended(b))) else { return Vec::new() };
    if ended(from).is_infinite() {
        return Vec::new();
    }
    let mut chain = vec![last, from];
    while from != 0 {
        let to = chain[chain.len() - 2];
        from = before[from * count + to];
        chain.push(from);
    }
    chain.reverse();
    chain
}

/// The polygon with its corners moved, and left out, where that makes it cheaper.
fn relaxed(field: &Field, mut kept: Vec<usize>, terms: Terms, toll: f64) -> Vec<usize> {
    let place = |cell: usize| field.lattice.place(cell);
    // The legs at the corner `k`, and the bends that they take part in.
    let around = |kept: &[usize], k: usize| {
        let direction = |i: usize| (place(kept[i + 1]) - place(kept[i])).normalize_or_zero();
        let bends =
            (k.max(2) - 1..=(k + 1).min(kept.len() - 2)).map(|i| bend(direction(i - 1), direction(i), toll));
        leg(field, kept[k - 1], kept[k], terms) + leg(field, kept[k], kept[k + 1], terms) + bends.sum::<f64>()
    };
    for _ in 0..12 {
        let mut changed = false;
        for k in 1..kept.len().saturating_sub(1) {
            let mut cost = around(&kept, k);
            for far in [4.0, 2.0, 1.0] {
                let was = kept[k];
                let mut best = was;
                for shift in shifts(field) {
                    let Some(cell) = field.lattice.cell(place(was) + shift * far) else { continue };
                    kept[k] = cell;
                    let tried = around(&kept, k);
                    if tried < cost - 1e-9 {
                        cost = tried;
                        best = cell;
                        changed = true;
                    }
                }
                kept[k] = best;
            }
        }
        // A corner that its neighbours can do without.
        let spare = (1..kept.len().saturating_sub(1)).find(|&k| {
            let mut without = kept.clone();
            without.remove(k);
            let straight = leg(field, kept[k - 1], kept[k + 1], terms);
            straight.is_finite() && total(field, &without, terms, toll) < total(field, &kept, terms, toll)
        });
        if let Some(k) = spare {
            kept.remove(k);
            changed = true;
        }
        if !changed {
            break;
        }
    }
    kept
}

/// What a polygon costs.
fn total(field: &Field, kept: &[usize], terms: Terms, toll: f64) -> f64 {
    let legs: f64 = kept.windows(2).map(|ends| leg(field, ends[0], ends[1], terms)).sum();
    let direction =
        |from: usize, to: usize| (field.lattice.place(to) - field.lattice.place(from)).normalize_or_zero();
    let bends = kept.windows(3).map(|at| bend(direction(at[0], at[1]), direction(at[1], at[2]), toll));
    legs + bends.sum::<f64>()
}

/// The steps to the neighbours of a cell.
fn shifts(field: &Field) -> impl Iterator<Item = DVec3> + use<> {
    let layers = if field.lattice.size[2] > 1 { -1..=1 } else { 0..=0 };
    let shifts = layers.flat_map(|z| (-1..=1).flat_map(move |y| (-1..=1).map(move |x| [x, y, z])));
    shifts.filter(|shift| *shift != [0; 3]).map(|shift| DVec3::from_array(shift.map(f64::from)))
}

/// What a straight leg between two cells costs; infinite if it meets a gap wider than the terms allow, or comes much
/// closer to broken ground.
///
/// Where it passes between samples, all of those around must do: what holds in single samples only, say along
/// a line of the grid, is left at right angles.
fn leg(field: &Field, from: usize, to: usize, terms: Terms) -> f64 {
    let (start, end) = (field.lattice.place(from), field.lattice.place(to));
    let length = start.distance(end);
    if length < 1.8 {
        let price = 0.5 * (field.price(from) + field.price(to));
        return if field.step_gap(from, to) > terms.widest { f64::INFINITY } else { length * price };
    }
    let steps = (2.0 * length).ceil() as usize;
    let mut sum = 0.0;
    for k in 0..=steps {
        let at = start.lerp(end, k as f64 / steps as f64);
        // Rounding must not turn a leg along a line of the grid into one beside it.
        let at = DVec3::from_array(at.to_array().map(snapped));
        if field.gap_around(at) > terms.widest {
            return f64::INFINITY;
        }
        let Some(cell) = field.lattice.cell(at) else { return f64::INFINITY };
        if field.room(cell) < 0.9 * terms.room {
            return f64::INFINITY;
        }
        sum += field.price(cell);
    }
    length * sum / (steps + 1) as f64
}

fn snapped(x: f64) -> f64 {
    if (x - x.round()).abs() < 1e-6 { x.round() } else { x }
}
