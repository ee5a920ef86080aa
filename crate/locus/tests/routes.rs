//! Ways to bring the shapes of the gallery to a morph keep the shapes.

use std::collections::HashSet;

use frond_core::{Affine2, ChaosGame, Ifs, Mode, Morph, MorphOptions, Route, RouteKind, routes, ways};
use frond_locus::{CertifyOptions, RateOptions, certify_path, check_path, rate};
use frond_scene::{preset, presets};
use glam::{DVec2, DVec3};

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
                let least = from.len().max(to.len());
                let as_many =
                    if route.kind == RouteKind::Joints { least..=16.max(least) } else { least..=least };
                assert!(first.len() == last.len() && as_many.contains(&first.len()), "{name}");
                let options = MorphOptions { correspondence, turns, ..Default::default() };
                assert!(Morph::new(&first, &last, &options).is_ok(), "{name}");
                if first != from.maps() {
                    assert!(same(&first, at_first), "{name}");
                }
                if last != to.maps() {
                    if let Some(place) = route.place {
                        let laid: Vec<DVec2> = at_last.iter().map(|&p| place.apply(p)).collect();
                        assert!(same(&last, &laid), "{name}");
                    } else if route.kind == RouteKind::Mirror {
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
    assert_eq!(kinds.len(), 8, "each kind occurs: {kinds:?}");
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

/// The ways that are looked through where nothing else holds keep the shapes as well.
#[test]
fn every_way_keeps_both_shapes() {
    let mut kinds = HashSet::new();
    for (a, b) in [("fern", "koch"), ("spiral", "fern"), ("koch", "dragon")] {
        let (from, to) = (named(a), named(b));
        let clouds = [cloud(&from, 30_000), cloud(&to, 30_000)];
        let all = ways(&from, &to, 30);
        assert!(all.len() > 20, "{a} {b}");
        for (k, way) in all.iter().enumerate() {
            kinds.insert((way.kind, way.mode));
            assert!(!all[..k].contains(way), "{a} {b} {k}");
            let middle = frond_core::Hull::of(&to).centre().x;
            let about = |p: &DVec2| {
                let p = if way.about.contains("mirror:") { DVec2::new(2.0 * middle - p.x, p.y) } else { *p };
                way.place.map_or(p, |place| place.apply(p))
            };
            let last: Vec<DVec2> = clouds[1].iter().map(about).collect();
            for (maps, points) in [(&way.from, &clouds[0]), (&way.to, &last)] {
                let made = Ifs::new(maps.clone()).unwrap();
                assert!(near(&cloud(&made, 4000), points), "{a} {b} {k}: {way:?}");
                assert!(near(&points[..4000], &cloud(&made, 30_000)), "{a} {b} {k}: {way:?}");
            }
        }
    }
    assert!(kinds.contains(&(RouteKind::Joints, Some(Mode::Linear))), "{kinds:?}");
    assert!(kinds.contains(&(RouteKind::Place, None)) && kinds.contains(&(RouteKind::Correspondence, None)));
}

#[test]
fn koch_becomes_the_dragon_joint_by_joint_where_the_plain_way_breaks() {
    let (koch, dragon) = (named("koch"), named("dragon"));
    let way = ways(&koch, &dragon, 1).remove(0);
    let options = MorphOptions { mode: Mode::Linear, ..Default::default() };
    let morph = Morph::new(&way.from, &way.to, &options).unwrap();
    let straight = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
    assert!(check_path(&morph, &straight, 1e-9, 500).holds);
    let proved = certify_path(&morph, &straight, &CertifyOptions { within: 1e-12, ..Default::default() });
    assert!(proved.holds && proved.joints == 3 && proved.gap < 1e-13, "{proved:?}");
    // The same maps by angle and stretch, and off the straight way, are not so held.
    let bent = [straight[0], DVec3::new(0.5, 0.3, 0.0), straight[1]];
    assert!(!check_path(&morph, &bent, 1e-3, 500).holds);
    assert_eq!(certify_path(&morph, &bent, &CertifyOptions { budget: 10, ..Default::default() }).joints, 0);
}
