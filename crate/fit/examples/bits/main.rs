//! How near an outline can be written in so many bytes, in several ways: `cargo run --release -p frond-fit --example
//! bits -- 50 150 500`. Grown outlines, and those (.csv) of the folder named in `FROND_LEAVES`.
//!
//! Every way has its best grid and a code of its own laws. Of our curves and of polylines bytes are all that is
//! written; of the others they are what these laws say, to which an arithmetic coder comes within one, and where the
//! outline lies and how large it is, is beside that. Of each the root mean square and the Hausdorff distance are told,
//! in percent of the diagonal, and how often it crosses itself.

mod copies;
mod rivals;

use frond_fit::{
    Outline, bezier_within, crossings, fidelity, fit_within, fourier_within, island, maple_leaf, oak_leaf,
    polyline_within,
};
use glam::DVec2;

fn main() {
    let budgets: Vec<usize> = std::env::args().skip(1).filter_map(|arg| arg.parse().ok()).collect();
    let budgets = if budgets.is_empty() { vec![50, 150, 500] } else { budgets };
    let names: Vec<String> = std::env::args().skip(1).filter(|arg| arg.parse::<usize>().is_err()).collect();
    let mut outlines =
        vec![("grown maple", maple_leaf(1)), ("grown oak", oak_leaf(1)), ("grown island", island(4))]
            .into_iter()
            .map(|(name, points)| (name.to_owned(), points))
            .collect::<Vec<_>>();
    let plane = |points: Vec<[f64; 2]>| points.into_iter().map(DVec2::from).collect();
    outlines.extend(frond_testing::leaves().into_iter().map(|(name, points)| (name, plane(points))));
    for (name, points) in outlines {
        if !names.is_empty() && !names.iter().any(|wanted| name.contains(wanted)) {
            continue;
        }
        let Ok(outline) = Outline::new(&points) else { continue };
        for &bytes in &budgets {
            measure(&name, &outline, bytes);
        }
    }
}

fn measure(name: &str, outline: &Outline, bytes: usize) {
    println!("{name}, {} points, {bytes} bytes", outline.points().len());
    let error = |line: &[DVec2]| fidelity(outline, line).rms;
    let report = |way: &str, line: &[DVec2], more: &str| {
        let near = fidelity(outline, line);
        let crossed = crossings(line, 99).map_or("too often".to_owned(), |found| found.len().to_string());
        println!(
            "  {way:<22} rms {:.4}  hausdorff {:.3}  dD {:+.3}  crossed {crossed}  {more}",
            near.rms,
            near.hausdorff,
            near.slope_difference()
        );
    };
    let begin = std::time::Instant::now();
    if let Some(fit) = fit_within(outline, bytes) {
        let spline = &fit.spline;
        let (on, off) = (spline.corners(), spline.nodes.len() - spline.corners());
        let seconds = begin.elapsed().as_secs_f64();
        report(
            "within bytes",
            &spline.polyline(16),
            &format!("{} bytes in all, {on} on, {off} off, {seconds:.1} s", fit.bytes.len()),
        );
        println!("    {}", copies::worth(outline, spline));
    }
    if let Some((line, copies)) = rivals::packed(outline, bytes, &error) {
        report("fit, packed", &line, &format!("{copies} copies"));
    }
    if let Some(line) = fourier_within(outline, bytes) {
        report("Fourier", &line, "");
    }
    if let Some(line) = bezier_within(outline, bytes) {
        report("Bézier", &line, "");
    }
    if let Some(line) = polyline_within(outline, bytes) {
        report("polyline", &line, "");
    }
}
