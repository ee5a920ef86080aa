//! Graph-directed systems: exact answers, systems of one state, and graphs that are none.

use frond_core::{
    Affine2, ChaosGame, DirectedError, DirectedGame, DirectedIfs, DirectedMap, DirectedMorph, HalfTurns,
    Hull, Ifs, MAX_STATES, Mode, adaptive_cut, directed_cut, directed_dimension, similarity_dimension,
};
use glam::DVec2;
use proptest::prelude::*;

fn part(from: usize, map: Affine2) -> DirectedMap {
    DirectedMap { from, map }
}

fn half(from: usize, x: f64, y: f64) -> DirectedMap {
    part(from, Affine2::similitude(0.5, 0.0, DVec2::new(x, y)))
}

/// The curve over each side of a triangle, clockwise, and Koch's curve from (0, 0) to (1, 0).
fn snowflake() -> Vec<Vec<DirectedMap>> {
    let turn = std::f64::consts::FRAC_PI_3;
    let height = 0.75_f64.sqrt();
    let to = |from, scale, angle, x, y| part(from, Affine2::similitude(scale, angle, DVec2::new(x, y)));
    let third = 1.0 / 3.0;
    vec![
        vec![to(1, 1.0, turn, 0.0, 0.0), to(1, 1.0, -turn, 0.5, height), to(1, 1.0, 3.0 * turn, 1.0, 0.0)],
        vec![
            to(1, third, 0.0, 0.0, 0.0),
            to(1, third, turn, third, 0.0),
            to(1, third, -turn, 0.5, height * third),
            to(1, third, 0.0, 2.0 * third, 0.0),
        ],
    ]
}

fn code(states: Vec<Vec<DirectedMap>>) -> String {
    let obvious = DirectedIfs::refuse_obvious(&states).err().map(|error| error.code());
    let found = DirectedIfs::new(states);
    // What is told without a search is what the search says.
    assert!(obvious.is_none() || obvious == found.as_ref().err().map(DirectedError::code));
    found.map_or_else(|error| error.code().to_owned(), |_| "fine".to_owned())
}

#[test]
fn the_snowflake_lies_in_its_star_and_has_its_area() {
    let flake = DirectedIfs::new(snowflake()).unwrap();
    let [outline, curve] = <[Hull; 2]>::try_from(Hull::of_states(&flake)).unwrap();
    let near = |a: DVec2, x: f64, y: f64| assert!(a.distance(DVec2::new(x, y)) < 0.01, "{a}");
    near(outline.min(), 0.0, -(1.0_f64 / 12.0).sqrt());
    near(outline.max(), 1.0, 0.75_f64.sqrt());
    near(curve.min(), 0.0, 0.0);
    near(curve.max(), 1.0, (1.0_f64 / 12.0).sqrt());
    assert_eq!((flake.unreached(), flake.never_return()), (vec![], vec![0]));
    for state in [0, 1] {
        let dimension = directed_dimension(&flake, state).unwrap();
        assert!((dimension - 4.0_f64.ln() / 3.0_f64.ln()).abs() < 1e-12, "{dimension}");
    }
    assert_eq!(directed_dimension(&flake, 2), None);
    // The pieces come in the order of the curve: their starts are the corners of the polygon of that step.
    for step in 0..6 {
        let mut corners = Vec::new();
        let size = 1.02 * 3.0_f64.powi(-step);
        let outcome = directed_cut(&flake, 0, size, 100_000, |piece| corners.push(piece.map.translation));
        assert!(outcome.complete && corners.len() == 3 * 4_usize.pow(step as u32), "{outcome:?}");
        let next = |i: usize| corners[(i + 1) % corners.len()];
        let area = 0.5 * (0..corners.len()).map(|i| next(i).perp_dot(corners[i])).sum::<f64>();
        let told = 3.0_f64.sqrt() / 4.0 * (1.0 + 0.6 * (1.0 - (4.0_f64 / 9.0).powi(step)));
        assert!((area - told).abs() < 1e-12, "{step}: {area} {told}");
    }
}

#[test]
fn the_rauzy_fractal_shrinks_by_its_ratio_and_fills_the_plane() {
    let beta = 1.839_286_755_214_161_f64;
    // x^3 = x^2 + x + 1 has the other roots a with a + conj a = 1 - beta, |a|^2 = 1 / beta.
    let real = (1.0 - beta) / 2.0;
    let alpha = DVec2::new(real, (1.0 / beta - real * real).sqrt());
    let by = |from, at| part(from, Affine2::new(glam::DMat2::from_cols(alpha, alpha.perp()), at));
    let here = |from| part(from, Affine2::IDENTITY);
    let rauzy = DirectedIfs::new(vec![
        vec![here(1), here(2), here(3)],
        vec![by(1, DVec2::ZERO), by(2, DVec2::ZERO), by(3, DVec2::ZERO)],
        vec![by(1, DVec2::X)],
        vec![by(2, DVec2::X)],
    ])
    .unwrap();
    let factor = rauzy.contraction().factor;
    assert!(factor >= 1.0 / beta.sqrt() - 1e-12 && factor < 0.75, "{factor}");
    for state in 0..4 {
        assert!((directed_dimension(&rauzy, state).unwrap() - 2.0).abs() < 1e-10);
    }
    // The areas of the three are an eigenvector: 1 : 1/beta : 1/beta^2.
    let p = rauzy.probabilities();
    let sum = 1.0 + 1.0 / beta + 1.0 / (beta * beta);
    for (p, share) in p[0].iter().zip([1.0, 1.0 / beta, 1.0 / (beta * beta)]) {
        assert!((p - share / sum).abs() < 1e-9, "{p} {share}");
    }
}

#[test]
fn dimensions_follow_the_largest_class() {
    // A line of halves beside a gasket, and both together: dimension 1, log2 3, and the larger of them.
    let states = vec![
        vec![half(1, 0.0, 0.0), half(2, 0.5, 0.0)],
        vec![half(1, 0.0, 0.0), half(1, 0.5, 0.0)],
        vec![half(2, 0.0, 0.0), half(2, 0.5, 0.0), half(2, 0.25, 0.5)],
    ];
    let system = DirectedIfs::new(states).unwrap();
    let told: Vec<f64> = (0..3).map(|state| directed_dimension(&system, state).unwrap()).collect();
    for (told, s) in told.iter().zip([3.0_f64.log2(), 1.0, 3.0_f64.log2()]) {
        assert!((told - s).abs() < 1e-12, "{told} {s}");
    }
    // Two that only change places: Cantor's dust in two states.
    let third = |from, x| part(from, Affine2::similitude(1.0 / 3.0, 0.0, DVec2::new(x, 0.0)));
    let places = vec![vec![third(1, 0.0), third(1, 2.0)], vec![third(0, 0.0), third(0, 2.0)]];
    let dust = DirectedIfs::new(places).unwrap();
    assert!((directed_dimension(&dust, 1).unwrap() - 2.0_f64.ln() / 3.0_f64.ln()).abs() < 1e-12);
    let flat = vec![vec![part(0, Affine2::from_row([0.5, 0.0, 0.0, 0.4, 0.0, 0.0])), half(0, 0.5, 0.0)]];
    assert_eq!(directed_dimension(&DirectedIfs::new(flat).unwrap(), 0), None);
}

#[test]
fn graphs_that_are_none_get_a_word_that_says_where() {
    assert_eq!(code(vec![]), "no-states");
    assert_eq!(code(vec![vec![half(0, 0.0, 0.0)]; MAX_STATES + 1]), "too-many-states");
    assert_eq!(code(vec![vec![half(0, 0.0, 0.0)], vec![]]), "no-maps");
    assert_eq!(code(vec![vec![]]), "no-maps");
    assert_eq!(code(vec![vec![half(0, 0.0, 0.0); 65]]), "too-many-maps");
    assert_eq!(code(vec![vec![half(1, 0.0, 0.0)]]), "state");
    assert_eq!(code(vec![vec![half(usize::MAX, 0.0, 0.0)]]), "state");
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        assert_eq!(
            code(vec![vec![half(0, 0.0, 0.0), half(1, bad, 0.0)], vec![half(0, 0.0, 0.0)]]),
            "not-finite"
        );
    }
    let text = |states| DirectedIfs::new(states).unwrap_err().to_string();
    let lost = text(vec![vec![half(0, 0.0, 0.0), half(3, 0.0, 0.0)], vec![half(0, 0.0, 0.0)]]);
    assert!(lost.contains("Map 2 of state 1 copies state 4, and there are 2."), "{lost}");
    let none = text(vec![vec![half(1, 0.0, 0.0)], vec![]]);
    assert!(none.contains("State 2 has no maps"), "{none}");
    // Each map shrinks or not; what counts is the way round.
    let by = |from, scale| part(from, Affine2::similitude(scale, 0.3, DVec2::X));
    let round = text(vec![vec![by(1, 3.0), half(0, 0.0, 0.0)], vec![half(1, 0.0, 0.0), by(0, 0.5)]]);
    assert!(round.contains("1 (by its map 1), 2 (by its map 2), 1 scales by 1.5000"), "{round}");
    assert_eq!(code(vec![vec![by(1, 3.0), half(0, 0.0, 0.0)], vec![half(1, 0.0, 0.0), by(0, 0.3)]]), "fine");
    // A large map that no way leads back through is no harm, and neither is the identity.
    assert_eq!(code(vec![vec![by(1, 40.0), part(1, Affine2::IDENTITY)], vec![half(1, 0.0, 0.0)]]), "fine");
    assert_eq!(code(vec![vec![by(1, 1.0)], vec![by(0, 1.0)]]), "no-attractor");
    for bad in [
        vec![vec![by(1, 1.0)], vec![by(0, 1.0)]],
        vec![vec![half(1, 0.0, 0.0)], vec![]],
        vec![vec![by(0, 1.0)]],
    ] {
        assert!(DirectedIfs::refuse_obvious(&bad).is_err());
    }
}

#[test]
fn sheared_ways_round_contract_in_ellipses_or_in_longer_blocks() {
    let shear = |s: f64| Affine2::from_row([1.0, s, 0.0, 1.0, 0.3, -1.0]);
    let turned = |from, angle| part(from, Affine2::similitude(0.6, angle, DVec2::X));
    let plain = vec![
        vec![turned(0, 0.4), turned(1, 2.0), turned(2, -1.0)],
        vec![turned(2, 1.0), turned(0, 1.2)],
        vec![turned(1, 0.1), turned(1, 2.5)],
    ];
    let system = DirectedIfs::new(plain).unwrap();
    let moved = system.moved(&[shear(30.0), shear(-12.0), Affine2::rotation(1.0)]).unwrap().unwrap();
    assert!(moved.states().iter().flatten().any(|part| part.map.norm() > 10.0));
    assert_eq!(moved.contraction().length, 1);
    assert!(moved.contraction().factor < 0.999, "{}", moved.contraction().factor);
    // No ellipse shrinks this one, but blocks do; 0.65 in the place of 0.6 does not shrink.
    let pair = |k: f64| {
        let a = Affine2::from_row([k, k, 0.0, k, 0.0, 0.0]);
        let b = Affine2::from_row([k, 0.0, k, k, 1.0, 0.0]);
        vec![vec![part(1, a), part(1, b)], vec![part(0, a), part(0, b)]]
    };
    assert_eq!((code(pair(0.6)), code(pair(0.65))), ("fine".to_owned(), "no-attractor".to_owned()));
}

#[test]
fn the_largest_graphs_are_checked_in_bounded_time() {
    let scale = |scale: f64| {
        let map = |i: usize, k: usize| {
            part((i + k) % MAX_STATES, Affine2::similitude(scale, (i * k) as f64, DVec2::new(k as f64, 1.0)))
        };
        (0..MAX_STATES).map(|i| (0..64).map(|k| map(i, k)).collect()).collect::<Vec<Vec<_>>>()
    };
    assert_eq!(code(scale(0.5)), "fine");
    assert_eq!(code(scale(1.0)), "no-attractor");
    let sheared = Affine2::from_row([0.9, 5.0, 0.0, 0.9, 0.0, 0.0]);
    let turned = Affine2::from_row([0.0, -0.9, 0.9, 0.0, 1.0, 0.0]);
    let mixed = (0..MAX_STATES)
        .map(|i| (0..64).map(|k| part(k, if (i + k).is_multiple_of(2) { sheared } else { turned })).collect())
        .collect();
    // The shortest way round that does not shrink has four maps: too many ways to look at.
    assert_eq!(code(mixed), "attractor-unproved");
}

#[test]
fn systems_that_were_found_may_have_more_states_and_be_moved() {
    let ring = |count: usize, maps: usize| -> Vec<Vec<DirectedMap>> {
        (0..count).map(|i| vec![half((i + 1) % count, 0.5, 0.0); maps]).collect()
    };
    let found = DirectedIfs::found(ring(200, 2)).unwrap();
    let by = vec![Affine2::similitude(2.0, 0.3, DVec2::ONE); found.len()];
    assert_eq!(found.moved(&by).unwrap().unwrap().len(), 200);
    let words = |states: usize, maps: usize| DirectedIfs::found(ring(states, maps)).unwrap_err().to_string();
    assert!(words(1025, 1).contains("1025 states, and the most is 1024"));
    assert!(words(200, 50).contains("10000 maps of all states together, and the most is 8192"));
}

#[test]
fn recurrent_systems_are_graphs_of_their_pieces() {
    let maps = [0.0, 0.5, 0.25].map(|x| Affine2::similitude(0.5, 0.0, DVec2::new(x, x)));
    let system = DirectedIfs::recurrent(&maps, &[0..3, 0..2, 1..3]).unwrap();
    let copies: Vec<Vec<usize>> =
        system.states().iter().map(|maps| maps.iter().map(|part| part.from).collect()).collect();
    assert_eq!(copies, [vec![1, 2, 3], vec![1, 2, 3], vec![1, 2], vec![2, 3]]);
    // All of which copy all are the plain system.
    let all = DirectedIfs::recurrent(&maps, &[0..3, 0..3, 0..3]).unwrap();
    let plain = Hull::of(&Ifs::new(maps.to_vec()).unwrap());
    let hull = &Hull::of_states(&all)[0];
    assert!(hull.min().distance(plain.min()) < 1e-2 && hull.max().distance(plain.max()) < 1e-2);
    let refused = |spans: &[std::ops::Range<usize>]| DirectedIfs::recurrent(&maps, spans).unwrap_err();
    assert_eq!(refused(&[0..3, 0..3]), DirectedError::NoMaps { state: 3 });
    assert_eq!(refused(&[0..3, 0..3, 0..usize::MAX]).code(), "too-many-maps");
    assert_eq!(refused(&[0..3, 0..3, 5..6]).code(), "state");
    let many = vec![maps[0]; 100_000];
    assert_eq!(DirectedIfs::recurrent(&many, &[]).unwrap_err().code(), "too-many-states");
}

#[test]
fn a_morph_goes_from_one_graph_to_another_and_leaves_both_shapes_as_they_are() {
    let flake = DirectedIfs::new(snowflake()).unwrap();
    let square = DirectedIfs::new(vec![
        vec![half(0, 0.0, 0.0), half(1, 0.5, 0.0), half(0, 0.0, 0.5), half(1, 0.5, 0.5)],
        vec![half(0, 0.0, 0.0), half(1, 0.5, 0.0), half(1, 0.0, 0.5)],
    ])
    .unwrap();
    let gasket =
        Ifs::new([0.0, 0.5, 0.25].map(|x| Affine2::similitude(0.5, 0.0, DVec2::new(x, x * x))).to_vec())
            .unwrap();
    let systems = [flake, square, DirectedIfs::from(&gasket)];
    for a in &systems {
        for b in &systems {
            let morph = DirectedMorph::new(a, b, Mode::Polar).unwrap();
            assert_eq!(morph.states()[0], (0, 0));
            assert_eq!(morph.steps().is_empty(), a == b, "{:?}", morph.steps());
            for (end, at) in [(a, 0.0), (b, 1.0)] {
                let there = DirectedIfs::new(morph.at(at, at)).unwrap();
                let (hull, own) = (&Hull::of_states(&there)[0], &Hull::of_states(end)[0]);
                assert!(hull.min().distance(own.min()) < 1e-2 && hull.max().distance(own.max()) < 1e-2);
                // Each state is one of the end's, and its maps are that one's, some of them twice.
                for (pair, maps) in morph.states().iter().zip(there.states()) {
                    let state = &end.states()[if at == 0.0 { pair.0 } else { pair.1 }];
                    assert!(maps.iter().all(|part| state.iter().any(|own| own.map == part.map)));
                    assert!(state.iter().all(|own| maps.iter().any(|part| own.map == part.map)));
                }
            }
        }
    }
    let same = DirectedMorph::new(&systems[1], &systems[1], Mode::Linear).unwrap();
    assert_eq!(same.at(0.3, 0.7), systems[1].states());
}

/// A square turned by half a turn: eq 6 of Burch & Hart goes from 180 to 0 degrees by 90, and back the same way.
#[test]
fn half_turns_go_by_signs_or_all_one_way() {
    let turned = |degrees: f64| {
        let at = |x: f64, y: f64| Affine2::similitude(0.5, degrees.to_radians(), DVec2::new(x, y));
        DirectedIfs::new(vec![vec![part(0, at(0.0, 0.0)), part(0, at(0.5, 0.5))]]).unwrap()
    };
    let (down, up) = (turned(180.0), turned(0.0));
    let halfway = |from: &DirectedIfs, to: &DirectedIfs, half: HalfTurns| {
        let morph = DirectedMorph::turning(from, to, Mode::Polar, half).unwrap();
        assert_eq!(morph.half_turns(), 2);
        let x = morph.at(0.5, 0.5)[0][0].map.linear.x_axis;
        x.y.atan2(x.x).to_degrees().round()
    };
    for (half, there, back) in [
        (HalfTurns::Signs, 90.0, 90.0),
        (HalfTurns::CounterClockwise, -90.0, 90.0),
        (HalfTurns::Clockwise, 90.0, -90.0),
    ] {
        assert_eq!((halfway(&down, &up, half), halfway(&up, &down, half)), (there, back), "{half:?}");
    }
    let still = DirectedMorph::turning(&down, &up, Mode::Linear, HalfTurns::Clockwise).unwrap();
    assert_eq!((still.half_turns(), still), (0, DirectedMorph::new(&down, &up, Mode::Linear).unwrap()));
}

#[test]
fn graphs_that_take_too_many_states_are_refused() {
    // A ring of 11 and one of 13 meet in 143 pairs.
    let ring = |count: usize| {
        DirectedIfs::new((0..count).map(|i| vec![half((i + 1) % count, i as f64, 0.0)]).collect()).unwrap()
    };
    let error = DirectedMorph::new(&ring(11), &ring(13), Mode::Polar).unwrap_err();
    assert_eq!(error.code(), "graph-match");
    assert_eq!(DirectedMorph::new(&ring(6), &ring(10), Mode::Polar).unwrap().states().len(), 30);
}

/// Maps that mostly shrink; some are singular, reflecting or sheared, some stretch.
fn any_part(states: usize) -> impl Strategy<Value = DirectedMap> {
    let entry = prop_oneof![6 => -0.6..0.6_f64, 1 => Just(0.0), 1 => Just(0.5), 1 => -1.5..1.5_f64];
    let shift = prop_oneof![6 => -1.0..1.0_f64, 1 => Just(0.0)];
    let row = (entry.clone(), entry.clone(), entry.clone(), entry, shift.clone(), shift);
    (0..states, row).prop_map(|(from, (a, b, c, d, e, f))| part(from, Affine2::from_row([a, b, c, d, e, f])))
}

fn any_states() -> impl Strategy<Value = Vec<Vec<DirectedMap>>> {
    (1_usize..5).prop_flat_map(|states| {
        proptest::collection::vec(proptest::collection::vec(any_part(states), 0..5), states)
    })
}

fn any_maps() -> impl Strategy<Value = Vec<Affine2>> {
    proptest::collection::vec(any_part(1).prop_map(|part| part.map), 1..6)
}

proptest! {
    #[test]
    fn a_system_of_one_state_is_the_plain_one_bit_by_bit(maps in any_maps(), seed: u32) {
        let states = vec![maps.iter().map(|&map| part(0, map)).collect()];
        match (Ifs::new(maps), DirectedIfs::new(states)) {
            (Err(plain), Err(directed)) => prop_assert_eq!(DirectedError::Ifs(plain), directed),
            (Ok(plain), Ok(directed)) => {
                prop_assert_eq!(&DirectedIfs::from(&plain), &directed);
                prop_assert_eq!(&Hull::of_states(&directed)[0], &Hull::of(&plain));
                let (mut p, mut q) = ([0.0; 200], [0.0; 200]);
                let (mut i, mut j) = ([0; 100], [0; 100]);
                ChaosGame::new(&plain, seed).fill(&mut p, &mut i);
                DirectedGame::new(&directed, 0, seed).unwrap().fill(&mut q, &mut j);
                prop_assert_eq!((p.map(f32::to_bits), i), (q.map(f32::to_bits), j));
                let size = 0.05 * Hull::of(&plain).diameter();
                let (mut cut, mut own) = (Vec::new(), Vec::new());
                let told = adaptive_cut(&plain, size, 2000, |map, first| cut.push((*map, first)));
                let same = directed_cut(&directed, 0, size, 2000, |piece| own.push((piece.map, piece.first)));
                prop_assert_eq!((told, cut), (same, own));
                let alike = |s: Option<f64>, t: Option<f64>| match (s, t) {
                    (Some(s), Some(t)) => (s - t).abs() < 1e-9 || s == t,
                    (s, t) => s.is_none() && t.is_none(),
                };
                let told = (similarity_dimension(&plain), directed_dimension(&directed, 0));
                prop_assert!(alike(told.0, told.1), "{told:?}");
            }
            (plain, directed) => prop_assert!(false, "{plain:?} {directed:?}"),
        }
    }

    #[test]
    fn points_lie_in_the_hull_and_every_hull_in_the_images_of_others(states in any_states(), seed: u32) {
        let Ok(system) = DirectedIfs::new(states) else { return Ok(()) };
        let hulls = Hull::of_states(&system);
        let extent = hulls.iter().map(|h| h.radius() + h.centre().length()).fold(1.0, f64::max);
        // Maps that hardly shrink carry their rounding far.
        let slack = 1e-4 * extent / (1.0 - system.contraction().factor);
        for (state, hull) in hulls.iter().enumerate() {
            let disc = system.contraction().discs[state];
            prop_assert!(hull.vertices().iter().all(|v| v.is_finite()));
            let mut positions = [0.0; 100];
            let mut pieces = [0; 50];
            let mut game = DirectedGame::new(&system, state, seed).unwrap();
            prop_assert_eq!(game.fill(&mut positions, &mut pieces), 50);
            for (point, piece) in positions.as_chunks::<2>().0.iter().zip(pieces) {
                let p = DVec2::new(point[0].into(), point[1].into());
                prop_assert!(p.distance(hull.centre()) <= hull.radius() + slack, "{p} {hull:?}");
                let away = (disc.to_round * (p - disc.centre)).length();
                prop_assert!(away <= disc.radius + slack * (1.0 + disc.to_round.to_cols_array().map(f64::abs).iter().sum::<f64>()));
                prop_assert!(usize::from(piece) < system.states()[state].len());
            }
        }
    }

    #[test]
    fn each_disc_holds_the_images_of_the_discs_that_it_copies(states in any_states()) {
        let Ok(system) = DirectedIfs::new(states) else { return Ok(()) };
        prop_assume!(system.contraction().length == 1);
        let discs = &system.contraction().discs;
        for (state, maps) in system.states().iter().enumerate() {
            for part in maps {
                let (own, inner) = (discs[state], discs[part.from]);
                for k in 0..16 {
                    let rim = DVec2::from_angle(0.4 * f64::from(k)) * inner.radius;
                    let point = part.map.apply(inner.centre + inner.from_round * rim);
                    let away = (own.to_round * (point - own.centre)).length();
                    prop_assert!(away <= own.radius * (1.0 + 1e-6) + 1e-9, "{away} {}", own.radius);
                }
            }
        }
    }

    #[test]
    fn whatever_is_given_gets_an_answer(
        states in proptest::collection::vec(proptest::collection::vec(
            (0_usize..4, proptest::array::uniform6(prop_oneof![
                Just(0.0), Just(1.0), Just(f64::NAN), Just(1e99), Just(-1e-300), -2.0..2.0_f64,
            ])).prop_map(|(from, row)| part(from, Affine2::from_row(row))), 0..4), 0..4),
    ) {
        let obvious = DirectedIfs::refuse_obvious(&states);
        let found = DirectedIfs::new(states);
        prop_assert!(obvious.is_ok() || found.is_err(), "{obvious:?}");
        if let Ok(system) = found {
            prop_assert!(system.contraction().factor < 1.0);
            let sums = system.probabilities().iter().map(|p| p.iter().sum::<f64>());
            prop_assert!(sums.into_iter().all(|sum| (sum - 1.0).abs() < 1e-9));
            let _ = (Hull::of_states(&system), system.points(), system.unreached(), system.never_return());
            let morph = DirectedMorph::new(&system, &system, Mode::Polar).unwrap();
            let _ = DirectedIfs::new(morph.at(0.5, 0.5));
        }
    }
}
