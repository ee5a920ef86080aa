//! The gallery of space.

use std::sync::LazyLock;

use frond_core::Affine3;
use glam::{DMat3, DQuat, DVec3};

/// The row of a map of space: the three rows of the matrix, then the translation.
pub type Row3 = [f64; 12];

/// A shape of the gallery of space.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset3 {
    /// Its name in links: lower case, never changed once published.
    pub id: &'static str,
    /// Its name on screen.
    pub name: &'static str,
    /// A sentence about it.
    pub about: &'static str,
    /// Its maps.
    pub maps: Vec<Row3>,
}

/// Half the root of 3: the height of a triangle of side 1.
const HEIGHT: f64 = 0.866_025_403_784_438_6;
const THIRD: f64 = 1.0 / 3.0;

/// All shapes of the gallery of space, in its order. z points up.
#[must_use]
pub fn presets3() -> &'static [Preset3] {
    static SHAPES: LazyLock<Vec<Preset3>> = LazyLock::new(shapes);
    &SHAPES
}

fn shapes() -> Vec<Preset3> {
    let preset = |id, name, about, maps: Vec<Affine3>| Preset3 {
        id,
        name,
        about,
        maps: maps.into_iter().map(Affine3::to_row).collect(),
    };
    vec![
        preset(
            "tetrahedron",
            "Tetrahedron",
            "Four copies, each half as long, that touch in the middles of its edges: from some sides it looks like a filled square.",
            shrunk(0.5, &TETRAHEDRON),
        ),
        preset(
            "tetrahedron-strung",
            "Strung tetrahedron",
            "The same tetrahedron of four copies, each half as long, but turned so that a single thread runs through all of it.",
            strung(0.0),
        ),
        preset(
            "dragon",
            "Dragon of space",
            "The strung tetrahedron, its four copies, each half as long, twisted about their threads by a third of a turn: still one thread.",
            strung(1.0),
        ),
        preset(
            "dragon-folded",
            "Folded dragon",
            "A thread of four copies, each half as long: it bends at right angles alone, in all three directions.",
            folded(),
        ),
        preset(
            "dragon-curled",
            "Curled dragon",
            "Four copies, each 0.58 as long, turned by a sixth of a turn about the lines through the tetrahedron's corners.",
            curled(),
        ),
        preset(
            "pyramid",
            "Pyramid",
            "Five copies, each half as long, around (15, 0, 0). The eye of Darwish & Abd-El-Wahab is at the origin, and their pyramid 30 units away.",
            pyramid(),
        ),
        preset(
            "triangle",
            "Triangle in space",
            "Sierpinski's triangle as a sheet of no thickness, tilted about x, y and z.",
            triangle(),
        ),
        preset(
            "sponge",
            "Menger sponge",
            "Twenty copies of a cube, each a third as long: no volume, and no end of surface.",
            sponge(),
        ),
        preset(
            "octahedron",
            "Octahedron",
            "Six copies, each half as long: they meet along their edges and in the middle.",
            shrunk(0.5, &OCTAHEDRON),
        ),
        preset(
            "fern",
            "Fern",
            "A stem, the frond above it that leans back, and two leaflets held forward.",
            fern(),
        ),
        preset("tree", "Tree", "A trunk, three boughs around it, and a leader between them.", tree()),
        preset(
            "koch",
            "Koch surface",
            "A square sheet with a cube folded out of its middle: thirteen copies, each a third as long.",
            koch(),
        ),
        preset(
            "dust",
            "Cantor dust",
            "Eight copies, each a third as long, in the corners of a cube: nothing but single points.",
            shrunk(THIRD, &CUBE),
        ),
    ]
}

/// The shape of the gallery of space with this id.
#[must_use]
pub fn preset3(id: &str) -> Option<Preset3> {
    presets3().iter().find(|preset| preset.id == id).cloned()
}

const TETRAHEDRON: [DVec3; 4] = [
    DVec3::new(1.0, 1.0, 1.0),
    DVec3::new(1.0, -1.0, -1.0),
    DVec3::new(-1.0, 1.0, -1.0),
    DVec3::new(-1.0, -1.0, 1.0),
];
const OCTAHEDRON: [DVec3; 6] = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
const CUBE: [DVec3; 8] = [
    DVec3::new(0.0, 0.0, 0.0),
    DVec3::new(1.0, 0.0, 0.0),
    DVec3::new(0.0, 1.0, 0.0),
    DVec3::new(1.0, 1.0, 0.0),
    DVec3::new(0.0, 0.0, 1.0),
    DVec3::new(1.0, 0.0, 1.0),
    DVec3::new(0.0, 1.0, 1.0),
    DVec3::new(1.0, 1.0, 1.0),
];

/// Copies scaled by `r`, without a turn, each with its fixed point at one of `corners`.
fn shrunk(r: f64, corners: &[DVec3]) -> Vec<Affine3> {
    corners.iter().map(|&corner| Affine3::scaling(DVec3::splat(r)).about(corner)).collect()
}

/// The tetrahedron on the thread from its first corner to its last, which runs along one edge of each half; `twist`
/// turns every half about its thread, by a third of a turn at 1.
///
/// Each map takes the thread's ends to the ends of its own part of the thread. The thread starts at 0 and is left where
/// it is by a twist about itself, so that the translations are the same whatever the twist: the halves share the ends
/// of their parts, and the shape is in one piece at every twist.
fn strung(twist: f64) -> Vec<Affine3> {
    let [a, b, c, d] = TETRAHEDRON;
    let stops = [a, a.midpoint(b), b.midpoint(c), c.midpoint(d), d];
    let thread = d - a;
    let turn = DMat3::from_axis_angle(thread.normalize(), twist * std::f64::consts::TAU / 3.0);
    (0..4)
        .map(|k| {
            let half = turned_onto(thread, (stops[k + 1] - stops[k]) * 2.0) * 0.5;
            Affine3::new(if twist == 0.0 { half } else { half * turn }, stops[k] - a)
        })
        .collect()
}

/// The turn of the tetrahedron onto itself that takes one of its directed edges to another.
fn turned_onto(from: DVec3, to: DVec3) -> DMat3 {
    // The turns of the tetrahedron are the even permutations of the axes with an even number of signs.
    let axes = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];
    let signs = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let turns = axes.iter().flat_map(|order| {
        signs.iter().map(move |sign| {
            let row = |k: usize| DVec3::AXES[order[k]] * sign[k];
            DMat3::from_cols(row(0), row(1), row(2)).transpose()
        })
    });
    turns
        .min_by(|a, b| (*a * from).distance(to).total_cmp(&(*b * from).distance(to)))
        .unwrap_or(DMat3::IDENTITY)
}

/// Four halves of a thread along x, by quarter turns alone.
fn folded() -> Vec<Affine3> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    // Where x and y of each half go; z follows. The steps are up, along, down, along.
    let frames = [(y, z), (x, z), (-y, x), (x, -z)];
    let mut stop = DVec3::ZERO;
    frames
        .iter()
        .map(|&(along, beside)| {
            let map = Affine3::new(DMat3::from_cols(along, beside, along.cross(beside)) * 0.5, stop);
            stop += along * 0.5;
            map
        })
        .collect()
}

/// The tetrahedron with larger pieces, turned and drawn halfway to the next corner: straight there the tetrahedron
/// breaks, but there is a way round.
fn curled() -> Vec<Affine3> {
    (0..4)
        .map(|k| {
            let (corner, next) = (TETRAHEDRON[k], TETRAHEDRON[(k + 1) % 4]);
            let turn = DQuat::from_axis_angle(corner.normalize(), std::f64::consts::FRAC_PI_3);
            Affine3::similitude(0.58, turn, (corner + next) * 0.25)
        })
        .collect()
}

/// The pyramid of Darwish & Abd-El-Wahab's figure v, rebuilt: four corners of a base and an apex, 15 units before the
/// eye.
fn pyramid() -> Vec<Affine3> {
    let corners =
        [[-0.4, -0.4, -0.3], [-0.4, 0.4, -0.3], [0.4, 0.4, -0.3], [0.4, -0.4, -0.3], [0.0, 0.0, 0.3]];
    let corners = corners.map(|corner| DVec3::from_array(corner) + DVec3::new(15.0, 0.0, 0.0));
    shrunk(0.5, &corners)
}

/// Three halves that are flat across their plane, turned about x, then y, then z.
fn triangle() -> Vec<Affine3> {
    let corners = [[-0.5, 0.0, -HEIGHT / 3.0], [0.5, 0.0, -HEIGHT / 3.0], [0.0, 0.0, 2.0 * HEIGHT / 3.0]];
    let tilt = DMat3::from_quat(
        DQuat::from_rotation_z(0.5) * DQuat::from_rotation_y(0.25) * DQuat::from_rotation_x(-0.4),
    );
    let flat = DMat3::from_diagonal(DVec3::new(0.5, 0.0, 0.5));
    let linear = tilt * flat * tilt.transpose();
    corners
        .iter()
        .map(|&corner| {
            let corner = tilt * DVec3::from_array(corner);
            Affine3::new(linear, corner - linear * corner)
        })
        .collect()
}

fn sponge() -> Vec<Affine3> {
    let cells = (0..27).map(|k: u32| [k % 3, k / 3 % 3, k / 9]);
    let kept = cells.filter(|cell| cell.iter().filter(|&&at| at == 1).count() < 2);
    kept.map(|cell| {
        let shift = DVec3::from_array(cell.map(|at| f64::from(at) / 3.0));
        Affine3::new(DMat3::from_diagonal(DVec3::splat(THIRD)), shift)
    })
    .collect()
}

/// Scales, tilts about x (forward), leans about y (to the side) and spins about z, then moves up to `height`.
fn branch(scale: DVec3, tilt: f64, lean: f64, spin: f64, height: f64) -> Affine3 {
    let turn = DQuat::from_rotation_z(spin) * DQuat::from_rotation_y(lean) * DQuat::from_rotation_x(tilt);
    Affine3::new(DMat3::from_quat(turn) * DMat3::from_diagonal(scale), DVec3::new(0.0, 0.0, height))
}

fn fern() -> Vec<Affine3> {
    vec![
        branch(DVec3::new(0.02, 0.02, 0.18), 0.0, 0.0, 0.0, 0.0),
        branch(DVec3::splat(0.85), -0.07, 0.03, 0.02, 1.6),
        branch(DVec3::new(0.3, 0.28, 0.34), 0.35, 1.05, 0.12, 1.5),
        branch(DVec3::new(0.3, 0.28, 0.36), 0.35, -1.05, -0.12, 1.15),
    ]
}

fn tree() -> Vec<Affine3> {
    let third = std::f64::consts::TAU / 3.0;
    let bough =
        |k: f64, height: f64| branch(DVec3::splat(0.56), 0.0, 0.72 + 0.05 * k, k * third + 0.4, height);
    vec![
        branch(DVec3::new(0.06, 0.06, 0.55), 0.0, 0.0, 0.0, 0.0),
        bough(0.0, 0.42),
        bough(1.0, 0.48),
        bough(2.0, 0.52),
        branch(DVec3::splat(0.58), 0.06, 0.05, 1.1, 0.55),
    ]
}

/// Koch's curve of the square kind, once more over: eight cells around a square, and five sides of a cube on the ninth.
fn koch() -> Vec<Affine3> {
    // A sheet from 0 to 1 in x and y, its outside up.
    let sheet = |corner: [f64; 3], along: DVec3, across: DVec3| {
        let linear = DMat3::from_cols(along, across, along.cross(across)) * THIRD;
        Affine3::new(linear, DVec3::from_array(corner) * THIRD)
    };
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let around = (0..9).filter(|&k| k != 4).map(|k| sheet([f64::from(k % 3), f64::from(k / 3), 0.0], x, y));
    let sides = [
        sheet([1.0, 1.0, 1.0], x, y),
        sheet([1.0, 1.0, 0.0], x, z),
        sheet([2.0, 1.0, 0.0], y, z),
        sheet([2.0, 2.0, 0.0], -x, z),
        sheet([1.0, 2.0, 0.0], -y, z),
    ];
    around.chain(sides).collect()
}

#[cfg(test)]
mod tests {
    use frond_core::{Bounds3, Ifs3, similarity_dimension};

    use super::*;

    fn ifs(id: &str) -> Ifs3 {
        Ifs3::new(preset3(id).unwrap().maps.into_iter().map(Affine3::from_row).collect()).unwrap()
    }

    #[test]
    fn every_shape_has_an_attractor_and_a_name_of_its_own() {
        let all = presets3();
        assert!(all.len() >= 11);
        for (i, preset) in all.iter().enumerate() {
            let ifs = ifs(preset.id);
            assert!(ifs.len() >= 2 && Bounds3::of(&ifs).radius > 0.1, "{}", preset.id);
            assert!(all[..i].iter().all(|other| other.id != preset.id && other.name != preset.name));
            assert!(preset.id.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'));
            assert!(preset.about.ends_with('.'));
        }
    }

    #[test]
    fn the_classics_have_their_dimensions() {
        for (id, dimension) in [
            ("tetrahedron", 2.0),
            ("tetrahedron-strung", 2.0),
            ("dragon", 2.0),
            ("dragon-folded", 2.0),
            ("pyramid", 5.0_f64.log2()),
            ("octahedron", 6.0_f64.log2()),
            ("sponge", 20.0_f64.ln() / 3.0_f64.ln()),
            ("koch", 13.0_f64.ln() / 3.0_f64.ln()),
        ] {
            let found = similarity_dimension(&ifs(id)).unwrap();
            assert!((found - dimension).abs() < 1e-9, "{id}: {found}");
        }
    }

    #[test]
    fn the_strung_tetrahedron_is_the_tetrahedron() {
        // Moved to where it starts at 0, it lies in the four halves of the plain one.
        let plain = shrunk(0.5, &TETRAHEDRON);
        let moved = Affine3::moving(-TETRAHEDRON[0]);
        let mut plain: Vec<[i64; 3]> = plain
            .iter()
            .map(|map| {
                map.conjugate(moved)
                    .unwrap()
                    .apply(-TETRAHEDRON[0])
                    .to_array()
                    .map(|x| (x * 1e9).round() as i64)
            })
            .collect();
        // The middle of the shape goes to the middles of the halves.
        let mut found: Vec<[i64; 3]> = strung(0.0)
            .iter()
            .map(|map| map.apply(-TETRAHEDRON[0]).to_array().map(|x| (x * 1e9).round() as i64))
            .collect();
        plain.sort_unstable();
        found.sort_unstable();
        assert_eq!(plain, found);
    }

    #[test]
    fn threads_are_chains() {
        for maps in [strung(0.0), strung(0.37), strung(1.0), folded()] {
            let (start, end) = (maps[0].fixed_point().unwrap(), maps[3].fixed_point().unwrap());
            for pair in maps.windows(2) {
                assert!(pair[0].apply(end).distance(pair[1].apply(start)) < 1e-12, "{maps:?}");
            }
        }
    }

    #[test]
    fn the_pyramid_is_fifteen_units_before_the_eye() {
        let bounds = Bounds3::of(&ifs("pyramid"));
        assert!((bounds.centre.x - 15.0).abs() < 0.05 && bounds.radius < 1.0, "{bounds:?}");
    }
}
