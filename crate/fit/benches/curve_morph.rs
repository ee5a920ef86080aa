//! What a morph of two leaves of 260 numbers costs: `cargo bench -p frond-fit --bench curve_morph`.

use std::hint::black_box;

use frond_fit::{ClosedCurve, CurveMorph, Fitter, Outline, crossings, maple_leaf, oak_leaf};
use frond_testing::least_time;
use glam::DVec2;

fn fitted(points: &[DVec2]) -> ClosedCurve {
    let mut fitter = Fitter::new(&Outline::new(points).expect("an outline"), 260).expect("a fit");
    for _ in 0..60 {
        fitter.step();
    }
    fitter.best().curve.clone()
}

/// The least time of some runs, in milliseconds.
fn least<T>(mut run: impl FnMut() -> T) -> f64 {
    least_time(20, || drop(black_box(run()))) * 1e3
}

fn main() {
    let (a, b) = (fitted(&maple_leaf(1)), fitted(&oak_leaf(1)));
    let morph = CurveMorph::new(&a, Some(&b)).expect("a morph");
    println!("{} and {} knots become {}", a.knots.len(), b.knots.len(), morph.knots());
    println!("matching {:.2} ms", least(|| CurveMorph::new(&a, Some(&b))));
    for s in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let morphed = morph.at(s);
        let [left, bottom, right, top] = morphed.bounds();
        let tolerance = (right - left).max(top - bottom) / 600.0;
        let line: Vec<_> = morphed.trace(tolerance, None, 1 << 16).iter().map(|corner| corner.1).collect();
        println!(
            "s {s:.2}: at {:.2} ms, bounds {:.2} ms, at 1/600 {:.2} ms for {} corners, {} copies, grid of 4^7 {:.2} ms, {} crossings",
            least(|| morph.at(s)),
            least(|| morphed.bounds()),
            least(|| morphed.trace(tolerance, None, 1 << 16)),
            line.len(),
            morphed.copies(),
            least(|| morphed.grid(16_384)),
            crossings(&line, 1000).map_or(usize::MAX, |found| found.len()),
        );
        for zoom in [1e-3, 1e-6] {
            let middle = morphed.point(0.37);
            let half = 0.5 * zoom * (right - left);
            let window = [middle.x - half, middle.y - half, middle.x + half, middle.y + half];
            let corners = morphed.trace(zoom * tolerance, Some(window), 1 << 16).len();
            println!(
                "        window of {zoom:.0e}: {:.2} ms for {corners} corners",
                least(|| morphed.trace(zoom * tolerance, Some(window), 1 << 16))
            );
        }
    }
}
