//! What fits come to, at 260 numbers, on grown leaves and on the outlines (.csv) of the folder named in `FROND_LEAVES`:
//! `FROND_LEAVES=.. cargo bench -p frond-fit --bench fit [name]`.

use frond_fit::{
    ClosedCurve, Fitter, Outline, fidelity, fourier, least_squares_polyline, maple_leaf, oak_leaf,
    split_polyline,
};
use glam::DVec2;

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    for (name, leaf) in [("grown maple", maple_leaf(1)), ("grown oak", oak_leaf(1))] {
        if wanted.is_empty() || wanted.iter().any(|w| name.contains(w)) {
            println!("{name}: {} points", leaf.len());
            measure(&Outline::new(&leaf).expect("an outline"), 260);
        }
    }
    let Some(folder) = std::env::var_os("FROND_LEAVES") else {
        println!("FROND_LEAVES names no folder of further outlines");
        return;
    };
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    for path in files {
        let name = path.file_stem().and_then(|s| s.to_str()).unwrap_or_default().to_owned();
        let is_csv = path.extension().is_some_and(|e| e == "csv");
        if !is_csv || !(wanted.is_empty() || wanted.iter().any(|w| name.contains(w))) {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("text");
        let points: Vec<_> = text
            .lines()
            .filter_map(|line| line.split_once(','))
            .filter_map(|(x, y)| Some(DVec2::new(x.trim().parse().ok()?, y.trim().parse().ok()?)))
            .collect();
        let Ok(outline) = Outline::new(&points) else { continue };
        println!("{name}: {} points", outline.points().len());
        measure(&outline, 260);
    }
}

/// Seconds of processor time of this process, where the system tells them; they do not depend on what else runs.
fn seconds() -> f64 {
    let told = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = told.split_whitespace().next().and_then(|n| n.parse::<f64>().ok());
    nanoseconds.map_or(f64::NAN, |n| n * 1e-9)
}

fn report(outline: &Outline, name: &str, fit: &[DVec2], seconds: f64) {
    let f = fidelity(outline, fit);
    println!(
        "  {name:<22} rms {:.4}%  hausdorff {:.3}%  dD {:+.4}  length {:.3}  {seconds:.2} s",
        f.rms,
        f.hausdorff,
        f.slope_difference(),
        f.length_ratio
    );
}

fn measure(outline: &Outline, numbers: usize) {
    let size = 8 * outline.points().len();
    for (name, make) in [
        ("polyline splitting", &(|| split_polyline(outline, numbers)) as &dyn Fn() -> Vec<DVec2>),
        ("polyline, least squares", &|| least_squares_polyline(outline, numbers)),
        ("Fourier", &|| fourier(outline, numbers, size.min(16_384))),
    ] {
        let start = seconds();
        let fit = make();
        report(outline, name, &fit, seconds() - start);
    }
    let start = seconds();
    let Ok(mut fitter) = Fitter::new(outline, numbers) else { return };
    println!("  first fit after {:.3} s", seconds() - start);
    let mut last = None;
    let mut steps = 0;
    let mut slowest: f64 = 0.0;
    while !fitter.is_done() {
        let before = seconds();
        let progress = fitter.step();
        slowest = slowest.max(seconds() - before);
        steps += 1;
        if last != Some(progress.stage) || steps % 10 == 0 {
            println!(
                "    {:?} {:.2} rms {:.4}% {:.2} s {} knots {} copies",
                progress.stage,
                progress.share,
                progress.rms,
                (seconds() - start),
                fitter.best().curve.knots.len(),
                fitter.best().curve.copies()
            );
            last = Some(progress.stage);
        }
    }
    let seconds = seconds() - start;
    let curve = &fitter.best().curve;
    println!(
        "  {} knots, {} copies, {} numbers, slowest step {slowest:.3} s",
        curve.knots.len(),
        curve.copies(),
        curve.numbers()
    );
    let diagonal = outline.diagonal();
    report(outline, "fractal", &curve.polyline(1e-4 * diagonal, 12), seconds);
    for precision in [1e-4, 3e-4, 1e-3] {
        let Ok(bytes) = curve.to_bytes(precision * diagonal) else { continue };
        let Ok(back) = ClosedCurve::from_bytes(&bytes) else { continue };
        let name = format!("{} bytes", bytes.len());
        report(outline, &name, &back.polyline(1e-4 * diagonal, 12), seconds);
    }
}
