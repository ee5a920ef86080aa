//! The morph of two closed curves.

use std::sync::LazyLock;

use frond_fit::{
    ArcCopy, ClosedCurve, CurveMorph, Fitter, MorphedCurve, Nearest, Outline, crossings, curve_presets,
    maple_leaf, oak_leaf,
};
use frond_testing::cases;
use glam::DVec2;

fn fitted(points: &[DVec2], numbers: usize, steps: usize) -> ClosedCurve {
    let outline = Outline::new(points).unwrap();
    let mut fitter = Fitter::new(&outline, numbers).unwrap();
    for _ in 0..steps {
        fitter.step();
    }
    while fitter.best().curve.copies() <= 3 && !fitter.is_done() {
        fitter.step();
    }
    fitter.best().curve.clone()
}

fn maple() -> ClosedCurve {
    static MAPLE: LazyLock<ClosedCurve> = LazyLock::new(|| fitted(&maple_leaf(1), 200, 12));
    MAPLE.clone()
}

fn oak() -> ClosedCurve {
    static OAK: LazyLock<ClosedCurve> = LazyLock::new(|| fitted(&oak_leaf(1), 200, 12));
    OAK.clone()
}

/// Koch's snowflake: 12 edges, each a copy of 4.
fn snowflake() -> ClosedCurve {
    let mut knots = Vec::new();
    for side in 0..3 {
        let corner = |k: i32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 3.0);
        let (a, b) = (corner(side), corner(side + 1));
        let third = (b - a) / 3.0;
        let tip = a + third + DVec2::from_angle(-std::f64::consts::FRAC_PI_3).rotate(third);
        knots.extend([a, a + third, tip, b - third]);
    }
    let mut curve = ClosedCurve::polygon(knots);
    for (i, edge) in curve.edges.iter_mut().enumerate() {
        *edge = Some(ArcCopy { from: i / 4 * 4, span: 4, reversed: false, c: 1.0 });
    }
    curve
}

fn triangle() -> ClosedCurve {
    ClosedCurve::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::Y])
}

fn diagonal(curve: &ClosedCurve) -> f64 {
    Outline::new(&curve.knots).map_or(1.0, |outline| outline.diagonal())
}

fn points(morphed: &MorphedCurve, tolerance: f64) -> Vec<DVec2> {
    morphed.trace(tolerance, None, 1 << 18).into_iter().map(|(_, p)| p).collect()
}

/// The largest distance from corners of a curve, opened some levels deep, to the curve that is traced to `tolerance`,
/// and back from points of it; in parts of the diagonal.
fn off(curve: &ClosedCurve, morphed: &MorphedCurve, tolerance: f64) -> f64 {
    let diagonal = diagonal(curve);
    let line = Nearest::new(&points(morphed, tolerance * diagonal), true);
    let corners = curve.polyline(1e-2 * diagonal, 8);
    let there = corners.iter().map(|&p| line.to(p).squared.sqrt()).fold(0.0, f64::max);
    let fine = Nearest::new(&curve.polyline(tolerance * diagonal, 12), true);
    let back = morphed.grid(3000).iter().map(|&p| fine.to(p).squared.sqrt()).fold(0.0, f64::max);
    there.max(back) / diagonal
}

fn pairs() -> Vec<(ClosedCurve, ClosedCurve)> {
    vec![
        (maple(), oak()),
        (maple(), snowflake()),
        (snowflake(), triangle()),
        (triangle(), oak()),
        (snowflake(), snowflake()),
        (oak(), turned(&oak(), 2.5)),
        (maple(), mirrored(&maple())),
        (triangle(), ClosedCurve::polygon(ring(500))),
        (coincident(), maple()),
        (clockwise(&maple()), oak()),
    ]
}

fn ring(count: usize) -> Vec<DVec2> {
    (0..count).map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64)).collect()
}

fn turned(curve: &ClosedCurve, angle: f64) -> ClosedCurve {
    let turn = DVec2::from_angle(angle) * 3.0;
    let knots = curve.knots.iter().map(|p| turn.rotate(*p) + DVec2::new(40.0, -7.0)).collect();
    ClosedCurve { knots, edges: curve.edges.clone() }
}

fn mirrored(curve: &ClosedCurve) -> ClosedCurve {
    let knots = curve.knots.iter().map(|p| DVec2::new(-p.x, p.y)).collect();
    ClosedCurve { knots, edges: curve.edges.clone() }
}

/// The same set, run through the other way round.
fn clockwise(curve: &ClosedCurve) -> ClosedCurve {
    let count = curve.knots.len();
    let knots = curve.knots.iter().rev().copied().collect();
    let edges = (0..count).map(|i| {
        let edge = (2 * count - 2 - i) % count;
        curve.edges[edge].map(|copy| {
            let end = (copy.from + copy.span) % count;
            ArcCopy { from: count - 1 - end, ..copy }
        })
    });
    ClosedCurve { knots, edges: edges.collect() }
}

/// Knots that lie on each other, by two and three.
fn coincident() -> ClosedCurve {
    let mut knots: Vec<_> = ring(5).into_iter().flat_map(|p| [p, p]).collect();
    knots.push(knots[9]);
    let mut curve = ClosedCurve::polygon(knots);
    curve.edges[1] = Some(ArcCopy { from: 4, span: 4, reversed: true, c: 0.6 });
    curve.edges[2] = Some(ArcCopy { from: 0, span: 3, reversed: false, c: 0.3 });
    assert!(curve.is_sound());
    curve
}

#[test]
fn the_ends_are_the_two_curves() {
    for (k, (a, b)) in pairs().into_iter().enumerate() {
        let morph = CurveMorph::new(&a, Some(&b)).unwrap();
        for (curve, s) in [(&a, 0.0), (&b, 1.0)] {
            let morphed = morph.at(s);
            let far = off(curve, &morphed, 2e-4);
            assert!(far < 3e-4, "pair {k}: {far} at {s}");
            // What is opened on both sides is the same to the last digits.
            let line = Nearest::new(&points(&morphed, 1e-2 * diagonal(curve)), true);
            let exact = Nearest::new(
                &points(&CurveMorph::new(curve, None).unwrap().at(0.3), 1e-4 * diagonal(curve)),
                true,
            );
            for p in curve.polyline(0.05 * diagonal(curve), 3) {
                let far = exact.to(p).squared.sqrt() / diagonal(curve);
                assert!(far < 1e-12, "pair {k}: {far} alone");
            }
            for p in &curve.knots {
                assert!(line.to(*p).squared.sqrt() < 1e-12 * diagonal(curve), "pair {k}: knot {p} at {s}");
            }
        }
    }
}

#[test]
fn from_the_other_end_a_morph_runs_backwards() {
    let presets: Vec<_> = curve_presets().into_iter().map(|preset| preset.curve).collect();
    let gallery = presets.iter().flat_map(|a| presets.iter().map(move |b| (a.clone(), b.clone())));
    for (k, (a, b)) in gallery.chain(pairs()).enumerate() {
        let there = CurveMorph::new(&a, Some(&b)).unwrap();
        let back = CurveMorph::new(&b, Some(&a)).unwrap();
        let size = diagonal(&a).max(diagonal(&b));
        for s in [0.0, 0.3, 0.5, 0.9] {
            let (one, other) = (there.at(s).grid(300), back.at(1.0 - s).grid(300));
            let far = one.iter().zip(&other).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
            assert!(far < 1e-5 * size, "pair {k}: {far} at {s}");
        }
    }
}

/// What an end gives at a place, against the same place of the curve alone, whose knots are fewer.
#[test]
fn further_knots_change_nothing() {
    // Of the corners every fourth; `deep` takes all.
    let stride = if cases(1) > 1 { 1 } else { 4 };
    for (k, (a, b)) in pairs().into_iter().enumerate() {
        let morph = CurveMorph::new(&a, Some(&b)).unwrap();
        for (curve, s) in [(&a, 0.0), (&b, 1.0)] {
            // Each corner of a coarse trace is a point of the curve, exactly: it is there in a finer one of the curve
            // alone, or in one that is as fine as can be around it, where the curve runs all but straight.
            let diagonal = diagonal(curve);
            let alone = CurveMorph::new(curve, None).unwrap().at(0.0);
            let fine: Vec<_> = alone.trace(2e-5 * diagonal, None, 1 << 20);
            let near = Nearest::new(&fine.iter().map(|c| c.1).collect::<Vec<_>>(), true);
            for (_, p) in morph.at(s).trace(5e-3 * diagonal, None, 1 << 16).into_iter().step_by(stride) {
                let mut far = near.to(p).squared.sqrt() / diagonal;
                if far >= 1e-12 {
                    let side = DVec2::splat(1e-7 * diagonal);
                    let window = [(p - side).x, (p - side).y, (p + side).x, (p + side).y];
                    let finest = alone.trace(1e-13 * diagonal, Some(window), 1 << 20);
                    let finest = Nearest::new(&finest.iter().map(|c| c.1).collect::<Vec<_>>(), true);
                    far = finest.to(p).squared.sqrt() / diagonal;
                }
                assert!(far < 1e-12, "pair {k}: {p} is {far} off at {s}");
            }
        }
    }
}

#[test]
fn every_moment_is_closed_and_contracts() {
    for (k, (a, b)) in pairs().into_iter().enumerate() {
        let morph = CurveMorph::new(&a, Some(&b)).unwrap();
        let mut before: Option<Vec<DVec2>> = None;
        for i in 0..=40 {
            let morphed = morph.at(f64::from(i) / 40.0);
            assert!(morphed.contraction() <= 0.9 + 1e-9, "pair {k}");
            let size = morphed_size(&morphed);
            // Neighbouring points are near each other all round.
            let grid = morphed.grid(4096);
            let longest = (0..4096).map(|i| grid[i].distance(grid[(i + 1) % 4096])).fold(0.0, f64::max);
            assert!(longest < 0.05 * size, "pair {k}: {longest} of {size} at {i}");
            // And so are neighbouring moments.
            if let Some(before) = before {
                let step = grid.iter().zip(&before).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
                let ends = a.knots.iter().chain(&b.knots).fold(0.0_f64, |m, p| m.max(p.length()));
                assert!(step < 0.1 * (ends + size), "pair {k}: {step} at {i}");
            }
            before = Some(grid);
        }
    }
}

#[test]
fn a_trace_is_as_near_as_it_says() {
    let morph = CurveMorph::new(&maple(), Some(&oak())).unwrap();
    for s in [0.0, 0.37, 0.8, 1.0] {
        let morphed = morph.at(s);
        let size = morphed_size(&morphed);
        for tolerance in [1e-2, 1e-3, 2e-4] {
            let corners = morphed.trace(tolerance * size, None, 1 << 18);
            let line = Nearest::new(&corners.iter().map(|c| c.1).collect::<Vec<_>>(), true);
            let far = morphed.grid(20_000).iter().map(|&p| line.to(p).squared.sqrt()).fold(0.0, f64::max);
            assert!(far <= tolerance * size * 1.1 + 2e-6 * size, "{far} of {}", tolerance * size);
            for window in corners.windows(2) {
                assert!(window[0].0 <= window[1].0);
            }
            for (t, p) in corners {
                assert!(morphed.point(t).distance(p) <= 0.1 * tolerance * size, "{t}");
            }
        }
    }
}

#[test]
fn a_window_is_fine_and_the_rest_is_not() {
    for (a, b, s, rough) in [
        (snowflake(), None, 0.0, true),
        (maple(), None, 0.5, false),
        (maple(), Some(oak()), 0.4, false),
        (snowflake(), Some(turned(&snowflake(), 0.3)), 0.5, true),
    ] {
        let morphed = CurveMorph::new(&a, b.as_ref()).unwrap().at(s);
        let size = morphed_size(&morphed);
        // About a point of the curve that is inside a copy.
        let fine = morphed.trace(1e-4 * size, None, 1 << 18);
        let middle = morphed.point(fine[fine.len() / 3].0);
        for zoom in [1e-2, 1e-4, 1e-6] {
            let half = DVec2::splat(0.5 * zoom * size);
            let (low, high) = (middle - half, middle + half);
            let window = [low.x, low.y, high.x, high.y];
            let corners = morphed.trace(zoom * size / 600.0, Some(window), 1 << 16);
            assert!(corners.len() < 20_000, "{} at {zoom}", corners.len());
            let inside = corners.iter().filter(|(_, p)| p.cmpge(low).all() && p.cmple(high).all()).count();
            assert!(
                inside > 10 || !rough || (b.is_some() && zoom < 1e-2),
                "{inside} of {} at {zoom}, s {s}",
                corners.len()
            );
            let line = Nearest::new(&corners.iter().map(|c| c.1).collect::<Vec<_>>(), true);
            // Two copies everywhere: there is a limit to what is computed.
            let limit = if rough && b.is_some() { 1e-5 * size } else { 0.0 };
            assert!(line.to(middle).squared.sqrt() < 2.0 * zoom * size / 600.0 + limit);
        }
    }
}

#[test]
fn there_are_no_more_corners_than_asked_for() {
    let morph = CurveMorph::new(&maple(), Some(&oak())).unwrap();
    for most in [0, 3, 10, 107, 500, 3000] {
        for window in [None, Some([0.0, 0.0, 0.1, 0.1]), Some([f64::NAN; 4]), Some([1.0, 1.0, -1.0, -1.0])] {
            for tolerance in [1e-9, 0.0, -1.0, f64::NAN, 1e9] {
                let corners = morph.at(0.5).trace(tolerance, window, most);
                assert!(corners.len() <= most.max(3) && corners.len() >= 3, "{} of {most}", corners.len());
            }
        }
    }
}

#[test]
fn a_leaf_becomes_another_without_crossing_itself() {
    let mut worst = 0;
    for (a, b) in [(maple(), oak()), (oak(), maple()), (maple(), snowflake()), (oak(), snowflake())] {
        let morph = CurveMorph::new(&a, Some(&b)).unwrap();
        for i in 0..=50 {
            let morphed = morph.at(f64::from(i) / 50.0);
            let line = points(&morphed, morphed_size(&morphed) / 500.0);
            worst = worst.max(crossings(&line, 1000).map_or(1000, |found| found.len()));
        }
    }
    assert!(worst <= 4, "{worst} crossings");
}

fn morphed_size(morphed: &MorphedCurve) -> f64 {
    let [a, b, c, d] = morphed.bounds();
    DVec2::new(a, b).distance(DVec2::new(c, d))
}

#[test]
fn any_s_and_t_has_a_point() {
    let morph = CurveMorph::new(&snowflake(), Some(&triangle())).unwrap();
    for s in [f64::NAN, -1.0, 2.0, f64::INFINITY, 0.5] {
        let morphed = morph.at(s);
        for t in [f64::NAN, f64::INFINITY, -3.25, 1e300, -1e-300, 1.0, 0.0] {
            assert!(morphed.point(t).is_finite());
        }
        assert!(morphed.point(1.25).distance(morphed.point(0.25)) < 1e-9);
    }
    assert!(morph.at(0.5).grid(0).is_empty());
}

#[test]
fn a_curve_of_one_point_stays_one() {
    let point = ClosedCurve::polygon(vec![DVec2::ONE; 4]);
    let morph = CurveMorph::new(&point, None).unwrap();
    assert!(points(&morph.at(0.5), 0.1).iter().all(|p| *p == DVec2::ONE));
    for (a, b) in [(point.clone(), maple()), (snowflake(), point.clone()), (point.clone(), point)] {
        let morph = CurveMorph::new(&a, Some(&b)).unwrap();
        for s in [0.0, 0.5, 1.0] {
            let morphed = morph.at(s);
            assert!(
                morphed.grid(100).iter().all(|p| p.is_finite()) && !morphed.trace(1e-3, None, 500).is_empty()
            );
        }
    }
}

#[test]
fn what_is_no_curve_is_told() {
    let mut bad = triangle();
    bad.edges[0] = Some(ArcCopy { from: 1, span: 2, reversed: false, c: 3.0 });
    let code = |a: &ClosedCurve, b: Option<&ClosedCurve>| CurveMorph::new(a, b).err().map(|e| e.code());
    assert_eq!(code(&bad, None), Some("unsound"));
    assert_eq!(code(&triangle(), Some(&bad)), Some("unsound"));
    let many = ClosedCurve::polygon(ring(5000));
    assert_eq!(code(&many, None), Some("too-many-knots"));
    assert_eq!(code(&ClosedCurve::polygon(Vec::new()), None), Some("unsound"));
    assert_eq!(code(&triangle(), None), None);
}
