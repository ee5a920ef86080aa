//! Leaves that are grown by program: outlines to try a fit on, free of anybody's rights.

use frond_core::hash;
use glam::DVec2;

/// A chance of its own for each thing that is grown.
struct Chance {
    seed: u32,
    next: u32,
}

impl Chance {
    /// A number between -1 and 1.
    fn swing(&mut self) -> f64 {
        self.next += 1;
        2.0 * f64::from(hash::unit(hash::counter(self.seed, self.next))) - 1.0
    }
}

/// A maple-like leaf: five pointed lobes whose margins carry teeth, and these smaller teeth. About 2 units wide, points
/// up, counter-clockwise; the same for the same seed.
#[must_use]
pub fn maple_leaf(seed: u32) -> Vec<DVec2> {
    // Tips and bays of the right half in turns of a clock's degrees, from the stalk up to the top: angle, radius.
    const RIGHT: [(f64, f64); 7] =
        [(-90.0, 0.16), (-68.0, 0.36), (-34.0, 0.68), (-8.0, 0.36), (26.0, 0.98), (57.0, 0.44), (90.0, 1.16)];
    let mut chance = Chance { seed, next: 0 };
    let half: Vec<DVec2> =
        RIGHT.iter().map(|&(turn, radius)| DVec2::from_angle(turn.to_radians()) * radius).collect();
    let mut corners = half.clone();
    corners.extend(half[1..6].iter().rev().map(|p| DVec2::new(-p.x, p.y)));
    for corner in &mut corners[1..] {
        *corner += DVec2::new(chance.swing(), chance.swing()) * 0.025;
    }
    let count = corners.len();
    let mut margin = Vec::new();
    for i in 0..count {
        // Tips are at even places, bays at odd ones; teeth point to the tip.
        let to_tip = (i + 1) % 2 == 0 && i + 1 != count;
        tooth(corners[i], corners[(i + 1) % count], to_tip, 4, &mut chance, &mut margin);
    }
    margin
}

/// Points from a to b, without b: a margin with two teeth, made of smaller such margins.
fn tooth(a: DVec2, b: DVec2, forward: bool, depth: u32, chance: &mut Chance, out: &mut Vec<DVec2>) {
    let chord = b - a;
    if depth == 0 || chord.length() < 0.012 {
        out.push(a);
        return;
    }
    // Along the chord and out of the leaf, which lies to the left of its margin.
    const SHAPE: [(f64, f64); 5] = [(0.0, 0.0), (0.34, 0.045), (0.42, 0.0), (0.74, 0.085), (0.80, 0.03)];
    let size = 1.0 + 0.35 * chance.swing();
    let outside = -chord.perp();
    let mut points: Vec<DVec2> =
        SHAPE.iter().map(|&(along, off)| a + chord * along + outside * off * size).collect();
    points.push(b);
    if !forward {
        let turned = |&(along, off): &(f64, f64)| a + chord * (1.0 - along) + outside * off * size;
        points = [b].into_iter().chain(SHAPE[1..].iter().map(turned)).chain([a]).collect();
        points.reverse();
    }
    for pair in points.windows(2) {
        tooth(pair[0], pair[1], forward, depth - 1, chance, out);
    }
}

/// An oak-like leaf: round lobes on both sides of a midrib, with a finely uneven margin. About 2 units high, points up,
/// counter-clockwise; the same for the same seed.
#[must_use]
pub fn oak_leaf(seed: u32) -> Vec<DVec2> {
    // Bays and lobes of the right half from the stalk up: distance from the midrib, height.
    const RIGHT: [(f64, f64); 13] = [
        (0.035, -1.05),
        (0.05, -0.86),
        (0.25, -0.72),
        (0.13, -0.55),
        (0.42, -0.38),
        (0.19, -0.2),
        (0.55, 0.06),
        (0.24, 0.22),
        (0.5, 0.47),
        (0.22, 0.56),
        (0.36, 0.8),
        (0.17, 0.84),
        (0.0, 1.03),
    ];
    let mut chance = Chance { seed: seed ^ 0x0a4b, next: 0 };
    let mut corners: Vec<DVec2> = RIGHT.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    corners.extend(RIGHT[..12].iter().rev().map(|&(x, y)| DVec2::new(-x, y)));
    for corner in &mut corners[1..] {
        *corner += DVec2::new(chance.swing(), chance.swing()) * 0.022;
    }
    let count = corners.len();
    let mut margin = Vec::new();
    for i in 0..count {
        let at = |k: usize| corners[(i + count + k - 1) % count];
        let mut stretch: Vec<DVec2> =
            (0..=8).map(|step| smooth([at(0), at(1), at(2), at(3)], f64::from(step) / 8.0)).collect();
        for _ in 0..3 {
            stretch = uneven(&stretch, &mut chance);
        }
        stretch.pop();
        margin.append(&mut stretch);
    }
    margin
}

/// An island with a rough coast: a ring of capes and bays whose sides are broken in the middle again and again. About 2
/// units wide, counter-clockwise; the same for the same seed. Most seeds have no crossing.
#[must_use]
pub fn island(seed: u32) -> Vec<DVec2> {
    // Directions in degrees and distances from the middle.
    const CAPES: [(f64, f64); 9] = [
        (-100.0, 0.72),
        (-58.0, 0.95),
        (-22.0, 0.62),
        (8.0, 1.02),
        (47.0, 0.74),
        (88.0, 0.98),
        (131.0, 0.66),
        (172.0, 1.05),
        (221.0, 0.82),
    ];
    let mut chance = Chance { seed: seed ^ 0x15_1a7d, next: 0 };
    let mut coast: Vec<DVec2> = CAPES
        .iter()
        .map(|&(turn, far)| {
            DVec2::from_angle((turn + 7.0 * chance.swing()).to_radians())
                * (far * (1.0 + 0.1 * chance.swing()))
        })
        .collect();
    for _ in 0..7 {
        let count = coast.len();
        coast = (0..count)
            .flat_map(|i| {
                let (a, b) = (coast[i], coast[(i + 1) % count]);
                let middle = a.lerp(b, 0.5 + 0.12 * chance.swing());
                [a, middle + (b - a).perp() * (0.24 * chance.swing())]
            })
            .collect();
    }
    coast
}

/// A leaf badly measured: every point is off by a chance of some 0.3% of the diagonal each way.
#[must_use]
pub fn noisy(points: &[DVec2], seed: u32) -> Vec<DVec2> {
    let mut next = 0_u32;
    let mut swing = || {
        next += 1;
        let unit = |k| f64::from(hash::unit(hash::counter(seed ^ 0x6e01, 4 * next + k)));
        // The sum of four is near a bell.
        (0..4_u32).map(unit).sum::<f64>() - 2.0
    };
    points.iter().map(|p| *p + DVec2::new(swing(), swing()) * 0.012).collect()
}

/// The Catmull-Rom curve from the second point to the third.
fn smooth([a, b, c, d]: [DVec2; 4], t: f64) -> DVec2 {
    let turn = |p: DVec2, q: DVec2| (q - p) * 0.45;
    let (m, n) = (turn(a, c), turn(b, d));
    let (t2, t3) = (t * t, t * t * t);
    b * (2.0 * t3 - 3.0 * t2 + 1.0) + m * (t3 - 2.0 * t2 + t) + c * (3.0 * t2 - 2.0 * t3) + n * (t3 - t2)
}

/// The midpoint of every side goes in or out by a chance.
fn uneven(points: &[DVec2], chance: &mut Chance) -> Vec<DVec2> {
    let mut finer = Vec::with_capacity(2 * points.len());
    for pair in points.windows(2) {
        let out = (pair[1] - pair[0]).perp() * 0.09 * chance.swing();
        finer.extend([pair[0], pair[0].midpoint(pair[1]) + out]);
    }
    finer.extend(points.last());
    finer
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::{Outline, box_slope, crossings};

    #[test]
    fn leaves_are_outlines_that_do_not_cross_themselves() {
        for seed in 0..6 {
            for leaf in [maple_leaf(seed), oak_leaf(seed), island(4)] {
                assert_eq!(crossings(&leaf, 5), Some(vec![]), "seed {seed}");
                let outline = Outline::new(&leaf).unwrap();
                assert_eq!(outline.points().first(), leaf.first(), "it runs counter-clockwise");
                assert!((1000..8000).contains(&leaf.len()), "{}", leaf.len());
            }
        }
    }

    #[test]
    fn the_maple_is_rougher_than_the_oak_and_seeds_differ() {
        let slope = |leaf: Vec<DVec2>| {
            let outline = Outline::new(&leaf).unwrap();
            box_slope(outline.points(), &outline)
        };
        assert!(slope(maple_leaf(1)) > slope(oak_leaf(1)));
        assert_ne!(maple_leaf(1), maple_leaf(2));
        assert_eq!(oak_leaf(3), oak_leaf(3));
    }
}
