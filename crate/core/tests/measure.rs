//! Whatever way is taken from one shape to another, both keep their measures.

use std::collections::HashSet;

use frond_core::{Affine2, Hull, Ifs, Route, RouteKind, routes, ways};
use glam::{DMat2, DVec2};

/// The maps with weights, in proportion, that every symmetry of the shape keeps.
fn weighted(rows: &[[f64; 6]], weights: &[f64]) -> Ifs {
    let maps = rows.iter().map(|&row| Affine2::from_row(row)).collect();
    Ifs::new(maps).unwrap().with_probabilities(weights).unwrap()
}

fn shapes() -> Vec<(&'static str, Ifs)> {
    let (third, s) = (1.0 / 3.0, 0.75_f64.sqrt() / 3.0);
    let half = |e: f64, f: f64| [0.5, 0.0, 0.0, 0.5, e, f];
    let koch = [
        [third, 0.0, 0.0, third, 0.0, 0.0],
        [0.5 * third, -s, s, 0.5 * third, third, 0.0],
        [0.5 * third, s, -s, 0.5 * third, 0.5, s],
        [third, 0.0, 0.0, third, 2.0 * third, 0.0],
    ];
    // Five thirds: to have as many maps as Koch's curve split once, one of them counts three times.
    let steps = [
        [third, 0.0, 0.0, third, 0.0, 0.0],
        [0.0, -third, third, 0.0, third, 0.0],
        [third, 0.0, 0.0, third, third, third],
        [0.0, third, -third, 0.0, 2.0 * third, third],
        [third, 0.0, 0.0, third, 2.0 * third, 0.0],
    ];
    let dragon = [[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]];
    let fern = [
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
        [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
        [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
    ];
    let corners = [half(0.0, 0.0), half(0.5, 0.0), half(0.25, 0.75_f64.sqrt() / 2.0)];
    let askew = [half(0.0, 0.0), half(0.5, 0.1), half(0.2, 0.6)];
    vec![
        ("dragon", weighted(&dragon, &[1.0, 3.0])),
        ("koch", weighted(&koch, &[1.0, 2.0, 2.0, 1.0])),
        ("steps", weighted(&steps, &[1.0, 2.0, 3.0, 2.0, 1.0])),
        ("fern", weighted(&fern, &[1.0, 85.0, 7.0, 7.0])),
        ("gasket", weighted(&corners, &[1.0, 1.0, 1.0])),
        ("askew", weighted(&askew, &[1.0, 4.0, 2.0])),
    ]
}

/// The integrals of x, y, x^2, xy and y^2 by the invariant measure, which is the sum of p_i w_i of itself (Hutchinson
/// 1981, section 4).
fn moments(maps: &[Affine2], p: &[f64]) -> [f64; 5] {
    let outer = |a: DVec2, b: DVec2| DMat2::from_cols(a * b.x, a * b.y);
    let (mut mean, mut square) = (DVec2::ZERO, DMat2::ZERO);
    for _ in 0..400 {
        let (mut next, mut next_square) = (DVec2::ZERO, DMat2::ZERO);
        for (map, &p) in maps.iter().zip(p) {
            let (moved, shift) = (map.linear * mean, map.translation);
            let image = map.linear * square * map.linear.transpose();
            next += (moved + shift) * p;
            next_square += (image + outer(moved, shift) + outer(shift, moved) + outer(shift, shift)) * p;
        }
        (mean, square) = (next, next_square);
    }
    [mean.x, mean.y, square.x_axis.x, square.x_axis.y, square.y_axis.y]
}

/// Where the last shape lies on a way.
fn last(route: &Route, to: &Ifs) -> Vec<Affine2> {
    let mut maps = to.maps().to_vec();
    if route.about.contains("in a mirror:") {
        let mirror = DMat2::from_diagonal(DVec2::new(-1.0, 1.0));
        let centre = Hull::of(to).centre();
        let mirror = Affine2::new(mirror, centre - mirror * centre);
        maps = maps.iter().map(|map| map.conjugate(mirror).unwrap()).collect();
    }
    route.place.map_or(maps.clone(), |place| maps.iter().map(|map| map.conjugate(place).unwrap()).collect())
}

#[test]
fn every_way_keeps_both_measures() {
    let shapes = shapes();
    let mut kinds = HashSet::new();
    for (a, from) in &shapes {
        for (b, to) in &shapes {
            for route in routes(from, to).into_iter().chain(ways(from, to, 60)) {
                kinds.insert(route.kind);
                let name = format!("{a} -> {b}: {route:?}");
                let ends = [
                    (&route.from, &route.from_probabilities, from.maps().to_vec(), from),
                    (&route.to, &route.to_probabilities, last(&route, to), to),
                ];
                for (maps, p, original, ifs) in ends {
                    assert_eq!(maps.len(), p.len(), "{name}");
                    assert!((p.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{name}");
                    let (found, known) = (moments(maps, p), moments(&original, ifs.probabilities()));
                    let size = known.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
                    let apart = found.iter().zip(known).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                    assert!(apart < 1e-9 * size, "{found:?} {known:?} {name}");
                }
            }
        }
    }
    for kind in
        [RouteKind::Refine, RouteKind::Double, RouteKind::Joints, RouteKind::Place, RouteKind::Symmetry]
    {
        assert!(kinds.contains(&kind), "{kinds:?}");
    }
}
