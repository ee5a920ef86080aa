//! The shortest function within a tolerance: it keeps what it promises, and no polyline of as many numbers is nearer.

use frond_fit::{
    Candidate, Features, FractalFunction, Hough, HoughOptions, Model, Within, assemble_within, name_clusters,
};
use glam::DVec2;

const FINE: usize = 65;

fn graph(height: impl Fn(f64) -> f64, count: usize) -> Features {
    let t = |i: usize| i as f64 / (count - 1) as f64;
    let points: Vec<_> = (0..count).map(|i| DVec2::new(1990.0 + 30.0 * t(i), 200.0 * height(t(i)))).collect();
    Features::new(&points).unwrap()
}

fn voted(coarse: &Features, fine: &Features) -> Vec<Candidate> {
    let options = HoughOptions::default();
    let clusters = Hough::new(coarse, fine, options).finish();
    name_clusters(coarse, fine, options, &clusters).iter().filter_map(|found| found.candidate).collect()
}

fn whole(height: impl Fn(f64) -> f64, tolerances: &[f64]) -> Vec<Within> {
    let (coarse, fine) = (graph(&height, 33), graph(&height, FINE));
    let candidates = voted(&coarse, &fine);
    let made = |&tolerance: &f64| {
        let within = assemble_within(&coarse, &fine, &candidates, tolerance).unwrap();
        keeps(&fine, &within, tolerance);
        within
    };
    tolerances.iter().map(made).collect()
}

/// How far the nearest polyline with corners at points is off, of so many pieces at most: all ways, one after another.
fn polyline(points: &[DVec2], pieces: usize) -> f64 {
    let count = points.len();
    let off = |from: usize, to: usize| {
        let (a, b) = (points[from], points[to]);
        let at = |t: f64| a.y + (b.y - a.y) * (t - a.x) / (b.x - a.x);
        points[from..=to].iter().map(|p| (p.y - at(p.x)).abs()).fold(0.0, f64::max)
    };
    let table: Vec<Vec<f64>> = (0..count)
        .map(|from| (0..count).map(|to| if to > from { off(from, to) } else { 0.0 }).collect())
        .collect();
    let mut least = table[0].clone();
    for _ in 1..pieces {
        least = (0..count)
            .map(|to| (0..to).map(|by| least[by].max(table[by][to])).fold(least[to], f64::min))
            .collect();
    }
    least[count - 1]
}

/// What is promised.
fn keeps(fine: &Features, within: &Within, tolerance: f64) {
    let Within { assembly, numbers, polyline: most } = within;
    let tall = fine.heights()[1] - fine.heights()[0];
    let off = fine.points().iter().map(|p| (assembly.function.at(p.x) - p.y).abs()).fold(0.0, f64::max);
    assert!(off <= tolerance * tall * (1.0 + 1e-6) + 1e-9 * (1.0 + tall), "{off} for {tolerance}");
    assert!(numbers <= most, "{numbers} of {most}");
    // As many numbers make a polyline of so many pieces: two a corner.
    let nearest = polyline(fine.points(), (numbers / 2).saturating_sub(1).max(1));
    assert!(off <= nearest + 1e-9 * (1.0 + tall), "{off} with {numbers} numbers, a polyline {nearest}");
}

/// Six roofs and two thin towers.
fn skyline(t: f64) -> f64 {
    let roofs = [0.2, 0.45, 0.3, 0.6, 0.25, 0.4];
    let roof = roofs[((6.0 * t) as usize).min(5)];
    let tower = [0.26, 0.81].iter().any(|middle| (t - middle).abs() < 0.012);
    if tower { 1.0 } else { roof }
}

#[test]
fn a_skyline_keeps_its_towers() {
    let all = whole(skyline, &[0.3, 0.1, 0.03, 0.0]);
    for within in &all {
        for tower in [0.26, 0.81] {
            let fine = graph(skyline, FINE);
            let top = fine.points()[(tower * (FINE - 1) as f64).round() as usize];
            assert!(within.assembly.function.at(top.x) > 130.0, "a tower is gone");
        }
    }
    assert!(all.windows(2).all(|pair| pair[0].numbers <= pair[1].numbers), "nearer costs no less");
}

#[test]
fn what_is_made_of_copies_is_told_in_fewer_numbers_than_a_polyline_takes() {
    let maps = [[0.5, 0.746, 0.5, -0.5, 0.246], [0.5, -0.199, -0.6, 0.5, 0.189]];
    let function = FractalFunction::pfif(&maps.map(|map| (map, [-1.0, 1.0]))).unwrap();
    let all = whole(|t| function.at(2.0 * t - 1.0), &[0.05, 0.02]);
    for within in all {
        assert_eq!(within.assembly.model, Model::Fif);
        assert!(2 * within.numbers < within.polyline, "{} of {}", within.numbers, within.polyline);
    }
}

#[test]
fn smooth_rough_and_degenerate_graphs_keep_the_promise() {
    let noise = |t: f64| ((t * 12_345.678).sin() * 43_758.545).fract();
    let graphs: [&dyn Fn(f64) -> f64; 8] = [
        &|_| 0.7,
        &|t| 3.0 - 2.0 * t,
        &|t| if (t - 0.5).abs() < 1e-3 { 1.0 } else { 0.0 },
        &|t| f64::from(t > 0.4),
        &|t| (9.0 * t).sin(),
        &|t| t * t,
        &noise,
        &|t| 1e-12 * noise(t),
    ];
    for height in graphs {
        whole(height, &[0.2, 0.05, 0.01, 0.0]);
    }
    let flat = whole(|_| 0.7, &[0.1]);
    assert_eq!(flat[0].numbers, 6, "even a line is two pieces");
}

#[test]
fn odd_tolerances_candidates_and_few_points_are_taken() {
    let few = Features::new(&[(0.0, 0.0), (0.3, 5.0), (1.0, 1.0)].map(DVec2::from)).unwrap();
    let uneven: Vec<_> = (0..40).map(|i| DVec2::new(f64::from(i * i), f64::from(i * 7 % 11))).collect();
    let uneven = Features::new(&uneven).unwrap();
    let odd = |map| Candidate { map, domain: [f64::NAN, 1.0], points: 3, rms: 0.0 };
    let candidates = [
        odd([f64::NAN; 5]),
        odd([1e200; 5]),
        odd([0.0; 5]),
        odd([0.5, 0.0, 0.25, 0.0, 0.0]),
        odd([-0.5, 0.0, 0.25, 700.0, f64::INFINITY]),
    ];
    for fine in [&few, &uneven] {
        for tolerance in [0.0, 0.1, 1.0] {
            keeps(fine, &assemble_within(fine, fine, &candidates, tolerance).unwrap(), tolerance);
        }
        for tolerance in [f64::NAN, -1.0] {
            keeps(fine, &assemble_within(fine, fine, &candidates, tolerance).unwrap(), 0.0);
        }
        keeps(fine, &assemble_within(fine, fine, &candidates, f64::INFINITY).unwrap(), 1.0);
    }
}
