//! From an outline to its formula, step by step: `cargo run --release -p frond-fit --example fit_outline`.

use frond_fit::{Fitter, Outline, fidelity, maple_leaf, split_polyline};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // An outline is a closed polyline. This one is grown by program; `read_file` takes it from a drawing.
    let outline = Outline::new(&maple_leaf(1))?;
    let numbers = 120;

    // The fit may be stopped after any step: the best curve so far is always at hand.
    let mut fitter = Fitter::new(&outline, numbers)?;
    let mut steps = 0;
    while !fitter.is_done() {
        fitter.step();
        steps += 1;
    }
    let curve = fitter.finish();

    // The curve is knots, and edges that are straight or copies of arcs. As a polyline it can be drawn and measured.
    let line = curve.polyline(1e-4 * outline.diagonal(), 12);
    println!("{steps} steps, {} corners when drawn", line.len());
    println!("the fit:                 {:?}", fidelity(&outline, &line));

    // The same numbers spent on a plain polyline, two for each corner.
    let plain = split_polyline(&outline, numbers);
    println!("a polyline of that size: {:?}", fidelity(&outline, &plain));
    Ok(())
}
