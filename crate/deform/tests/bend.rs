//! Bends against the formulas, and their pieces against each other.

mod common;

use common::{
    bumps, cursor, fern, fern_mesh, gasket, mirrored, polygon, settings, square, twindragon, unit_mesh,
};
use frond_core::{Affine2, Ifs};
use frond_deform::{Bend, Continuity, Corners, Field, Mesh, Place, Roughness, Settings, Spin, Tint, weights};
use glam::DVec2;
use proptest::prelude::*;

const SPINS: [Spin; 4] = [Spin::None, Spin::Orthogonal, Spin::Rotation, Spin::Scaled];

fn any_mesh() -> impl Strategy<Value = Vec<(f64, f64)>> {
    proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 16)
}

fn any_spin() -> impl Strategy<Value = Spin> {
    proptest::sample::select(SPINS.to_vec())
}

fn any_roughness() -> impl Strategy<Value = Roughness> {
    let delta = || prop_oneof![0.0..1.5_f64, Just(0.0), Just(1.0), Just(1e300)];
    prop_oneof![
        delta().prop_map(Roughness::Constant),
        [delta(), delta(), delta(), delta()].prop_map(Roughness::Corners),
    ]
}

/// Whole depths as often as not.
fn any_depths(deepest: f64) -> impl Strategy<Value = (f64, f64)> {
    (0.0..1.0_f64, 0.0..1.0_f64, any::<bool>()).prop_map(move |(a, b, whole)| {
        let (kb, ke) = (a * b * deepest, b * deepest);
        if whole { (kb.round(), ke.round()) } else { (kb, ke) }
    })
}

/// Shapes with corners: gaskets, mirrored, squares and carpets, polygons.
fn with_corners(shape: usize) -> Vec<Affine2> {
    let quarters = || {
        let mut maps = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]]
            .map(|[x, y]| Affine2::similitude(0.5, 0.0, DVec2::new(x, y)))
            .to_vec();
        maps.push(Affine2::from_row([-0.5, 0.0, 0.0, -0.5, 0.5, 0.5]));
        maps
    };
    match shape {
        0 => gasket(),
        1 => square(2, |_| true),
        2 => square(3, |i| i != 4),
        3 => mirrored(),
        4 => polygon(5),
        5 => polygon(6),
        6 => square(3, |i| i % 2 == 0),
        _ => quarters(),
    }
}

/// The pieces of so many letters that hold a point, and the point of the whole that each takes there.
fn all_places(maps: &[Affine2], point: DVec2, letters: usize) -> Vec<(Vec<u8>, DVec2)> {
    let corners = Corners::find(maps).unwrap();
    let points = corners.points();
    let inside = |p: DVec2| {
        (0..points.len())
            .all(|i| (points[(i + 1) % points.len()] - points[i]).perp_dot(p - points[i]) > -1e-9)
    };
    let mut places = vec![(Vec::new(), point)];
    for _ in 0..letters {
        let mut next = Vec::new();
        for (code, rest) in &places {
            for (i, map) in maps.iter().enumerate() {
                let rest = map.inverse().unwrap().apply(*rest);
                if inside(rest) {
                    next.push(([&code[..], &[i as u8]].concat(), rest));
                }
            }
        }
        places = next;
    }
    places
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(200)))]

    #[test]
    fn raw_terms_are_the_formula(
        code in proptest::collection::vec(0..4_u8, 6..12), (kb, ke) in any_depths(6.0), list in any_mesh(),
        delta in 0.0..1.5_f64, superposed: bool, spin in any_spin(),
    ) {
        let (maps, mesh) = (fern(), fern_mesh(&list));
        let asked = Settings { superposed, ..settings(kb, ke, delta, spin, Continuity::Raw) };
        let bend = Bend::new(&maps, mesh.clone(), asked, None).unwrap();
        let place = Place { code: &code, tail: DVec2::new(0.1, 2.0) };
        let field = Field::new(&maps, &mesh, spin);
        let v = if superposed { field.superposed_between(kb, ke, delta, place) } else { field.term_between(kb, ke, place) };
        let found = bend.point(&cursor(&bend, &code), place.tail);
        let wanted = field.position(place) + v;
        prop_assert!((found - wanted).length() < 1e-11, "{found} {wanted}");
    }

    #[test]
    fn pieces_agree_on_what_they_share(
        shape in 0..8_usize, (kb, ke) in any_depths(4.0), more in -2..3_i32, roughness in any_roughness(),
        spin in any_spin(), list in any_mesh(), superposed: bool, picks in proptest::collection::vec(0..64_usize, 6),
        side in 0..8_usize, along in 0.0..1.0_f64,
    ) {
        let maps = with_corners(shape);
        let asked = Settings { kb, ke, roughness, spin, continuity: Continuity::Auto, superposed };
        let bend = Bend::new(&maps, unit_mesh(&list), asked, None).unwrap();
        prop_assert_eq!(bend.continuity(), Continuity::Corners);
        let corners = Corners::find(&maps).unwrap();
        let letters = (ke.ceil() as i32 + more).clamp(0, 6) as usize;
        let word: Vec<u8> = picks[..letters].iter().map(|pick| (pick % maps.len()) as u8).collect();
        let piece = cursor(&bend, &word).map();
        let (a, b) = (corners.points()[side % corners.points().len()], corners.points()[(side + 1) % corners.points().len()]);
        for z in [a, a.lerp(b, along)] {
            let places = all_places(&maps, piece.apply(z), letters);
            prop_assert!(!places.is_empty());
            let goals: Vec<DVec2> =
                places.iter().map(|(code, tail)| bend.point(&cursor(&bend, code), *tail)).collect();
            for goal in &goals {
                prop_assert!((*goal - goals[0]).length() < 1e-9, "{:?} of {:?}", goals, places);
            }
        }
        // The anchors are such points; and so are those of words too short to be shuffled.
        let at = cursor(&bend, &word);
        for (anchor, goal) in bend.anchors().iter().zip(bend.displaced(&at)) {
            prop_assert!((bend.point(&at, *anchor) - goal).length() < 1e-9);
            let letter = maps.iter().position(|map| map.apply(*anchor).distance(*anchor) < 1e-12).unwrap();
            let deeper = (0..6).fold(at.clone(), |at, _| bend.child(&at, letter));
            prop_assert!((bend.point(&deeper, *anchor) - goal).length() < 1e-9);
        }
    }

    #[test]
    fn with_kb_at_ke_all_is_plain(
        shape in 0..8_usize, deep in 0.0..5.0_f64, whole: bool, roughness in any_roughness(), spin in any_spin(),
        continuity in proptest::sample::select(vec![Continuity::Corners, Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published]),
        picks in proptest::collection::vec(0..64_usize, 0..8), list in any_mesh(), x in 0.0..1.0_f64, y in 0.0..1.0_f64,
    ) {
        let maps = with_corners(shape);
        // Between whole numbers kb = ke is a blend of shuffles for k up to the next one, which are none without a turn.
        let deep = if whole || spin != Spin::None { deep.floor() } else { deep };
        let mesh = unit_mesh(&list);
        let asked = Settings { kb: deep, ke: deep, roughness, spin, continuity, superposed: true };
        let bend = Bend::new(&maps, mesh.clone(), asked, None).unwrap();
        let word: Vec<u8> = picks.iter().map(|pick| (pick % maps.len()) as u8).collect();
        let (at, z) = (cursor(&bend, &word), DVec2::new(x, y));
        let rest = at.map().apply(z);
        prop_assert!((bend.point(&at, z) - rest - mesh.at(rest)).length() < 1e-11);
    }

    #[test]
    fn what_is_moved_as_a_whole_stays_whole(
        shape in 0..10_usize, (kb, ke) in any_depths(4.0), roughness in any_roughness(), superposed: bool,
        continuity in proptest::sample::select(vec![Continuity::Auto, Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published]),
        picks in proptest::collection::vec(0..64_usize, 0..8),
    ) {
        let maps = match shape { 8 => fern(), 9 => twindragon(), shape => with_corners(shape) };
        let by = DVec2::new(0.3, -0.7);
        let asked = Settings { kb, ke, roughness, spin: Spin::None, continuity, superposed };
        let bend = Bend::new(&maps, unit_mesh(&[(0.3, -0.7); 16]), asked, None).unwrap();
        let word: Vec<u8> = picks.iter().map(|pick| (pick % maps.len()) as u8).collect();
        let at = cursor(&bend, &word);
        for (anchor, goal) in bend.anchors().iter().zip(bend.displaced(&at)) {
            let rest = at.map().apply(*anchor);
            prop_assert!((goal - rest - by).length() < 1e-9 * (1.0 + rest.length()), "{goal} {rest}");
        }
        prop_assert!(bend.reach() >= by.length());
    }

    #[test]
    fn nothing_goes_beyond_its_reach(
        shape in 0..10_usize, (kb, ke) in any_depths(4.0), roughness in any_roughness(), spin in any_spin(), list in any_mesh(),
        continuity in proptest::sample::select(vec![Continuity::Auto, Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published]),
        picks in proptest::collection::vec(0..64_usize, 0..8),
    ) {
        let maps = match shape { 8 => fern(), 9 => twindragon(), shape => with_corners(shape) };
        let asked = Settings { kb, ke, roughness, spin, continuity, superposed: true };
        let bend = Bend::new(&maps, unit_mesh(&list), asked, None).unwrap();
        let word: Vec<u8> = picks.iter().map(|pick| (pick % maps.len()) as u8).collect();
        let at = cursor(&bend, &word);
        let mut points = bend.anchors().to_vec();
        points.extend(maps.iter().filter_map(|map| map.fixed_point()));
        for z in points {
            let v = bend.point(&at, z) - at.map().apply(z);
            prop_assert!(v.length() <= bend.reach() * (1.0 + 1e-12), "{v} {}", bend.reach());
        }
    }

    #[test]
    fn skins_go_where_the_bend_goes(
        shape in 0..10_usize, (kb, ke) in any_depths(4.0), roughness in any_roughness(), spin in any_spin(), list in any_mesh(),
        continuity in proptest::sample::select(vec![Continuity::Auto, Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published]),
        words in proptest::collection::vec(proptest::collection::vec(0..64_usize, 0..7), 1..12), superposed: bool,
    ) {
        let (maps, low, high) = match shape {
            8 => (fern(), DVec2::new(-3.0, 0.0), DVec2::new(3.0, 10.2)),
            9 => (twindragon(), DVec2::new(-1.2, -0.6), DVec2::new(1.2, 1.6)),
            shape => (with_corners(shape), DVec2::ZERO, DVec2::ONE),
        };
        let mesh = Mesh::at_rest(low, high, 4, 4).unwrap();
        let asked = Settings { kb, ke, roughness, spin, continuity, superposed };
        let mut bend = Bend::new(&maps, mesh, asked, None).unwrap();
        let places: Vec<_> = words
            .iter()
            .map(|word| {
                let word: Vec<u8> = word.iter().map(|pick| (pick % maps.len()) as u8).collect();
                (cursor(&bend, &word), bend.anchors()[word.len() % bend.anchors().len()])
            })
            .collect();
        let skin = bend.skin(&places);
        let moves: Vec<DVec2> = list.into_iter().map(DVec2::from).collect();
        bend.set_mesh(&moves).unwrap();
        let mut out = vec![0.0; 2 * skin.len()];
        skin.follow(&moves, &mut out);
        for ((at, z), found) in places.iter().zip(out.chunks_exact(2)) {
            let wanted = bend.point(at, *z);
            let found = DVec2::new(f64::from(found[0]), f64::from(found[1]));
            prop_assert!((found - wanted).length() < 2e-5 * (1.0 + bend.reach()), "{found} {wanted}");
        }
    }
}

#[test]
fn a_moved_bend_is_a_new_one() {
    let (rest, moved) = (unit_mesh(&[(0.0, 0.0); 16]), unit_mesh(&bumps(0.05)));
    for shape in 0..8 {
        let maps = with_corners(shape);
        for continuity in
            [Continuity::Auto, Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published]
        {
            let asked = settings(0.3, 3.6, 0.8, Spin::Orthogonal, continuity);
            let mut bend = Bend::new(&maps, rest.clone(), asked, None).unwrap();
            bend.set_mesh(moved.displacements()).unwrap();
            let fresh = Bend::new(&maps, moved.clone(), asked, None).unwrap();
            let at = cursor(&bend, &[0, 1, 2]);
            assert_eq!(bend.displaced(&at), fresh.displaced(&at));
            assert!(bend.set_mesh(&[DVec2::NAN; 16]).is_err() && bend.set_mesh(&[]).is_err());
            assert_eq!(bend.displaced(&at), fresh.displaced(&at), "the last good state is kept");
        }
    }
}

#[test]
fn splats_are_smooth() {
    let mesh = Mesh::new(
        DVec2::splat(-2.0),
        DVec2::splat(3.0),
        4,
        4,
        unit_mesh(&bumps(0.03)).displacements().to_vec(),
    )
    .unwrap();
    for (kb, ke, spin) in [(0.0, 8.0, Spin::None), (1.5, 7.5, Spin::Rotation), (0.0, 6.0, Spin::None)] {
        for roughness in [Roughness::Constant(0.7), Roughness::Corners([0.2, 1.0, 0.5, 0.9])] {
            let asked = Settings { roughness, ..settings(kb, ke, 0.0, spin, Continuity::Auto) };
            let bend = Bend::new(&twindragon(), mesh.clone(), asked, None).unwrap();
            assert_eq!(bend.continuity(), Continuity::Splat);
            let whole = bend.whole();
            let at = |t: f64| bend.point(&whole, DVec2::new(-0.9 + 1.8 * t, 1.3 - 1.7 * t));
            let slope = |t: f64| (at(t + 1e-6) - at(t - 1e-6)) / 2e-6;
            let (mut steepest, mut sharpest) = (0.0_f64, 0.0_f64);
            for i in 0..4000 {
                let t = f64::from(i) / 4000.0;
                steepest = steepest.max(slope(t).length());
                sharpest = sharpest.max((slope(t + 1e-5) - slope(t)).length());
            }
            // A kink anywhere would stay as sharp however near one looks: some 0.1 of the slope and more.
            assert!(sharpest < 2e-3 * steepest, "{steepest} {sharpest}");
            // It hangs on the place alone, not on the word.
            let deep = cursor(&bend, &[0, 1, 1, 0, 1]);
            let z = DVec2::new(0.1, 0.4);
            assert!((bend.point(&deep, z) - bend.point(&whole, deep.map().apply(z))).length() < 1e-12);
        }
    }
}

#[test]
fn splats_go_where_the_formula_goes() {
    // Smoothed, so not the same; but the two depart from the plain deformation alike.
    let maps = twindragon();
    let mesh = Mesh::new(
        DVec2::splat(-2.0),
        DVec2::splat(3.0),
        4,
        4,
        unit_mesh(&bumps(0.03)).displacements().to_vec(),
    )
    .unwrap();
    let field = Field::new(&maps, &mesh, Spin::None);
    for continuity in [Continuity::Splat, Continuity::Average, Continuity::Published] {
        let bend =
            Bend::new(&maps, mesh.clone(), settings(0.0, 6.0, 0.7, Spin::None, continuity), None).unwrap();
        let (mut both, mut ours, mut theirs) = (0.0, 0.0, 0.0);
        for i in 0..64_u8 {
            let code: Vec<u8> = (0..6).map(|k| i >> k & 1).collect();
            let place = Place { code: &code, tail: DVec2::splat(0.5) };
            let plain = mesh.at(field.position(place));
            let wanted = field.superposed(0, 6, 0.7, place) - plain;
            let found = bend.point(&cursor(&bend, &code), place.tail) - field.position(place) - plain;
            both += found.dot(wanted);
            ours += found.length_squared();
            theirs += wanted.length_squared();
        }
        let (likeness, size) = (both / (ours * theirs).sqrt(), (ours / theirs).sqrt());
        assert!(likeness > 0.8 && size > 0.5 && size < 1.5, "{continuity:?} {likeness} {size}");
    }
}

/// The smallest parts of a piece, each with how much it counts, down to a hundredth of the size of the whole.
fn parts(ifs: &Ifs, piece: Affine2, code: &[u8], share: f64, visit: &mut impl FnMut(&[u8], Affine2, f64)) {
    if piece.norm() < 0.01 {
        return visit(code, piece, share);
    }
    for (i, (map, p)) in ifs.maps().iter().zip(ifs.probabilities()).enumerate() {
        parts(ifs, piece * *map, &[code, &[i as u8]].concat(), share * p, visit);
    }
}

#[test]
fn averages_are_the_means_over_the_regions() {
    let (low, high) = (DVec2::new(-3.0, -1.0), DVec2::new(3.0, 10.2));
    let list: Vec<DVec2> = unit_mesh(&bumps(0.03)).displacements().to_vec();
    let over = |low, high| Mesh::new(low, high, 4, 4, list.clone()).unwrap();
    for (maps, mesh) in [
        (gasket(), unit_mesh(&bumps(0.03))),
        (twindragon(), over(DVec2::splat(-1.2), DVec2::splat(1.6))),
        (fern(), over(low, high)),
    ] {
        let ifs = Ifs::new(maps.clone()).unwrap();
        // The middle of the shape, as of its parts; the fern's last parts need it to be at home in them.
        let mut middle = DVec2::ZERO;
        for _ in 0..2 {
            let mut sum = DVec2::ZERO;
            parts(&ifs, Affine2::IDENTITY, &[], 1.0, &mut |_, part, share| sum += part.apply(middle) * share);
            middle = sum;
        }
        for (ke, spin) in [(1, Spin::Orthogonal), (2, Spin::None), (2, Spin::Scaled)] {
            let bend = Bend::new(
                &maps,
                mesh.clone(),
                settings(0.0, f64::from(ke), 0.8, spin, Continuity::Average),
                None,
            )
            .unwrap();
            let field = Field::new(&maps, &mesh, spin);
            // The terms that are shuffled: from k = 2 on, with a turn from 1 on.
            let first = if spin == Spin::None { 2 } else { 1 };
            let list = weights(0.8, 0, ke as usize);
            let plain: f64 = list[..first].iter().sum();
            let mut farthest = 0.0_f64;
            for number in 0..maps.len().pow(ke) {
                let code: Vec<u8> =
                    (0..ke).rev().map(|k| (number / maps.len().pow(k) % maps.len()) as u8).collect();
                let region = code.iter().fold(Affine2::IDENTITY, |map, &i| map * maps[usize::from(i)]);
                let at = region.apply(middle);
                let mut wanted = mesh.at(at) * plain;
                parts(&ifs, region, &code, 1.0, &mut |code, _, share| {
                    let place = Place { code, tail: middle };
                    for (k, weight) in list.iter().enumerate().skip(first) {
                        wanted += field.term(0, k, place) * (weight * share);
                    }
                });
                let sampled = field.superposed(0, ke as usize, 0.8, Place { code: &code, tail: middle });
                farthest = farthest.max(sampled.distance(wanted));
                let found = bend.point(&bend.whole(), at) - at;
                assert!(found.distance(wanted) < 1e-4 * bend.reach(), "{code:?}: {found} {wanted}");
            }
            // What lies in the middle of a region is something else.
            println!("{} {ke} {spin:?}: {}", maps.len(), farthest / bend.reach());
            assert!(farthest > 2e-3 * bend.reach(), "{farthest} of {}", bend.reach());
        }
    }
}

#[test]
fn shapes_choose_what_suits_them() {
    let choice = |maps: &[Affine2], continuity| {
        Bend::new(maps, unit_mesh(&bumps(0.01)), settings(0.0, 4.0, 0.7, Spin::None, continuity), None)
            .unwrap()
            .continuity()
    };
    assert_eq!(choice(&gasket(), Continuity::Auto), Continuity::Corners);
    assert_eq!(choice(&fern(), Continuity::Auto), Continuity::Raw);
    let spiral = [[0.8645, -0.3147, 0.3147, 0.8645, 0.0, 0.0], [0.15, -0.2598, 0.2598, 0.15, 0.8, 0.1]];
    assert_eq!(choice(&spiral.map(Affine2::from_row), Continuity::Auto), Continuity::Raw);
    assert_eq!(choice(&twindragon(), Continuity::Auto), Continuity::Splat);
    assert_eq!(choice(&twindragon(), Continuity::Corners), Continuity::Splat, "it has none");
    for asked in [Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published] {
        assert_eq!(choice(&gasket(), asked), asked);
    }
}

#[test]
fn degenerate_shapes_do_no_harm() {
    let one = vec![Affine2::similitude(0.5, 0.0, DVec2::X)];
    let twice = vec![Affine2::similitude(0.5, 0.0, DVec2::X); 3];
    let line = [0.0, 0.25, 0.5].map(|x| Affine2::similitude(0.5, 0.0, DVec2::splat(x))).to_vec();
    let points = [DVec2::X, DVec2::Y].map(|p| Affine2::similitude(0.0, 0.0, p)).to_vec();
    let sheared =
        [[0.5, 7.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.001, 0.5, 0.5, 0.0]].map(Affine2::from_row).to_vec();
    // Each shape with other localities than the one before; `deep` tries all of them on all.
    let localities = frond_testing::cases(1) as usize;
    let shapes = [one, twice, line, points, sheared, fern(), square(3, |_| true)];
    for (first, maps) in shapes.into_iter().enumerate() {
        for (second, continuity) in [
            Continuity::Auto,
            Continuity::Corners,
            Continuity::Splat,
            Continuity::Raw,
            Continuity::Average,
            Continuity::Published,
        ]
        .into_iter()
        .enumerate()
        {
            for ke in [0.0, 2.0, 3.7].into_iter().cycle().skip(first + second).take(localities.min(3)) {
                let bend = Bend::new(
                    &maps,
                    unit_mesh(&bumps(0.02)),
                    settings(0.0, ke, 1.2, Spin::Scaled, continuity),
                    None,
                )
                .unwrap();
                let mut at = bend.whole();
                for i in 0..80 {
                    assert!(bend.displaced(&at).iter().all(|p| p.is_finite()), "{maps:?} {continuity:?} {i}");
                    assert!(bend.even(&at) || (i as f64) < bend.ke().ceil());
                    at = bend.child(&at, i % 7);
                }
                assert!(bend.reach().is_finite());
                assert_eq!(bend.skin(&[(at, DVec2::ONE)]).len(), 1);
            }
        }
    }
}

#[test]
fn depths_beyond_memory_are_taken_down() {
    for (maps, continuity, deepest) in [
        (gasket(), Continuity::Auto, 12),
        (square(3, |_| true), Continuity::Auto, 6),
        (twindragon(), Continuity::Auto, 18),
        (twindragon(), Continuity::Average, 16),
        (twindragon(), Continuity::Published, 16),
        (fern(), Continuity::Auto, 64),
    ] {
        let asked = settings(0.0, 1e9, 0.5, Spin::None, continuity);
        let bend = Bend::new(&maps, unit_mesh(&bumps(0.01)), asked, None).unwrap();
        assert_eq!((bend.ke(), bend.deepest()), (f64::from(deepest), deepest as usize));
        let at = (0..70).fold(bend.whole(), |at, i| bend.child(&at, i % 2));
        assert!(bend.displaced(&at)[0].is_finite());
    }
}

#[test]
fn tints_are_shuffled_raw() {
    // Colours by place, one letter shuffled alone: Fig 3's second row. Pieces swap colours and are not blended.
    let colours: Vec<[f64; 3]> =
        (0..16).map(|i| [f64::from(i % 4) / 3.0, f64::from(i / 4) / 3.0, 0.5]).collect();
    let tint = Tint { colours, kb: 0.0, ke: 2.0, roughness: 1.0, superposed: false };
    let rest = unit_mesh(&[(0.0, 0.0); 16]);
    let good = settings(0.0, 1.0, 0.7, Spin::None, Continuity::Auto);
    let bend = Bend::new(&square(2, |_| true), rest, good, Some(tint)).unwrap();
    let middle = DVec2::splat(0.5);
    for code in [[0, 1, 2], [3, 0, 0], [1, 2, 3]] {
        let other = [code[1], code[0], code[2]];
        let from = cursor(&bend, &other).map().apply(middle);
        let found = bend.colour(&cursor(&bend, &code), middle).unwrap();
        assert!((found[0] - from.x).abs() < 1e-12 && (found[1] - from.y).abs() < 1e-12 && found[2] == 0.5);
    }
    let plain = Bend::new(&gasket(), unit_mesh(&[(0.0, 0.0); 16]), good, None).unwrap();
    assert_eq!(plain.colour(&plain.whole(), middle), None);
}
