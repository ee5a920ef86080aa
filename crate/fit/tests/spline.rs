//! Fits within so many bytes: they come back as they were, cross nothing, and are no worse than polylines.

use frond_fit::{
    Guard, Node, Outline, Spline, SplineError, SplineFitter, decimated, fidelity, fit_within, island,
    least_squares_polyline, maple_leaf, polyline_within, sugar_maple,
};
use glam::DVec2;
use proptest::prelude::*;

/// Fits, and holds the fit to all that it promises.
fn fitted(outline: &Outline, bytes: usize) -> f64 {
    let fit = fit_within(outline, bytes).unwrap();
    assert!(fit.bytes.len() <= bytes);
    let back = Spline::from_bytes(&fit.bytes).unwrap();
    assert_eq!(back, fit.spline);
    let line = back.polyline(16);
    let near = fidelity(outline, &line);
    let guard = Guard::new(outline).unwrap();
    if guard.is_strict() {
        assert!(guard.passes(&line), "{bytes} bytes");
        assert!(guard.passes(&back.polyline(5)), "{bytes} bytes");
    }
    // Corners alone, on any grid.
    let diagonal = outline.diagonal();
    for corners in [3, 5, bytes / 3, bytes / 2, bytes * 2 / 3] {
        let marks = decimated(outline, corners);
        for fine in 5..12 {
            let grid = (diagonal * 0.5_f64.powi(fine)).log2().floor().exp2();
            let at = |&mark: &usize| Node { at: (outline.points()[mark] / grid).round(), on: true };
            let plain = Spline { nodes: marks.iter().map(at).collect(), grid };
            if plain.to_bytes().is_ok_and(|packed| packed.len() <= bytes) {
                let line = plain.polyline(1);
                if line.len() >= 3 && guard.passes(&line) {
                    assert!(near.rms <= fidelity(outline, &line).rms, "{corners} corners, 2^-{fine}");
                }
            }
        }
    }
    near.rms
}

/// The boundary of the cells of a grid whose middles lie in a disc.
fn disc_of_cells(radius: f64) -> Vec<DVec2> {
    let most = radius.ceil() as i32;
    let wide = |y: i32| (0..=most).rfind(|&x| f64::from(x).hypot(f64::from(y)) <= radius).unwrap_or(0);
    let half: Vec<DVec2> = (-most..=most)
        .filter(|&y| f64::from(y).abs() <= radius)
        .flat_map(|y| [(wide(y), y), (wide(y), y + 1)])
        .map(|(x, y)| DVec2::new(f64::from(x) + 0.5, f64::from(y) - 0.5))
        .collect();
    half.iter().copied().chain(half.iter().rev().map(|p| DVec2::new(-p.x, p.y))).collect()
}

/// Polylines within so many bytes as they may be looked for by whoever doubts a fit: corners by least squares, or all
/// of the outline, on grids by quarters of an octave. The root mean square of the nearest.
fn nearest_polyline(outline: &Outline, bytes: usize) -> f64 {
    let guard = Guard::new(outline).unwrap();
    let counts = [6.5, 7.5, 8.5, 9.5, 11.0, 13.0].map(|bits| 2 * (8.0 * bytes as f64 / bits) as usize);
    let lines = counts.map(|numbers| least_squares_polyline(outline, numbers));
    let mut nearest = f64::INFINITY;
    for line in lines.iter().map(Vec::as_slice).chain([outline.points()]) {
        for quarter in 8..40 {
            // Widths of two digits of sixteen, as the form keeps them.
            let grid = outline.diagonal() * (-0.25 * f64::from(quarter)).exp2();
            let grid = f64::from_bits(grid.to_bits() >> 46 << 46);
            for grid in [grid, grid.log2().round().exp2()] {
                let mut nodes: Vec<_> =
                    line.iter().map(|p| Node { at: (*p / grid).round(), on: true }).collect();
                nodes.dedup();
                let plain = Spline { nodes, grid };
                if plain.to_bytes().is_ok_and(|packed| packed.len() <= bytes) {
                    let drawn = plain.polyline(1);
                    if drawn.len() >= 3 && guard.passes(&drawn) {
                        nearest = nearest.min(fidelity(outline, &drawn).rms);
                    }
                }
            }
        }
    }
    nearest
}

/// A fit is no farther than the polyline that is shown beside it, nor than those of the search above.
fn beats_polylines(points: &[DVec2], bytes: usize) {
    let outline = Outline::new(points).unwrap();
    let fit = fit_within(&outline, bytes).map_or(f64::INFINITY, |fit| fit.near.rms);
    if let Some(line) = polyline_within(&outline, bytes) {
        let beside = fidelity(&outline, &line).rms;
        assert!(fit <= beside, "{bytes} bytes: {fit}, the polyline beside it {beside}");
    }
    let nearest = nearest_polyline(&outline, bytes);
    // Where corners come to lie on a grid of another width is as good as chance.
    assert!(fit <= 1.05 * nearest + 1e-9, "{bytes} bytes: {fit}, a polyline {nearest}");
}

#[test]
fn drawings_on_a_grid_are_fitted_exactly_where_a_polyline_is() {
    for radius in [2.3, 3.0, 3.6, 4.2, 5.0] {
        let outline = Outline::new(&disc_of_cells(radius)).unwrap();
        for bytes in [32, 40] {
            beats_polylines(outline.points(), bytes);
        }
        assert!(fit_within(&outline, 48).unwrap().near.rms < 1e-9, "{radius}");
    }
    let stairs = (0..9).flat_map(|i| [(i, i), (i + 1, i)]).map(|(x, y)| DVec2::new(x.into(), y.into()));
    let stairs: Vec<_> = stairs.chain([DVec2::new(9.0, 9.0), DVec2::new(0.0, 9.0)]).collect();
    beats_polylines(&stairs, 32);
}

#[test]
fn grown_leaves_are_nearer_with_more_bytes() {
    for points in [maple_leaf(3), island(5)] {
        let outline = Outline::new(&points).unwrap().resampled(500);
        let [few, many] = [32, 50].map(|bytes| fitted(&outline, bytes));
        assert!(many < 0.9 * few, "{few} {many}");
    }
}

#[test]
fn degenerate_outlines_have_fits() {
    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(DVec2::from);
    assert!(fitted(&Outline::new(&triangle).unwrap(), 32) < 0.2);
    let spike = [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [2.0, 0.0], [1.0, 1.0]].map(DVec2::from);
    let along = [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 1e-9], [0.5, 1e-9]].map(DVec2::from);
    let eight: Vec<_> = (0..300)
        .map(|i| DVec2::from_angle(f64::from(i) / 300.0 * std::f64::consts::TAU))
        .map(|p| DVec2::new(p.x, p.x * p.y))
        .collect();
    for (points, scale) in [(&spike[..], 1e-90), (&along[..], 1.0), (&eight, 1e9)] {
        let scaled: Vec<_> = points.iter().map(|p| *p * scale).collect();
        let outline = Outline::new(&scaled).unwrap();
        // Two sides a billionth apart fall together on every grid.
        let Some(fit) = fit_within(&outline, 36) else {
            assert_eq!(points, &along);
            continue;
        };
        let guard = Guard::new(&outline).unwrap();
        assert!(!guard.is_strict() || guard.passes(&fit.spline.polyline(16)));
        assert!(fit.bytes.len() <= 36 && fit.near.rms < 3.0, "{scale}: {}", fit.near.rms);
        assert_eq!(Spline::from_bytes(&fit.bytes).unwrap(), fit.spline);
    }
    let far: Vec<_> = triangle.iter().map(|p| *p + DVec2::splat(1e15)).collect();
    assert!(fit_within(&Outline::new(&far).unwrap(), 32).is_none_or(|fit| fit.bytes.len() <= 32));
}

#[test]
fn a_leaf_of_curves_is_fitted_by_parabolas_and_corners() {
    // Two arcs that end in two tips: what parabolas are for, but for the tips.
    let arc = |i: i32| DVec2::from_angle(0.5 + f64::from(i % 300) / 300.0 * 2.14) * 3.0 - DVec2::Y * 1.44;
    let points: Vec<DVec2> = (0..600).map(|i| if i < 300 { arc(i) } else { -arc(i) }).collect();
    let outline = Outline::new(&points).unwrap();
    let fit = fit_within(&outline, 48).unwrap();
    let corners = fit.spline.corners();
    assert!(corners >= 2 && 2 * corners < fit.spline.nodes.len(), "{corners} of {}", fit.spline.nodes.len());
    assert!(fit.near.rms < 0.03, "{}", fit.near.rms);
}

#[test]
fn a_million_points_are_fitted_step_by_step_and_measured_at_all() {
    let wave = |i: u32| {
        let angle = f64::from(i) * 1e-6 * std::f64::consts::TAU;
        // A ripple that is finer than what is followed, and counts all the same.
        DVec2::from_angle(angle) * (1.0 + 0.2 * (5.0 * angle).sin() + 3e-4 * f64::from(i % 2))
    };
    let outline = Outline::new(&(0..1_000_000).map(wave).collect::<Vec<_>>()).unwrap();
    let mut fitter = SplineFitter::new(&outline, 40);
    assert!(fitter.best().is_none());
    let mut shares = vec![fitter.share()];
    while !fitter.is_done() {
        fitter.step();
        shares.push(fitter.share());
    }
    assert!(shares.is_sorted() && shares.len() > 50 && shares.ends_with(&[1.0]));
    let fit = fitter.best().unwrap();
    let all = fidelity(&outline, &fit.spline.polyline(16));
    assert_eq!(fit.near, all);
    let line = polyline_within(&outline, 40).unwrap();
    assert!(all.rms <= fidelity(&outline, &line).rms, "the polyline is nearer at all points");
    assert!(fit.bytes.len() <= 40 && fit.near.rms < 1.0, "{}", fit.near.rms);
}

#[test]
fn tangles_have_fits() {
    let far = |i: u32| DVec2::from_angle(f64::from(i) * 2.5) * (1.0 + f64::from(i % 7));
    let outline = Outline::new(&(0..3000).map(far).collect::<Vec<_>>()).unwrap();
    assert!(fit_within(&outline, 32).is_some_and(|fit| fit.bytes.len() <= 32));
}

#[test]
fn long_sides_on_fine_grids_take_few_bytes() {
    let size = 3.0e9;
    let corners = [[0.0, 0.0], [size, 1.0], [size + 7.0, size], [-1.0, size - 5.0]];
    let nodes = corners.map(|p| Node { at: p.into(), on: true }).to_vec();
    let spline = Spline { nodes, grid: 0.125 };
    let bytes = spline.to_bytes().unwrap();
    assert_eq!(Spline::from_bytes(&bytes).unwrap(), spline);
    // Three steps of two numbers, each of some 32 bits.
    assert!(bytes.len() < 3 * 2 * 33 / 8 + 9, "{}", bytes.len());
}

#[test]
fn what_is_no_curve_is_refused() {
    assert_eq!(Spline::from_bytes(&[]), Err(SplineError::UnknownVersion));
    assert_eq!(Spline::from_bytes(&[1, 2, 3]), Err(SplineError::UnknownVersion));
    let node = |x: f64, y: f64| Node { at: DVec2::new(x, y), on: true };
    let mut spline = Spline { nodes: vec![node(0.0, 0.0); 5000], grid: 1.0 };
    assert_eq!(spline.to_bytes(), Err(SplineError::TooLarge));
    spline.nodes.truncate(3);
    spline.nodes[2].at.y = 0.5;
    assert_eq!(spline.to_bytes(), Err(SplineError::Unsound));
    spline.nodes.pop();
    assert_eq!(spline.to_bytes(), Err(SplineError::Unsound));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_bytes_are_a_curve_or_none(mut bytes in proptest::collection::vec(any::<u8>(), 0..60)) {
        bytes.insert(0, 2);
        if let Ok(spline) = Spline::from_bytes(&bytes) {
            prop_assert!(spline.is_sound());
        }
    }

    #[test]
    fn curves_come_back_as_they_were(
        places in proptest::collection::vec((-40_i32..40, -40_i32..40, any::<bool>()), 3..60),
        shift in -1_000_000_i64..1_000_000,
        size in 0_u32..30,
        exponent in -300..300,
    ) {
        let nodes = places
            .iter()
            .map(|&(x, y, on)| {
                let at = DVec2::new(f64::from(x), f64::from(y)) * f64::from(1 << size);
                Node { at: at + DVec2::new(shift as f64, f64::from(y)), on }
            })
            .collect();
        let spline = Spline { nodes, grid: 1.5 * f64::from(exponent).exp2() };
        let bytes = spline.to_bytes().unwrap();
        prop_assert_eq!(Spline::from_bytes(&bytes).unwrap(), spline);
    }
}

/// Outlines as they are drawn, and as they grow: discs and stairs of grid steps, rectangles, stars, rough leaves.
fn any_outline() -> impl Strategy<Value = Vec<DVec2>> {
    let rectangle = (1..30_i32, 1..30_i32).prop_map(|(x, y)| {
        let (x, y) = (f64::from(x), f64::from(y));
        [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)].map(DVec2::from).to_vec()
    });
    let stairs = proptest::collection::vec((1..5_i32, 1..5_i32), 2..14).prop_map(|steps| {
        let (mut at, mut line) = (DVec2::ZERO, vec![DVec2::ZERO]);
        for (x, y) in steps {
            for step in [DVec2::new(x.into(), 0.0), DVec2::new(0.0, y.into())] {
                at += step;
                line.push(at);
            }
        }
        line.push(DVec2::new(0.0, at.y));
        line
    });
    let star = (3..12_usize, 0.2..0.9_f64, 0.0..6.0_f64).prop_map(|(tips, bay, turn)| {
        let tip = |i: usize| DVec2::from_angle(turn + std::f64::consts::PI * i as f64 / tips as f64);
        (0..2 * tips).map(|i| tip(i) * if i % 2 == 0 { 1.0 } else { bay }).collect()
    });
    let leaf = (0..1000_u32, 60..600_usize, 0..3).prop_map(|(seed, count, kind)| {
        let points = [maple_leaf, sugar_maple, island][kind as usize](seed);
        Outline::new(&points).unwrap().resampled(count).points().to_vec()
    });
    let shape = prop_oneof![(1.5..9.0_f64).prop_map(disc_of_cells), rectangle, stairs, star, leaf];
    let size = prop_oneof![Just(1.0), Just(0.25), Just(3.0), 0.01..100.0_f64];
    let place = prop_oneof![Just(DVec2::ZERO), (-50.0..50.0_f64, -50.0..50.0_f64).prop_map(DVec2::from)];
    (shape, size, place).prop_map(|(points, size, place)| points.iter().map(|p| *p * size + place).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(6)))]

    #[test]
    fn no_polyline_of_as_many_bytes_is_nearer(points in any_outline(), bytes in 32..81_usize) {
        beats_polylines(&points, bytes);
    }
}
