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

/// A leaf as sugar maples have: five lobes with few pointed teeth, hollow between them, round bays, on a stalk. About 2
/// units high, points up, counter-clockwise; the same for the same seed.
#[must_use]
pub fn sugar_maple(seed: u32) -> Vec<DVec2> {
    // Of the right half, from the stalk up: the tip of a tooth or a turn of the margin, and what draws the stretch to
    // the next one to its side.
    const RIGHT: [[(f64, f64); 2]; 16] = [
        [(0.022, -1.16), (0.012, -0.8)],
        [(0.026, -0.47), (0.1, -0.6)],
        [(0.3, -0.565), (0.46, -0.5)],
        [(0.7, -0.6), (0.63, -0.46)],
        [(0.585, -0.33), (0.545, -0.245)],
        [(0.66, -0.235), (0.8, -0.25)],
        [(0.97, -0.29), (0.87, -0.14)],
        [(0.89, -0.02), (0.93, 0.09)],
        [(1.14, 0.18), (0.97, 0.18)],
        [(0.86, 0.235), (0.77, 0.275)],
        [(0.78, 0.52), (0.65, 0.35)],
        [(0.45, 0.23), (0.2, 0.055)],
        [(0.275, 0.32), (0.32, 0.52)],
        [(0.485, 0.7), (0.36, 0.675)],
        [(0.265, 0.76), (0.2, 0.8)],
        [(0.175, 0.87), (0.075, 0.99)],
    ];
    const TIP: DVec2 = DVec2::new(0.0, 1.22);
    let mut chance = Chance { seed: seed ^ 0x05_a9a2, next: 0 };
    let mut stretches: Vec<[DVec2; 3]> = Vec::new();
    for side in [1.0, -1.0] {
        let mut half: Vec<[DVec2; 2]> =
            RIGHT.iter().map(|pair| pair.map(|(x, y)| DVec2::new(side * x, y))).collect();
        for point in half[2..].iter_mut().flatten() {
            *point += DVec2::new(chance.swing(), chance.swing()) * 0.014;
        }
        let ends = half.iter().skip(1).map(|place| place[0]).chain([TIP]);
        let own: Vec<[DVec2; 3]> = half.iter().zip(ends).map(|(&[a, by], b)| [a, by, b]).collect();
        if side > 0.0 {
            stretches.extend(own);
        } else {
            stretches.extend(own.into_iter().rev().map(|[a, by, b]| [b, by, a]));
        }
    }
    let count = stretches.len();
    let mut margin = Vec::new();
    for (i, [a, by, b]) in stretches.into_iter().enumerate() {
        let stretch = (0..=16).map(|step| {
            let t = f64::from(step) / 16.0;
            a.lerp(by, t).lerp(by.lerp(b, t), t)
        });
        let on_stalk = i == 0 || i + 1 == count;
        extend_unevenly(&mut margin, stretch.collect(), on_stalk, &mut chance);
    }
    // The stalk is cut off square.
    margin.push(DVec2::new(-RIGHT[0][0].0, RIGHT[0][0].1));
    margin
}

/// A leaf as white oaks have: round lobes, longest above the middle, and narrow bays between them, not quite opposite,
/// on a stalk. About 2 units high, points up, counter-clockwise; the same for the same seed.
#[must_use]
pub fn white_oak(seed: u32) -> Vec<DVec2> {
    // Of the right half, from the stalk up.
    const RIGHT: [(f64, f64); 36] = [
        (0.028, -1.15),
        (0.03, -0.9),
        (0.1, -0.83),
        (0.22, -0.77),
        (0.27, -0.695),
        (0.21, -0.64),
        (0.115, -0.6),
        (0.115, -0.535),
        (0.22, -0.48),
        (0.37, -0.4),
        (0.43, -0.315),
        (0.37, -0.255),
        (0.2, -0.285),
        (0.135, -0.235),
        (0.19, -0.155),
        (0.4, -0.04),
        (0.575, 0.1),
        (0.585, 0.2),
        (0.485, 0.235),
        (0.28, 0.13),
        (0.175, 0.125),
        (0.175, 0.215),
        (0.33, 0.35),
        (0.5, 0.505),
        (0.515, 0.6),
        (0.43, 0.635),
        (0.285, 0.545),
        (0.2, 0.535),
        (0.19, 0.61),
        (0.255, 0.72),
        (0.32, 0.85),
        (0.285, 0.935),
        (0.19, 0.935),
        (0.125, 0.955),
        (0.085, 1.02),
        (0.0, 1.05),
    ];
    // How much higher the lobes of the left are: nothing at both ends.
    let higher = |y: f64| 0.045 * ((y + 0.85) / 0.3).clamp(0.0, 1.0) * ((1.0 - y) / 0.4).clamp(0.0, 1.0);
    let mut chance = Chance { seed: seed ^ 0x0a4d, next: 0 };
    let mut corners: Vec<DVec2> = RIGHT.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    corners.extend(RIGHT[..35].iter().rev().map(|&(x, y)| DVec2::new(-0.96 * x, y + higher(y))));
    let count = corners.len();
    for corner in &mut corners[2..count - 2] {
        *corner += DVec2::new(chance.swing(), chance.swing()) * 0.016;
    }
    let mut margin = Vec::new();
    for i in 0..count {
        let at = |k: usize| corners[(i + count + k - 1) % count];
        let stretch = (0..=8).map(|step| smooth([at(0), at(1), at(2), at(3)], f64::from(step) / 8.0));
        let on_stalk = i == 0 || i + 2 >= count;
        extend_unevenly(&mut margin, stretch.collect(), on_stalk, &mut chance);
    }
    margin
}

/// Adds a stretch without its end, four times as fine; a margin is a little uneven, a stalk is not.
fn extend_unevenly(margin: &mut Vec<DVec2>, mut stretch: Vec<DVec2>, on_stalk: bool, chance: &mut Chance) {
    for _ in 0..if on_stalk { 0 } else { 2 } {
        stretch = uneven(&stretch, chance);
    }
    stretch.pop();
    margin.append(&mut stretch);
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
            for leaf in [maple_leaf(seed), oak_leaf(seed), sugar_maple(seed), white_oak(seed), island(4)] {
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
