//! Bent closed curves against the formulas, digit by digit.

mod common;

use common::bumps;
use frond_deform::{BendError, Continuity, Mesh, RingBend, Roughness, Settings, Spin, shuffle, weights};
use glam::DVec2;
use proptest::prelude::*;

/// A closed curve that is nowhere smooth to speak of.
fn curve(t: f64) -> DVec2 {
    let angle = std::f64::consts::TAU * t;
    let wave = |k: f64| DVec2::from_angle(k * angle) * 0.6 / k;
    DVec2::splat(0.5) + 0.4 * (wave(1.0) + wave(-5.0) + wave(27.0) + wave(-131.0))
}

fn grid(letters: u32) -> Vec<DVec2> {
    let count = 4_usize.pow(letters);
    (0..count).map(|i| curve(i as f64 / count as f64)).collect()
}

fn settings(kb: f64, ke: f64, roughness: Roughness, superposed: bool) -> Settings {
    Settings { kb, ke, roughness, spin: Spin::None, continuity: Continuity::Auto, superposed }
}

fn mesh(list: &[(f64, f64)]) -> Mesh {
    Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, list.iter().map(|&pair| pair.into()).collect()).unwrap()
}

fn bend(list: &[(f64, f64)], settings: Settings) -> RingBend {
    let count = RingBend::points(&settings).unwrap();
    RingBend::new(mesh(list), settings, &grid(count.ilog(4))).unwrap()
}

/// One term at the end of part `i` of 4^k: the formula on digits, from the right and from the left.
fn term(mesh: &Mesh, kb: usize, k: usize, i: usize) -> DVec2 {
    let count = 4_usize.pow(k as u32);
    let start = |i: usize| {
        let mut code: Vec<u8> = (0..k).rev().map(|digit| (i / 4_usize.pow(digit as u32) % 4) as u8).collect();
        shuffle(&mut code, kb, k);
        code.iter().fold(0, |number, &digit| 4 * number + usize::from(digit))
    };
    let at = |i: usize| mesh.at(curve((i % count) as f64 / count as f64));
    if k <= kb + 1 {
        return at(i);
    }
    0.5 * (at(start(i)) + at(start((i + count - 1) % count) + 1))
}

/// Terms kb to ke at t: linear between the ends of parts, but plain where nothing is shuffled.
fn formula(mesh: &Mesh, kb: usize, ke: usize, delta: f64, superposed: bool, t: f64) -> DVec2 {
    let value = |k: usize| {
        if k <= kb + 1 {
            return mesh.at(curve(t));
        }
        let place = t * 4_f64.powi(k as i32);
        let i = place as usize;
        let next = (i + 1) % 4_usize.pow(k as u32);
        term(mesh, kb, k, i).lerp(term(mesh, kb, k, next), place.fract())
    };
    let ke = ke.max(kb);
    if !superposed {
        return value(ke);
    }
    weights(delta, kb, ke).iter().enumerate().map(|(i, weight)| value(kb + i) * *weight).sum()
}

fn any_mesh() -> impl Strategy<Value = Vec<(f64, f64)>> {
    proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 16)
}

/// Whole depths as often as not.
fn any_depths(deepest: f64) -> impl Strategy<Value = (f64, f64)> {
    (0.0..1.0_f64, 0.0..1.0_f64, any::<bool>()).prop_map(move |(a, b, whole)| {
        let (kb, ke) = (a * b * deepest, b * deepest);
        if whole { (kb.round(), ke.round()) } else { (kb, ke) }
    })
}

fn any_roughness() -> impl Strategy<Value = Roughness> {
    let delta = || prop_oneof![0.0..1.5_f64, Just(0.0), Just(1.0), Just(1e300)];
    prop_oneof![
        delta().prop_map(Roughness::Constant),
        [delta(), delta(), delta(), delta()].prop_map(Roughness::Corners),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(150)))]

    #[test]
    fn it_is_the_formula(
        list in any_mesh(), (kb, ke) in any_depths(5.0), delta in 0.0..1.5_f64, superposed: bool, t in 0.0..1.0_f64,
    ) {
        let bent = bend(&list, settings(kb, ke, Roughness::Constant(delta), superposed));
        let (mesh, (b, e)) = (mesh(&list), (kb.floor() as usize, ke.floor() as usize));
        let mut wanted = curve(t);
        // Equation 19.
        for (kb, x) in [(b, 1.0 - kb.fract()), (b + 1, kb.fract())] {
            for (ke, y) in [(e, 1.0 - ke.fract()), (e + 1, ke.fract())] {
                if x * y > 0.0 {
                    wanted += formula(&mesh, kb, ke, delta, superposed, t) * (x * y);
                }
            }
        }
        let found = bent.displaced(t, curve(t));
        prop_assert!(found.distance(wanted) < 1e-10, "{found} {wanted}");
    }

    #[test]
    fn parts_meet_and_it_is_closed(
        list in any_mesh(), (kb, ke) in any_depths(6.0), roughness in any_roughness(), superposed: bool,
        part in 0..4096_usize,
    ) {
        let bent = bend(&list, settings(kb, ke, roughness, superposed));
        let z = DVec2::new(0.3, 0.7);
        let t = part as f64 / 4096.0;
        // The values on both sides of the end of a part: a step of t this small moves nothing that is continuous.
        let (before, after) = (bent.displaced(t - 1e-16, z), bent.displaced(t + 1e-16, z));
        prop_assert!(before.distance(after) < 1e-11);
        prop_assert!(bent.displaced(0.0, z).distance(bent.displaced(1.0, z)) < 1e-12);
        let near_end = bent.displaced(1.0 - f64::EPSILON, z);
        prop_assert!(near_end.distance(bent.displaced(0.0, z)) < 1e-11);
    }

    #[test]
    fn moving_all_moves_all(
        (kb, ke) in any_depths(6.0), roughness in any_roughness(), superposed: bool, t in -2.0..3.0_f64,
        by in (-1.0..1.0_f64, -1.0..1.0_f64),
    ) {
        let bent = bend(&[by; 16], settings(kb, ke, roughness, superposed));
        let z = DVec2::new(0.2, 0.9);
        prop_assert!(bent.displaced(t, z).distance(z + DVec2::from(by)) < 1e-12);
    }

    #[test]
    fn a_moved_bend_is_a_new_one(
        one in any_mesh(), other in any_mesh(), (kb, ke) in any_depths(6.0), roughness in any_roughness(), t in 0.0..1.0_f64,
    ) {
        let asked = settings(kb, ke, roughness, true);
        let mut bent = bend(&one, asked);
        bent.set_mesh(mesh(&other).displacements()).unwrap();
        prop_assert_eq!(bent.displaced(t, curve(t)), bend(&other, asked).displaced(t, curve(t)));
    }

    #[test]
    fn a_finer_grid_than_is_needed_changes_nothing(list in any_mesh(), (kb, ke) in any_depths(4.0), t in 0.0..1.0_f64) {
        let asked = settings(kb, ke, Roughness::Constant(0.7), true);
        let fine = RingBend::new(mesh(&list), asked, &grid(6)).unwrap();
        prop_assert_eq!(fine.displaced(t, curve(t)), bend(&list, asked).displaced(t, curve(t)));
        // A coarser one takes the detail down.
        let coarse = RingBend::new(mesh(&list), settings(kb, 9.0, Roughness::Constant(0.7), true), &grid(3)).unwrap();
        let plain = bend(&list, settings(kb.min(3.0), 3.0, Roughness::Constant(0.7), true));
        prop_assert_eq!(coarse.displaced(t, curve(t)), plain.displaced(t, curve(t)));
    }

    #[test]
    fn four_corners_alike_are_one_number(list in any_mesh(), (kb, ke) in any_depths(5.0), delta in 0.0..1.5_f64, t in 0.0..1.0_f64) {
        let near = |delta: f64| Roughness::Corners([delta, delta, delta, delta * (1.0 + 1e-12)]);
        let one = bend(&list, settings(kb, ke, Roughness::Constant(delta), true));
        let four = bend(&list, settings(kb, ke, near(delta), true));
        prop_assert!(one.displaced(t, curve(t)).distance(four.displaced(t, curve(t))) < 1e-9);
    }
}

#[test]
fn where_nothing_is_shuffled_it_is_the_plain_mesh() {
    let list = bumps(0.05);
    for (kb, ke) in [(0.0, 0.0), (0.0, 1.0), (3.0, 3.0), (6.5, 7.5), (4.0, 4.7), (9.0, 20.0), (12.0, 20.0)] {
        for superposed in [true, false] {
            let asked = settings(kb, ke, Roughness::Constant(0.8), superposed);
            let bent = bend(&list, asked);
            if ke <= kb.floor() + 1.0 || kb >= 9.0 {
                assert_eq!((RingBend::points(&asked).unwrap(), bent.letters()), (1, 0), "{kb} {ke}");
                for i in 0..100 {
                    let z = curve(f64::from(i) / 100.0);
                    assert_eq!(bent.displaced(f64::from(i) / 100.0, z), z + bent.mesh().at(z));
                }
            }
        }
    }
    // Without roughness, too, though the terms are there.
    let bent = bend(&list, settings(0.0, 5.0, Roughness::Constant(0.0), true));
    let z = curve(0.37);
    assert_eq!(bent.displaced(0.37, z), z + bent.mesh().at(z));
}

#[test]
fn spin_and_continuity_do_not_count() {
    let list = bumps(0.05);
    let asked = settings(1.0, 4.0, Roughness::Constant(0.8), true);
    let (plain, z) = (bend(&list, asked), curve(0.61));
    for spin in [Spin::Orthogonal, Spin::Rotation, Spin::Scaled] {
        for continuity in [Continuity::Raw, Continuity::Splat, Continuity::Average, Continuity::Published] {
            let other = bend(&list, Settings { spin, continuity, ..asked });
            assert_eq!(other.displaced(0.61, z), plain.displaced(0.61, z));
        }
    }
}

#[test]
fn small_meshes_and_flat_curves() {
    let asked = settings(0.0, 4.0, Roughness::Corners([0.0, 1e300, 0.5, 1.0]), true);
    let corners = vec![DVec2::new(0.1, 0.0), DVec2::ZERO, DVec2::new(0.0, -0.3), DVec2::ONE];
    let two = Mesh::new(DVec2::ZERO, DVec2::ONE, 2, 2, corners).unwrap();
    let sixteen = Mesh::at_rest(DVec2::ZERO, DVec2::splat(1e-300), 16, 16).unwrap();
    let curves = [vec![DVec2::splat(0.4); 256], (0..256).map(|i| DVec2::X * f64::from(i)).collect()];
    for (mesh, curve) in
        [&two, &sixteen].into_iter().flat_map(|mesh| curves.iter().map(move |curve| (mesh, curve)))
    {
        let bent = RingBend::new(mesh.clone(), asked, curve).unwrap();
        for t in [0.0, 0.3, 1.0, -7.2, 1e300, f64::NAN, f64::INFINITY, -1e-300] {
            assert!(bent.displaced(t, DVec2::splat(0.4)).is_finite() || mesh.columns() == 16, "{t}");
        }
    }
    // A point has one displacement, however it is shuffled.
    let bent = RingBend::new(two.clone(), asked, &curves[0]).unwrap();
    let z = DVec2::splat(0.4);
    assert!(bent.displaced(0.77, z).distance(z + two.at(z)) < 1e-12);
}

#[test]
fn what_is_no_ring_is_refused() {
    let asked = settings(0.0, 4.0, Roughness::Constant(0.5), true);
    let made = |grid: &[DVec2], settings| RingBend::new(mesh(&bumps(0.1)), settings, grid).map(|_| ());
    for count in [0, 2, 3, 5, 100, 4_usize.pow(9) + 1, 4_usize.pow(10)] {
        assert_eq!(made(&vec![DVec2::ZERO; count], asked), Err(BendError::Ring { count }));
    }
    let mut broken = grid(2);
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        for at in [DVec2::new(bad, 0.5), DVec2::new(0.5, bad)] {
            broken[5] = at;
            let error = made(&broken, asked).unwrap_err();
            assert_eq!(error.code(), "bend-ring");
        }
    }
    let wrong = |settings: Settings| {
        assert_eq!(RingBend::points(&settings).err(), made(&grid(2), settings).err());
        made(&grid(2), settings).unwrap_err().code()
    };
    assert_eq!(wrong(settings(3.0, 2.0, Roughness::Constant(0.5), true)), "bend-locality");
    assert_eq!(wrong(settings(f64::NAN, 2.0, Roughness::Constant(0.5), true)), "bend-depth");
    assert_eq!(wrong(settings(0.0, 2.0, Roughness::Constant(-1.0), true)), "bend-roughness");
    let mut bent = bend(&bumps(0.1), asked);
    let before = bent.displaced(0.3, DVec2::ONE);
    assert!(bent.set_mesh(&[DVec2::ZERO; 3]).is_err());
    assert!(bent.set_mesh(&[DVec2::NAN; 16]).is_err());
    assert_eq!(bent.displaced(0.3, DVec2::ONE), before);
}

/// The distance of a point from a closed polyline.
fn distance(p: DVec2, line: &[DVec2]) -> f64 {
    let sides = line.iter().zip(line.iter().cycle().skip(1));
    let to = |(&a, &b): (&DVec2, &DVec2)| {
        let along = (b - a).length_squared();
        let share = if along > 0.0 { ((p - a).dot(b - a) / along).clamp(0.0, 1.0) } else { 0.0 };
        p.distance(a.lerp(b, share))
    };
    sides.map(to).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_bent_polyline_is_near_the_bent_curve() {
    let square = [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]].map(DVec2::from);
    let line: Vec<_> = (0..4).map(|i| (i as f64 / 4.0, square[i])).collect();
    let at =
        |t: f64| square[(t * 4.0) as usize % 4].lerp(square[((t * 4.0) as usize + 1) % 4], (t * 4.0).fract());
    let grid: Vec<_> = (0..1024).map(|i| at(f64::from(i) / 1024.0)).collect();
    for (kb, ke, superposed) in [(0.0, 0.0, true), (0.0, 5.0, true), (1.5, 4.5, true), (0.0, 5.0, false)] {
        let asked = settings(kb, ke, Roughness::Constant(0.6), superposed);
        let bent = RingBend::new(mesh(&bumps(0.03)), asked, &grid).unwrap();
        let all: Vec<_> = (0..20_000).map(|i| f64::from(i) / 2e4).map(|t| bent.displaced(t, at(t))).collect();
        let mut before = usize::MAX;
        for tolerance in [1e-4, 1e-3, 1e-2] {
            let found = bent.polyline(&line, tolerance, None, 1 << 20);
            let worst = all.iter().map(|&p| distance(p, &found)).fold(0.0, f64::max);
            assert!(worst <= 1.3 * tolerance, "{kb} {ke}: {worst} at {tolerance}");
            assert!(found.len() < before && found.len() > 8);
            before = found.len();
        }
        let window = [0.8, 0.4, 1.0, 0.6];
        let found = bent.polyline(&line, 1e-4, Some(window), 1 << 20);
        let inside =
            |p: &&DVec2| p.x >= window[0] && p.y >= window[1] && p.x <= window[2] && p.y <= window[3];
        let worst = all.iter().filter(inside).map(|&p| distance(p, &found)).fold(0.0, f64::max);
        assert!(worst <= 1.3e-4, "{kb} {ke}: {worst} in the window");
        let all = bent.polyline(&line, 1e-4, None, 1 << 20).len();
        println!("{kb} {ke} {superposed}: {} of {all}", found.len());
        assert!(found.len() * 4 < 3 * all, "{} of {all}", found.len());
        for most in [3, 10, 100] {
            assert!(bent.polyline(&line, 0.0, None, most).len() <= most);
        }
    }
}

#[test]
fn polylines_of_nothing_much() {
    let bent = bend(&bumps(0.1), settings(0.0, 4.0, Roughness::Constant(0.6), true));
    assert!(bent.polyline(&[], 0.1, None, 100).is_empty());
    for line in [
        vec![(0.0, DVec2::ONE)],
        vec![(0.0, DVec2::ONE), (0.0, DVec2::ONE), (0.0, DVec2::ONE)],
        vec![(0.0, DVec2::NAN), (0.5, DVec2::ONE)],
        vec![(f64::NAN, DVec2::ONE), (0.5, DVec2::ZERO), (0.2, DVec2::X)],
        vec![(0.0, DVec2::ONE), (1e300, DVec2::ZERO)],
    ] {
        for tolerance in [0.0, 0.1, f64::NAN, f64::INFINITY] {
            for window in [None, Some([0.0, 0.0, 1.0, 1.0]), Some([f64::NAN; 4])] {
                assert!(bent.polyline(&line, tolerance, window, 50).len() <= 50);
            }
        }
    }
}
