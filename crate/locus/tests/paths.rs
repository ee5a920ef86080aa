//! Ways through three parameters where the plane has none.

use frond_core::{Affine2, Morph, MorphOptions};
use frond_locus::{Axes, PathOptions, PathPlan, check_path, find_path};
use glam::DVec3;

type Rows = &'static [[f64; 6]];

const HEIGHT: f64 = 0.866_025_403_784_438_6;
const GASKET: Rows = &[
    [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
    [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
    [0.5, 0.0, 0.0, 0.5, 0.25, HEIGHT / 2.0],
];
const TREE: Rows = &[
    [0.04, 0.0, 0.0, 0.5, 0.0, 0.0],
    [0.514, -0.3467, 0.3467, 0.514, 0.0, 0.44],
    [0.4443, 0.3728, -0.3728, 0.4443, 0.0, 0.36],
    [0.3565, -0.0501, 0.0501, 0.3565, 0.0, 0.44],
];
const FERN: Rows = &[
    [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
    [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
    [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
    [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
];

fn terdragon(side: f64) -> Vec<[f64; 6]> {
    let (re, im) = (0.5, side * HEIGHT / 3.0);
    vec![[re, -im, im, re, 0.0, 0.0], [0.0, 2.0 * im, -2.0 * im, 0.0, re, im], [re, -im, im, re, re, -im]]
}

fn morph(from: &[[f64; 6]], to: &[[f64; 6]]) -> Morph {
    let maps = |rows: &[[f64; 6]]| rows.iter().map(|&row| Affine2::from_row(row)).collect::<Vec<_>>();
    Morph::new(&maps(from), &maps(to), &MorphOptions::default()).unwrap()
}

fn plans(morph: &Morph, size: usize) -> [PathPlan; 2] {
    [Axes::Two, Axes::Three]
        .map(|axes| find_path(morph, &PathOptions { size, axes, ..Default::default() }).unwrap())
}

#[test]
fn the_third_parameter_opens_a_way_that_the_plane_lacks() {
    let mirrored = terdragon(-1.0);
    for (name, from, to) in [
        ("mirrored terdragon to gasket", &mirrored[..], GASKET),
        ("gasket to mirrored terdragon", GASKET, &mirrored[..]),
        ("tree to fern", TREE, FERN),
    ] {
        let morph = morph(from, to);
        let [plane, space] = plans(&morph, 49);
        assert!(!plane.holds && plane.apart && plane.gap > 0.003, "{name}: {plane:?}");
        let worst = plane.worst.unwrap();
        let there = check_path(&morph, &[worst, worst], 1.0 / 600.0, 2);
        assert!((there.gap - plane.gap).abs() < 1e-6, "{name}: {there:?}");
        assert!(
            space.holds && space.gap == 0.0 && space.worst.is_none() && !space.apart,
            "{name}: {space:?}"
        );
        assert!(space.points.iter().any(|at| at.z != 0.0) && space.points.len() <= 6, "{name}: {space:?}");
        assert!(space.clearance > 0.05, "{name}: {space:?}");
        // Looked at again at parameters that the search did not see.
        assert!(check_path(&morph, &space.points, 1.0 / 600.0, 5003).holds, "{name}");
        let ends = (space.points[0], space.points[space.points.len() - 1]);
        assert_eq!(ends, (DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)));
    }
}

#[test]
fn a_path_that_the_plane_has_is_kept() {
    let [plane, space] = plans(&morph(&terdragon(1.0), GASKET), 97);
    assert!(plane.holds && plane == space, "{plane:?} {space:?}");
}

#[test]
fn where_no_path_holds_three_parameters_are_no_worse_than_two() {
    let dust: Vec<[f64; 6]> =
        [[0.0, 0.0], [0.6, 0.0], [0.6, 0.6], [0.0, 0.6]].map(|[e, f]| [0.4, 0.0, 0.0, 0.4, e, f]).to_vec();
    let [plane, space] = plans(&morph(TREE, &dust), 25);
    assert!(!plane.holds && !space.holds && plane.apart && space.apart);
    // The dust itself is in pieces, 0.2 apart, and its diameter is the root of 2.
    assert!(plane.gap > 0.13 && space.gap <= plane.gap, "{} {}", plane.gap, space.gap);
    assert!(space.points.len() <= PathPlan::MOST_POINTS);
}
