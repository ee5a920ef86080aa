//! A natural scene of several objects.

use frond_core::Affine3;
use glam::{DMat3, DQuat, DVec3};

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

/// Hills with a wood on them under two clouds, all of them attractors, z up, the eye at the origin and the scene along x, as
/// in the paper (Darwish & Abd-El-Wahab, figure vii, whose parameters are not printed: this one is Frond's own).
#[must_use]
pub fn natural_scene() -> Vec<Thing> {
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

/// Where the middle of the ground is, and half its sides and the scale of its height.
const GROUND: [f64; 3] = [14.0, 0.0, -1.6];
const HILLS: [f64; 3] = [9.0, 9.0, 2.2];

/// A place on the ground, a little below it.
fn rooted([x, y]: [f64; 2]) -> [f64; 3] {
    let height = height((x - GROUND[0]) / HILLS[0], (y - GROUND[1]) / HILLS[1]);
    [x, y, GROUND[2] + HILLS[2] * height - 0.03]
}

/// The height of the ground over a point of its square: the map of the quarter that the point is in says how it follows
/// from the height over another.
fn height(x: f64, y: f64) -> f64 {
    let maps = ground().map(Affine3::to_row);
    let (mut x, mut y, mut height, mut part) = (x, y, 0.0, 1.0);
    for _ in 0..40 {
        let row = maps[usize::from(x >= 0.0) + 2 * usize::from(y >= 0.0)];
        (x, y) = (((x - row[9]) * 2.0).clamp(-1.0, 1.0), ((y - row[10]) * 2.0).clamp(-1.0, 1.0));
        height += part * (row[6] * x + row[7] * y + row[11]);
        part *= row[8];
    }
    height
}

fn rows(id: &str) -> Vec<Affine3> {
    preset3(id).map(|preset| preset.maps.into_iter().map(Affine3::from_row).collect()).unwrap_or_default()
}

/// The maps of a shape that is scaled, spun about z and moved (Darwish & Abd-El-Wahab, eq 1).
fn placed(maps: &[Affine3], at: [f64; 3], spin: f64, scale: [f64; 3]) -> Vec<Row3> {
    let turn = DMat3::from_quat(DQuat::from_rotation_z(spin));
    let by = Affine3::new(turn * DMat3::from_diagonal(DVec3::from_array(scale)), DVec3::from_array(at));
    // The places above can be undone: none is flat.
    maps.iter().filter_map(|map| map.moved(by).ok()).map(Affine3::to_row).collect()
}

/// A square from -1 to 1 as the graph of a rough height: four quarters of the square, each with its own slopes.
///
/// A map of a quarter keeps x and y and adds to a share of the height a plane that agrees with the heights of its
/// corners; since quarters share corners and the share is the same, the ground does not tear (an affine interpolating
/// surface would need heights along edges to agree as well: steps that remain are as small as the share).
fn ground() -> [Affine3; 4] {
    let heights: [[f64; 3]; 3] = [[0.05, -0.12, 0.1], [-0.05, 0.22, -0.1], [0.02, -0.08, 0.16]];
    let share = 0.42;
    std::array::from_fn(|k| {
        let (i, j) = (k % 2, k / 2);
        let corner = |a: usize, b: usize| heights[j + b][i + a];
        // The plane through the quarter's corners, by least squares.
        let mean = 0.25 * (corner(0, 0) + corner(1, 0) + corner(0, 1) + corner(1, 1));
        let along = 0.25 * (corner(1, 0) + corner(1, 1) - corner(0, 0) - corner(0, 1));
        let across = 0.25 * (corner(0, 1) + corner(1, 1) - corner(0, 0) - corner(1, 0));
        let (x, y) = (i as f64 - 0.5, j as f64 - 0.5);
        Affine3::from_row([0.5, 0.0, 0.0, 0.0, 0.5, 0.0, along, across, share, x, y, mean])
    })
}

/// Seven large and overlapping pieces: a heap that is denser below.
fn cloud() -> Vec<Affine3> {
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
