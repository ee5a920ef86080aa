//! Paths proved from end to end, against their samples.

mod common;

use frond_core::{Affine2, Ifs, Mode, Morph, MorphOptions, hash, routes};
use frond_locus::{
    CertifyOptions, PathCertificate, PathOptions, Scratch, along, certify_path, decide_bounds, find_path,
};
use glam::{DVec2, DVec3};

use crate::common::dragon_to_gasket;

/// Three corners of a triangle, each drawn towards by this factor.
fn gasket(scale: f64) -> Vec<Affine2> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
    corners.map(|c| Affine2::similitude(scale, 0.0, c * (1.0 - scale))).to_vec()
}

/// The widest gap that is sure to be somewhere along a path.
fn sure(morph: &Morph, points: &[DVec3], samples: u32, (t0, t1): (f64, f64)) -> f64 {
    let mut scratch = Scratch::default();
    let mut widest = 0.0_f64;
    for k in 0..=samples {
        let at = along(points, t0 + (t1 - t0) * f64::from(k) / f64::from(samples));
        let known = decide_bounds(&morph.at3(at.x, at.y, at.z), 1e-9, 20_000, &mut scratch);
        widest = widest.max(known.lower);
    }
    widest
}

#[test]
fn a_found_path_is_proved() {
    let morph = dragon_to_gasket();
    let plan = find_path(&morph, &PathOptions::default()).unwrap();
    assert!(plan.holds);
    let options = CertifyOptions::default();
    let proved = certify_path(&morph, &plan.points, &options);
    assert!(proved.holds && proved.complete && proved.gap <= 1.0 / 600.0, "{proved:?}");
    assert!(proved.boxes > 10 && (0.0..=1.0).contains(&proved.worst), "{proved:?}");
    assert!(sure(&morph, &plan.points, 500, (0.0, 1.0)) <= proved.gap);
}

#[test]
fn gaps_that_are_there_are_never_excluded() {
    let morph = dragon_to_gasket();
    for seed in 0..24 {
        let at = |k| f64::from(hash::unit(hash::counter(seed, k)));
        let mut points = vec![DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
        for k in 0..seed % 3 {
            points.insert(1, DVec3::new(at(3 * k), at(3 * k + 1), 0.3 * (at(3 * k + 2) - 0.5)));
        }
        let within = [0.0, 1e-3, 0.02, 0.1][seed as usize % 4];
        let (t0, t1) = if seed.is_multiple_of(5) { (0.2, 0.6) } else { (0.0, 1.0) };
        let proved = certify_path(&morph, &points, &CertifyOptions { within, budget: 120, t0, t1 });
        let there = sure(&morph, &points, 300, (t0, t1));
        assert!(proved.gap >= there, "seed {seed}: {proved:?}, {there}");
        assert_eq!(proved.holds, proved.gap <= within);
        assert!((t0 - 1e-9..=t1 + 1e-9).contains(&proved.worst), "{proved:?}");
    }
}

#[test]
fn a_gap_of_known_width_is_bounded_closely() {
    // From scale 0.5 down to 0.45 and back: the gap is (1 - 2 s) of a diameter of 1, at most 0.1.
    let morph = Morph::new(&gasket(0.5), &gasket(0.45), &MorphOptions::default()).unwrap();
    let there = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), DVec3::ZERO];
    let proved = certify_path(&morph, &there, &CertifyOptions::default());
    assert!(!proved.holds && proved.complete, "{proved:?}");
    assert!((0.1..0.11).contains(&proved.gap) && (proved.worst - 0.5).abs() < 0.05, "{proved:?}");
    let wide = CertifyOptions { within: 0.105, ..CertifyOptions::default() };
    let proved = certify_path(&morph, &there, &wide);
    assert!(proved.holds && proved.complete && proved.gap <= 0.105, "{proved:?}");
    // On a part of the way it is narrower.
    let part = CertifyOptions { within: 0.055, t1: 0.25, ..CertifyOptions::default() };
    assert!(certify_path(&morph, &there, &part).holds);
}

#[test]
fn one_touching_point_is_bounded_as_finely_as_asked() {
    // The gasket: its pieces meet in points, at all times.
    let morph = Morph::new(&gasket(0.5), &gasket(0.5), &MorphOptions::default()).unwrap();
    let way = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
    for within in [1e-2, 1e-4, 1e-6] {
        let proved = certify_path(&morph, &way, &CertifyOptions { within, ..CertifyOptions::default() });
        assert!(proved.holds && proved.gap <= within, "{proved:?}");
    }
}

fn assert_proves_nothing(proved: &PathCertificate) {
    assert!(!proved.holds && !proved.complete && proved.gap == f64::INFINITY, "{proved:?}");
}

/// Three maps whose attractor is dust, moved from here to there: at every moment its gap is 2/5 of its length.
#[test]
fn moments_of_dust_are_looked_at_and_what_is_no_stretch_proves_nothing() {
    let dust = |y: f64| [0.0, 0.5, 1.0].map(|x| Affine2::similitude(0.2, 0.0, DVec2::new(x, y) * 0.8));
    let morph = Morph::new(&dust(0.0), &dust(1.0), &MorphOptions::default()).unwrap();
    let straight = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
    let bent = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
    for points in [&straight[..], &bent, &straight[..1]] {
        let proved = |t0: f64, t1: f64, within: f64| {
            certify_path(&morph, points, &CertifyOptions { t0, t1, within, budget: 300 })
        };
        for (t0, t1) in
            [(0.0, 0.0), (0.3, 0.3), (0.5, 0.5), (1.0, 1.0), (-1.0, 0.0), (1.0, 2.0), (0.5, 0.5 + 1e-17)]
        {
            let moment = proved(t0, t1, 1e-3);
            let at = t0.clamp(0.0, 1.0);
            assert!(!moment.holds && moment.gap >= 0.2 && moment.gap < 0.6, "{t0} {t1}: {moment:?}");
            assert!(moment.boxes > 0 && (moment.worst - at).abs() < 1e-12, "{t0} {t1}: {moment:?}");
            assert!(proved(t0, t1, 0.6).holds, "{t0} {t1}");
        }
        for (t0, t1) in
            [(0.5, 0.2), (2.0, 3.0), (-2.0, -1.0), (f64::NAN, 1.0), (0.0, f64::NAN), (f64::NAN, f64::NAN)]
        {
            assert_proves_nothing(&proved(t0, t1, 1e-3));
            assert_proves_nothing(&proved(t0, t1, f64::INFINITY));
        }
    }
    // What cannot be bounded does not hold, whatever was asked for.
    let lost = [DVec3::ZERO, DVec3::new(f64::INFINITY, 0.0, 0.0)];
    let options = CertifyOptions { within: f64::INFINITY, ..CertifyOptions::default() };
    assert_proves_nothing(&certify_path(&morph, &lost, &options));
}

/// Where joints bound the gap of all moments, they do not bound that of none.
#[test]
fn joints_prove_no_stretch_that_is_none() {
    let half = |angle: f64| {
        let at = |k: f64| Affine2::similitude(0.5, 0.0, DVec2::new(0.5 * k, 0.0)).to_row();
        let turn = Affine2::rotation(angle);
        [0.0, 1.0].map(|k| Affine2::from_row(at(k)).conjugate(turn).unwrap())
    };
    let linear = MorphOptions { mode: Mode::Linear, ..MorphOptions::default() };
    let morph = Morph::new(&half(0.0), &half(0.0), &linear).unwrap();
    let straight = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
    assert!(certify_path(&morph, &straight, &CertifyOptions::default()).joints > 0);
    for (t0, t1) in [(0.5, 0.2), (2.0, 3.0), (f64::NAN, 1.0)] {
        assert_proves_nothing(&certify_path(
            &morph,
            &straight,
            &CertifyOptions { t0, t1, ..CertifyOptions::default() },
        ));
    }
}

#[test]
fn odd_paths_are_no_trouble() {
    let morph = dragon_to_gasket();
    let options = CertifyOptions { budget: 60, ..CertifyOptions::default() };
    assert_proves_nothing(&certify_path(&morph, &[], &options));
    let (a, b) = (DVec3::new(0.2, 0.5, 0.0), DVec3::new(0.3, 0.5, 0.1));
    for points in [vec![a], vec![a, a], vec![a, a, a], vec![a, a, b, b], vec![a, b, a, b]] {
        let proved = certify_path(&morph, &points, &options);
        assert!(proved.gap.is_finite() && proved.boxes > 0, "{points:?}: {proved:?}");
    }
    for bad in [f64::NAN, f64::INFINITY, 1e9] {
        let proved = certify_path(&morph, &[a, DVec3::new(bad, 0.0, 0.0)], &options);
        assert!(!proved.holds && proved.gap == f64::INFINITY, "{proved:?}");
    }
    let all = certify_path(&morph, &[a, b], &options);
    assert_eq!(certify_path(&morph, &[a, b], &CertifyOptions { t0: -3.0, t1: 9.0, ..options }), all);
    let none = certify_path(&morph, &[a, b], &CertifyOptions { budget: 0, within: f64::NAN, ..options });
    assert!(!none.complete || none.gap == 0.0, "{none:?}");
}

/// A shape of the gallery.
fn preset(id: &str) -> Ifs {
    let rows = frond_scene::preset(id).unwrap().maps;
    Ifs::new(rows.into_iter().map(Affine2::from_row).collect()).unwrap()
}

/// Hulls of pieces that overlap deep need not belong to pieces that meet: near points of other pieces bound the gap.
#[test]
fn paths_of_many_pieces_are_proved_by_the_pieces_that_meet() {
    for (from, to, way, corner) in [
        ("gasket", "gosper", 0, [0.625, 0.1875]),
        ("terdragon", "hexagon", 0, [0.6875, 1.0625]),
        ("terdragon-mirrored", "carpet", 1, [0.4375, 0.875]),
    ] {
        let route = routes(&preset(from), &preset(to)).swap_remove(way);
        let (correspondence, turns) = (route.correspondence, route.turns);
        let options = MorphOptions { correspondence, turns, ..MorphOptions::default() };
        let morph = Morph::new(&route.from, &route.to, &options).unwrap();
        let points = [DVec3::ZERO, DVec2::from_array(corner).extend(0.0), DVec3::new(1.0, 1.0, 0.0)];
        let proved = certify_path(&morph, &points, &CertifyOptions::default());
        assert!(proved.holds && proved.complete && proved.boxes < 1000, "{from} to {to}: {proved:?}");
    }
}
