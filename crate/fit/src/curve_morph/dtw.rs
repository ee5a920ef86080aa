//! Which place of one closed curve belongs to which of another.

use glam::DVec2;

/// Places along each curve at first, when every beginning is tried, and in the end.
const COARSE_PLACES: usize = 96;
const FINE_PLACES: usize = 4 * COARSE_PLACES;

/// How far the fine alignment may stray from the coarse one, in places.
const BAND_PLACES: usize = 20;

/// What a difference of direction counts against one of place: half a turn is as bad as so much of the curve's size,
/// squared.
const TURN_WEIGHT: f64 = 0.6;

/// What it costs to stand still on one curve.
const STANDSTILL_COST: f64 = 0.05;

/// Steps on the two curves.
const STEPS: [(usize, usize); 5] = [(1, 1), (1, 2), (2, 1), (1, 0), (0, 1)];

/// A place of a curve as it is compared: the middle of the curve is 0, and its mean size 1.
#[derive(Clone, Copy, Debug)]
struct Spot {
    /// The curve's parameter.
    t: f64,
    at: DVec2,
    direction: DVec2,
}

/// `count` spots at equal distances along a closed polyline of (t, point).
fn spots(line: &[(f64, DVec2)], count: usize) -> Vec<Spot> {
    let many = line.len();
    let at = |i: usize| line[i % many].1;
    let t = |i: usize| if i < many { line[i].0 } else { line[0].0 + 1.0 };
    let mut lengths = vec![0.0];
    for i in 0..many {
        lengths.push(lengths[i] + at(i).distance(at(i + 1)));
    }
    let whole = lengths[many];
    let mut side = 0;
    let mut found: Vec<Spot> = (0..count)
        .map(|k| {
            let place = whole * k as f64 / count as f64;
            while side + 1 < many && lengths[side + 1] <= place {
                side += 1;
            }
            let long = lengths[side + 1] - lengths[side];
            let share = if long > 0.0 { ((place - lengths[side]) / long).clamp(0.0, 1.0) } else { 0.0 };
            let t = t(side) + share * (t(side + 1) - t(side));
            Spot { t, at: at(side).lerp(at(side + 1), share), direction: DVec2::ZERO }
        })
        .collect();
    let middle = found.iter().map(|spot| spot.at).sum::<DVec2>() / count as f64;
    let square = found.iter().map(|spot| spot.at.distance_squared(middle)).sum::<f64>() / count as f64;
    let scale = if square > 0.0 { 1.0 / square.sqrt() } else { 0.0 };
    for spot in &mut found {
        spot.at = (spot.at - middle) * scale;
    }
    let near = (count / COARSE_PLACES).max(1);
    for k in 0..count {
        let direction = found[(k + near) % count].at - found[(k + count - near) % count].at;
        found[k].direction = direction.normalize_or_zero();
    }
    found
}

fn cost(a: &Spot, b: &Spot) -> f64 {
    a.at.distance_squared(b.at) + TURN_WEIGHT * 0.5 * (1.0 - a.direction.dot(b.direction))
}

/// The cheapest path from (0, first) once round both curves, where only places within `band` of `centre(i)` are looked
/// at: its cost and its steps as pairs of indices, the second unwrapped.
fn path(
    a: &[Spot],
    b: &[Spot],
    first: usize,
    band: usize,
    centre: impl Fn(usize) -> usize,
) -> (f64, Vec<(usize, usize)>) {
    let count = a.len();
    let wide = 2 * band + 1;
    // Column k of row i is place centre(i) + k - band after the first.
    let column = |i: usize, j: usize| (j + band).checked_sub(centre(i)).filter(|&k| k < wide);
    let mut costs = vec![f64::INFINITY; (count + 1) * wide];
    let mut steps = vec![u8::MAX; (count + 1) * wide];
    if let Some(k) = column(0, 0) {
        costs[k] = 0.0;
    }
    for i in 0..=count {
        for k in 0..wide {
            let Some(j) = (centre(i) + k).checked_sub(band).filter(|&j| j <= count) else { continue };
            if (i, j) == (0, 0) {
                continue;
            }
            let here = cost(&a[i % count], &b[(first + j) % count]);
            let mut best = (f64::INFINITY, u8::MAX);
            for (step, &(di, dj)) in STEPS.iter().enumerate() {
                let (Some(pi), Some(pj)) = (i.checked_sub(di), j.checked_sub(dj)) else { continue };
                let Some(pk) = column(pi, pj) else { continue };
                let still = if di == 0 || dj == 0 { STANDSTILL_COST } else { 0.0 };
                let total = costs[pi * wide + pk] + 0.5 * (di + dj) as f64 * here + still;
                if total < best.0 {
                    best = (total, step as u8);
                }
            }
            (costs[i * wide + k], steps[i * wide + k]) = best;
        }
    }
    let Some(end) = column(count, count) else { return (f64::INFINITY, Vec::new()) };
    let total = costs[count * wide + end];
    let mut warp = vec![(count, first + count)];
    let (mut i, mut j) = (count, count);
    while (i, j) != (0, 0) {
        let step = column(i, j).map_or(u8::MAX, |k| steps[i * wide + k]);
        let Some(&(di, dj)) = STEPS.get(step as usize) else { return (f64::INFINITY, Vec::new()) };
        (i, j) = (i - di, j - dj);
        warp.push((i, first + j));
    }
    warp.reverse();
    (total, warp)
}

/// Pairs (t of a, t of b) in order, once round both: what belongs together. The second goes on above 1.
pub(super) fn align(a: &[(f64, DVec2)], b: &[(f64, DVec2)]) -> Vec<(f64, f64)> {
    let (few_a, few_b) = (spots(a, COARSE_PLACES), spots(b, COARSE_PLACES));
    let rough = |first: usize| path(&few_a, &few_b, first, COARSE_PLACES / 3, |i| i);
    let best = (0..COARSE_PLACES).map(|first| (first, rough(first))).min_by(|a, b| a.1.0.total_cmp(&b.1.0));
    let Some((first, (_, warp))) = best else { return Vec::new() };
    // Where the coarse path is at each of its places.
    let mut centres = vec![0; COARSE_PLACES + 1];
    warp.iter().for_each(|&(i, j)| centres[i] = j - first);
    for i in 1..=COARSE_PLACES {
        centres[i] = centres[i].max(centres[i - 1]);
    }
    let fold = FINE_PLACES / COARSE_PLACES;
    let centre = |i: usize| {
        let (k, rest) = (i / fold, i % fold);
        centres[k] * (fold - rest) + centres[(k + 1).min(COARSE_PLACES)] * rest
    };
    let (all_a, all_b) = (spots(a, FINE_PLACES), spots(b, FINE_PLACES));
    let fine = |shift: usize| {
        path(&all_a, &all_b, (first * fold + FINE_PLACES + shift - fold) % FINE_PLACES, BAND_PLACES, centre)
    };
    let best = (0..=2 * fold).map(fine).min_by(|a, b| a.0.total_cmp(&b.0));
    let t = |spots: &[Spot], i: usize| spots[i % spots.len()].t + (i / spots.len()) as f64;
    best.map_or(Vec::new(), |(_, warp)| warp.iter().map(|&(i, j)| (t(&all_a, i), t(&all_b, j))).collect())
}
