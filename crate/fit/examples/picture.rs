//! The picture of the documentation, a leaf in 120 numbers: `cargo run --release -p frond-fit --example picture >
//! crate/fit/picture.svg`.

use frond_fit::{Fitter, Outline, maple_leaf, split_polyline};
use glam::DVec2;

const NUMBERS: usize = 120;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let outline = Outline::new(&maple_leaf(1))?;
    let mut fitter = Fitter::new(&outline, NUMBERS)?;
    while !fitter.is_done() {
        fitter.step();
    }
    let fitted = fitter.finish().polyline(1e-3 * outline.diagonal(), 12);
    let plain = split_polyline(&outline, NUMBERS);

    println!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100%\" viewBox=\"0 0 3100 1050\" role=\"img\">"
    );
    println!(
        "<title>The outline of a leaf, copies of arcs fitted to it, and a polyline of as many numbers</title>"
    );
    let (min, max) =
        (outline.points().iter()).fold((DVec2::MAX, DVec2::MIN), |(min, max), &p| (min.min(p), max.max(p)));
    let scale = 960.0 / (max - min).max_element();
    let lines = [(outline.points(), "#808080"), (&fitted[..], "#00835f"), (&plain[..], "#c47800")];
    for (k, (line, colour)) in lines.into_iter().enumerate() {
        let middle = DVec2::new(520.0 + 1030.0 * k as f64, 525.0);
        let corner = |p: &DVec2| {
            let at = (*p - 0.5 * (min + max)) * DVec2::new(scale, -scale) + middle;
            format!("{:.0} {:.0}", at.x, at.y)
        };
        let mut corners: Vec<String> = line.iter().map(corner).collect();
        corners.dedup();
        println!(
            "<path fill=\"{colour}\" fill-opacity=\"0.15\" stroke=\"{colour}\" stroke-width=\"4\" d=\"M{}z\"/>",
            corners.join("L")
        );
    }
    println!("</svg>");
    Ok(())
}
