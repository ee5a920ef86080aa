//! Fractal functions and curves: what must hold whatever the numbers, and bad input.

use frond_fit::{Dimension, FractalCurve, FractalFunction, FunctionError, Piece, Side};
use glam::{DMat2, DVec2};
use proptest::prelude::*;

fn tent() -> Vec<DVec2> {
    vec![DVec2::ZERO, DVec2::new(0.5, 1.0), DVec2::X]
}

#[test]
fn without_roughness_it_is_the_polyline() {
    let function = FractalFunction::fif(&tent(), &[0.0, 0.0], &[false, true]).unwrap();
    for i in 0..=40 {
        let t = f64::from(i) / 40.0;
        assert!((function.at(t) - (1.0 - (2.0 * t - 1.0).abs())).abs() < 1e-15, "at {t}");
    }
    assert_eq!(function.dimension(), Dimension::Equation(1.0));
    assert_eq!(function.curve().contractivity(), 0.75);
}

#[test]
fn a_quarter_is_a_parabola() {
    // x(1 - x) is its own copy: halves with c = 1/4 (Barnsley & Harrington 1989 start from it).
    let knots = [DVec2::ZERO, DVec2::new(0.5, 0.25), DVec2::X];
    for reflected in [[false, false], [true, false], [true, true]] {
        let function = FractalFunction::fif(&knots, &[0.25, 0.25], &reflected).unwrap();
        for i in 0..=1000 {
            let t = f64::from(i) / 1000.0;
            assert!((function.at(t) - t * (1.0 - t)).abs() < 1e-15, "at {t}");
        }
        assert!((function.integral().unwrap() - 1.0 / 6.0).abs() < 1e-15);
        assert!((function.counted_dimension() - 1.0).abs() < 0.05);
    }
}

#[test]
fn the_counted_dimension_is_near_the_true_one() {
    let function = FractalFunction::fif(&tent(), &[0.65, 0.65], &[false, false]).unwrap();
    let Dimension::Equation(exact) = function.dimension() else { panic!("whole domains") };
    let counted = function.counted_dimension();
    assert!((exact - (1.0 + 1.3_f64.log2())).abs() < 1e-11, "{exact}");
    assert!((counted - exact).abs() < 0.1, "{counted} for {exact}");
}

#[test]
fn collinear_points_give_a_straight_line_whatever_the_factors() {
    let points = [DVec2::ZERO, DVec2::splat(0.3), DVec2::ONE];
    let function = FractalFunction::fif(&points, &[0.9, 0.9], &[false, false]).unwrap();
    assert_eq!(function.dimension(), Dimension::Equation(1.0));
    assert!((function.at(0.7) - 0.7).abs() < 1e-14);
}

#[test]
fn a_hidden_variable_bends_the_other_coordinate() {
    let t = [0.0, 0.5, 1.0];
    let knots = [DVec2::ZERO, DVec2::ONE, DVec2::new(1.0, 0.0)];
    let plain = [DMat2::from_diagonal(DVec2::new(0.3, 0.4)); 2];
    let linked = [DMat2::from_cols(DVec2::new(0.3, 0.0), DVec2::new(0.2, 0.4)); 2];
    let curve = |factors: &[DMat2]| FractalCurve::fif(&t, &knots, factors, &[false, true]).unwrap();
    let (plain, linked) = (curve(&plain), curve(&linked));
    assert_eq!(plain.at(0.3).y, linked.at(0.3).y);
    assert!((plain.at(0.3).x - linked.at(0.3).x).abs() > 0.01);
    // Separable: each coordinate is what it would be alone.
    let points: Vec<_> = t.iter().zip(knots).map(|(&t, p)| DVec2::new(t, p.y)).collect();
    let alone = FractalFunction::fif(&points, &[0.4, 0.4], &[false, true]).unwrap();
    assert!((plain.at(0.3).y - alone.at(0.3)).abs() < 1e-15);
}

#[test]
fn errors_have_codes() {
    let fif = |points: &[DVec2], c: &[f64]| {
        FractalFunction::fif(points, c, &vec![false; c.len()]).map_err(|error| error.code())
    };
    let nan = |i: usize| {
        let mut points = tent();
        points[i].y = f64::NAN;
        points
    };
    assert_eq!(fif(&[], &[]), Err("too-few-points"));
    assert_eq!(fif(&tent()[..1], &[]), Err("too-few-points"));
    // Two points make one piece, which is as long as all it could copy.
    assert_eq!(fif(&tent()[..2], &[0.5]), Err("bad-domain"));
    assert_eq!(fif(&nan(1), &[0.5, 0.5]), Err("not-finite"));
    assert_eq!(fif(&tent(), &[f64::NAN, 0.5]), Err("not-finite"));
    assert_eq!(fif(&[DVec2::X, DVec2::ZERO, DVec2::Y], &[0.5, 0.5]), Err("not-increasing"));
    assert_eq!(fif(&[DVec2::ZERO, DVec2::ZERO, DVec2::X], &[0.5, 0.5]), Err("not-increasing"));
    assert_eq!(fif(&tent(), &[0.5]), Err("wrong-count"));
    assert_eq!(fif(&tent(), &[0.5, -1.0]), Err("not-contractive"));
    let short = FractalFunction::rfif(&tent(), &[0.5, 0.5], &[(0, 2), (0, 1)]);
    assert_eq!(short, Err(FunctionError::BadDomain { piece: 1 }));
    let outside = FractalFunction::rfif(&tent(), &[0.5, 0.5], &[(0, 2), (0, 3)]);
    assert_eq!(outside, Err(FunctionError::BadDomain { piece: 1 }));
    let half = ([0.5, 0.0, 0.5, 0.0, 0.0], [0.0, 1.0]);
    let far = ([0.5, 0.0, 0.5, 0.6, 0.0], [0.0, 1.0]);
    assert_eq!(
        FractalFunction::pfif(&[half, far]),
        Err(FunctionError::NotJoined { piece: 1, begin: 0.6, end: 0.5 })
    );
    assert_eq!(FractalFunction::pfif(&[]).map_err(|e| e.code()), Err("too-few-points"));
}

#[test]
fn a_million_points_are_a_function_and_more_are_refused() {
    let points: Vec<_> = (0..=1_000_000).map(|i| DVec2::new(f64::from(i), f64::from(i % 7))).collect();
    let function = FractalFunction::fif(&points, &vec![0.5; 1_000_000], &vec![false; 1_000_000]).unwrap();
    assert!((function.at(123_456.0) - 4.0).abs() < 1e-9);
    assert!(function.at(123_456.5).is_finite());
    assert!(matches!(function.curve().polyline(1e-3, 5000), Err(FunctionError::TooManyPoints { .. })));
    let points = vec![DVec2::ZERO; 1 << 21];
    assert!(matches!(FractalFunction::fif(&points, &[], &[]), Err(FunctionError::TooManyPoints { .. })));
}

#[test]
fn odd_parameters_have_values() {
    let function = FractalFunction::fif(&tent(), &[0.6, 0.4], &[false, false]).unwrap();
    for (t, value) in [(f64::NAN, 0.0), (-5.0, 0.0), (f64::INFINITY, 0.0), (0.5, 1.0)] {
        assert!((function.at(t) - value).abs() < 1e-15, "at {t}");
    }
    assert_eq!(function.curve().address(0.3, 4), [0, 1, 0, 0]);
    assert_eq!(function.curve().address(1.0, 3), [1, 1, 1]);
    let slow = FractalFunction::fif(&tent(), &[0.999_999, -0.999_999], &[false, true]).unwrap();
    assert!(slow.at(1.0 / 3.0).is_finite());
}

#[test]
fn values_at_images_of_knots_do_not_suffer_from_rounding() {
    // 0.3 of a curve with knots in tenths is an image of knots, though no double is 3/10 of anything.
    let knots: Vec<_> = (0..=10).map(|i| DVec2::new(f64::from(i) / 10.0, f64::from(i * i % 7))).collect();
    let function = FractalFunction::fif(&knots, &[0.97; 10], &[false; 10]).unwrap();
    for (i, piece) in function.curve().pieces().iter().enumerate() {
        for knot in &knots {
            let image = piece.a() * knot.x + piece.d();
            let [_, b, c, _, e] = piece.map();
            let value = b * knot.x + c * knot.y + e;
            assert!((function.at(image) - value).abs() < 1e-9, "knot {knot} in piece {i}");
        }
    }
}

fn factor() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), -0.8..0.8f64]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(64)))]

    #[test]
    fn the_graph_is_made_of_its_copies(
        heights in prop::collection::vec(-2.0..2.0f64, 4),
        steps in prop::collection::vec(0.1..1.0f64, 3),
        c in prop::collection::vec(factor(), 3),
        back in prop::collection::vec(any::<bool>(), 3),
        t in 0.0..1.0f64,
    ) {
        let mut at = 0.0;
        let mut points = vec![DVec2::new(0.0, heights[0])];
        for (step, &height) in steps.iter().zip(&heights[1..]) {
            at += step;
            points.push(DVec2::new(at, height));
        }
        let function = FractalFunction::fif(&points, &c, &back).unwrap();
        let t = t * at;
        for piece in function.curve().pieces() {
            let [a, b, c, d, e] = piece.map();
            // The image is looked up with an error of an ulp, to which a rough function answers with a power of it.
            let tolerance = 1e-5;
            prop_assert!((function.at(a * t + d) - (b * t + c * function.at(t) + e)).abs() < tolerance);
        }
        prop_assert!(function.curve().widest_gap() < 1e-12);
        for point in &points {
            prop_assert!((function.at(point.x) - point.y).abs() < 1e-12);
        }
    }

    #[test]
    fn polylines_follow_the_curve(
        c in prop::collection::vec(factor(), 2),
        twist in -0.15..0.15f64,
        back in prop::collection::vec(any::<bool>(), 2),
    ) {
        let factors: Vec<_> = c.iter().map(|&c| DMat2::from_cols(DVec2::new(c, twist), DVec2::new(-twist, c * 0.5))).collect();
        let knots = [DVec2::ZERO, DVec2::new(0.3, 1.0), DVec2::X];
        let curve = FractalCurve::fif(&[0.0, 0.4, 1.0], &knots, &factors, &back).unwrap();
        let tolerance = 0.2;
        let line = curve.polyline(tolerance, 1 << 18).unwrap();
        prop_assert!(line.windows(2).all(|w| w[0].0 < w[1].0), "t increases");
        prop_assert_eq!(line.last().unwrap().0, 1.0);
        for w in line.windows(2).step_by(7) {
            for (t, p) in w {
                prop_assert!(curve.at(*t).distance(*p) < 1e-5);
            }
            let middle = curve.at(f64::midpoint(w[0].0, w[1].0));
            prop_assert!(middle.distance(w[0].1) <= tolerance + 1e-9 && middle.distance(w[1].1) <= tolerance + 1e-9);
        }
    }
}

#[test]
fn a_partitioned_function_is_sampled_where_domains_cut_pieces() {
    let maps = [
        ([0.5, 0.1, 0.5, -0.1, 0.0], [0.2, 0.9]),
        ([-0.5, 0.3, -0.4, 0.75, 0.5], [0.1, 0.8]),
        ([0.5, 0.0, 0.3, 0.65, 0.2], [0.1, 0.7]),
    ];
    let function = FractalFunction::pfif(&maps).unwrap();
    let line = function.curve().polyline(0.01, 1 << 18).unwrap();
    assert!(line.windows(2).all(|w| w[0].0 < w[1].0));
    for (t, p) in &line {
        let values = [Side::Left, Side::Right].map(|side| (function.limit(*t, side, 0.0) - p.x).abs());
        assert!(values[0].min(values[1]) < 1e-6, "{t} {p} {values:?}");
    }
    let _: &[Piece] = function.curve().pieces();
}

#[test]
fn a_polyline_takes_as_many_points_wherever_the_curve_lies() {
    let t = [0.0, 0.5, 1.0];
    let factors = [DMat2::from_angle(0.8) * 0.6, DMat2::from_angle(-0.8) * 0.6];
    let count = |at: DVec2| {
        let knots = [DVec2::ZERO, DVec2::new(0.5, 0.4), DVec2::X].map(|p| p + at);
        let curve = FractalCurve::fif(&t, &knots, &factors, &[false, true]).unwrap();
        let line = curve.polyline(0.01, 1 << 16).unwrap();
        let (middle, reach) = curve.disc();
        let off = line.iter().map(|p| p.1.distance(middle)).fold(0.0, f64::max);
        assert!(off <= reach, "{off}");
        line.len()
    };
    assert_eq!(count(DVec2::ZERO), count(DVec2::new(4096.0, -512.0)));
}

#[test]
fn a_factor_that_lengthens_is_refused_with_the_direction() {
    let knots = [DVec2::ZERO, DVec2::ONE, DVec2::X];
    let all = DMat2::from_cols(DVec2::splat(0.7), DVec2::splat(0.7));
    let error =
        FractalCurve::rfif(&[0.0, 0.5, 1.0], &knots, &[DMat2::ZERO, all], &[(0, 2), (2, 0)]).unwrap_err();
    assert_eq!(error.code(), "not-contractive");
    assert!(error.to_string().contains("piece 2 makes the direction (0.71, 0.71) 1.400 times"), "{error}");
}

#[test]
fn in_a_window_nothing_that_is_there_is_left_out() {
    let knots = [DVec2::ZERO, DVec2::new(0.5, 0.45), DVec2::X];
    let factors =
        [DMat2::from_cols(DVec2::new(0.5, 0.45), DVec2::new(0.45, -0.5)), DMat2::from_angle(0.8) * 0.6];
    let curve = FractalCurve::fif(&[0.0, 0.5, 1.0], &knots, &factors, &[false, true]).unwrap();
    let window = [DVec2::new(0.3, 0.1), DVec2::new(0.5, 0.3)];
    let inside = |p: &DVec2| p.cmpge(window[0]).all() && p.cmple(window[1]).all();
    let whole = curve.polyline(2e-3, 1 << 20).unwrap();
    let part = curve.polyline_in(Some(window), 2e-3, 1 << 20).unwrap();
    let wanted: Vec<_> = whole.iter().filter(|point| inside(&point.1)).collect();
    let got: Vec<_> = part.iter().filter(|point| inside(&point.1)).collect();
    assert!(wanted.len() > 100);
    assert_eq!(wanted, got);
    assert!(part.len() < whole.len() / 2, "{} of {}", part.len(), whole.len());
    assert!(part.iter().any(|point| point.1.is_nan()));
    assert!(part.windows(2).all(|pair| pair[0].0 < pair[1].0));
}
