//! Self-affine closed curves fitted to grown leaves, and bad input.

use frond_core::hash;
use frond_fit::{
    ArcCopy, ClosedCurve, DRAWING_LEVELS, DRAWING_TOLERANCE, Fitter, Outline, contacts, fidelity,
    least_squares_polyline, maple_leaf, oak_leaf, split_polyline,
};
use frond_testing::cases;
use glam::DVec2;

/// How many numbers a leaf is fitted with on each run.
const NUMBERS: usize = 100;

fn outline(points: &[DVec2]) -> Outline {
    Outline::new(points).expect("an outline")
}

fn circle(count: usize) -> Vec<DVec2> {
    (0..count).map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64)).collect()
}

#[test]
fn a_fit_of_a_maple_leaf_is_nearer_than_a_polyline_of_as_many_numbers() {
    is_nearer_than_a_polyline(&maple_leaf(1));
}

#[test]
fn a_fit_of_an_oak_leaf_is_nearer_than_a_polyline_of_as_many_numbers() {
    is_nearer_than_a_polyline(&oak_leaf(1));
}

fn is_nearer_than_a_polyline(leaf: &[DVec2]) {
    // What 260 numbers take half a minute for, on each run fewer show; `deep` tries both.
    let counts = [NUMBERS, 260];
    for numbers in counts.into_iter().take(cases(1) as usize) {
        is_nearer_with(leaf, numbers);
    }
}

fn drawn(outline: &Outline, curve: &ClosedCurve) -> Vec<DVec2> {
    curve.polyline(DRAWING_TOLERANCE * outline.diagonal(), DRAWING_LEVELS)
}

/// What is promised of every fit.
fn keeps_its_promises(points: &[DVec2], numbers: usize) {
    let outline = outline(points);
    let line = least_squares_polyline(&outline, numbers);
    let straight = fidelity(&outline, &line);
    let simple = contacts(outline.points(), 1).is_some_and(|found| found.is_empty());
    let crossed = |line: &[DVec2]| simple && contacts(line, 1) != Some(vec![]);
    assert!(!crossed(&line), "the polyline");
    let mut fitter = Fitter::new(&outline, numbers).unwrap();
    while !fitter.is_done() {
        let stage = fitter.step().stage;
        let curve = &fitter.best().curve;
        assert!(curve.is_sound() && curve.numbers() <= numbers);
        assert!(!crossed(&drawn(&outline, curve)), "{stage:?}");
    }
    // It may be stopped at any time; what is kept is what a document keeps.
    let curve = fitter.best().curve.quantised().unwrap();
    assert!(!crossed(&drawn(&outline, &curve)));
    let fit = fidelity(&outline, &drawn(&outline, &curve));
    assert!(fit.rms <= straight.rms, "{fit:?} {straight:?}");
}

/// A closed curve that is rough at all scales; it meets itself only where the roughness is large.
fn rough(seed: u32, points: usize, roughness: f64) -> Vec<DVec2> {
    let random = |k: u32| f64::from(hash::unit(hash::counter(seed, k))) - 0.5;
    let at = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / points as f64;
        let wave = |k: u32| {
            let (a, b) = (random(4 * k), random(4 * k + 1));
            (a * (f64::from(k) * angle).cos() + b * (f64::from(k) * angle).sin()) / f64::from(k).powf(1.3)
        };
        DVec2::from_angle(angle) * (1.0 + roughness * (2..60).map(wave).sum::<f64>())
    };
    (0..points).map(at).collect()
}

#[test]
fn no_fit_is_worse_than_the_polyline_of_as_many_numbers_and_none_crosses_itself() {
    for seed in 0..cases(4) {
        let points = 120 + 90 * (seed as usize % 4);
        keeps_its_promises(&rough(seed, points, 0.6), 16 + 8 * (seed as usize % 5));
    }
    // Narrow necks, where copies are apt to cross.
    let neck: Vec<_> = rough(9, 300, 0.5).iter().map(|p| DVec2::new(p.x, p.y * (0.02 + p.x * p.x))).collect();
    keeps_its_promises(&neck, 24);
    keeps_its_promises(&neck, 60);
}

#[test]
fn odd_outlines_are_no_worse_than_their_polyline_either() {
    let doubled: Vec<_> = circle(40).into_iter().chain(circle(40)).collect();
    let eight: Vec<_> = circle(60).iter().map(|p| DVec2::new(p.x, p.x * p.y)).collect();
    // A needle, its sides next to each other; and a comb, most of whose points lie on lines.
    let needle: Vec<_> =
        (0..60).map(|i| DVec2::new(f64::from(i.min(59 - i)), if i < 30 { 0.0 } else { 1e-3 })).collect();
    let comb: Vec<_> = (0..48)
        .map(|i| DVec2::new(f64::from(i / 2), if i % 4 < 2 { 0.0 } else { 5.0 }))
        .chain([DVec2::new(24.0, -1.0), DVec2::new(-1.0, -1.0)])
        .collect();
    for points in [circle(24), doubled, eight, needle, comb] {
        keeps_its_promises(&points, 16);
    }
}

fn is_nearer_with(leaf: &[DVec2], numbers: usize) {
    let outline = outline(leaf);
    let mut fitter = Fitter::new(&outline, numbers).unwrap();
    // The first fit is usable at once: a polyline through points of the outline.
    let first = fidelity(&outline, &fitter.best().curve.knots);
    let split = fidelity(&outline, &split_polyline(&outline, numbers));
    assert!(first.rms < 1.2 * split.rms, "{} {}", first.rms, split.rms);
    let mut share = 0.0;
    while !fitter.is_done() {
        let progress = fitter.step();
        assert!(progress.share >= share && progress.share <= 1.0);
        share = progress.share;
        let best = fitter.best();
        assert!(best.curve.is_sound() && best.curve.numbers() <= numbers, "{:?}", progress.stage);
        let told = 100.0 * (best.error / outline.points().len() as f64).sqrt() / outline.diagonal();
        assert!((progress.rms - told).abs() < 1e-9, "what is told is what is there");
    }
    assert_eq!(share, 1.0);
    let curve = &fitter.best().curve;
    assert!(curve.copies() > 5, "{} copies", curve.copies());
    let fine = drawn(&outline, curve);
    let ours = fidelity(&outline, &fine);
    let line = fidelity(&outline, &least_squares_polyline(&outline, numbers));
    assert!(ours.rms <= line.rms, "{ours:?} {line:?}");
    // The maple's teeth are finer than its numbers tell; at least it is about as rough as the polyline.
    let most = split.slope_difference().abs().max(0.02) + 0.005;
    assert!(ours.slope_difference().abs() <= most, "{ours:?} {split:?}");
    assert!(ours.hausdorff <= 2.0, "{ours:?}");
    // No gap: no side of the opened curve is longer than an edge.
    let longest = |points: &[DVec2]| {
        (0..points.len()).map(|i| points[i].distance(points[(i + 1) % points.len()])).fold(0.0, f64::max)
    };
    assert!(longest(&fine) <= longest(&curve.knots) + 1e-9);
}

#[test]
fn a_fit_keeps_no_more_digits_than_it_needs() {
    let outline = outline(&maple_leaf(1));
    let curve = Fitter::new(&outline, 60).unwrap().finish();
    let rms = |curve: &ClosedCurve| fidelity(&outline, &drawn(&outline, curve)).rms;
    assert_eq!(curve.quantised().as_ref(), Ok(&curve), "documents keep it as it is");
    // The same curve a little moved takes the digits that documents have for any.
    let mut moved = curve.clone();
    moved.knots.iter_mut().zip(0_i32..).for_each(|(p, i)| *p += 1e-4 * f64::from(i % 7 - 3));
    let (few, many) = (curve.to_text().unwrap().len(), moved.to_text().unwrap().len());
    assert!(10 * few < 9 * many, "{few} {many}");
    assert!(rms(&curve) <= fidelity(&outline, &least_squares_polyline(&outline, 60)).rms);
}

#[test]
fn the_same_outline_gives_the_same_fit() {
    let outline = outline(&oak_leaf(2));
    let fit = || {
        let mut fitter = Fitter::new(&outline, 80).unwrap();
        (0..20).for_each(|_| {
            fitter.step();
        });
        fitter.best().curve.clone()
    };
    assert_eq!(fit(), fit());
}

#[test]
fn odd_outlines_are_fitted_without_panics() {
    let flat: Vec<_> =
        (0..60).map(|i| DVec2::new(f64::from(i.min(59 - i)), if i < 30 { 0.0 } else { 1e-9 })).collect();
    let star: Vec<_> = (0..41).map(|i| DVec2::from_angle(f64::from(i * 20) * 2.0)).collect();
    let doubled: Vec<_> = circle(100).into_iter().chain(circle(100)).collect();
    let far: Vec<_> = circle(200).into_iter().map(|p| p * 1e-3 + DVec2::splat(1e6)).collect();
    let large: Vec<_> = circle(90).into_iter().map(|p| p * 1e40).collect();
    for points in [circle(24), circle(1000), flat, star, doubled, far, large] {
        let outline = outline(&points);
        let mut fitter = Fitter::new(&outline, 24).unwrap();
        for _ in 0..60 {
            fitter.step();
        }
        let curve = &fitter.best().curve;
        assert!(curve.is_sound() && curve.numbers() <= 24);
    }
}

#[test]
fn few_corners_are_fitted_with_any_numbers() {
    for corners in [3, 4, 6, 7] {
        let outline = outline(&circle(corners));
        let line = outline.subdivided(100);
        assert!(
            line.points().len() >= 100 && circle(corners).iter().all(|corner| line.points().contains(corner))
        );
        assert!((line.area() / outline.area() - 1.0).abs() < 1e-12);
        for numbers in [12, 13, 40] {
            let curve = Fitter::new(&outline, numbers).unwrap().finish();
            // A knot for each corner takes two numbers: then the fit is the polygon. In hundredths of the diagonal.
            let far = fidelity(&outline, &drawn(&outline, &curve)).rms;
            assert!(curve.numbers() <= numbers, "{corners} corners, {numbers} numbers");
            assert!(far < if 2 * corners <= numbers { 0.01 } else { 5.0 }, "{corners}, {numbers}: {far}");
        }
    }
}

#[test]
fn errors_have_codes() {
    let fit =
        |count, numbers| Fitter::new(&outline(&circle(count)), numbers).map(|_| ()).map_err(|e| e.code());
    assert_eq!(fit(100, 10), Err("bad-numbers"));
    assert_eq!(fit(100, usize::MAX), Err("bad-numbers"));
    assert_eq!(fit(100, 260), Ok(()));
    let outline = |points: &[DVec2]| Outline::new(points).map(|_| ()).map_err(|e| e.code());
    assert_eq!(outline(&[]), Err("too-few-points"));
    assert_eq!(outline(&[DVec2::ZERO, DVec2::X, DVec2::X, DVec2::ZERO]), Err("too-few-points"));
    assert_eq!(outline(&[DVec2::ZERO, DVec2::X, DVec2::NAN]), Err("not-finite"));
    assert_eq!(outline(&[DVec2::ZERO, DVec2::X, DVec2::X * 3.0]), Err("flat"));
    assert_eq!(outline(&vec![DVec2::ZERO; 2_000_000]), Err("too-many-points"));
    assert_eq!(outline(&[DVec2::ZERO, DVec2::X, DVec2::Y]), Ok(()));
}

#[test]
fn unsound_curves_are_known() {
    let mut curve = ClosedCurve::polygon(circle(8));
    assert!(curve.is_sound());
    let copy = ArcCopy { from: 1, span: 3, reversed: false, c: 0.5 };
    curve.edges[0] = Some(copy);
    assert!(curve.is_sound());
    for bad in [
        ArcCopy { c: 5.0, ..copy },
        ArcCopy { c: f64::NAN, ..copy },
        ArcCopy { span: 1, ..copy },
        ArcCopy { span: 8, ..copy },
        ArcCopy { from: 8, ..copy },
    ] {
        curve.edges[0] = Some(bad);
        assert!(!curve.is_sound(), "{bad:?}");
    }
}

#[test]
fn outlines_are_cleaned_turned_and_measured() {
    let square = [DVec2::ZERO, DVec2::Y, DVec2::Y, DVec2::ONE, DVec2::X, DVec2::ZERO];
    let outline = outline(&square);
    assert_eq!(outline.points().len(), 4);
    assert_eq!((outline.area(), outline.length()), (1.0, 4.0));
    let even = outline.resampled(16);
    assert_eq!(even.points().len(), 16);
    assert!((even.length() - 4.0).abs() < 1e-12);
    let measure = fidelity(&outline, even.points());
    assert!(measure.rms < 1e-12 && measure.hausdorff < 1e-12 && measure.slope_difference().abs() < 1e-12);
    // A square a tenth larger all round: corners are off by the root of 2 / 100.
    let larger: Vec<_> = outline.points().iter().map(|p| (*p - 0.5) * 1.2 + 0.5).collect();
    let measure = fidelity(&outline, &larger);
    assert!((measure.hausdorff - 10.0).abs() < 1e-9 && (measure.rms - 10.0 / 2.0_f64.sqrt()).abs() < 1e-9);
    assert!((measure.length_ratio - 1.2).abs() < 1e-12);
}

#[test]
fn smoothing_takes_noise_off_and_keeps_the_shape() {
    let noisy: Vec<_> =
        circle(720).iter().enumerate().map(|(i, p)| *p * (1.0 + 0.01 * (-1.0_f64).powi(i as i32))).collect();
    let smooth = outline(&noisy).smoothed(0.1);
    let off = smooth.points().iter().map(|p| (p.length() - 1.0).abs()).fold(0.0, f64::max);
    assert!(off < 0.008, "{off}");
    assert!(outline(&noisy).smoothed(f64::NAN) == outline(&noisy));
    assert!(smooth.smoothed(1e9).points().iter().all(|p| p.is_finite()));
}
