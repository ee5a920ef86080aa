//! Systems whose maps share one linear part: the special path against the general one, and against theorems.

use frond_core::{Affine2, Ifs, hash};
use frond_locus::{Options, Scratch, State, Verdict, connectedness, decide, decide_bounds, decide_polygon};
use glam::{DMat2, DVec2};

/// A number from -1 to 1.
fn number(seed: u32, index: u32) -> f64 {
    f64::from(hash::counter(seed, index)) / f64::from(u32::MAX) * 2.0 - 1.0
}

/// Two to six maps with one linear part: any, a similitude, one of a single number, singular, or sheared.
fn system(seed: u32) -> Vec<Affine2> {
    let count = 2 + hash::counter(seed, 100) % 5;
    let at = |k| number(seed, k);
    let linear = match seed % 5 {
        0 => DMat2::from_cols(DVec2::new(at(0), at(1)), DVec2::new(at(2), at(3))) * 0.9,
        1 => DMat2::from_angle(3.2 * at(0)) * (0.5 + 0.3 * at(1)),
        2 => DMat2::from_diagonal(DVec2::splat(0.4 + 0.3 * at(0))),
        3 => DMat2::from_cols(DVec2::new(at(0), at(1)), DVec2::new(at(0), at(1)) * at(2)) * 0.8,
        _ => DMat2::from_cols(DVec2::new(0.5 * at(0), 0.0), DVec2::new(4.0 * at(1), 0.6 * at(2))),
    };
    // Some on a grid, so that pieces meet in points and along sides.
    let grid = seed.is_multiple_of(3);
    let shift = |k| if grid { (2.0 * at(k)).round() } else { at(k) };
    (0..count).map(|i| Affine2::new(linear, DVec2::new(shift(10 + 2 * i), shift(11 + 2 * i)))).collect()
}

#[test]
fn it_never_contradicts_the_general_path() {
    let mut scratch = Scratch::default();
    let (mut counts, count) = ([0; 5], frond_testing::cases(300));
    for seed in 0..count {
        let maps = system(seed);
        let Ok(ifs) = Ifs::new(maps.clone()) else { continue };
        let full = connectedness(&ifs, &Options { epsilon: 1e-4, budget: 20_000 });
        for epsilon in [1e-2, 1e-4, 1e-6] {
            let known = decide_bounds(&maps, epsilon, 20_000, &mut scratch);
            let sample = decide(&maps, epsilon, 20_000, &mut Scratch::default());
            let context = format!("{seed} at {epsilon}: {known:?} {full:?} {maps:?}");
            assert_eq!(
                (sample.state, sample.gap.to_bits()),
                (known.sample.state, known.sample.gap.to_bits())
            );
            counts[sample.state as usize] += 1;
            match sample.state {
                State::Disconnected => {
                    assert_ne!(full.verdict, Verdict::Connected, "{context}");
                    assert!(known.lower > 0.0, "{context}");
                }
                State::Connected => assert_ne!(full.verdict, Verdict::Disconnected, "{context}"),
                State::Touching => assert!(known.upper <= epsilon * 1.0001, "{context}"),
                State::Undecided => {}
                State::NoAttractor => panic!("{context}"),
            }
            // The bounds of both paths overlap.
            let slack = 1e-9 * full.diameter;
            assert!(full.gap.lower <= known.upper * known.diameter + slack, "{context}");
            if full.verdict == Verdict::Disconnected {
                assert!(known.lower * known.diameter <= full.gap.upper + 1e-4 * full.diameter, "{context}");
            }
            if full.verdict.holds() {
                assert!(known.lower <= 1.1e-4, "{context}");
            }
        }
    }
    // Some that hold are proved to, segments that two maps cover among them.
    let hold = counts[0] + counts[1];
    assert!(15 * counts[0] > 2 * count && 15 * hold > 8 * count && 3 * counts[2] > 4 * count, "{counts:?}");
    assert!(counts[3] * 50 < counts[1] + counts[2], "{counts:?}");
}

#[test]
fn the_polygon_is_what_its_maps_are() {
    let mut scratch = Scratch::default();
    for sides in [2, 3, 4, 5, 6, 7, 12] {
        for k in 0..60 {
            let s = [0.7 * number(sides, 2 * k), 0.7 * number(sides, 2 * k + 1)];
            let linear = DMat2::from_cols(DVec2::new(s[0], s[1]), DVec2::new(-s[1], s[0]));
            let corner = |k: u32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / f64::from(sides));
            let maps: Vec<_> = (0..sides).map(|k| Affine2::new(linear, corner(k))).collect();
            let polygon = decide_polygon(sides as usize, s, 1e-4, 20_000, &mut scratch);
            let general = decide(&maps, 1e-4, 20_000, &mut scratch);
            let context = format!("{sides} {s:?} {polygon:?} {general:?}");
            let close = (polygon.gap - general.gap).abs() <= 0.12 * general.gap;
            let near = polygon.gap.max(general.gap) < 2e-4;
            assert!(polygon.state == general.state && close || near, "{context}");
        }
    }
    for sides in [0, 1, 65, usize::MAX] {
        assert_eq!(decide_polygon(sides, [0.3, 0.0], 1e-4, 20_000, &mut scratch).state, State::NoAttractor);
    }
    for s in [[1.0, 0.0], [f64::NAN, 0.0], [0.0, f64::INFINITY], [0.0, -2.0]] {
        assert_eq!(decide_polygon(5, s, 1e-4, 20_000, &mut scratch).state, State::NoAttractor, "{s:?}");
    }
    assert_eq!(decide_polygon(5, [0.0, 0.0], 1e-4, 20_000, &mut scratch).state, State::Disconnected);
}

#[test]
fn critical_scales_of_polygons() {
    let mut scratch = Scratch::default();
    for sides in 2..=64_usize {
        let tau = std::f64::consts::TAU;
        let sum: f64 = (1..=sides / 4).map(|k| (tau * k as f64 / sides as f64).cos()).sum();
        let critical = 1.0 / (2.0 * (1.0 + sum));
        for (off, holds) in [(1e-9, true), (-1e-9, false)] {
            let s = [critical * (1.0 + off), 0.0];
            let sample = decide_polygon(sides, s, 1e-11, 40_000, &mut scratch);
            assert_eq!(sample.state.holds(), holds, "{sides} {off} {sample:?}");
            assert!(holds || sample.state == State::Disconnected, "{sides} {off} {sample:?}");
        }
        // Pieces that meet in exact points are never said to be apart.
        let sample = decide_polygon(sides, [critical, 0.0], 0.0, 5_000, &mut scratch);
        assert_ne!(sample.state, State::Disconnected, "{sides} {sample:?}");
    }
}

#[test]
fn the_set_m() {
    let mut scratch = Scratch::default();
    let mut at = |x: f64, y: f64| decide_polygon(2, [x, y], 1e-6, 20_000, &mut scratch);
    assert_eq!(at(0.0227, 0.703).state, State::Disconnected, "the hole of Barnsley & Harrington");
    assert_eq!(at(0.5, 0.5).state, State::Connected);
    for k in 0..2000 {
        let [x, y] = [0.75 * number(5, 2 * k), 0.75 * number(5, 2 * k + 1)];
        let sample = at(x, y);
        let modulus = x.hypot(y);
        if modulus >= 1.0 {
            assert_eq!(sample.state, State::NoAttractor);
            continue;
        }
        if modulus >= 0.5_f64.sqrt() + 1e-12 {
            assert_eq!(sample.state, State::Connected);
        }
        if modulus < 0.5 - 1e-6 {
            assert_eq!(sample.state, State::Disconnected, "{x} {y} {sample:?}");
        }
        assert_ne!(sample.state, State::Undecided, "{x} {y}");
        // Conjugate shapes are mirror images, and -s has the same shape up to its signs.
        for [x, y] in [[x, -y], [-x, y], [-x, -y]] {
            let other = at(x, y);
            assert_eq!(sample.state, other.state, "{x} {y}");
            assert!((sample.gap - other.gap).abs() <= 0.11 * sample.gap, "{x} {y} {sample:?} {other:?}");
        }
    }
    // All real s of modulus 1/2 or more.
    for k in 0..=1000 {
        let s = 0.5 + 0.0002 * f64::from(k);
        assert!(at(s, 0.0).state.holds() && at(-s, 0.0).state.holds(), "{s}");
        assert_eq!(at(s - 0.500_01, 0.0).state, State::Disconnected);
    }
}
