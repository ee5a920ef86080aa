//! A natural scene of several objects.

use std::sync::LazyLock;

use frond_core::Affine3;
use glam::{DMat2, DMat3, DQuat, DVec2, DVec3};

use crate::space::preset::{Row3, preset3};

/// An object of a scene: a shape of its own, made where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Thing {
    /// Its name on screen.
    pub name: &'static str,
    /// What it is coloured as, for a renderer to choose by: `ground`, `leaf`, `cloud`, `water`.
    pub tint: &'static str,
    /// Its maps, with its place in them: to move it is to conjugate them.
    pub maps: Vec<Row3>,
    /// Its share of the points of the scene; all shares add up to 1.
    pub share: f64,
}

/// Hills with a wood on them under two clouds, all of them attractors, z up, the eye at the origin and the scene along
/// x, as in the paper (Darwish & Abd-El-Wahab, figure vii, whose parameters are not printed: this one is Frond's own).
#[must_use]
pub fn natural_scene() -> &'static [Thing] {
    static THINGS: LazyLock<Vec<Thing>> = LazyLock::new(things);
    &THINGS
}

fn things() -> Vec<Thing> {
    let mut things = vec![
        Thing { name: "Ground", tint: "ground", maps: placed(&ground(), GROUND, 0.0, HILLS), share: 0.34 },
        Thing {
            name: "Cloud",
            tint: "cloud",
            maps: placed(&cloud(), [17.0, -2.6, 2.5], 0.3, [2.4, 2.4, 1.1]),
            share: 0.1,
        },
        Thing {
            name: "Small cloud",
            tint: "cloud",
            maps: placed(&cloud(), [15.0, 2.4, 2.1], 2.0, [1.3, 1.3, 0.6]),
            share: 0.06,
        },
    ];
    let tree = rows("tree");
    let fern = rows("fern");
    let trees = [
        ("Oak", [11.5, -1.5], 0.0, 1.25),
        ("Young oak", [12.6, 0.9], 1.9, 0.9),
        ("Far oak", [16.0, -0.4], 4.1, 1.1),
    ];
    for (name, at, spin, size) in trees {
        things.push(Thing {
            name,
            tint: "leaf",
            maps: placed(&tree, rooted(at), spin, [size; 3]),
            share: 0.12,
        });
    }
    for (name, at, spin) in [("Fern", [9.6, -0.55], 0.8), ("Second fern", [9.9, 0.7], 3.6)] {
        things.push(Thing {
            name,
            tint: "leaf",
            maps: placed(&fern, rooted(at), spin, [0.075; 3]),
            share: 0.07,
        });
    }
    things
}

/// Where the ground's far edge has its middle, half of that edge and the scale of its height.
const GROUND: [f64; 3] = [24.0, 0.0, -1.75];
const HILLS: [f64; 3] = [22.0, 22.0, 2.2];

/// A place on the ground, a little below it.
fn rooted([x, y]: [f64; 2]) -> [f64; 3] {
    let height = height((x - GROUND[0]) / HILLS[0], (y - GROUND[1]) / HILLS[1]);
    [x, y, GROUND[2] + HILLS[2] * height - 0.03]
}

/// The height of the ground over a point of its triangle: the map of the part that the point is in says how it follows
/// from the height over another.
pub(super) fn height(x: f64, y: f64) -> f64 {
    let maps = ground();
    let (mut x, mut y, mut height, mut part) = (x, y, 0.0, 1.0);
    for _ in 0..60 {
        // The point that a map takes here; the map whose point lies deepest in the triangle is the one.
        let before = |map: &Affine3| {
            let [a, b, _, c, d, _, p, q, share, e, f, rise] = map.to_row();
            let det = a * d - b * c;
            let (u, v) = (x - e, y - f);
            let (u, v) = ((d * u - b * v) / det, (a * v - c * u) / det);
            let depth = (-u).min(1.0 + u - v.abs());
            (depth, u, v, p * u + q * v + rise, share)
        };
        let Some(found) = maps.iter().map(before).max_by(|a, b| a.0.total_cmp(&b.0)) else { break };
        let (_, u, v, rise, share) = found;
        (x, y) = (u, v);
        height += part * rise;
        part *= share;
    }
    height
}

fn rows(id: &str) -> Vec<Affine3> {
    preset3(id).map(|preset| preset.maps.into_iter().map(Affine3::from_row).collect()).unwrap_or_default()
}

/// The maps of a shape that is scaled, spun about z and moved (Darwish & Abd-El-Wahab, eq 1).
pub(super) fn placed(maps: &[Affine3], at: [f64; 3], spin: f64, scale: [f64; 3]) -> Vec<Row3> {
    let turn = DMat3::from_quat(DQuat::from_rotation_z(spin));
    let by = Affine3::new(turn * DMat3::from_diagonal(DVec3::from_array(scale)), DVec3::from_array(at));
    // The places above can be undone: none is flat.
    maps.iter().filter_map(|map| map.moved(by).ok()).map(Affine3::to_row).collect()
}

/// Corners of the ground: the ends of its long edge, and the corner between the short ones.
const CORNERS: [DVec2; 3] = [DVec2::new(0.0, -1.0), DVec2::new(0.0, 1.0), DVec2::new(-1.0, 0.0)];

/// How much of the heights of the ground its parts have.
const HEIGHT_SHARE: f64 = 0.46;

/// A right-angled triangle with two equal sides as the graph of a rough height.
///
/// It is halved by its axis, and the halves by theirs. Every edge between two parts comes from one and the same edge of
/// the whole, so that the heights of both agree along it as soon as what is added to a share of them does: planes
/// through given heights of the corners of the parts. The ground nowhere tears.
pub(super) fn ground() -> [Affine3; 4] {
    let [a, b, c] = CORNERS;
    let middle = 0.5 * (a + b);
    // Each half, as the images of the three corners.
    let halves = [[a, c, middle], [b, c, middle]];
    std::array::from_fn(|k| {
        // The map of a half of a half, by what becomes of the corners.
        let [first, second] = [halves[k / 2], halves[k % 2]];
        let (outer, to) = plane_map(first);
        let images = second.map(|p| outer * p + to);
        let (linear, shift) = plane_map(images);
        let rises = images.map(rise);
        // The height as a plane over the whole triangle.
        let along = rises[0] / 2.0 + rises[1] / 2.0 - rises[2];
        let across = 0.5 * (rises[1] - rises[0]);
        let level = 0.5 * (rises[0] + rises[1]);
        let [p, q] = [linear.x_axis, linear.y_axis];
        Affine3::from_row([
            p.x,
            q.x,
            0.0,
            p.y,
            q.y,
            0.0,
            along,
            across,
            HEIGHT_SHARE,
            shift.x,
            shift.y,
            level,
        ])
    })
}

/// The map of the plane that takes the corners there.
fn plane_map([a, b, c]: [DVec2; 3]) -> (DMat2, DVec2) {
    let middle = 0.5 * (a + b);
    (DMat2::from_cols(middle - c, 0.5 * (b - a)), middle)
}

/// What is added to the height at the corners of the parts.
fn rise(at: DVec2) -> f64 {
    let [first, second, front] = [0.05, -0.04, 0.0];
    let [middle, left] = [0.16, -0.03];
    // With any other height here the slopes on both sides of the axis, which runs straight away from the eye, differ on
    // the average, and a seam is seen. With s for the share, the mean slope across the long edge is the sum of those of
    // its two parts and 2s of itself; and 2s of it, with those of the parts at the axis, is to come to nothing.
    let right = middle - left + HEIGHT_SHARE * (first + second) + (1.0 - 2.0 * HEIGHT_SHARE) * front;
    let known = [
        (DVec2::ZERO, middle),
        (DVec2::new(-0.5, -0.5), left),
        (DVec2::new(-0.5, 0.5), right),
        (CORNERS[0], first),
        (CORNERS[1], second),
        (CORNERS[2], front),
    ];
    known.iter().find(|(p, _)| p.distance(at) < 1e-9).map_or(0.0, |&(_, rise)| rise)
}

/// Seven large and overlapping pieces: a heap that is denser below.
pub(super) fn cloud() -> Vec<Affine3> {
    let piece = |x: f64, y: f64, z: f64, size: f64, spin: f64| {
        let turn = DMat3::from_quat(DQuat::from_rotation_z(spin) * DQuat::from_rotation_x(0.3 * spin));
        Affine3::new(turn * size, DVec3::new(x, y, z))
    };
    vec![
        piece(0.0, 0.0, 0.0, 0.52, 0.4),
        piece(0.5, 0.12, -0.05, 0.45, 1.3),
        piece(-0.5, -0.1, -0.06, 0.46, 2.2),
        piece(0.18, 0.42, 0.02, 0.42, 3.3),
        piece(-0.2, -0.42, 0.0, 0.42, 4.4),
        piece(0.1, -0.06, 0.34, 0.4, 5.1),
        piece(-0.24, 0.2, 0.24, 0.36, 0.9),
    ]
}

#[cfg(test)]
mod tests {
    use frond_core::{Bounds3, Ifs3};

    use super::*;

    #[test]
    fn all_of_it_is_before_the_eye_and_stands_on_the_ground() {
        let things = natural_scene();
        assert!(things.len() >= 6);
        assert!((things.iter().map(|thing| thing.share).sum::<f64>() - 1.0).abs() < 1e-12);
        let ifs =
            |thing: &Thing| Ifs3::new(thing.maps.iter().copied().map(Affine3::from_row).collect()).unwrap();
        let bounds: Vec<Bounds3> = things.iter().map(|thing| Bounds3::of(&ifs(thing))).collect();
        let top = things.iter().zip(&bounds).filter(|(thing, _)| thing.tint == "leaf").map(|(_, b)| b.max.z);
        let top = top.fold(f64::NEG_INFINITY, f64::max);
        for (thing, bounds) in things.iter().zip(&bounds) {
            assert!(bounds.min.x > 0.5, "{}: {bounds:?}", thing.name);
            let foot = rooted([bounds.centre.x, bounds.centre.y])[2];
            match thing.tint {
                "cloud" => assert!(bounds.min.z > top, "{}: {bounds:?} {top}", thing.name),
                "leaf" => assert!((bounds.min.z - foot).abs() < 0.3, "{}: {bounds:?} {foot}", thing.name),
                _ => {}
            }
        }
    }

    #[test]
    fn the_ground_does_not_tear() {
        let maps = ground();
        let height = |at: DVec2| height(at.x, at.y);
        let [a, b, c] = CORNERS;
        // Each edge of the whole, as each of the parts takes it: where two land in one place they are at one height.
        let mut seen: Vec<(DVec3, f64)> = Vec::new();
        for map in &maps {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                for k in 0..=16 {
                    let at = from.lerp(to, f64::from(k) / 16.0);
                    let there = map.apply(at.extend(height(at)));
                    for (other, _) in
                        seen.iter().filter(|(p, _)| (p.truncate() - there.truncate()).length() < 1e-9)
                    {
                        assert!((other.z - there.z).abs() < 1e-9, "{other} {there}");
                    }
                    seen.push((there, there.z));
                }
            }
        }
    }

    #[test]
    fn no_seam_runs_along_the_axis_of_the_ground() {
        // How much steeper it rises to one side than it falls from the other, on the average over the axis.
        let (count, away) = (4000, 1e-3);
        let folds = (0..count).map(|k| {
            let x = -(f64::from(k) + 0.5) / f64::from(count);
            (height(x, away) + height(x, -away) - 2.0 * height(x, 0.0)) / away
        });
        let fold = folds.sum::<f64>() / f64::from(count);
        assert!(fold.abs() < 0.05, "{fold}");
    }

    #[test]
    fn the_height_is_that_of_the_ground() {
        let maps = ground();
        let mut x = DVec3::ZERO;
        for k in 0..2000_u32 {
            x = maps[frond_core::hash::counter(4, k) as usize % 4].apply(x);
            if k > 60 {
                assert!((height(x.x, x.y) - x.z).abs() < 1e-6, "{x}");
            }
        }
    }
}
