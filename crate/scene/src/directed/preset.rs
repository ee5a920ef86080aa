//! The gallery of graph-directed shapes.

use frond_core::{Affine2, DirectedMap};
use glam::{DMat2, DVec2};

/// A graph-directed shape.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectedPreset {
    /// Its name: lower case, never changed once published.
    pub id: &'static str,
    /// Its name on screen.
    pub name: &'static str,
    /// A sentence or two about it.
    pub about: &'static str,
    /// Its states, the shape itself first.
    pub states: Vec<Vec<DirectedMap>>,
}

/// All graph-directed shapes.
#[must_use]
pub fn directed_presets() -> Vec<DirectedPreset> {
    let preset = |id, name, about, states| DirectedPreset { id, name, about, states };
    vec![
        preset(
            "frond",
            "Frond",
            "A fern whose leaves stand in pairs at the end of its stem, so that it is in one piece exactly. It becomes any outline and stays in one.",
            frond(),
        ),
        preset(
            "snowflake",
            "Snowflake",
            "Koch's curve over the three sides of a triangle: an outline of three copies, and the curve that they copy.",
            outline(
                3,
                &[
                    DVec2::ZERO,
                    DVec2::new(1.0 / 3.0, 0.0),
                    DVec2::new(0.5, HEIGHT / 3.0),
                    DVec2::new(2.0 / 3.0, 0.0),
                    DVec2::X,
                ],
            ),
        ),
        preset(
            "crystal",
            "Crystal",
            "The snowflake's kin on a square, with numbers that doubles hold exactly.",
            outline(
                4,
                &[
                    DVec2::ZERO,
                    DVec2::new(0.375, 0.0),
                    DVec2::new(0.5, 0.25),
                    DVec2::new(0.625, 0.0),
                    DVec2::X,
                ],
            ),
        ),
        preset(
            "two-dragons",
            "Dragon of two states",
            "Heighway's dragon without a turn of the paper: one that folds to the left and one that folds to the right, each made of both.",
            two_dragons(DVec2::new(0.5, 0.5)),
        ),
        preset(
            "sun",
            "Penrose's sun",
            "Robinson's two triangles, each cut into copies of both by the golden ratio, and ten of the one around a point.",
            sun(),
        ),
        preset(
            "rauzy",
            "Rauzy's fractal",
            "Three tiles after the words 1 to 12, 2 to 13, 3 to 1: each is copies of others, and all together tile the plane.",
            rauzy(),
        ),
        preset(
            "pentigree",
            "Pentigree",
            "McWorter's curve of six copies, each 0.382 as long, turned by multiples of 36 degrees, and five such curves around a point.",
            pentigree(),
        ),
        preset(
            "quilt",
            "Quilt",
            "Frond's own: a square of two squares and two patches, and a patch of one square and two patches.",
            quilt(),
        ),
    ]
}

/// A fern of one state from 0 to (0, 1), in numbers that doubles hold: its leaves and the rest of it stand where its
/// stem ends.
fn frond() -> Vec<Vec<DirectedMap>> {
    let at = DVec2::new(-0.031_25, 0.125);
    let map = |x: [f64; 2], y: DVec2, at: DVec2| DirectedMap {
        from: 0,
        map: Affine2::new(DMat2::from_cols(DVec2::from_array(x), y), at),
    };
    vec![vec![
        map([0.0, 0.0], at, DVec2::ZERO),
        map([0.875, -0.031_25], DVec2::Y - at, at),
        map([0.234_375, 0.234_375], DVec2::new(-0.265_625, 0.218_75), at),
        map([-0.218_75, 0.25], DVec2::new(0.265_625, 0.203_125), at),
    ]]
}

/// Half the root of 3: the height of a triangle of side 1.
const HEIGHT: f64 = 0.866_025_403_784_438_6;

fn copy(from: usize, z: DVec2, at: DVec2) -> DirectedMap {
    DirectedMap { from, map: Affine2::new(complex(z), at) }
}

/// The matrix of the multiplication by a complex number.
fn complex(z: DVec2) -> DMat2 {
    DMat2::from_cols(z, z.perp())
}

fn degrees(angle: f64) -> DVec2 {
    Affine2::rotation(angle.to_radians()).apply(DVec2::X)
}

/// The curve that runs over these knots as over (0, 0) to (1, 0), on each side of a triangle or a square, outward.
fn outline(sides: usize, knots: &[DVec2]) -> Vec<Vec<DirectedMap>> {
    let corners: &[DVec2] = match sides {
        3 => &[DVec2::ZERO, DVec2::new(0.5, HEIGHT), DVec2::X],
        _ => &[DVec2::ZERO, DVec2::Y, DVec2::ONE, DVec2::X],
    };
    let next = |i: usize| corners[(i + 1) % corners.len()];
    let sides = (0..corners.len()).map(|i| copy(1, next(i) - corners[i], corners[i]));
    let curve = knots.windows(2).map(|pair| copy(1, pair[1] - pair[0], pair[0]));
    vec![sides.collect(), curve.collect()]
}

/// A curve over 0, the fold and 1, and its kin that folds to the other side; each is the one, then the other.
fn two_dragons(fold: DVec2) -> Vec<Vec<DirectedMap>> {
    let folded = |fold: DVec2| vec![copy(0, fold, DVec2::ZERO), copy(1, DVec2::X - fold, fold)];
    vec![folded(fold), folded(DVec2::new(fold.x, -fold.y))]
}

/// Robinson's triangles: with an apex of 36 degrees (state 2) and of 108 degrees (state 3), both with their apex at 0
/// and sides of length 1; the first of them around a point, next to each other in the mirror.
fn sun() -> Vec<Vec<DirectedMap>> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let own = [[DVec2::ZERO, DVec2::X, degrees(36.0)], [DVec2::ZERO, DVec2::X, degrees(108.0)]];
    // The map that takes the corners of a triangle to others.
    let onto = |kind: usize, [a, b, c]: [DVec2; 3]| {
        let [_, p, q] = own[kind];
        let linear = DMat2::from_cols(b - a, c - a) * DMat2::from_cols(p, q).inverse();
        DirectedMap { from: kind + 1, map: Affine2::new(linear, a) }
    };
    let along = |from: DVec2, to: DVec2| from + (to - from) / golden;
    let [[a, b, c], [d, e, f]] = own;
    let p = along(a, b);
    let (q, r) = (along(e, d), along(e, f));
    let sector = |k: usize| {
        let mirror = if k.is_multiple_of(2) { 0.0 } else { 36.0 };
        let [first, second] = [mirror, 36.0 - mirror].map(|angle| degrees(36.0 * k as f64 + angle));
        onto(0, [DVec2::ZERO, first, second])
    };
    vec![
        (0..10).map(sector).collect(),
        vec![onto(0, [c, p, b]), onto(1, [p, c, a])],
        vec![onto(1, [r, f, d]), onto(1, [q, r, e]), onto(0, [r, q, d])],
    ]
}

/// Rauzy's fractal: the tiles of the words over 1 to 12, 2 to 13, 3 to 1 (Rauzy 1982; as a graph, Arnoux & Ito 2001).
fn rauzy() -> Vec<Vec<DirectedMap>> {
    // The real root of x^3 = x^2 + x + 1; of the other two the sum is 1 less it, the product one over it.
    let beta = 1.839_286_755_214_161_1_f64;
    let real = (1.0 - beta) / 2.0;
    let alpha = DVec2::new(real, (1.0 / beta - real * real).sqrt());
    let here = |from| DirectedMap { from, map: Affine2::IDENTITY };
    vec![
        vec![here(1), here(2), here(3)],
        vec![copy(1, alpha, DVec2::ZERO), copy(2, alpha, DVec2::ZERO), copy(3, alpha, DVec2::ZERO)],
        vec![copy(1, alpha, DVec2::X)],
        vec![copy(2, alpha, DVec2::X)],
    ]
}

/// McWorter's pentigree (1987): six copies from 0 to 1, each (3 - sqrt 5) / 2 as long, and five around 0.
fn pentigree() -> Vec<Vec<DirectedMap>> {
    let length = (3.0 - 5.0_f64.sqrt()) / 2.0;
    let mut at = DVec2::ZERO;
    let step = |angle: f64| {
        let along = degrees(angle) * length;
        at += along;
        copy(1, along, at - along)
    };
    let curve = [36.0, 108.0, -36.0, -108.0, -36.0, 36.0].map(step).to_vec();
    let around = (0..5).map(|k| copy(1, degrees(72.0 * f64::from(k)), DVec2::ZERO));
    vec![around.collect(), curve]
}

fn quilt() -> Vec<Vec<DirectedMap>> {
    // Quarter turns that take the unit square to a quarter of it.
    let quarter = |from, turns: i32, x: f64, y: f64| {
        let turn = Affine2::rotation(f64::from(turns) * std::f64::consts::FRAC_PI_2).about(DVec2::splat(0.5));
        DirectedMap { from, map: Affine2::new(DMat2::IDENTITY * 0.5, DVec2::new(x, y)) * turn }
    };
    vec![
        vec![
            quarter(0, 0, 0.0, 0.0),
            quarter(1, 1, 0.5, 0.0),
            quarter(0, 2, 0.5, 0.5),
            quarter(1, 3, 0.0, 0.5),
        ],
        vec![quarter(0, 0, 0.0, 0.0), quarter(1, 0, 0.5, 0.0), quarter(1, 0, 0.0, 0.5)],
    ]
}
