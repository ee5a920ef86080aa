//! Self-affine closed curves fitted to grown leaves, and bad input.

use frond_fit::{
    ArcCopy, ClosedCurve, Fitter, Outline, Stage, fidelity, least_squares_polyline, maple_leaf, oak_leaf,
    split_polyline,
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

fn is_nearer_with(leaf: &[DVec2], numbers: usize) {
    let outline = outline(leaf);
    let mut fitter = Fitter::new(&outline, numbers).unwrap();
    // The first fit is usable at once: it is the polyline through feature points.
    let first = fidelity(&outline, &fitter.best().curve.knots);
    let split = fidelity(&outline, &split_polyline(&outline, numbers));
    assert!((first.rms - split.rms).abs() < 0.05 * split.rms, "{} {}", first.rms, split.rms);
    let (mut share, mut error) = (0.0, f64::INFINITY);
    let mut stage = Stage::Straight;
    while !fitter.is_done() {
        let progress = fitter.step();
        assert!(progress.share >= share && progress.share <= 1.0);
        share = progress.share;
        let best = fitter.best();
        assert!(best.curve.is_sound() && best.curve.numbers() <= numbers, "{:?}", progress.stage);
        if progress.stage == stage && stage != Stage::Straight && stage != Stage::Polish {
            assert!(best.error <= error, "the best got worse");
        }
        (stage, error) = (progress.stage, best.error);
    }
    assert_eq!(share, 1.0);
    let curve = &fitter.best().curve;
    assert!(curve.copies() > 5, "{} copies", curve.copies());
    let fine = curve.polyline(1e-4 * outline.diagonal(), 10);
    let ours = fidelity(&outline, &fine);
    let line = fidelity(&outline, &least_squares_polyline(&outline, numbers));
    assert!(ours.rms <= line.rms, "{ours:?} {line:?}");
    // The maple's teeth are finer than its numbers tell; at least it is rougher than the polyline.
    let most = split.slope_difference().abs().max(0.02);
    assert!(ours.slope_difference().abs() <= most, "{ours:?} {split:?}");
    assert!(ours.hausdorff <= 2.0, "{ours:?}");
    // No gap: no side of the opened curve is longer than an edge.
    let longest = |points: &[DVec2]| {
        (0..points.len()).map(|i| points[i].distance(points[(i + 1) % points.len()])).fold(0.0, f64::max)
    };
    assert!(longest(&fine) <= longest(&curve.knots) + 1e-9);
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
fn errors_have_codes() {
    let fit =
        |count, numbers| Fitter::new(&outline(&circle(count)), numbers).map(|_| ()).map_err(|e| e.code());
    assert_eq!(fit(100, 10), Err("bad-numbers"));
    assert_eq!(fit(100, usize::MAX), Err("bad-numbers"));
    assert_eq!(fit(100, 260), Err("outline-too-coarse"));
    assert_eq!(fit(130, 260), Ok(()));
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
