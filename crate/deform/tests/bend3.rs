//! Bends of space against the formula, against those of the plane, and against their own bounds.

mod common;

use common::{cursor, gasket, settings, square};
use frond_core::{Affine2, Affine3};
use frond_deform::{Bend, Bend3, Continuity, Corners3, Field, Mesh, Mesh3, Piece3, Place, Settings3, Spin};
use glam::{DMat3, DQuat, DVec2, DVec3};
use proptest::prelude::*;

const SIZES: [usize; 3] = [3, 4, 2];

fn spins() -> impl Strategy<Value = Spin> {
    proptest::sample::select(vec![Spin::None, Spin::Orthogonal, Spin::Rotation, Spin::Scaled])
}

fn any_moves() -> impl Strategy<Value = Vec<DVec3>> {
    proptest::collection::vec([-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64], 24)
        .prop_map(|list| list.into_iter().map(DVec3::from_array).collect())
}

fn any_roughness() -> impl Strategy<Value = f64> {
    prop_oneof![0.0..1.5_f64, Just(0.0), Just(1.0), Just(1e300)]
}

/// Whole depths as often as not.
fn any_depths(deepest: f64) -> impl Strategy<Value = (f64, f64)> {
    (0.0..1.0_f64, 0.0..1.0_f64, any::<bool>()).prop_map(move |(a, b, whole)| {
        let (kb, ke) = (a * b * deepest, b * deepest);
        if whole { (kb.round(), ke.round()) } else { (kb, ke) }
    })
}

fn lifted(maps: &[Affine2], heights: &[[f64; 2]]) -> Vec<Affine3> {
    let map = |map: &Affine2, [scale, shift]: [f64; 2]| {
        let [a, b, c, d, e, f] = map.to_row();
        Affine3::from_row([a, b, 0.0, c, d, 0.0, 0.0, 0.0, scale, e, f, shift])
    };
    maps.iter().flat_map(|one| heights.iter().map(move |&height| map(one, height))).collect()
}

fn tetrahedron() -> Vec<Affine3> {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::new(0.3, 0.8, 0.0), DVec3::new(0.4, 0.3, 0.9)];
    corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, c * 0.5)).to_vec()
}

fn grid(parts: u8, keep: impl Fn([u8; 3]) -> bool) -> Vec<Affine3> {
    let s = 1.0 / f64::from(parts);
    let cells = (0..parts).flat_map(|z| (0..parts).flat_map(move |y| (0..parts).map(move |x| [x, y, z])));
    let corner = |cell: [u8; 3]| DVec3::from_array(cell.map(f64::from)) * s;
    cells
        .filter(|&cell| keep(cell))
        .map(|cell| Affine3::similitude(s, DQuat::IDENTITY, corner(cell)))
        .collect()
}

fn sponge() -> Vec<Affine3> {
    grid(3, |cell| cell.iter().filter(|x| **x == 1).count() < 2)
}

/// The corner pieces of a cube of 27 turned about their own diagonals: they are the same cells.
fn turned_dust() -> Vec<Affine3> {
    let dust = grid(3, |cell| cell.iter().all(|x| *x != 1));
    let mut maps = dust;
    // x to y to z.
    let turn = DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X);
    for k in [0, 7] {
        maps[k] = Affine3::new(maps[k].linear * turn, maps[k].translation);
    }
    maps
}

fn with_corners(shape: usize) -> Vec<Affine3> {
    match shape {
        0 => tetrahedron(),
        1 => sponge(),
        2 => grid(2, |_| true),
        3 => turned_dust(),
        _ => lifted(&square(3, |i| i != 4), &[[0.5, 0.0], [0.5, 0.5]]),
    }
}

/// A fern of space, whose stem is flat.
fn fern() -> Vec<Affine3> {
    let leaf = |angle: f64, side: f64| {
        let turn = DQuat::from_rotation_y(side) * DQuat::from_rotation_x(angle);
        Affine3::similitude(0.3, turn, DVec3::new(0.0, 0.0, 0.3))
    };
    vec![
        Affine3::similitude(0.8, DQuat::from_rotation_x(0.1), DVec3::Z * 0.3),
        leaf(0.6, 1.0),
        leaf(0.5, -1.0),
        Affine3::scaling(DVec3::new(0.0, 0.0, 0.2)),
    ]
}

fn without_corners(shape: usize) -> Vec<Affine3> {
    match shape {
        0 => fern(),
        // One half turned by less than brings it back, one mirrored.
        1 => {
            let mut maps = tetrahedron();
            maps[0].linear *= DMat3::from_axis_angle(DVec3::ONE.normalize(), 0.7);
            maps[1].linear *= DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
            maps
        }
        _ => {
            let mut maps = tetrahedron();
            maps[3].linear *= DMat3::from_diagonal(DVec3::new(1.1, 0.9, 0.7));
            maps
        }
    }
}

fn mesh(moves: &[DVec3]) -> Mesh3 {
    Mesh3::new(DVec3::splat(-0.2), DVec3::new(1.2, 1.2, 1.5), SIZES, moves.to_vec()).unwrap()
}

fn asked(kb: f64, ke: f64, roughness: f64, spin: Spin) -> Settings3 {
    Settings3 { kb, ke, roughness, spin, raw: false }
}

fn word(maps: usize, picks: &[usize]) -> Vec<u8> {
    picks.iter().map(|pick| (pick % maps) as u8).collect()
}

fn piece(bend: &Bend3, code: &[u8]) -> Piece3 {
    code.iter().fold(bend.whole(), |piece, &letter| bend.child(&piece, usize::from(letter)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(120)))]

    #[test]
    fn raw_terms_are_the_formula_in_space_as_well(
        shape in 0..8_usize, picks in proptest::collection::vec(0..64_usize, 6..12), (kb, ke) in any_depths(6.0),
        moves in any_moves(), delta in 0.0..1.5_f64, spin in spins(),
    ) {
        let maps = if shape < 3 { without_corners(shape) } else { with_corners(shape - 3) };
        let (code, mesh) = (word(maps.len(), &picks), mesh(&moves));
        let bend = Bend3::new(&maps, mesh.clone(), Settings3 { raw: true, ..asked(kb, ke, delta, spin) }, None).unwrap();
        prop_assert!(!bend.continuous());
        let place = Place { code: &code, tail: DVec3::new(0.1, 0.4, 0.2) };
        let field = Field::new(&maps, &mesh, spin);
        let wanted = field.position(place) + field.superposed_between(kb, ke, delta, place);
        let found = bend.point(&piece(&bend, &code), place.tail);
        prop_assert!((found - wanted).length() < 1e-11, "{found} {wanted}");
    }

    #[test]
    fn without_change_along_z_a_prism_bends_as_its_base_does(
        picks in proptest::collection::vec(0..64_usize, 0..6), (kb, ke) in any_depths(3.0), delta in any_roughness(),
        list in proptest::collection::vec([-1.0..1.0_f64, -1.0..1.0_f64], 16), x in 0.0..1.0_f64, y in 0.0..1.0_f64,
        raw: bool,
    ) {
        let base = square(3, |i| i != 4);
        let maps = lifted(&base, &[[0.5, 0.0], [0.5, 0.5]]);
        let flat: Vec<DVec2> = list.into_iter().map(DVec2::from_array).collect();
        let high: Vec<DVec3> = flat.iter().map(|d| d.extend(0.0)).collect();
        let space = Mesh3::new(DVec3::ZERO, DVec3::ONE, [4, 4, 3], high.repeat(3)).unwrap();
        let plane = Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, flat).unwrap();
        let continuity = if raw { Continuity::Raw } else { Continuity::Corners };
        let flat = Bend::new(&base, plane, settings(kb, ke, delta, Spin::None, continuity), None).unwrap();
        let bend = Bend3::new(&maps, space, Settings3 { raw, ..asked(kb, ke, delta, Spin::None) }, None).unwrap();
        prop_assert_eq!(bend.continuous(), !raw);
        let mut code = word(maps.len(), &picks);
        if raw {
            // Short words go on as is nearest, in a way of their own.
            code.extend([0, 3, 7, 12]);
        }
        let below: Vec<u8> = code.iter().map(|letter| letter / 2).collect();
        let z = DVec3::new(x, y, 0.7);
        let found = bend.point(&piece(&bend, &code), z);
        let wanted = flat.point(&cursor(&flat, &below), z.truncate());
        prop_assert!((found.truncate() - wanted).length() < 1e-9, "{found} {wanted}");
        prop_assert!((found.z - piece(&bend, &code).map().apply(z).z).abs() < 1e-12);
    }

    #[test]
    fn the_foot_of_the_tetrahedron_bends_as_the_gasket_does(
        // Long enough for all to be smooth: in the holes of the shape, short words go on in a way of their own.
        picks in proptest::collection::vec(0..64_usize, 5..8), (kb, ke) in any_depths(5.0), delta in any_roughness(),
        list in proptest::collection::vec([-1.0..1.0_f64, -1.0..1.0_f64], 16),
        x in 0.0..1.0_f64, y in 0.0..1.0_f64,
    ) {
        let maps = tetrahedron();
        let flat: Vec<DVec2> = list.into_iter().map(DVec2::from_array).collect();
        let high: Vec<DVec3> = flat.iter().map(|d| d.extend(0.0)).collect();
        let space = Mesh3::new(DVec3::ZERO, DVec3::ONE, [4, 4, 2], high.repeat(2)).unwrap();
        let plane = Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, flat).unwrap();
        let flat = Bend::new(&gasket(), plane, settings(kb, ke, delta, Spin::None, Continuity::Auto), None).unwrap();
        let bend = Bend3::new(&maps, space, asked(kb, ke, delta, Spin::None), None).unwrap();
        let code = word(3, &picks);
        let [a, b] = if x + y > 1.0 { [1.0 - x, 1.0 - y] } else { [x, y] };
        let z = DVec2::new(a + 0.3 * b, 0.8 * b);
        let found = bend.point(&piece(&bend, &code), z.extend(0.0));
        let wanted = flat.point(&cursor(&flat, &code), z);
        prop_assert!((found - wanted.extend(0.0)).length() < 1e-9, "{found} {wanted}");
    }

    #[test]
    fn pieces_agree_on_what_they_share(
        shape in 0..5_usize, (kb, ke) in any_depths(2.0), delta in any_roughness(), spin in spins(), moves in any_moves(),
        picks in proptest::collection::vec(0..64_usize, 3), corner in 0..8_usize, a in 0.0..1.0_f64, b in 0.0..1.0_f64,
    ) {
        let maps = with_corners(shape);
        let bend = Bend3::new(&maps, mesh(&moves), asked(kb, ke, delta, spin), None).unwrap();
        prop_assert!(bend.continuous());
        let corners = Corners3::find(&maps).unwrap();
        // A corner, or anywhere on a face of a box.
        let points = corners.points();
        let z = if corners.grid().is_none() { points[corner % 4] } else {
            let face = [points[0], points[1 << (corner % 3)] - points[0], points[1 << ((corner + 1) % 3)] - points[0]];
            let far = if corner < 4 { DVec3::ZERO } else { points[1 << ((corner + 2) % 3)] - points[0] };
            face[0] + face[1] * a + face[2] * b + far
        };
        let code = word(maps.len(), &picks);
        let point = piece(&bend, &code).map().apply(z);
        let mut places = vec![(Vec::new(), point)];
        for _ in 0..code.len() {
            let next = |(code, rest): &(Vec<u8>, DVec3)| -> Vec<(Vec<u8>, DVec3)> {
                let inner = |(i, map): (usize, &Affine3)| {
                    let rest = map.inverse().unwrap().apply(*rest);
                    let inside = corners.weights(rest).iter().all(|weight| *weight > -1e-9);
                    inside.then(|| ([&code[..], &[i as u8]].concat(), rest))
                };
                maps.iter().enumerate().filter_map(inner).collect()
            };
            places = places.iter().flat_map(next).collect();
        }
        let goals: Vec<DVec3> = places.iter().map(|(code, z)| bend.point(&piece(&bend, code), *z)).collect();
        prop_assert!(!goals.is_empty());
        for goal in &goals {
            prop_assert!((*goal - goals[0]).length() < 1e-8, "{goals:?} of {places:?}");
        }
    }

    #[test]
    fn balls_hold_what_is_in_the_piece(
        shape in 0..8_usize, (kb, ke) in any_depths(3.0), delta in any_roughness(), spin in spins(), moves in any_moves(),
        picks in proptest::collection::vec(0..64_usize, 0..5), more in proptest::collection::vec(0..64_usize, 6..20),
        raw: bool, size in prop_oneof![Just(1.0), Just(1e-3), Just(1e12)],
    ) {
        let maps = if shape < 3 { without_corners(shape) } else { with_corners(shape - 3) };
        let moves: Vec<DVec3> = moves.into_iter().map(|d| d * size).collect();
        let bend = Bend3::new(&maps, mesh(&moves), Settings3 { raw, ..asked(kb, ke, delta, spin) }, None).unwrap();
        let at = piece(&bend, &word(maps.len(), &picks));
        let (centre, radius) = bend.ball(&at);
        let deeper = more.iter().fold(at.clone(), |at, pick| bend.child(&at, pick % maps.len()));
        let z = maps[more[0] % maps.len()].fixed_point().unwrap();
        let point = bend.point(&deeper, z);
        prop_assert!(point.distance(centre) <= radius * (1.0 + 1e-9) + 1e-12, "{} > {radius}", point.distance(centre));
        let (inner, small) = bend.ball(&deeper);
        prop_assert!(point.distance(inner) <= small * (1.0 + 1e-9) + 1e-12);
        // It is no larger than what the pieces of a piece need: it shrinks with the word.
        let smaller = (0..30).fold(deeper, |at, _| bend.child(&at, 0));
        prop_assert!(bend.ball(&smaller).1 <= 1e-2 * radius + 1e-9 * size.max(1.0));
    }

    #[test]
    fn with_kb_at_ke_all_is_plain_and_linear_maps_are_kept(
        shape in 0..8_usize, deep in 0..3_u8, delta in any_roughness(), spin in spins(), moves in any_moves(),
        picks in proptest::collection::vec(0..64_usize, 0..6), x in 0.0..1.0_f64, y in 0.0..1.0_f64, raw: bool,
    ) {
        let maps = if shape < 3 { without_corners(shape) } else { with_corners(shape - 3) };
        let settings = Settings3 { raw, ..asked(f64::from(deep), f64::from(deep), delta, spin) };
        let z = DVec3::new(x, y, 0.4);
        let plain = mesh(&moves);
        let bend = Bend3::new(&maps, plain.clone(), settings, None).unwrap();
        let at = piece(&bend, &word(maps.len(), &picks));
        let rest = at.map().apply(z);
        prop_assert!((bend.point(&at, z) - rest - plain.at(rest)).length() < 1e-11);
        let turn = DMat3::from_cols_array(&[0.3, 0.5, -1.0, -0.2, 1.0, 0.25, 0.0, 2.0, 0.7]);
        let affine = |p: DVec3| turn * p + DVec3::ONE;
        let moves: Vec<DVec3> = (0..24).map(|i| affine(plain.rest(i))).collect();
        let bend = Bend3::new(&maps, mesh(&moves), settings, None).unwrap();
        let at = piece(&bend, &word(maps.len(), &picks));
        prop_assert!((bend.point(&at, z) - rest - affine(rest)).length() < 1e-11);
        // Of an affine plain bend the frame is all there is to say.
        prop_assert!((bend.frame(&at).apply(z) - bend.point(&at, z)).length() < 1e-9);
    }

    #[test]
    fn what_is_moved_as_a_whole_stays_whole_and_rest_is_rest(
        shape in 0..8_usize, (kb, ke) in any_depths(3.0), delta in any_roughness(), raw: bool, still: bool,
        picks in proptest::collection::vec(0..64_usize, 0..6),
    ) {
        let maps = if shape < 3 { without_corners(shape) } else { with_corners(shape - 3) };
        let by = if still { DVec3::ZERO } else { DVec3::new(0.3, -0.7, 0.2) };
        let settings = Settings3 { raw, ..asked(kb, ke, delta, Spin::None) };
        let bend = Bend3::new(&maps, mesh(&[by; 24]), settings, None).unwrap();
        let at = piece(&bend, &word(maps.len(), &picks));
        for z in maps.iter().map(|map| map.fixed_point().unwrap()) {
            prop_assert!((bend.point(&at, z) - at.map().apply(z) - by).length() < 1e-9);
        }
    }

    #[test]
    fn frames_come_near_small_pieces(
        shape in 0..8_usize, (kb, ke) in any_depths(2.0), delta in 0.0..1.5_f64, spin in spins(), moves in any_moves(),
        picks in proptest::collection::vec(0..64_usize, 16),
    ) {
        let maps = if shape < 3 { without_corners(shape) } else { with_corners(shape - 3) };
        let moves: Vec<DVec3> = moves.into_iter().map(|d| d * 0.2).collect();
        let bend = Bend3::new(&maps, mesh(&moves), asked(kb, ke, delta, spin), None).unwrap();
        // Long enough for all to be small.
        let mut at = piece(&bend, &word(maps.len(), &picks));
        while at.map().stretch() > 1e-3 {
            at = bend.child(&at, 0);
        }
        for z in maps.iter().map(|map| map.fixed_point().unwrap()) {
            let off = bend.frame(&at).apply(z).distance(bend.point(&at, z));
            prop_assert!(off < 0.1 * bend.ball(&at).1 + 1e-9, "{off} of {}", bend.ball(&at).1);
        }
    }

    #[test]
    fn what_was_known_before_makes_no_difference(
        shape in 0..8_usize, (kb, ke) in any_depths(3.0), deep in 0..4_u8, moves in any_moves(), others in any_moves(),
        picks in proptest::collection::vec(0..64_usize, 0..6), raw: bool, other in 0..8_usize,
    ) {
        let of = |shape: usize| if shape < 3 { without_corners(shape) } else { with_corners(shape - 3) };
        let maps = of(shape);
        let old = Settings3 { raw, ..asked(0.0, f64::from(deep), 0.3, Spin::None) };
        let before = Bend3::new(&of(if raw { other } else { shape }), mesh(&others), old, None).unwrap();
        let settings = asked(kb, ke, 0.6, Spin::Orthogonal);
        let anew = Bend3::new(&maps, mesh(&moves), settings, None).unwrap();
        let again = Bend3::new(&maps, mesh(&moves), settings, Some(&before)).unwrap();
        let code = word(maps.len(), &picks);
        prop_assert_eq!(anew.ball(&piece(&anew, &code)), again.ball(&piece(&again, &code)));
        let z = DVec3::splat(0.2);
        prop_assert_eq!(anew.point(&piece(&anew, &code), z), again.point(&piece(&again, &code), z));
    }
}

#[test]
fn without_corners_the_formula_tears_and_with_them_it_does_not() {
    let mut moves = vec![DVec3::ZERO; 24];
    moves[23] = DVec3::new(0.4, 0.3, 0.5);
    let (maps, code) = (tetrahedron(), [1_u8, 0, 3, 3, 3]);
    // The middle of an edge of a piece, from either side.
    let other = [1_u8, 3, 0, 0, 0];
    let gap = |raw: bool| {
        let settings = Settings3 { raw, ..asked(1.0, 5.0, 0.8, Spin::None) };
        let bend = Bend3::new(&maps, mesh(&moves), settings, None).unwrap();
        let corners = Corners3::find(&maps).unwrap();
        let top = *corners.points().iter().max_by(|a, b| a.z.total_cmp(&b.z)).unwrap();
        let one = bend.point(&piece(&bend, &code), top);
        one.distance(bend.point(&piece(&bend, &other), DVec3::ZERO))
    };
    assert!(gap(false) < 1e-12 && gap(true) > 1e-4, "{} {}", gap(false), gap(true));
}

#[test]
fn bad_input_is_refused_in_words() {
    let moves = vec![DVec3::ZERO; 24];
    let new = |maps: &[Affine3], settings: Settings3| {
        Bend3::new(maps, mesh(&moves), settings, None).map(|_| ()).map_err(|error| error.code())
    };
    let fine = asked(0.0, 3.0, 0.5, Spin::None);
    assert_eq!(new(&tetrahedron(), fine), Ok(()));
    assert_eq!(new(&tetrahedron(), Settings3 { kb: 4.0, ..fine }), Err("bend-locality"));
    assert_eq!(new(&tetrahedron(), Settings3 { ke: f64::NAN, ..fine }), Err("bend-depth"));
    assert_eq!(new(&tetrahedron(), Settings3 { roughness: -1.0, ..fine }), Err("bend-roughness"));
    assert!(new(&[Affine3::scaling(DVec3::splat(2.0))], fine).is_err());
    assert!(new(&[], fine).is_err());
    // A point alone, and one map that is a point.
    assert_eq!(new(&vec![Affine3::scaling(DVec3::ZERO); 3], fine), Ok(()));
    // A detail beyond memory is taken down.
    let bend = Bend3::new(&sponge(), mesh(&moves), Settings3 { ke: 1e9, ..fine }, None).unwrap();
    assert_eq!(bend.ke(), 4.0);
    // Numbers as large as may be overflow nothing.
    let huge = vec![DVec3::splat(9e99); 24];
    for maps in [tetrahedron(), fern()] {
        let bend = Bend3::new(&maps, mesh(&huge), fine, None).unwrap();
        let (centre, radius) = bend.ball(&bend.whole());
        assert!(centre.is_finite() && radius.is_finite());
    }
}
