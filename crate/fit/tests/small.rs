//! Small fits: what is exact needs no search, and what is small needs a short one. Steps are counted, never time.

use frond_fit::{
    Fidelity, Fitter, Guard, Outline, OutlineError, SplineFitter, fidelity, fit_within, island,
    least_squares_polyline, maple_leaf, sugar_maple,
};
use glam::DVec2;

/// Steps of a fit within so many bytes that tries grids for one polyline, and nothing else.
const GRIDS: usize = 45;

/// Steps of a fit of 12 numbers to 150 points, and to any number of points.
const MOST_STEPS: usize = 1500;
const MOST_STEPS_OF_MANY: usize = 9400;

fn polygon(corners: &[[f64; 2]]) -> Vec<DVec2> {
    corners.iter().map(|&p| DVec2::from(p)).collect()
}

fn star(tips: u32) -> Vec<DVec2> {
    let tip = |i: u32| DVec2::from_angle(std::f64::consts::PI * f64::from(i) / f64::from(tips));
    (0..2 * tips).map(|i| tip(i) * if i % 2 == 0 { 1.0 } else { 0.45 }).collect()
}

/// The same with `each` points a side.
fn along(corners: &[DVec2], each: u32) -> Vec<DVec2> {
    let side = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        (0..each).map(move |k| a.lerp(b, f64::from(k) / f64::from(each)))
    };
    (0..corners.len()).flat_map(side).collect()
}

/// Turned, stretched and put somewhere, so that no corner lies on a grid.
fn placed(points: &[DVec2]) -> Vec<DVec2> {
    points.iter().map(|p| DVec2::from_angle(0.3).rotate(*p) * 7.3 + DVec2::new(-101.7, 33.1)).collect()
}

/// Outlines of no more than six corners.
fn of_few_corners() -> Vec<(usize, Vec<DVec2>)> {
    let shapes = [
        polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]),
        polygon(&[[0.1, 0.2], [3.3, 0.7], [1.4, 2.9]]),
        star(3),
        // An eight of four corners.
        polygon(&[[0.0, 0.0], [2.0, 1.0], [2.0, 0.0], [0.0, 1.5]]),
        polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1e-3], [0.0, 1e-3]]),
    ];
    let all = shapes.into_iter().map(|shape| (shape.len(), shape));
    all.flat_map(|(count, shape)| {
        let far = placed(&shape);
        [(count, along(&shape, 40)), (count, along(&far, 25_000)), (count, shape), (count, far)]
    })
    .collect()
}

fn steps_of(mut fitter: Fitter) -> (usize, Fitter) {
    let mut steps = 0;
    while !fitter.is_done() {
        fitter.step();
        steps += 1;
    }
    (steps, fitter)
}

fn near(outline: &Outline, fitter: &Fitter) -> Fidelity {
    fidelity(outline, &fitter.best().curve.polyline(1e-4 * outline.diagonal(), 12))
}

#[test]
fn an_outline_of_few_corners_is_its_own_fit() {
    for (count, points) in of_few_corners() {
        let outline = Outline::new(&points).unwrap();
        let mut fitter = Fitter::new(&outline, 12).unwrap();
        assert!(fitter.is_done(), "{count} corners, {} points", points.len());
        let curve = &fitter.best().curve;
        assert_eq!((curve.knots.len(), curve.copies()), (count, 0), "{} points", points.len());
        assert_eq!(&curve.quantised().unwrap(), curve, "a document keeps it as it is");
        let near = near(&outline, &fitter);
        assert!(near.rms < 1e-3 && near.hausdorff < 2e-3, "{near:?}");
        // Whoever steps all the same is told that it is done.
        let progress = fitter.step();
        assert!(progress.share == 1.0 && progress.rms < 1e-3, "{progress:?}");
    }
}

#[test]
fn corners_that_cost_more_than_was_asked_for_are_looked_for_as_before() {
    let outline = Outline::new(&star(5)).unwrap();
    assert!(!Fitter::new(&outline, 18).unwrap().is_done());
    assert!(Fitter::new(&outline, 20).unwrap().is_done());
    let (_, fitter) = steps_of(Fitter::new(&outline, 18).unwrap());
    assert!(fitter.best().curve.numbers() <= 18);
}

#[test]
fn a_search_that_finds_what_is_exact_ends_there() {
    // A hexagon whose corners are cut off by next to nothing: 12 corners, of which six will do.
    let hexagon: Vec<DVec2> =
        (0..6).map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::FRAC_PI_3)).collect();
    let cut = |i: usize| {
        let (before, p, after) = (hexagon[(i + 5) % 6], hexagon[i], hexagon[(i + 1) % 6]);
        [p.lerp(before, 2e-7), p.lerp(after, 2e-7)]
    };
    let outline = Outline::new(&(0..6).flat_map(cut).collect::<Vec<_>>()).unwrap();
    let (steps, fitter) = steps_of(Fitter::new(&outline, 12).unwrap());
    assert!(steps <= 130 && fitter.best().curve.copies() == 0, "{steps} steps");
    assert!(near(&outline, &fitter).rms < 1e-3);
}

#[test]
fn few_corners_need_no_descent_within_their_bytes() {
    for (count, points) in of_few_corners() {
        let outline = Outline::new(&points).unwrap();
        let mut fitter = SplineFitter::new(&outline, 50);
        let mut steps = 0;
        while !fitter.is_done() {
            fitter.step();
            steps += 1;
        }
        // Two sides a thousandth apart, far from the origin, take more bytes.
        let Some(fit) = fitter.best() else { panic!("{count} corners: nothing was found") };
        assert!(steps <= GRIDS, "{count} corners, {} points: {steps} steps", points.len());
        assert!(fit.bytes.len() <= 50 && fit.spline.nodes.len() == count, "{} nodes", fit.spline.nodes.len());
        assert!(fit.near.rms < 1e-3, "{:?}", fit.near);
    }
    // Corners that do not lie on a grid take as many bits as there are.
    let coarse = fit_within(&Outline::new(&placed(&star(5))).unwrap(), 32).unwrap();
    assert!(coarse.near.rms > 1e-3);
}

#[test]
fn few_numbers_are_found_in_few_steps() {
    for points in [maple_leaf(1), sugar_maple(1), island(4)] {
        let outline = Outline::new(&points).unwrap().resampled(150);
        let (steps, fitter) = steps_of(Fitter::new(&outline, 12).unwrap());
        assert!(steps <= MOST_STEPS, "{steps} steps");
        let found = near(&outline, &fitter).rms;
        let line = fidelity(&outline, &least_squares_polyline(&outline, 12)).rms;
        assert!(found <= line * (1.0 + 1e-3), "{found}, the polyline {line}");
    }
}

#[test]
fn hard_outlines_have_small_fits_or_are_refused() {
    let fits = |points: &[DVec2]| {
        let outline = Outline::new(points).unwrap();
        let (steps, fitter) = steps_of(Fitter::new(&outline, 12).unwrap());
        assert!(steps <= MOST_STEPS_OF_MANY, "{steps} steps");
        let curve = &fitter.best().curve;
        assert!(curve.is_sound() && curve.numbers() <= 12);
        let line = curve.polyline(1e-4 * outline.diagonal(), 12);
        if let Some(guard) = Guard::new(&outline).filter(Guard::is_strict) {
            assert!(guard.passes(&line));
        }
        fidelity(&outline, &line).rms
    };
    let turn =
        |i: u32, count: u32| DVec2::from_angle(f64::from(i) / f64::from(count) * std::f64::consts::TAU);
    let wave = |i: u32| turn(i, 100_000) * (1.0 + 0.2 * turn(5 * i, 100_000).y);
    assert!(fits(&(0..100_000).map(wave).collect::<Vec<_>>()) < 5.0);
    let eight = |i: u32| DVec2::new(turn(i, 150).x, turn(i, 150).x * turn(i, 150).y);
    assert!(fits(&(0..150).map(eight).collect::<Vec<_>>()) < 5.0);
    // A spike out along a side and back: rounded, it crosses itself elsewhere.
    let spike = placed(&polygon(&[[0.0, 0.0], [3.0, 0.0], [1.0, 0.0], [1.0, 1.0]]));
    assert!(fits(&spike) < 1e-3);
    let tangle = |i: u32| DVec2::from_angle(2.5 * f64::from(i)) * (1.0 + f64::from(i % 7));
    assert!(fits(&(0..300).map(tangle).collect::<Vec<_>>()) < 40.0);
    // Less than an outline.
    let refused = |points: &[DVec2]| Outline::new(points).unwrap_err();
    assert_eq!(refused(&[DVec2::ZERO, DVec2::X]), OutlineError::TooFewPoints { count: 2 });
    assert_eq!(refused(&[DVec2::ONE; 9]), OutlineError::TooFewPoints { count: 1 });
    assert_eq!(refused(&placed(&polygon(&[[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]]))), OutlineError::Flat);
}
