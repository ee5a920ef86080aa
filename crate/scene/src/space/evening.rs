//! A natural scene in evening light: hills, trees with bark and leaves, ferns and clouds.

use std::f64::consts::TAU;
use std::sync::LazyLock;

use frond_core::Affine3;
use glam::{DMat3, DQuat, DVec3};

use crate::space::natural::{ground, height, placed};
use crate::space::preset::{Row3, preset3};

/// An object of the scene.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Thing {
    /// Its name on screen.
    pub name: &'static str,
    /// The colour of all of it, `#rrggbb`.
    pub tint: &'static str,
    /// Its maps, with its place in them: to move it is to conjugate them.
    pub maps: Vec<Row3>,
}

/// What the scene is seen before: the sky near the horizon.
pub(super) const SKY: &str = "#e9d2b4";

const MEADOW: &str = "#7f8a45";
const FAR_HILLS: &str = "#6f7f74";
const BARK: &str = "#6b4a32";
const CLOUD: &str = "#f1ece8";
const FERN: &str = "#4f8f3c";

/// Where the far edge of the meadow has its middle, half of that edge and the scale of its height.
const MEADOW_AT: [f64; 3] = [30.0, 0.0, -1.85];
const MEADOW_SIZE: [f64; 3] = [34.0, 34.0, 4.2];
/// It is turned, so that its axis does not run straight away from the eye.
const MEADOW_TURN: f64 = 0.25;

/// Numbers of maps have as many decimals, so that they can be read in a table.
const DECIMALS: f64 = 1e4;

/// All of them attractors, z up, the eye at the origin and the scene along x, as in the paper (Darwish & Abd-El-Wahab,
/// figure vii, whose parameters are not printed: this one is Frond's own).
pub(super) fn evening_scene() -> &'static [Thing] {
    static THINGS: LazyLock<Vec<Thing>> = LazyLock::new(things);
    &THINGS
}

fn things() -> Vec<Thing> {
    let thing = |name, tint, maps: Vec<Row3>| Thing { name, tint, maps: maps.iter().map(readable).collect() };
    let fern: Vec<Affine3> = preset3("fern")
        .map(|fern| fern.maps.into_iter().map(Affine3::from_row).collect())
        .unwrap_or_default();
    let mut things = vec![
        thing("Meadow", MEADOW, placed(&ground(), MEADOW_AT, MEADOW_TURN, MEADOW_SIZE)),
        thing("Far hills", FAR_HILLS, placed(&ground(), [50.0, 3.0, -2.3], -0.12, [30.0, 30.0, 14.0])),
        thing("Cloud", CLOUD, placed(&cloud(), [17.0, -2.9, 2.6], 0.3, [2.2, 2.6, 0.9])),
        thing("Small cloud", CLOUD, placed(&cloud(), [19.0, 3.0, 3.1], 2.0, [1.5, 1.9, 0.6])),
    ];
    let trees = [
        ("Oak", "#5c8a35", [11.2, -1.5], 0.0, 1.45),
        ("Golden birch", "#c39432", [13.4, 1.35], 1.9, 1.25),
        ("Far oak", "#4f7d3d", [17.5, -0.35], 4.1, 1.35),
    ];
    for (name, leaves, at, spin, size) in trees {
        let foot = rooted(at);
        things.push(thing(name, leaves, placed(&crown(), foot, spin, [size; 3])));
        let thick = 0.075 * size;
        things.push(thing("Trunk", BARK, placed(&trunk(), foot, spin, [thick, thick, 0.62 * size])));
    }
    for (name, at, spin, size) in [
        ("Fern", [8.6, 0.75], 0.8, 0.085),
        ("Second fern", [9.2, -0.45], 3.6, 0.07),
        ("Third fern", [8.1, 1.15], 2.2, 0.06),
    ] {
        things.push(thing(name, FERN, placed(&fern, rooted(at), spin, [size; 3])));
    }
    things
}

/// A place on the meadow, a little below it.
fn rooted([x, y]: [f64; 2]) -> [f64; 3] {
    let (sin, cos) = MEADOW_TURN.sin_cos();
    let (u, v) = (x - MEADOW_AT[0], y - MEADOW_AT[1]);
    let height = height((u * cos + v * sin) / MEADOW_SIZE[0], (v * cos - u * sin) / MEADOW_SIZE[1]);
    [x, y, MEADOW_AT[2] + MEADOW_SIZE[2] * height - 0.05]
}

fn readable(row: &Row3) -> Row3 {
    row.map(|x| (x * DECIMALS).round() / DECIMALS)
}

/// A column of fibres that twists a little and grows thinner: five thinner ones around, below and above.
fn trunk() -> Vec<Affine3> {
    let fibre = |k: usize| {
        let (level, angle) = ((k / 5) as f64, (k % 5) as f64 * TAU / 5.0 + 0.6 * (k / 5) as f64);
        let (wide, apart) = (0.46 - 0.06 * level, 0.54 - 0.12 * level);
        let turn = DMat3::from_quat(DQuat::from_rotation_z(angle));
        let (sin, cos) = angle.sin_cos();
        Affine3::new(
            turn * DMat3::from_diagonal(DVec3::new(wide, wide, 0.52)),
            DVec3::new(apart * cos, apart * sin, 0.48 * level),
        )
    };
    (0..10).map(fibre).collect()
}

/// Five large and overlapping pieces side by side, and two on top.
fn cloud() -> Vec<Affine3> {
    let piece = |x: f64, y: f64, z: f64, size: f64, spin: f64| {
        let turn = DMat3::from_quat(DQuat::from_rotation_z(spin) * DQuat::from_rotation_x(0.3 * spin));
        Affine3::new(turn * size, DVec3::new(x, y, z))
    };
    vec![
        piece(0.0, 0.0, 0.0, 0.62, 0.4),
        piece(0.46, 0.12, -0.05, 0.52, 1.3),
        piece(-0.46, -0.1, -0.06, 0.54, 2.2),
        piece(0.18, 0.4, 0.02, 0.5, 3.3),
        piece(-0.2, -0.4, 0.0, 0.5, 4.4),
        piece(0.1, -0.06, 0.3, 0.5, 5.1),
        piece(-0.24, 0.2, 0.22, 0.45, 0.9),
    ]
}

/// Three boughs of leaves around, and one on top.
fn crown() -> Vec<Affine3> {
    let bough = |size: f64, lean: f64, spin: f64, height: f64| {
        let turn = DQuat::from_rotation_z(spin) * DQuat::from_rotation_y(lean);
        Affine3::new(DMat3::from_quat(turn) * size, DVec3::Z * height)
    };
    let third = TAU / 3.0;
    vec![
        bough(0.56, 0.78, 0.4, 0.42),
        bough(0.56, 0.83, 0.4 + third, 0.48),
        bough(0.56, 0.88, 0.4 + 2.0 * third, 0.52),
        bough(0.58, 0.08, 1.1, 0.55),
    ]
}

#[cfg(test)]
mod tests {
    use frond_core::{Bounds3, Ifs3};

    use super::*;

    fn ifs(thing: &Thing) -> Ifs3 {
        Ifs3::new(thing.maps.iter().copied().map(Affine3::from_row).collect()).unwrap()
    }

    #[test]
    fn all_of_it_is_before_the_eye_and_trees_stand_on_the_meadow() {
        let things = evening_scene();
        for thing in things {
            let bounds = Bounds3::of(&ifs(thing));
            assert!(bounds.min.x > 0.5 || thing.tint == MEADOW, "{}: {bounds:?}", thing.name);
            let foot = rooted([bounds.centre.x, bounds.centre.y])[2];
            if thing.tint == BARK || thing.tint == FERN {
                assert!((bounds.min.z - foot).abs() < 0.3, "{}: {bounds:?} {foot}", thing.name);
            }
            if thing.tint == CLOUD {
                assert!(bounds.min.z > 0.9, "{}: {bounds:?}", thing.name);
            }
        }
    }

    #[test]
    fn its_maps_can_be_read_in_a_table() {
        for thing in evening_scene() {
            assert!(thing.maps.len() <= 10, "{}", thing.name);
            for x in thing.maps.iter().flatten() {
                assert!(format!("{x}").trim_start_matches('-').len() <= 7, "{}: {x}", thing.name);
            }
        }
    }
}
