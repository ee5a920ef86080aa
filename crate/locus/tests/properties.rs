//! What must not change a verdict, and what a verdict must not contradict.

use frond_check::{Pair, check};
use frond_core::{Affine2, Ifs, hash};
use frond_locus::{
    Components, Connectedness, Options, Reason, Scratch, Separation, State, Verdict, certificate,
    connectedness, decide,
};
use glam::{DMat2, DVec2};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A map that mostly shrinks; some are singular, reflecting or sheared, or shrink hardly at all.
fn any_map() -> impl Strategy<Value = Affine2> {
    let entry = prop_oneof![6 => -0.7..0.7_f64, 1 => Just(0.0), 1 => Just(0.5)];
    let shift = prop_oneof![6 => -1.0..1.0_f64, 1 => Just(0.0)];
    let row = (entry.clone(), entry.clone(), entry.clone(), entry, shift.clone(), shift.clone())
        .prop_map(|(a, b, c, d, e, f)| [a, b, c, d, e, f]);
    let turned = (0.3..0.9_f64, 0.0..6.3_f64, shift.clone(), shift.clone(), any::<bool>()).prop_map(
        |(scale, angle, e, f, reflect)| {
            let map = Affine2::similitude(scale, angle, DVec2::new(e, f));
            let flip = DMat2::from_diagonal(DVec2::new(1.0, if reflect { -1.0 } else { 1.0 }));
            Affine2::new(map.linear * flip, map.translation).to_row()
        },
    );
    let slow = (0.95..0.9995_f64, 0.0..6.3_f64, shift.clone(), shift)
        .prop_map(|(scale, angle, e, f)| Affine2::similitude(scale, angle, DVec2::new(e, f)).to_row());
    prop_oneof![5 => row, 8 => turned, 1 => slow].prop_map(Affine2::from_row)
}

/// A system of up to 5 maps that has an attractor; some of its maps may be the same.
fn any_ifs() -> impl Strategy<Value = Ifs> {
    let maps = proptest::collection::vec(any_map(), 1..6);
    (maps, 0..12_usize).prop_filter_map("no attractor", |(mut maps, twice)| {
        if let Some(&again) = maps.get(twice) {
            maps.push(again);
        }
        Ifs::new(maps).ok()
    })
}

/// Coordinates that stretch one direction against another at most fivefold.
fn any_coordinates() -> impl Strategy<Value = Affine2> {
    (0.0..6.3_f64, 1.0..5.0_f64, 0.0..6.3_f64, 0.01..100.0_f64, -9.0..9.0_f64, any::<bool>()).prop_map(
        |(first, stretch, second, size, e, reflect)| {
            let diagonal = DVec2::new(size * stretch, if reflect { -size } else { size });
            let linear =
                DMat2::from_angle(first) * DMat2::from_diagonal(diagonal) * DMat2::from_angle(second);
            Affine2::new(linear, DVec2::new(e, 2.0 * e - 1.0))
        },
    )
}

const EPSILON: f64 = 1e-3;
/// Deep enough for most; what is left is `undecided`, which contradicts nothing.
const BUDGET: usize = 20_000;

fn answer(ifs: &Ifs, epsilon: f64) -> Connectedness {
    connectedness(ifs, &Options { epsilon, budget: BUDGET })
}

/// Whether two answers about one shape cannot both be right. In the one that is apart, pieces may still be
/// within `slack` epsilons, which the other may call touching.
fn contradict(a: &Connectedness, b: &Connectedness, epsilon: f64, slack: f64) -> bool {
    let apart = |x: &Connectedness| x.verdict == Verdict::Disconnected;
    let clearly = |x: &Connectedness| apart(x) && x.gap.lower > slack * epsilon * x.diameter;
    let proved = |x: &Connectedness| x.verdict == Verdict::Connected;
    (clearly(a) && b.verdict.holds())
        || (clearly(b) && a.verdict.holds())
        || (apart(a) && proved(b))
        || (apart(b) && proved(a))
}

/// The proof that comes with a verdict, if any, and that there is none for the opposite.
fn proved(ifs: &Ifs, a: &Connectedness) -> Result<(), TestCaseError> {
    let certificate = certificate(ifs, &Options { epsilon: EPSILON, budget: BUDGET });
    match (a.verdict, certificate) {
        (Verdict::Disconnected, Some(found)) => {
            let pair = |pair: &Separation| Pair {
                u: pair.u.clone(),
                v: pair.v.clone(),
                normal: pair.normal.to_array(),
            };
            let plain = frond_check::Certificate {
                maps: found.maps.clone(),
                polygon: found.polygon.iter().map(|p| p.to_array()).collect(),
                letters: found.letters,
                side: found.side.clone(),
                pairs: found.pairs.iter().map(pair).collect(),
                exact: None,
            };
            prop_assert!(check(&plain).is_ok(), "{:?} {:?}", check(&plain), a);
        }
        (verdict, found) => prop_assert!(
            found.is_none() && verdict != Verdict::Disconnected
                || verdict == Verdict::Disconnected && a.gap.upper < 1e-9 * a.diameter,
            "{:?}",
            a
        ),
    }
    Ok(())
}

fn well_formed(ifs: &Ifs, a: &Connectedness) -> Result<(), TestCaseError> {
    prop_assert_eq!(a.components.len(), ifs.len());
    prop_assert_eq!(a.components.iter().max().unwrap() + 1, a.count);
    prop_assert!(a.gap.lower >= 0.0 && a.gap.lower <= a.gap.upper && a.gap.upper.is_finite(), "{:?}", a);
    prop_assert!(a.verdict != Verdict::Disconnected || a.count > 1 && a.gap.lower > 0.0, "{:?}", a);
    prop_assert!(!a.verdict.holds() || a.count == 1, "{:?}", a);
    match a.verdict {
        Verdict::Connected => prop_assert!(a.closest.is_none() && a.gap.upper == 0.0, "{:?}", a),
        Verdict::Touching => prop_assert_eq!(a.closest.is_some(), a.diameter > 0.0, "{:?}", a),
        Verdict::Disconnected | Verdict::Undecided => prop_assert!(a.closest.is_some(), "{:?}", a),
    }
    if let Some((p, q)) = a.closest {
        // In the plane, a shape that is little more than a point has few digits.
        let digits = 1e-9 * a.diameter + 1e-15 * p.length();
        prop_assert!((p.distance(q) - a.gap.upper).abs() <= digits, "{:?}", a);
    }
    prop_assert_eq!(a.verdict == Verdict::Connected, a.reason.as_ref().is_some_and(Reason::is_proof));
    prop_assert!(a.reason.is_none() || a.verdict != Verdict::Disconnected, "{:?}", a);
    if let Some(reason) = &a.reason {
        prop_assert!(reason.text().len() > 20);
        let mut components = Components::new(ifs.len());
        for link in &reason.links {
            let (i, j) = link.pair;
            prop_assert!(i < j && j < ifs.len() && link.at.is_finite(), "{:?}", link);
            prop_assert!(a.overlaps.contains(&(i, j)) || !reason.is_proof(), "{:?}", a);
            components.join(i, j);
        }
        // What holds two pieces together holds all.
        prop_assert!(reason.links.is_empty() || components.count() == 1, "{:?}", reason);
    }
    for &(i, j) in &a.overlaps {
        prop_assert!(i < j && j < ifs.len() && a.components[i] == a.components[j]);
    }
    Ok(())
}

/// Points of each piece.
fn clouds(ifs: &Ifs, each: u32) -> Vec<Vec<DVec2>> {
    let mut x = ifs.maps()[0].fixed_point().unwrap_or(DVec2::ZERO);
    let mut orbit = Vec::new();
    for i in 0..each {
        x = ifs.maps()[hash::counter(7, i) as usize % ifs.len()].apply(x);
        orbit.push(x);
    }
    ifs.maps().iter().map(|map| orbit.iter().map(|&p| map.apply(p)).collect()).collect()
}

/// The widest edge of the least spanning tree between clouds of points.
fn widest_gap(clouds: &[Vec<DVec2>]) -> f64 {
    let least = |i: usize, j: usize| {
        let all = clouds[i].iter().flat_map(|p| clouds[j].iter().map(|q| p.distance_squared(*q)));
        all.fold(f64::INFINITY, f64::min).sqrt()
    };
    let mut edges: Vec<(f64, usize, usize)> =
        (0..clouds.len()).flat_map(|i| (i + 1..clouds.len()).map(move |j| (least(i, j), i, j))).collect();
    edges.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut components = Components::new(clouds.len());
    edges.into_iter().filter(|&(_, i, j)| components.join(i, j)).map(|(d, ..)| d).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: frond_testing::cases(50), failure_persistence: None, rng_seed: RngSeed::Fixed(1997), ..ProptestConfig::default() })]

    #[test]
    fn answers_are_well_formed_and_no_gap_is_wider_than_points_show(ifs in any_ifs()) {
        let a = answer(&ifs, EPSILON);
        well_formed(&ifs, &a)?;
        proved(&ifs, &a)?;
        let seen = widest_gap(&clouds(&ifs, 250));
        prop_assert!(a.gap.lower <= seen * (1.0 + 1e-9) + 1e-12 * a.diameter, "{} {:?}", seen, a);
    }

    #[test]
    fn other_coordinates_change_nothing(ifs in any_ifs(), by in any_coordinates()) {
        let Ok(moved) = ifs.conjugate(by) else { return Ok(()) };
        let (a, b) = (answer(&ifs, EPSILON), answer(&moved, EPSILON));
        well_formed(&moved, &b)?;
        // A gap may grow by the stretch, at most five, against the diameter.
        prop_assert!(!contradict(&a, &b, EPSILON, 5.5), "{:?} {:?}", a, b);
    }

    #[test]
    fn the_order_of_the_maps_changes_nothing(ifs in any_ifs(), turn in 0..5_usize) {
        let mut maps = ifs.maps().to_vec();
        let count = maps.len();
        maps.rotate_left(turn % count);
        let turned = Ifs::new(maps).unwrap();
        let (a, b) = (answer(&ifs, EPSILON), answer(&turned, EPSILON));
        prop_assert!(!contradict(&a, &b, EPSILON, 1.02), "{:?} {:?}", a, b);
        let apart = a.verdict == Verdict::Disconnected && b.verdict == a.verdict;
        if apart && a.gap.lower > 2.0 * EPSILON * a.diameter {
            let same = |x: usize, y: usize| a.components[x] == a.components[y];
            for x in 0..count {
                for y in 0..count {
                    let there = |z: usize| (z + count - turn % count) % count;
                    let same_there = b.components[there(x)] == b.components[there(y)];
                    // Only pieces within epsilon may be taken for one.
                    if same(x, y) != same_there {
                        let pair = [clouds(&ifs, 200)[x].clone(), clouds(&ifs, 200)[y].clone()];
                        prop_assert!(widest_gap(&pair) < 0.2 * a.diameter);
                    }
                }
            }
            prop_assert!(a.gap.lower <= 1.001 * b.gap.upper && b.gap.lower <= 1.001 * a.gap.upper);
        }
    }

    #[test]
    fn refining_a_map_changes_nothing(ifs in any_ifs(), which in 0..5_usize) {
        let maps = ifs.maps();
        let which = which % maps.len();
        let others = maps.iter().enumerate().filter(|(i, _)| *i != which).map(|(_, map)| *map);
        let refined: Vec<Affine2> = others.chain(maps.iter().map(|&map| maps[which] * map)).collect();
        // Its blocks contract, since those of the whole do; but one that contracts slowly may go unproved.
        let Ok(refined) = Ifs::new(refined) else { return Ok(()) };
        let (a, b) = (answer(&ifs, EPSILON), answer(&refined, EPSILON));
        well_formed(&refined, &b)?;
        prop_assert!(!contradict(&a, &b, EPSILON, 1.05), "{:?} {:?}", a, b);
    }

    #[test]
    fn a_smaller_epsilon_never_contradicts(ifs in any_ifs()) {
        let answers = [1e-1, 1e-2, 1e-4, 1e-7, 0.0].map(|epsilon| answer(&ifs, epsilon));
        for (k, coarse) in answers.iter().enumerate() {
            for fine in &answers[k + 1..] {
                // What is apart stays apart, whatever the resolution.
                let stays = matches!(fine.verdict, Verdict::Disconnected | Verdict::Undecided);
                prop_assert!(coarse.verdict != Verdict::Disconnected || stays, "{:?} {:?}", coarse, fine);
                let held = coarse.verdict.holds() || coarse.verdict == Verdict::Undecided || coarse.gap.upper < 2e-1 * coarse.diameter;
                prop_assert!(!fine.verdict.holds() || held, "{:?} {:?}", coarse, fine);
            }
        }
    }

    #[test]
    fn the_fast_answer_agrees_with_the_full_one(ifs in any_ifs()) {
        let full = answer(&ifs, EPSILON);
        let mut scratch = Scratch::default();
        let fast = decide(ifs.maps(), EPSILON, BUDGET, &mut scratch);
        let gap = f64::from(fast.gap);
        let context = format!("{fast:?} {full:?}");
        match fast.state {
            State::Disconnected => {
                let proved = full.verdict == Verdict::Connected;
                prop_assert!(!proved && (!full.verdict.holds() || gap < 2.1 * EPSILON), "{}", context);
                let (least, most) = (full.gap.lower / full.diameter, full.gap.upper / full.diameter);
                // Where both bounds close slowly, what is in between is only known roughly.
                prop_assert!(gap > 0.4 * least && gap < 3.0 * most || full.verdict.holds(), "{}", context);
            }
            State::Connected | State::Touching => {
                let near = full.gap.lower <= 1.05 * EPSILON * full.diameter;
                prop_assert!(full.verdict != Verdict::Disconnected || near && fast.state != State::Connected, "{}", context);
                prop_assert_eq!(fast.gap, 0.0);
            }
            State::Undecided => prop_assert!(gap.is_nan() || gap >= 0.0),
            State::NoAttractor => prop_assert!(false, "{}", context),
        }
        // Nothing of the last call is left in the memory.
        prop_assert_eq!(fast, decide(ifs.maps(), EPSILON, BUDGET, &mut Scratch::default()));
        decide(&[Affine2::similitude(0.4, 1.0, DVec2::X); 3], EPSILON, BUDGET, &mut scratch);
        prop_assert_eq!(fast, decide(ifs.maps(), EPSILON, BUDGET, &mut scratch));
    }

    #[test]
    fn any_numbers_get_an_answer(
        rows in proptest::collection::vec(proptest::array::uniform6(prop_oneof![
            3 => -1.2..1.2_f64, 1 => any::<f64>(), 1 => Just(0.0), 1 => Just(1e-300), 1 => Just(1e99),
        ]), 0..5),
        epsilon in prop_oneof![Just(0.0), Just(1.0), Just(-1.0), Just(f64::NAN), Just(f64::INFINITY), 0.0..1.0_f64],
        budget in prop_oneof![Just(0), 0..3000_usize],
    ) {
        let maps: Vec<Affine2> = rows.into_iter().map(Affine2::from_row).collect();
        let sample = decide(&maps, epsilon, budget, &mut Scratch::default());
        prop_assert_eq!(sample.state == State::NoAttractor && !sample.gap.is_nan(), false);
        if let Ok(ifs) = Ifs::new(maps) {
            let full = connectedness(&ifs, &Options { epsilon, budget });
            prop_assert_eq!(full.components.len(), ifs.len());
        }
    }
}
