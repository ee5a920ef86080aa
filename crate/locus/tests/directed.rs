//! Which states of graph-directed systems are in one piece.

use frond_core::{
    Affine2, DirectedIfs, DirectedMap, DirectedMorph, Ifs, Mode, directed_cut, directed_dimension,
};
use frond_locus::{
    Bounds, DirectedCertifyOptions, Gap, LocusGrid, Options, State, StateConnectedness, StateOnTheWay,
    Verdict, certify_directed, connectedness, directed_connectedness, directed_tile,
};
use frond_scene::directed_presets;
use glam::{DMat2, DVec2};
use proptest::prelude::*;

fn part(from: usize, map: Affine2) -> DirectedMap {
    DirectedMap { from, map }
}

/// A copy of a line, `scale` as long, moved along it.
fn line(from: usize, scale: f64, x: f64) -> DirectedMap {
    part(from, Affine2::similitude(scale, 0.0, DVec2::new(x, 0.0)))
}

/// States of a morph by their names, each with its maps in an order of their own: what does not hang on how states and
/// maps are numbered.
fn unnumbered(morph: &DirectedMorph, [u, v]: [f64; 2], swapped: bool) -> Vec<((usize, usize), Vec<String>)> {
    let name = |&(i, j): &(usize, usize)| if swapped { (j, i) } else { (i, j) };
    let names: Vec<_> = morph.states().iter().map(name).collect();
    let state = |maps: &Vec<DirectedMap>| {
        let told = |part: &DirectedMap| {
            let row = part.map.to_row().map(|x| (x * 1e6 + 0.123).round() / 1e6);
            format!("{:?} {row:?}", names[part.from])
        };
        let mut maps: Vec<String> = maps.iter().map(told).collect();
        maps.sort();
        maps
    };
    let mut states: Vec<_> = names.iter().copied().zip(morph.at(u, v).iter().map(state)).collect();
    states.sort();
    states
}

#[test]
fn from_the_other_end_a_morph_of_the_gallery_runs_backwards() {
    let presets = directed_presets();
    let system = |states: &Vec<Vec<DirectedMap>>| DirectedIfs::new(states.clone()).unwrap();
    let (mut alike, mut differ) = (0, Vec::new());
    for (i, a) in presets.iter().enumerate() {
        for b in &presets[i + 1..] {
            for mode in [Mode::Polar, Mode::Linear] {
                let (from, to) = (system(&a.states), system(&b.states));
                let Ok(there) = DirectedMorph::new(&from, &to, mode) else { continue };
                let back = DirectedMorph::new(&to, &from, mode).unwrap();
                let same = |u: f64, v: f64| {
                    unnumbered(&there, [u, v], false) == unnumbered(&back, [1.0 - u, 1.0 - v], true)
                };
                alike += 1;
                if !same(0.3, 0.6) || !same(0.0, 1.0) {
                    differ.push((a.id, b.id, mode));
                }
            }
        }
    }
    assert!(differ.is_empty() && alike > 50, "{alike} {differ:?}");
}

fn preset(id: &str) -> DirectedIfs {
    let found = directed_presets().into_iter().find(|preset| preset.id == id).unwrap();
    DirectedIfs::new(found.states).unwrap()
}

fn decided(states: Vec<Vec<DirectedMap>>) -> Vec<StateConnectedness> {
    directed_connectedness(&DirectedIfs::new(states).unwrap(), &Options::default())
}

fn verdicts(found: &[StateConnectedness]) -> Vec<Verdict> {
    found.iter().map(|state| state.verdict).collect()
}

#[test]
fn what_is_known_of_the_presets() {
    use Verdict::{Connected, Touching};
    for (id, verdict, read) in [
        ("frond", Connected, false),
        ("snowflake", Connected, false),
        ("crystal", Connected, false),
        ("two-dragons", Connected, false),
        ("sun", Touching, true),
        ("rauzy", Touching, false),
        ("pentigree", Touching, true),
        ("quilt", Connected, false),
    ] {
        let system = preset(id);
        let found = directed_connectedness(&system, &Options::default());
        for (state, maps) in found.iter().zip(system.states()) {
            assert_eq!(state.verdict, verdict, "{id}: {state:?}");
            // A state of one copy has nothing to be joined.
            assert!(
                state.links.len() >= if verdict == Connected { maps.len() - 1 } else { 0 },
                "{id}: {state:?}"
            );
            assert_eq!(!state.assuming.is_empty(), read, "{id}: {state:?}");
            assert!(state.gap.lower == 0.0 && state.open_by.is_empty());
        }
    }
    assert_eq!(directed_presets().len(), 8, "what is new has to be told here");
    let pentigree = directed_dimension(&preset("pentigree"), 0).unwrap();
    let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
    assert!((pentigree - 6.0_f64.ln() / (2.0 * golden.ln())).abs() < 1e-9, "{pentigree}");
    let sun = directed_dimension(&preset("sun"), 0).unwrap();
    assert!((sun - 2.0).abs() < 1e-9, "{sun}");
    let quilt = directed_dimension(&preset("quilt"), 1).unwrap();
    assert!((quilt - (2.0 + 2.0_f64.sqrt()).log2()).abs() < 1e-9, "{quilt}");
}

#[test]
fn ways_are_told_by_the_maps_along_them() {
    let found = directed_connectedness(&preset("two-dragons"), &Options::default());
    // Both begin at 0 with their first map, and end at 1: the first with its second, of the second state.
    assert_eq!(found[0].links.len(), 1);
    assert_eq!(found[0].links[0].pair, (0, 1));
    assert!(found[0].links[0].at.distance(DVec2::new(0.5, 0.5)) < 1e-12);
    assert_eq!(found[0].links[0].words, ["1(2)", "2(1)"]);
}

#[test]
fn dust_is_in_pieces_by_as_much_as_its_gap() {
    // Both are dust: 0 has thirds of 1, 1 has fifths of both.
    let states = vec![
        vec![line(1, 1.0 / 3.0, 0.0), line(1, 1.0 / 3.0, 2.0)],
        vec![line(0, 0.2, 0.0), line(1, 0.2, 3.0)],
    ];
    let found = decided(states);
    assert_eq!(verdicts(&found), [Verdict::Disconnected; 2]);
    // The ends: p = q / 3 + 2 and q = 3 + q / 5, so that q is 15/4 and p is 13/4.
    for (state, gap) in found.iter().zip([2.0 - 1.25, 3.0 - 0.65]) {
        assert!(state.gap.lower <= gap && gap <= state.gap.upper + 1e-9, "{:?} {gap}", state.gap);
        assert!(state.gap.upper < 1.02 * gap, "{:?} {gap}", state.gap);
        let (p, q) = state.closest.unwrap();
        assert!((p.distance(q) - gap).abs() < 0.02 * gap);
    }
}

#[test]
fn what_is_made_of_dust_is_looked_into() {
    let dust = vec![line(1, 1.0 / 3.0, 0.0), line(1, 1.0 / 3.0, 2.0 / 3.0)];
    let segment = vec![line(2, 0.5, 0.0), line(2, 0.5, 0.5)];
    // The dust and its copy that ends where it begins: the two meet in a point, and are in pieces all the same.
    let two = decided(vec![vec![line(1, 1.0, 0.0), line(1, 1.0, 1.0)], dust.clone(), segment.clone()]);
    assert_eq!(verdicts(&two), [Verdict::Disconnected, Verdict::Disconnected, Verdict::Connected]);
    assert!((two[0].gap.upper - 1.0 / 3.0).abs() < 0.01, "{:?}", two[0].gap);
    // Filled by a segment it is whole, which no splitting shows: the question stays open, by the dust.
    let filled = decided(vec![vec![line(1, 1.0, 0.0), line(2, 1.0, 0.0)], dust, segment]);
    assert_eq!(verdicts(&filled), [Verdict::Undecided, Verdict::Disconnected, Verdict::Connected]);
    assert_eq!(filled[0].open_by, [1]);
    assert_eq!(filled[0].gap.lower, 0.0);
}

#[test]
fn touching_is_not_connected() {
    // A line with a slit narrower than epsilon, and one with a slit that is told apart.
    let slit = |width: f64| {
        let half = 0.5 - 0.5 * width;
        let ends = [line(1, 1.0, 0.0), line(1, 1.0, 1.0)].to_vec();
        decided(vec![ends, vec![line(1, half, 0.0), line(1, half, 0.5 + 0.5 * width)]])
    };
    assert_eq!(verdicts(&slit(0.0)), [Verdict::Connected; 2]);
    assert_eq!(verdicts(&slit(1e-5)), [Verdict::Touching; 2]);
    assert_eq!(slit(0.01)[1].verdict, Verdict::Disconnected);
    let system = DirectedIfs::new(vec![
        vec![line(1, 1.0, 0.0), line(1, 1.0, 1.0)],
        vec![line(1, 0.5 - 1e-5, 0.0), line(1, 0.5 - 1e-5, 0.5)],
    ])
    .unwrap();
    let fine = directed_connectedness(&system, &Options { epsilon: 1e-7, ..Options::default() });
    assert_eq!(verdicts(&fine), [Verdict::Disconnected; 2]);
    for epsilon in [f64::NAN, -1.0] {
        let found = directed_connectedness(&system, &Options { epsilon, budget: 20_000 });
        assert_eq!(verdicts(&found), [Verdict::Disconnected; 2]);
    }
    let spent = directed_connectedness(&system, &Options { epsilon: 1e-7, budget: 0 });
    assert!(spent.iter().all(|state| state.verdict != Verdict::Connected));
}

#[test]
fn points_and_doubled_maps_are_in_one_piece() {
    let still = |x: f64| Affine2::new(DMat2::ZERO, DVec2::new(x, 2.0));
    let found = decided(vec![vec![line(1, 0.5, 0.0), line(1, 0.5, 0.0)], vec![part(1, still(3.0))]]);
    assert_eq!(verdicts(&found), [Verdict::Connected; 2]);
    let apart = decided(vec![vec![line(1, 1.0, 0.0), line(1, 1.0, 5.0)], vec![part(1, still(3.0))]]);
    assert_eq!(verdicts(&apart), [Verdict::Disconnected, Verdict::Connected]);
    assert!((apart[0].gap.upper - 5.0).abs() < 1e-6);
}

#[test]
fn the_largest_graphs_are_answered_in_bounded_time() {
    let map = |i: usize, k: usize| {
        part(
            (i + k) % 64,
            Affine2::similitude(0.1, (i * k) as f64, DVec2::new((k % 8) as f64, (k / 8) as f64)),
        )
    };
    let states = (0..64).map(|i| (0..64).map(|k| map(i, k)).collect()).collect();
    let system = DirectedIfs::new(states).unwrap();
    let found = directed_connectedness(&system, &Options { budget: 2000, ..Options::default() });
    assert_eq!(found.len(), 64);
    assert!(found.iter().all(|state| state.verdict != Verdict::Connected));
}

/// The curve over these knots as over 0 to 1, around a square.
fn around(knots: &[(f64, f64)]) -> DirectedIfs {
    let crystal = preset("crystal");
    let points: Vec<DVec2> = knots.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    let along = |pair: &[DVec2]| {
        let z = pair[1] - pair[0];
        part(1, Affine2::new(DMat2::from_cols(z, z.perp()), pair[0]))
    };
    let curve = points.windows(2).map(along).collect();
    DirectedIfs::new(vec![crystal.states()[0].clone(), curve]).unwrap()
}

#[test]
fn curves_between_fixed_ends_stay_in_one_piece_on_the_way() {
    let crystal = preset("crystal");
    let other = around(&[(0.0, 0.0), (0.25, 0.25), (0.5, -0.125), (0.75, 0.0), (1.0, 0.0)]);
    let morph = DirectedMorph::new(&crystal, &other, Mode::Linear).unwrap();
    let proof = certify_directed(&morph, &DirectedCertifyOptions::default());
    assert_eq!(proof.states, [StateOnTheWay::Connected; 2]);
    assert!(proof.assuming.is_empty() && proof.moments == 0);
    // It holds where it is looked at, too.
    for k in 0..=8 {
        let t = f64::from(k) / 8.0;
        let there = DirectedIfs::new(morph.at(t, t)).unwrap();
        let found = directed_connectedness(&there, &Options::default());
        assert!(found.iter().all(|state| state.verdict == Verdict::Connected), "{t}: {found:?}");
    }
    // By eq 6 the maps turn, and the ends of their copies leave each other: no proof, but none that breaks.
    let turned = DirectedMorph::new(&crystal, &other, Mode::Polar).unwrap();
    let proof = certify_directed(&turned, &DirectedCertifyOptions::default());
    assert!(proof.states.iter().all(|state| *state != StateOnTheWay::Connected), "{proof:?}");
    // The snowflake to the triangle: its doubles add up exactly.
    let flake = preset("snowflake");
    let mut low = flake.states().to_vec();
    for (part, at) in low[1].iter_mut().zip([0.0, 0.25, 0.5, 0.75]) {
        part.map = Affine2::similitude(0.25, 0.0, DVec2::new(at, 0.0));
    }
    let morph = DirectedMorph::new(&flake, &DirectedIfs::new(low).unwrap(), Mode::Linear).unwrap();
    let proof = certify_directed(&morph, &DirectedCertifyOptions::default());
    assert_eq!(proof.states, [StateOnTheWay::Connected; 2]);
    // The numbers of the pentigree have to be read.
    let still = DirectedMorph::new(&preset("pentigree"), &preset("pentigree"), Mode::Polar).unwrap();
    let proof = certify_directed(&still, &DirectedCertifyOptions::default());
    assert_eq!(proof.states, [StateOnTheWay::Connected; 2]);
    assert!(!proof.assuming.is_empty());
}

#[test]
fn a_fern_becomes_a_leaf_in_one_piece_at_every_moment() {
    // A polygon with as many corners as leaves have; and an edge that is made of two copies.
    let corners: Vec<DVec2> = (0..40)
        .map(|k| {
            DVec2::from_angle(0.05 * std::f64::consts::PI * f64::from(k)) * (1.0 + 0.2 * f64::from(k % 2))
        })
        .collect();
    let onto = |from: usize, k: usize| {
        let along = corners[(k + 1) % 40] - corners[k];
        DirectedMap { from, map: Affine2::new(DMat2::from_cols(along, along.perp()), corners[k]) }
    };
    let whole: Vec<DirectedMap> = (0..40).map(|k| onto(1 + usize::from(k == 7), k)).collect();
    let bent =
        |z: DVec2, at: DVec2| DirectedMap { from: 2, map: Affine2::new(DMat2::from_cols(z, z.perp()), at) };
    let top = DVec2::new(0.5, 0.3);
    let leaf = DirectedIfs::new(vec![
        whole,
        vec![line(1, 0.5, 0.0), line(1, 0.5, 0.5)],
        vec![bent(top, DVec2::ZERO), bent(DVec2::X - top, top)],
    ])
    .unwrap();
    for (from, to) in [(preset("frond"), leaf.clone()), (leaf, preset("frond"))] {
        let morph = DirectedMorph::new(&from, &to, Mode::Linear).unwrap();
        let proof = certify_directed(&morph, &DirectedCertifyOptions::default());
        assert!(proof.states.iter().all(|state| *state == StateOnTheWay::Connected), "{proof:?}");
        assert!(proof.assuming.is_empty() && proof.moments == 0);
        // It holds where it is looked at, too.
        let there = DirectedIfs::new(morph.at(0.4, 0.4)).unwrap();
        let found = directed_connectedness(&there, &Options::default());
        assert!(found[0].verdict.holds(), "{:?} {:?}", found[0].verdict, found[0].gap);
    }
}

#[test]
fn nothing_is_proved_of_a_way_without_an_attractor() {
    // Both ends contract, and have 0 in both pieces; halfway one map stretches.
    let flat = |b: f64, c: f64| part(0, Affine2::from_row([0.1, b, c, 0.1, 0.0, 0.0]));
    let [first, last] = [flat(4.0, 0.0), flat(0.0, 4.0)]
        .map(|map| DirectedIfs::new(vec![vec![map, line(0, 0.5, 0.0)]]).unwrap());
    let morph = DirectedMorph::new(&first, &last, Mode::Linear).unwrap();
    assert!(DirectedIfs::new(morph.at(0.5, 0.5)).is_err());
    let proof = certify_directed(&morph, &DirectedCertifyOptions::default());
    assert!(matches!(proof.states[0], StateOnTheWay::Open(_)), "{proof:?}");
}

#[test]
fn doubled_maps_that_part_are_not_held_together_by_having_been_one() {
    let first = vec![vec![line(0, 0.5, 0.0), line(0, 0.5, 0.0), line(0, 0.5, 0.5)]];
    let last = vec![vec![line(0, 0.5, 0.0), line(0, 0.25, 10.0), line(0, 0.5, 0.5)]];
    let [first, last] = [first, last].map(|states| DirectedIfs::new(states).unwrap());
    let morph = DirectedMorph::new(&first, &last, Mode::Linear).unwrap();
    let proof = certify_directed(&morph, &DirectedCertifyOptions::default());
    assert!(matches!(proof.states[0], StateOnTheWay::Open(_)), "{proof:?}");
    // Where they stay one they hold.
    let still = DirectedMorph::new(&first, &first, Mode::Polar).unwrap();
    let proof = certify_directed(&still, &DirectedCertifyOptions::default());
    assert_eq!(proof.states, [StateOnTheWay::Connected]);
}

#[test]
fn a_way_by_eq_6_is_held_within_epsilon_or_said_to_break() {
    let quilt = preset("quilt");
    let mut larger = quilt.states().to_vec();
    for part in larger.iter_mut().flatten() {
        let about = part.map.apply(DVec2::splat(0.5));
        let turn = Affine2::similitude(1.06, 0.06, DVec2::ZERO).about(about);
        part.map = turn * part.map;
    }
    let morph = DirectedMorph::new(&quilt, &DirectedIfs::new(larger).unwrap(), Mode::Polar).unwrap();
    let options =
        DirectedCertifyOptions { epsilon: 0.05, moments: 200, budget: 20_000, ..Default::default() };
    let proof = certify_directed(&morph, &options);
    assert_eq!(proof.states, [StateOnTheWay::Within(0.05); 2], "{}", proof.moments);
    // Pieces that go apart.
    let segment = |scale: f64| {
        DirectedIfs::new(vec![
            vec![line(1, 0.5, 0.0), line(1, 0.5, 0.5)],
            vec![line(0, scale, 0.0), line(0, scale, 0.5)],
        ])
        .unwrap()
    };
    let morph = DirectedMorph::new(&segment(0.5), &segment(0.25), Mode::Polar).unwrap();
    let proof = certify_directed(&morph, &options);
    assert!(
        proof.states.iter().all(|state| matches!(state, StateOnTheWay::Open(at) if *at < 0.5)),
        "{proof:?}"
    );
}

fn any_map() -> impl Strategy<Value = Affine2> {
    let entry = prop_oneof![6 => -0.6..0.6_f64, 1 => Just(0.0), 1 => Just(0.5)];
    let shift = prop_oneof![6 => -1.0..1.0_f64, 1 => Just(0.0), 1 => Just(0.5)];
    (entry.clone(), entry.clone(), entry.clone(), entry, shift.clone(), shift)
        .prop_map(|(a, b, c, d, e, f)| Affine2::from_row([a, b, c, d, e, f]))
}

fn any_system() -> impl Strategy<Value = DirectedIfs> {
    let states = (1_usize..4).prop_flat_map(|states| {
        let maps =
            proptest::collection::vec((0..states, any_map()).prop_map(|(from, map)| part(from, map)), 1..4);
        proptest::collection::vec(maps, states)
    });
    states.prop_filter_map("no attractor", |states| DirectedIfs::new(states).ok())
}

/// The widest edge of the minimum spanning tree between sets of points.
fn widest(sets: &[Vec<DVec2>]) -> f64 {
    let apart = |a: &[DVec2], b: &[DVec2]| {
        a.iter().flat_map(|p| b.iter().map(move |q| p.distance(*q))).fold(f64::INFINITY, f64::min)
    };
    let mut inside = vec![0];
    let mut outside: Vec<usize> = (1..sets.len()).collect();
    let mut most = 0.0_f64;
    while !outside.is_empty() {
        let reach =
            |&k: &usize| inside.iter().map(|&i| apart(&sets[i], &sets[k])).fold(f64::INFINITY, f64::min);
        let near = outside.iter().copied().min_by(|a, b| reach(a).total_cmp(&reach(b))).unwrap();
        most = most.max(reach(&near));
        outside.retain(|&k| k != near);
        inside.push(near);
    }
    most
}

proptest! {
    #![proptest_config(ProptestConfig { cases: frond_testing::cases(64), ..ProptestConfig::default() })]

    #[test]
    fn one_state_is_decided_as_a_plain_system(maps in proptest::collection::vec(any_map(), 1..4)) {
        let Ok(ifs) = Ifs::new(maps) else { return Ok(()) };
        let options = Options { budget: 20_000, ..Options::default() };
        let (plain, own) = (connectedness(&ifs, &options), directed_connectedness(&DirectedIfs::from(&ifs), &options));
        prop_assert_eq!(own.len(), 1);
        prop_assert_eq!(&plain.verdict, &own[0].verdict);
        prop_assert_eq!((plain.gap, plain.overlaps, plain.closest), (own[0].gap, own[0].overlaps.clone(), own[0].closest));
    }

    #[test]
    fn copies_of_a_plain_system_are_decided_as_it_is(maps in proptest::collection::vec(any_map(), 1..4)) {
        let Ok(ifs) = Ifs::new(maps.clone()) else { return Ok(()) };
        // Two states, each made of the other: both are the one shape.
        let turn = |to: usize| maps.iter().map(|&map| part(to, map)).collect::<Vec<_>>();
        let Ok(twice) = DirectedIfs::new(vec![turn(1), turn(0)]) else { return Ok(()) };
        let options = Options { budget: 20_000, ..Options::default() };
        let plain = connectedness(&ifs, &options);
        for state in directed_connectedness(&twice, &options) {
            let apart = |a: Verdict, b: Verdict| a == Verdict::Connected && b == Verdict::Disconnected;
            prop_assert!(!apart(plain.verdict, state.verdict) && !apart(state.verdict, plain.verdict));
            prop_assert!(state.gap.lower <= plain.gap.upper * (1.0 + 1e-9) + 1e-12, "{:?} {:?}", state.gap, plain.gap);
            prop_assert!(plain.gap.lower <= state.gap.upper * (1.0 + 1e-9) + 1e-12, "{:?} {:?}", state.gap, plain.gap);
        }
    }

    #[test]
    fn gaps_hold_against_points_of_the_pieces(system in any_system()) {
        let options = Options { budget: 20_000, ..Options::default() };
        let found = directed_connectedness(&system, &options);
        let points = system.points();
        for (state, found) in found.iter().enumerate() {
            let size = 0.02 * found.diameter;
            let mut sets = vec![Vec::new(); system.states()[state].len()];
            let outcome = directed_cut(&system, state, size, 4000, |piece| {
                sets[piece.first].push(piece.map.apply(points[piece.from]));
            });
            if !outcome.complete || sets.iter().any(Vec::is_empty) || found.diameter == 0.0 {
                continue;
            }
            let seen = widest(&sets);
            // Points are no nearer than the pieces, and no farther by more than two of their parts.
            if found.verdict == Verdict::Disconnected {
                let level = found.gap.lower > seen * (1.0 + 1e-9) + 1e-9 * found.diameter;
                // A gap that is deeper than the pieces is not seen between them.
                prop_assert!(!level || seen <= 2.0 * size, "{:?} {seen}", found.gap);
            } else {
                prop_assert!(found.gap.upper + 2.0 * size + 1e-9 >= seen || found.verdict == Verdict::Undecided);
            }
            if found.verdict == Verdict::Connected {
                prop_assert!(seen <= 2.0 * size + 1e-9, "{seen} {found:?}");
            }
        }
    }
}

/// A row of 40 copies of a row of 40 lines, which is parted in the middle by this much of its length.
fn parted_rows(gap: f64) -> DirectedIfs {
    let within = |from: usize, x0: f64, x1: f64| {
        (0..20).map(move |k| {
            let scale = (x1 - x0) / 20.0;
            line(from, scale, x0 + scale * f64::from(k))
        })
    };
    let half = 0.5 * (1.0 - gap);
    let parted = within(2, 0.0, half).chain(within(2, 1.0 - half, 1.0)).collect();
    let row = within(1, 0.0, 0.5).chain(within(1, 0.5, 1.0)).collect();
    DirectedIfs::new(vec![row, parted, vec![line(2, 0.5, 0.0), line(2, 0.5, 0.5)]]).unwrap()
}

#[test]
fn a_gap_within_pieces_is_found_where_there_are_too_many_to_split_all() {
    use Verdict::{Connected, Disconnected};
    // The second gap is finer than epsilon of the whole.
    for gap in [0.2, 0.02] {
        let found = directed_connectedness(&parted_rows(gap), &Options::default());
        assert_eq!(verdicts(&found), [Disconnected, Disconnected, Connected]);
        let Gap { lower, upper } = found[0].gap;
        assert!(0.9 * gap / 40.0 < lower && upper < 1.1 * gap / 40.0, "{lower} {upper}");
    }
}

#[test]
fn the_search_for_a_proof_ends_where_the_shape_or_a_part_of_it_is_lost() {
    let morph = |gap: f64| DirectedMorph::new(&parted_rows(gap), &parted_rows(0.21), Mode::Polar).unwrap();
    let proof = certify_directed(&morph(0.2), &DirectedCertifyOptions::default());
    assert_eq!(proof.moments, 1);
    assert!(proof.states[..2].iter().all(|state| matches!(state, StateOnTheWay::Open(_))), "{proof:?}");
    // And where all the work that was to be done is done.
    let morph = DirectedMorph::new(&parted_rows(0.0), &parted_rows(0.001), Mode::Polar).unwrap();
    let least = DirectedCertifyOptions { epsilon: 0.1, work: 1, ..Default::default() };
    assert!(matches!(certify_directed(&morph, &least).states[0], StateOnTheWay::Open(_)));
    let all = DirectedCertifyOptions { epsilon: 0.1, ..Default::default() };
    assert_eq!(certify_directed(&morph, &all).states[0], StateOnTheWay::Within(0.1));
}

/// Red where the map says other than the verdict of the shape there, or leaves samples out.
#[test]
fn the_map_of_a_morph_says_what_is_said_of_its_shape_at_each_moment() {
    let grid = LocusGrid::new(Bounds::default(), 7, 7).unwrap();
    let (mut apart, mut whole) = (0, 0);
    for (a, b, mode) in [
        ("snowflake", "crystal", Mode::Linear),
        ("two-dragons", "quilt", Mode::Polar),
        ("snowflake", "rauzy", Mode::Polar),
    ] {
        let morph = DirectedMorph::new(&preset(a), &preset(b), mode).unwrap();
        let options = Options { budget: 20_000, ..Options::default() };
        let tile = directed_tile(&grid, &morph, options.epsilon, 0..7, 1);
        assert_eq!((tile.state.len(), tile.gap.len()), (49, 49));
        for (k, (&state, &gap)) in tile.state.iter().zip(&tile.gap).enumerate() {
            let at = (grid.u(k % 7), grid.v(k / 7));
            let state = State::from_code(state).unwrap();
            let Ok(system) = DirectedIfs::new(morph.at(at.0, at.1)) else {
                assert!(matches!(state, State::NoAttractor | State::Undecided), "{a} {b} {at:?} {state:?}");
                continue;
            };
            let found = &directed_connectedness(&system, &options)[0];
            let told = format!("{a} {b} {at:?} {state:?} {gap} {found:?}");
            match state {
                State::Connected => assert!(found.verdict == Verdict::Connected, "{told}"),
                State::Disconnected => {
                    assert!(found.verdict == Verdict::Disconnected, "{told}");
                    let [low, high] = [found.gap.lower, found.gap.upper].map(|gap| gap / found.diameter);
                    assert!((0.9 * low..=1.1 * high).contains(&f64::from(gap)), "{told}");
                    apart += 1;
                }
                State::Touching => {
                    assert!(found.verdict.holds(), "{told}");
                    whole += 1;
                }
                State::Undecided => {}
                State::NoAttractor => panic!("{told}"),
            }
        }
        // Both ends are samples, and what is proved of them is proved here.
        for (k, end) in [(2 * 7 + 2, a), (4 * 7 + 4, b)] {
            let known = directed_connectedness(&preset(end), &options)[0].verdict;
            assert_eq!(
                State::from_code(tile.state[k]).map(|state| state == State::Connected),
                Some(known == Verdict::Connected),
                "{end}"
            );
        }
        // Every second row and column, of some rows.
        let coarse = directed_tile(&grid, &morph, options.epsilon, 1..5, 2);
        let of = |row: usize| (0..7).step_by(2).map(move |column| 7 * row + column);
        let expected: Vec<u8> = [2, 4].into_iter().flat_map(of).map(|k| tile.state[k]).collect();
        assert_eq!(coarse.state, expected);
    }
    assert!(apart > 20 && whole > 5, "{apart} {whole}");
}
