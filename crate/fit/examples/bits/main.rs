//! How near an outline can be written in so many bytes, in several ways: `cargo run --release -p frond-fit --example
//! bits -- 50 150 500`. Grown outlines, and those (.csv) of the folder named in `FROND_LEAVES`.
//!
//! Every way has its best grid and a code of its own laws; the bytes are what these laws say, to which an arithmetic
//! coder comes within one. Where the outline lies and how large it is, is beside that, the same for all. Of each the
//! root mean square and the Hausdorff distance are told, in percent of the diagonal, and how often it crosses itself.

mod copies;
mod descent;
mod rate;
mod rivals;
mod spline;

use descent::Descent;
use frond_fit::{Outline, crossings, decimated, fidelity, fit_within, island, maple_leaf, oak_leaf};
use glam::DVec2;
use spline::Node;

/// How many points are followed for each byte, and how many at least and at most.
const POINTS_A_BYTE: usize = 6;
const POINTS: (usize, usize) = (400, 1600);

/// A curve is put up with that has so much of its bytes.
const FILLED: f64 = 0.985;

/// A curve of nodes within so many bytes: the nodes, the width of their grid, and the bits.
struct Written {
    nodes: Vec<Node>,
    grid: f64,
    bits: f64,
    line: Vec<DVec2>,
}

/// Some points of an outline, as many as so many bytes can tell of.
fn followed(outline: &Outline, bytes: usize) -> Vec<DVec2> {
    let points = outline.points();
    let most = (POINTS_A_BYTE * bytes).clamp(POINTS.0, POINTS.1);
    points.iter().step_by(points.len().div_ceil(most)).map(|p| *p - points[0]).collect()
}

/// The nearest curve of nodes that is found within so many bytes. Where nodes may leave the curve, it sets out once
/// from corners and once from none.
fn written(outline: &Outline, bytes: usize, bends: bool) -> Option<Written> {
    let from = |on: bool| written_from(outline, bytes, bends, on);
    let off = |written: &Written| fidelity(outline, &written.line).rms;
    match (from(true), if bends { from(false) } else { None }) {
        (Some(a), Some(b)) => Some(if off(&a) <= off(&b) { a } else { b }),
        (a, b) => a.or(b),
    }
}

fn written_from(outline: &Outline, bytes: usize, bends: bool, on: bool) -> Option<Written> {
    let origin = outline.points()[0];
    let thin = Outline::new(&followed(outline, bytes)).ok()?;
    let followed = thin.points();
    let budget = 8.0 * bytes as f64;
    let mut best: Option<(f64, Written)> = None;
    // A node is some 9 bits. A grid too coarse or too fine is mended below.
    let mut grid = outline.diagonal() * 0.7 / bytes as f64;
    let start = decimated(&thin, ((budget / 9.0) as usize).clamp(12, followed.len() / 2));
    let (mut fine, mut coarse) = (0.0, f64::INFINITY);
    let mut nodes: Vec<(DVec2, bool, usize)> =
        start.into_iter().map(|mark| (followed[mark], on, mark)).collect();
    for _ in 0..10 {
        let scaled: Vec<DVec2> = followed.iter().map(|p| *p / grid).collect();
        let on_grid =
            nodes.iter().map(|&(at, on, mark)| Node { at: (at / grid).round(), on, mark }).collect();
        let mut descent = Descent::new(&scaled, on_grid, bends);
        descent.run(1.0);
        let bits = descent.bits();
        nodes = descent.nodes.iter().map(|node| (node.at * grid, node.on, node.mark)).collect();
        if bits <= budget {
            let line: Vec<DVec2> =
                spline::closed(&descent.nodes).iter().map(|p| *p * grid + origin).collect();
            let off = fidelity(outline, &line).rms;
            if best.as_ref().is_none_or(|best| off < best.0) {
                best = Some((off, Written { nodes: descent.nodes, grid, bits, line }));
            }
            coarse = f64::min(coarse, grid);
        } else {
            fine = f64::max(fine, grid);
        }
        if (FILLED..=1.0).contains(&(bits / budget)) {
            break;
        }
        // Bits go with about the root of the width. What was found before may be in the way: the search is no function.
        let guess = grid * (bits / (0.993 * budget)).powf(1.5);
        grid = if fine > 0.0 && coarse.is_finite() && 1.01 * fine < coarse {
            guess.clamp(1.002 * fine, 0.998 * coarse)
        } else {
            guess
        };
    }
    best.map(|best| best.1)
}

fn main() {
    let budgets: Vec<usize> = std::env::args().skip(1).filter_map(|arg| arg.parse().ok()).collect();
    let budgets = if budgets.is_empty() { vec![50, 150, 500] } else { budgets };
    let names: Vec<String> = std::env::args().skip(1).filter(|arg| arg.parse::<usize>().is_err()).collect();
    let mut outlines =
        vec![("grown maple", maple_leaf(1)), ("grown oak", oak_leaf(1)), ("grown island", island(4))]
            .into_iter()
            .map(|(name, points)| (name.to_owned(), points))
            .collect::<Vec<_>>();
    if let Some(folder) = std::env::var_os("FROND_LEAVES") {
        let entries = std::fs::read_dir(folder).expect("a folder");
        let mut files: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
        files.sort();
        for path in files.iter().filter(|path| path.extension().is_some_and(|e| e == "csv")) {
            let text = std::fs::read_to_string(path).expect("text");
            let pair =
                |(x, y): (&str, &str)| Some(DVec2::new(x.trim().parse().ok()?, y.trim().parse().ok()?));
            let points = text.lines().filter_map(|line| line.split_once(',')).filter_map(pair).collect();
            outlines.push((path.file_stem().and_then(|s| s.to_str()).unwrap_or_default().to_owned(), points));
        }
    }
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
    }
    if let Some((line, copies)) = rivals::packed(outline, bytes, &error) {
        report("fit, packed", &line, &format!("{copies} copies"));
    }
    if let Some(line) = rivals::fourier(outline, bytes, &error) {
        report("Fourier", &line, "");
    }
    if let Some(line) = rivals::bezier(outline, bytes, &error) {
        report("Bézier", &line, "");
    }
    for (way, bends) in [("polyline", false), ("corners and parabolas", true)] {
        let Some(curve) = written(outline, bytes, bends) else { continue };
        let on = curve.nodes.iter().filter(|node| node.on).count();
        let said = format!(
            "{:.0} bytes, {on} on, {} off, grid 1/{:.0}",
            curve.bits / 8.0,
            curve.nodes.len() - on,
            outline.diagonal() / curve.grid
        );
        report(way, &curve.line, &said);
        let scaled: Vec<DVec2> = followed(outline, bytes).iter().map(|p| *p / curve.grid).collect();
        println!("    {}", copies::worth(&scaled, &curve.nodes));
    }
}
