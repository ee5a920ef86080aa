//! Shapes that the tests share.

use frond_core::{Affine2, Ifs};
use glam::DVec2;

/// A map by its row.
pub fn row(row: [f64; 6]) -> Affine2 {
    Affine2::from_row(row)
}

/// An IFS by its rows.
pub fn of_rows(rows: &[[f64; 6]]) -> Ifs {
    Ifs::new(rows.iter().copied().map(Affine2::from_row).collect()).expect("a valid IFS")
}

/// The one point `at`.
pub fn point_attractor(at: DVec2) -> Ifs {
    of_rows(&[[0.5, 0.0, 0.0, 0.5, at.x * 0.5, at.y * 0.5]])
}

/// A turn of `degrees`, scaled, then moved.
fn turned(scale: f64, degrees: f64, e: f64, f: f64) -> Affine2 {
    Affine2::similitude(scale, degrees.to_radians(), DVec2::new(e, f))
}

/// Well-known and nasty shapes by name.
pub fn ifs(name: &str) -> Ifs {
    Ifs::new(match name {
        "gasket" => {
            vec![turned(0.5, 0.0, 0.0, 0.0), turned(0.5, 0.0, 0.5, 0.0), turned(0.5, 0.0, 0.25, 0.433)]
        }
        "dragon" => {
            let s = 0.5_f64.sqrt();
            vec![turned(s, 45.0, 0.0, 0.0), turned(s, 135.0, 1.0, 0.0)]
        }
        "levy" => {
            let s = 0.5_f64.sqrt();
            vec![turned(s, 45.0, 0.0, 0.0), turned(s, -45.0, 0.5, 0.5)]
        }
        "koch" => vec![
            turned(1.0 / 3.0, 0.0, 0.0, 0.0),
            turned(1.0 / 3.0, 60.0, 1.0 / 3.0, 0.0),
            turned(1.0 / 3.0, -60.0, 0.5, 3.0_f64.sqrt() / 6.0),
            turned(1.0 / 3.0, 0.0, 2.0 / 3.0, 0.0),
        ],
        "fern" => vec![
            row([0.0, 0.0, 0.0, 0.16, 0.0, 0.0]),
            row([0.85, 0.04, -0.04, 0.85, 0.0, 1.6]),
            row([0.2, -0.26, 0.23, 0.22, 0.0, 1.6]),
            row([-0.15, 0.28, 0.26, 0.24, 0.0, 0.44]),
        ],
        "carpet" => (0..9)
            .filter(|i| *i != 4)
            .map(|i| turned(1.0 / 3.0, 0.0, f64::from(i % 3) / 3.0, f64::from(i / 3) / 3.0))
            .collect(),
        "dust" => [0.0, 0.7].iter().flat_map(|x| [0.0, 0.7].map(|y| turned(0.3, 0.0, *x, y))).collect(),
        "square" => {
            (0..4).map(|i| turned(0.5, 0.0, 0.5 * f64::from(i % 2), 0.5 * f64::from(i / 2))).collect()
        }
        "spiral" => vec![turned(0.93, 20.0, 0.0, 0.0), turned(0.18, 0.0, 1.0, 0.0)],
        // Overlaps everywhere: words explode.
        "overlap" => vec![turned(0.9, 0.0, 0.0, 0.0), turned(0.9, 40.0, 0.1, 0.0)],
        "overlap line" => vec![row([0.9, 0.0, 0.0, 0.9, 0.0, 0.0]), row([0.9, 0.0, 0.0, 0.9, 0.1, 0.0])],
        "overlap shear" => vec![row([0.8, 0.5, 0.0, 0.7, 0.0, 0.0]), row([0.6, -0.5, 0.3, 0.8, 0.1, 0.0])],
        "doubled" => [0.0, 0.5, 0.25, 0.25]
            .iter()
            .enumerate()
            .map(|(i, e)| turned(0.5, 0.0, *e, if i > 1 { 0.433 } else { 0.0 }))
            .collect(),
        "many" => (0..64)
            .map(|i| turned(0.16, 7.0 * f64::from(i), (0.7 * f64::from(i)).cos(), (1.3 * f64::from(i)).sin()))
            .collect(),
        "thin" => vec![row([0.5, 30.0, 0.0, 0.5, 0.0, 0.0]), row([0.5, -20.0, 0.0, 0.4, 0.5, 0.01])],
        "slow" => vec![turned(0.9999, 30.0, 0.0, 0.0), turned(0.5, 0.0, 1.0, 0.0)],
        // Its million steps from one end to the other are each too short to see.
        "slow line" => {
            let k = 0.999_999;
            vec![row([k, 0.0, 0.0, k, 0.0, 0.0]), row([k, 0.0, 0.0, k, 0.0, 1.0])]
        }
        "segment" => vec![turned(0.5, 0.0, 0.0, 0.0), turned(0.5, 0.0, 0.5, 0.0)],
        "singular" => vec![row([0.5, 0.0, 0.0, 0.0, 0.0, 0.0]), row([0.0, 0.5, 0.0, 0.5, 0.5, 0.5])],
        _ => panic!("no shape is called {name}"),
    })
    .expect("a valid IFS")
}

/// Every name that [`ifs`] knows whose pieces hardly overlap.
pub const PLAIN: &[&str] = &[
    "gasket", "dragon", "levy", "koch", "fern", "carpet", "dust", "square", "spiral", "doubled", "segment",
    "singular",
];
/// Shapes on which simple methods give up.
pub const NASTY: &[&str] = &["overlap", "overlap line", "overlap shear", "many", "thin", "slow", "slow line"];

/// Some system of one to five maps; some of them are singular, reflect, shear, or overlap the others.
pub fn some_ifs(seed: u32) -> Ifs {
    let unit = |i: u32| f64::from(frond_core::hash::unit(frond_core::hash::counter(seed, i)));
    for attempt in 0.. {
        let at = 1000 * attempt;
        let count = 1 + (unit(at) * 5.0) as u32;
        let maps = (0..count).map(|map| {
            let from = at + 10 * map + 1;
            let entry = |i| if unit(from + 6) < 0.1 { 0.0 } else { 1.5 * unit(from + i) - 0.75 };
            row([0, 1, 2, 3]
                .map(entry)
                .into_iter()
                .chain([4, 5].map(|i| unit(from + i) * 2.0 - 1.0))
                .collect::<Vec<_>>()
                .try_into()
                .expect("six"))
        });
        if let Ok(ifs) = Ifs::new(maps.collect()) {
            return ifs;
        }
    }
    unreachable!("one of them contracts")
}
