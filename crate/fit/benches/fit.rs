//! What fits come to, on grown leaves and on the outlines (.csv) of the folder named in `FROND_LEAVES`:
//! `FROND_LEAVES=.. cargo bench -p frond-fit --bench fit -- [name ..] [numbers=260] [turns=1] [noise=0] [only]`.
//!
//! With `turns` the outline is begun at so many places of it, and each is fitted: how much results scatter. `noise` is
//! how far each point is moved by chance, in percent of the diagonal; errors are measured against the outline with its
//! noise, and against the one without. `only` leaves out what fits are compared with.

use frond_fit::{
    ClosedCurve, Fitter, Outline, Stage, bezier, crossings, fidelity, fourier, island,
    least_squares_polyline, maple_leaf, oak_leaf, split_polyline,
};
use frond_testing::processor_seconds;
use glam::DVec2;

struct Options {
    names: Vec<String>,
    numbers: usize,
    turns: usize,
    noise: f64,
    only: bool,
}

fn main() {
    let mut options = Options { names: Vec::new(), numbers: 260, turns: 1, noise: 0.0, only: false };
    for arg in std::env::args().skip(1).filter(|arg| !arg.starts_with('-')) {
        match arg.split_once('=') {
            Some(("numbers", value)) => options.numbers = value.parse().expect("a number"),
            Some(("turns", value)) => options.turns = value.parse().expect("a number"),
            Some(("noise", value)) => options.noise = value.parse().expect("a number"),
            _ if arg == "only" => options.only = true,
            _ => options.names.push(arg),
        }
    }
    let mut outlines =
        vec![("grown maple", maple_leaf(1)), ("grown oak", oak_leaf(1)), ("grown island", island(4))]
            .into_iter()
            .map(|(name, points)| (name.to_owned(), points))
            .collect::<Vec<_>>();
    let plane = |points: Vec<[f64; 2]>| points.into_iter().map(DVec2::from).collect();
    outlines.extend(frond_testing::leaves().into_iter().map(|(name, points)| (name, plane(points))));
    for (name, points) in outlines {
        if options.names.is_empty() || options.names.iter().any(|wanted| name.contains(wanted)) {
            measure(&name, &points, &options);
        }
    }
}

fn report(outline: &Outline, name: &str, fit: &[DVec2], seconds: f64) {
    let f = fidelity(outline, fit);
    println!(
        "  {name:<24} rms {:.4}%  hausdorff {:.3}%  dD {:+.4}  length {:.3}  {seconds:.2} s  crossed {}",
        f.rms,
        f.hausdorff,
        f.slope_difference(),
        f.length_ratio,
        crossings(fit, 99).map_or("too often to tell".to_owned(), |found| found.len().to_string())
    );
}

/// Evenly spread chance, the same every time.
fn swing(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn measure(name: &str, points: &[DVec2], options: &Options) {
    let Ok(clean) = Outline::new(points) else { return };
    let mut seed = 7;
    let reach = options.noise / 100.0 * clean.diagonal();
    let noisy: Vec<_> =
        clean.points().iter().map(|p| *p + DVec2::new(swing(&mut seed), swing(&mut seed)) * reach).collect();
    let Ok(outline) = Outline::new(&noisy) else { return };
    println!("{name}: {} points, {} numbers", outline.points().len(), options.numbers);
    let size = (8 * outline.points().len()).min(16_384);
    let numbers = options.numbers;
    for (name, make) in [
        ("polyline splitting", &(|| split_polyline(&outline, numbers)) as &dyn Fn() -> Vec<DVec2>),
        ("polyline, least squares", &|| least_squares_polyline(&outline, numbers)),
        ("Bézier segments", &|| bezier(&outline, numbers, size)),
        ("Fourier", &|| fourier(&outline, numbers, size)),
    ] {
        if !options.only {
            let start = processor_seconds();
            let fit = make();
            report(&outline, name, &fit, processor_seconds() - start);
        }
    }
    for turn in 0..options.turns {
        let mut turned = outline.points().to_vec();
        turned.rotate_left(turn * outline.points().len() / options.turns.max(1));
        let Ok(turned) = Outline::new(&turned) else { continue };
        fit(&turned, &clean, options);
    }
}

fn fit(outline: &Outline, clean: &Outline, options: &Options) {
    let diagonal = outline.diagonal();
    let line = |curve: &ClosedCurve| curve.polyline(1e-4 * diagonal, 12);
    let start = processor_seconds();
    let Ok(mut fitter) = Fitter::new(outline, options.numbers) else { return };
    let mut slowest: f64 = 0.0;
    let mut stage = Stage::Straight;
    while !fitter.is_done() {
        let before = processor_seconds();
        let progress = fitter.step();
        slowest = slowest.max(processor_seconds() - before);
        if progress.stage != stage {
            let curve = &fitter.best().curve;
            let (knots, copies) = (curve.knots.len(), curve.copies());
            let name = format!("{:?}: {knots} + {copies}", progress.stage);
            if options.turns == 1 {
                report(outline, &name, &line(curve), processor_seconds() - start);
            }
            stage = progress.stage;
        }
    }
    let took = processor_seconds() - start;
    let curve = &fitter.best().curve;
    let name = format!("fractal, {} + {}", curve.knots.len(), curve.copies());
    report(outline, &name, &line(curve), took);
    if options.noise > 0.0 {
        report(clean, "  without the noise", &line(curve), took);
    }
    if let Ok(text) = curve.to_text() {
        println!("  a document keeps it in {} bytes", text.len() * 3 / 4);
    }
    for precision in [1e-4, 1.5e-4, 3e-4] {
        let Ok(bytes) = curve.to_bytes(precision * diagonal) else { continue };
        let Ok(back) = ClosedCurve::from_bytes(&bytes) else { continue };
        report(outline, &format!("  {} bytes", bytes.len()), &line(&back), took);
    }
    if options.turns == 1 {
        println!("  slowest step {slowest:.3} s");
    }
}
