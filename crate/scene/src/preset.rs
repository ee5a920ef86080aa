//! The gallery.

use frond_core::Affine2;

/// The row of a map, `[a, b, c, d, e, f]`.
pub type Row = [f64; 6];

/// A shape of the gallery.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// Its name in links: lower case, never changed once published.
    pub id: &'static str,
    /// Its name on screen.
    pub name: &'static str,
    /// A sentence about it.
    pub about: &'static str,
    /// Its maps.
    pub maps: Vec<Row>,
}

/// Half the root of 3: the height of a triangle of side 1.
const HEIGHT: f64 = 0.866_025_403_784_438_6;
const THIRD: f64 = 1.0 / 3.0;

/// All shapes of the gallery, in its order.
#[must_use]
pub fn presets() -> Vec<Preset> {
    let preset = |id, name, about, maps| Preset { id, name, about, maps };
    vec![
        preset(
            "gasket",
            "Gasket",
            "Sierpinski's triangle: three copies, each half as long, that touch in single points.",
            gasket(),
        ),
        preset(
            "dragon",
            "Dragon",
            "Heighway's dragon, a strip of paper folded for ever: two copies, each 1/√2 as long.",
            dragon(),
        ),
        preset(
            "dragon-3",
            "Dragon of three",
            "Heighway's dragon again, its second copy split in two, so that it has three maps.",
            dragon_of_three(),
        ),
        preset(
            "terdragon",
            "Terdragon",
            "Three copies, each 1/√3 as long, turned by 30 or 90 degrees.",
            terdragon(1.0),
        ),
        preset(
            "terdragon-mirrored",
            "Mirrored terdragon",
            "Three copies, each 1/√3 as long: the terdragon in the mirror, which has another morph.",
            terdragon(-1.0),
        ),
        preset(
            "twindragon",
            "Twin-dragon",
            "Two copies, each 1/√2 as long: two dragons back to back, which tile the plane.",
            vec![[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]],
        ),
        preset(
            "levy",
            "Lévy curve",
            "Two copies, each 1/√2 as long, turned outward by 45 degrees: a curve that becomes a tapestry.",
            vec![[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [0.5, 0.5, -0.5, 0.5, 0.5, 0.5]],
        ),
        preset(
            "koch",
            "Koch curve",
            "Four copies, each a third as long: an endless coast over a finite line.",
            koch(),
        ),
        preset(
            "carpet",
            "Carpet",
            "Sierpinski's carpet: eight copies, each a third as long, around an empty middle.",
            carpet(),
        ),
        preset("vicsek", "Vicsek cross", "Five copies, each a third as long, in a cross.", vicsek()),
        preset(
            "pentagon",
            "Pentagon gasket",
            "Five copies, each 0.382 as long: just large enough to touch.",
            pentagon(),
        ),
        preset(
            "hexagon",
            "Hexagon gasket",
            "Six copies, each a third as long, around a star, with Koch's curve inside.",
            hexagon(),
        ),
        preset(
            "hexaflake",
            "Hexaflake",
            "The hexagon gasket with its middle filled: seven copies, each a third as long.",
            hexaflake(),
        ),
        preset(
            "gosper",
            "Gosper island",
            "Seven copies, each 1/√7 as long: a ragged hexagon that tiles the plane.",
            gosper(),
        ),
        preset(
            "fern",
            "Fern",
            "Barnsley's fern: a stem, two leaflets and the rest of the fern.",
            vec![
                [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
                [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
                [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
                [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
            ],
        ),
        preset("maple", "Maple of four", "Three lobes and a stalk, drawn for Frond.", maple()),
        preset("tree", "Tree", "A trunk, two large boughs and a small one between them.", tree()),
        preset(
            "spiral",
            "Spiral",
            "One map that turns and barely shrinks, and a small one that grows its arms.",
            vec![[0.8645, -0.3147, 0.3147, 0.8645, 0.0, 0.0], [0.15, -0.2598, 0.2598, 0.15, 0.8, 0.1]],
        ),
        preset(
            "dust",
            "Cantor dust",
            "Four copies, each 0.4 as long and too small to meet: nothing but single points.",
            dust(),
        ),
        preset(
            "twigs",
            "Twigs",
            "A stalk and two twigs, each the whole in small.",
            vec![
                [0.02, 0.0, 0.0, 0.42, 0.0, 0.0],
                [0.56, -0.4, 0.4, 0.56, 0.0, 0.3],
                [0.5, 0.42, -0.42, 0.5, 0.0, 0.3],
            ],
        ),
    ]
}

/// The shape of the gallery with this id.
#[must_use]
pub fn preset(id: &str) -> Option<Preset> {
    presets().into_iter().find(|preset| preset.id == id)
}

/// Copies by one linear part, and moved.
fn copies(linear: [f64; 4], shifts: &[[f64; 2]]) -> Vec<Row> {
    let [a, b, c, d] = linear;
    shifts.iter().map(|[e, f]| [a, b, c, d, *e, *f]).collect()
}

/// Copies scaled by `ratio`, without a turn, and moved.
fn shrunk(ratio: f64, shifts: &[[f64; 2]]) -> Vec<Row> {
    copies([ratio, 0.0, 0.0, ratio], shifts)
}

/// Copies scaled by a third into cells of a 3 x 3 board.
fn board(cells: &[[u8; 2]]) -> Vec<Row> {
    cells.iter().map(|[x, y]| [THIRD, 0.0, 0.0, THIRD, f64::from(*x) / 3.0, f64::from(*y) / 3.0]).collect()
}

fn gasket() -> Vec<Row> {
    vec![
        [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
        [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
        [0.5, 0.0, 0.0, 0.5, 0.25, HEIGHT / 2.0],
    ]
}

fn dragon() -> Vec<Row> {
    vec![[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]]
}

/// `{w1, w2 w1, w2 w2}` of the dragon: the same attractor.
fn dragon_of_three() -> Vec<Row> {
    let two: Vec<Affine2> = dragon().into_iter().map(Affine2::from_row).collect();
    [two[0], two[1] * two[0], two[1] * two[1]].map(Affine2::to_row).to_vec()
}

/// `{l z, -i z / sqrt 3 + l, l z + conj l}` with `l = 1/2 + i / (2 sqrt 3)`; `side` -1 mirrors it.
fn terdragon(side: f64) -> Vec<Row> {
    let (re, im) = (0.5, side * HEIGHT / 3.0);
    vec![[re, -im, im, re, 0.0, 0.0], [0.0, 2.0 * im, -2.0 * im, 0.0, re, im], [re, -im, im, re, re, -im]]
}

fn koch() -> Vec<Row> {
    let (c, s) = (THIRD / 2.0, THIRD * HEIGHT);
    vec![
        [THIRD, 0.0, 0.0, THIRD, 0.0, 0.0],
        [c, -s, s, c, THIRD, 0.0],
        [c, s, -s, c, 0.5, s],
        [THIRD, 0.0, 0.0, THIRD, 2.0 * THIRD, 0.0],
    ]
}

fn carpet() -> Vec<Row> {
    board(&[[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]])
}

fn vicsek() -> Vec<Row> {
    board(&[[1, 1], [0, 0], [2, 0], [2, 2], [0, 2]])
}

// What is not a fraction of few digits below is the double nearest to the number that is meant: what Frond proves of
// the gallery, it proves of these numbers.

fn pentagon() -> Vec<Row> {
    // 1 / golden ratio^2, and the corners of a regular pentagon over the golden ratio, one on top.
    let ratio = 0.381_966_011_250_105_15;
    let (x1, y1) = (0.587_785_252_292_473_1, 0.190_983_005_625_052_58);
    let (x2, y2) = (0.363_271_264_002_680_45, -0.5);
    shrunk(ratio, &[[0.0, 0.618_033_988_749_894_9], [-x1, y1], [-x2, y2], [x2, y2], [x1, y1]])
}

/// The middle, and the corners of the hexagon of size 2/3 around it.
const HEXAGON: [[f64; 2]; 7] = {
    // sqrt 3 / 3.
    let height = 0.577_350_269_189_625_7;
    let (far, near) = (2.0 / 3.0, THIRD);
    [[0.0, 0.0], [far, 0.0], [near, height], [-near, height], [-far, 0.0], [-near, -height], [near, -height]]
};

fn hexagon() -> Vec<Row> {
    shrunk(THIRD, &HEXAGON[1..])
}

fn hexaflake() -> Vec<Row> {
    shrunk(THIRD, &HEXAGON)
}

/// Seven copies scaled by 1 / sqrt 7 and turned, one in the middle and six around it.
fn gosper() -> Vec<Row> {
    // 1 / (2 + w) with w = (1 + i sqrt 3) / 2, whose square is 1/7, and its products with the powers of w.
    let (re, im) = (5.0 / 14.0, -0.123_717_914_826_348_38);
    let (x, y) = (2.0 / 7.0, 0.247_435_829_652_696_75);
    let (p, q) = (-1.0 / 14.0, 0.371_153_744_479_045_14);
    copies([re, -im, im, re], &[[0.0, 0.0], [re, im], [x, y], [p, q], [-re, -im], [-x, -y], [-p, -q]])
}

fn maple() -> Vec<Row> {
    vec![
        [0.02, 0.0, 0.0, 0.4, 0.0, -0.6],
        [0.48, 0.0, 0.0, 0.6, 0.0, 0.4],
        [0.3, -0.55, 0.55, 0.35, -0.35, 0.0],
        [0.3, 0.55, -0.55, 0.35, 0.35, 0.0],
    ]
}

fn tree() -> Vec<Row> {
    vec![
        [0.04, 0.0, 0.0, 0.5, 0.0, 0.0],
        [0.514, -0.3467, 0.3467, 0.514, 0.0, 0.44],
        [0.4443, 0.3728, -0.3728, 0.4443, 0.0, 0.36],
        [0.3565, -0.0501, 0.0501, 0.3565, 0.0, 0.44],
    ]
}

fn dust() -> Vec<Row> {
    shrunk(0.4, &[[0.0, 0.0], [0.6, 0.0], [0.6, 0.6], [0.0, 0.6]])
}

#[cfg(test)]
mod tests {
    use frond_core::{Ifs, similarity_dimension};

    use super::*;

    #[test]
    fn every_shape_has_an_attractor_and_a_name_of_its_own() {
        let all = presets();
        assert!(all.len() >= 16);
        for (i, preset) in all.iter().enumerate() {
            let maps = preset.maps.iter().map(|&row| Affine2::from_row(row)).collect();
            let ifs = Ifs::new(maps).unwrap_or_else(|error| panic!("{}: {error}", preset.id));
            assert!(ifs.len() >= 2);
            assert!(all[..i].iter().all(|other| other.id != preset.id && other.name != preset.name));
            assert!(preset.id.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'));
        }
    }

    #[test]
    fn the_classics_have_their_dimensions() {
        for (id, dimension) in [
            ("gasket", 3.0_f64.log2()),
            ("dragon", 2.0),
            ("terdragon", 2.0),
            ("twindragon", 2.0),
            ("levy", 2.0),
            ("gosper", 2.0),
            ("koch", 4.0_f64.ln() / 3.0_f64.ln()),
            ("carpet", 8.0_f64.ln() / 3.0_f64.ln()),
        ] {
            let maps = preset(id).unwrap().maps.into_iter().map(Affine2::from_row).collect();
            let found = similarity_dimension(&Ifs::new(maps).unwrap()).unwrap();
            assert!((found - dimension).abs() < 1e-9, "{id}: {found}");
        }
    }
}
