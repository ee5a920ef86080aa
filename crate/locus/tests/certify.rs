//! Paths proved from end to end, against their samples.

mod common;

use frond_core::{Affine2, Ifs, Morph, MorphOptions, hash, routes};
use frond_locus::{CertifyOptions, PathOptions, Scratch, along, certify_path, decide_bounds, find_path};
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

#[test]
fn odd_paths_are_no_trouble() {
    let morph = dragon_to_gasket();
    let options = CertifyOptions { budget: 60, ..CertifyOptions::default() };
    let proved = certify_path(&morph, &[], &options);
    assert!(proved.holds && proved.boxes == 0 && proved.gap == 0.0);
    let (a, b) = (DVec3::new(0.2, 0.5, 0.0), DVec3::new(0.3, 0.5, 0.1));
    for points in [vec![a], vec![a, a], vec![a, a, a], vec![a, a, b, b], vec![a, b, a, b]] {
        let proved = certify_path(&morph, &points, &options);
        assert!(proved.gap.is_finite() && proved.boxes > 0, "{points:?}: {proved:?}");
    }
    for bad in [f64::NAN, f64::INFINITY, 1e9] {
        let proved = certify_path(&morph, &[a, DVec3::new(bad, 0.0, 0.0)], &options);
        assert!(!proved.holds && proved.gap == f64::INFINITY, "{proved:?}");
    }
    for (t0, t1) in [(0.5, 0.5), (0.7, 0.2), (-3.0, 9.0), (f64::NAN, 1.0)] {
        let proved = certify_path(&morph, &[a, b], &CertifyOptions { t0, t1, ..options });
        assert!(proved.gap >= 0.0, "{proved:?}");
    }
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
