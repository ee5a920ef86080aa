//! Ways to bring the shapes of the gallery to a morph keep the shapes.

use std::collections::HashSet;

use frond_core::{Affine2, ChaosGame, Ifs, Morph, MorphOptions, Route, RouteKind, routes};
use frond_locus::{RateOptions, rate};
use frond_scene::{preset, presets};
use glam::DVec2;

fn ifs(rows: &[[f64; 6]]) -> Ifs {
    Ifs::new(rows.iter().map(|&row| Affine2::from_row(row)).collect()).unwrap()
}

fn named(id: &str) -> Ifs {
    ifs(&preset(id).unwrap().maps)
}

/// Points of the attractor, by two chaos games: by area, which is quick where maps are large, and all maps alike, which
/// fills thin pieces.
fn cloud(ifs: &Ifs, count: usize) -> Vec<DVec2> {
    let alike = ifs.clone().with_probabilities(&vec![1.0; ifs.len()]).unwrap();
    let half = |ifs: &Ifs| {
        let (mut positions, mut pieces) = (vec![0.0_f32; count], vec![0; count / 2]);
        ChaosGame::new(ifs, 7).fill(&mut positions, &mut pieces);
        positions
    };
    let mut positions = Vec::new();
    for (p, q) in half(ifs).chunks_exact(2).zip(half(&alike).chunks_exact(2)) {
        positions.extend([p, q].map(|p| DVec2::new(f64::from(p[0]), f64::from(p[1]))));
    }
    positions
}

/// Whether every point of `few` has one of `many` close by: in the same or a neighbouring square of a 40th of the
/// width.
fn near(few: &[DVec2], many: &[DVec2]) -> bool {
    let (low, high) = many.iter().fold((DVec2::MAX, DVec2::MIN), |(low, high), &p| (low.min(p), high.max(p)));
    let width = (high - low).max_element() / 40.0;
    let square = |p: DVec2| ((p - low) / width).floor().as_i64vec2();
    let full: HashSet<_> = many.iter().map(|&p| square(p)).collect();
    let around = |p: DVec2| {
        let at = square(p);
        (-1..=1).any(|x| (-1..=1).any(|y| full.contains(&(at + glam::I64Vec2::new(x, y)))))
    };
    few.iter().all(|&p| around(p))
}

#[test]
fn every_route_keeps_both_shapes() {
    let shapes: Vec<(&str, Ifs, Vec<DVec2>)> = presets()
        .iter()
        .map(|preset| {
            let ifs = ifs(&preset.maps);
            let points = cloud(&ifs, 60_000);
            (preset.id, ifs, points)
        })
        .collect();
    let same = |maps: &[Affine2], points: &[DVec2]| {
        let found = cloud(&Ifs::new(maps.to_vec()).unwrap(), 6000);
        near(&found, points) && near(&points[..6000], &cloud(&Ifs::new(maps.to_vec()).unwrap(), 60_000))
    };
    let mut kinds = HashSet::new();
    for (a, from, at_first) in &shapes {
        for (b, to, at_last) in &shapes {
            let all = routes(from, to);
            for (k, route) in all.iter().enumerate() {
                let name = format!("{a} -> {b}: {:?}", route.kind);
                kinds.insert(route.kind);
                assert!(route.about.ends_with('.') && route.about.len() > 20, "{name}: {}", route.about);
                assert!(!all[..k].contains(route), "{name}");
                let Route { from: first, to: last, correspondence, turns, .. } = route.clone();
                assert!(first.len() == last.len() && first.len() == from.len().max(to.len()), "{name}");
                let options = MorphOptions { correspondence, turns, ..Default::default() };
                assert!(Morph::new(&first, &last, &options).is_ok(), "{name}");
                if first != from.maps() {
                    assert!(same(&first, at_first), "{name}");
                }
                if last != to.maps() {
                    if route.kind == RouteKind::Mirror {
                        let middle = frond_core::Hull::of(to).centre().x;
                        let mirrored: Vec<DVec2> =
                            at_last.iter().map(|p| DVec2::new(2.0 * middle - p.x, p.y)).collect();
                        assert!(same(&last, &mirrored), "{name}");
                    } else {
                        assert!(same(&last, at_last), "{name}");
                    }
                }
            }
        }
    }
    assert_eq!(kinds.len(), 7, "each kind occurs: {kinds:?}");
}

#[test]
fn a_symmetry_spares_the_fern_to_be_turned_over() {
    let all = routes(&named("fern"), &named("maple"));
    let kinds: Vec<RouteKind> = all.iter().map(|route| route.kind).collect();
    assert_eq!(kinds, [RouteKind::Collapse, RouteKind::Symmetry]);
    assert_eq!(all[0].about, "Piece 4 has to be turned over, and is flat for a moment on the way.");
    assert!(all[1].cost < 0.5 * all[0].cost);
    let kinds_of = |route: &Route| {
        let options =
            MorphOptions { correspondence: route.correspondence.clone(), ..MorphOptions::default() };
        Morph::new(&route.from, &route.to, &options).unwrap().kinds()
    };
    assert!(kinds_of(&all[0]).contains(&frond_core::Kind::Opposite));
    assert!(!kinds_of(&all[1]).contains(&frond_core::Kind::Opposite));
}

#[test]
fn a_symmetry_of_the_gasket_opens_a_way_from_the_mirrored_terdragon() {
    let options = RateOptions::default();
    let rated: Vec<_> = routes(&named("terdragon-mirrored"), &named("gasket"))
        .into_iter()
        .map(|route| {
            let choice = MorphOptions {
                correspondence: route.correspondence,
                turns: route.turns,
                ..MorphOptions::default()
            };
            let morph = Morph::new(&route.from, &route.to, &choice).unwrap();
            (route.kind, rate(&morph, &options).unwrap())
        })
        .collect();
    assert!(rated[0].0 == RouteKind::Plain && !rated[0].1.plan.holds);
    let best = rated.iter().min_by(|a, b| a.1.compare(&b.1)).unwrap();
    assert!(best.1.plan.holds, "{:?}", best.1.plan);
    assert!(best.1.share > 0.05 && best.1.share < 1.0);
}
