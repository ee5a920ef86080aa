//! Fits the curves of the gallery, says how near they are, and writes them into a folder, if one is named:
//! `cargo run --release -p frond-fit --example bake -- crate/fit/src/preset`.
//!
//! That folder is where [`frond_fit::curve_presets`] finds them. Links name these curves: what is written there changes
//! the pictures of all who have such a link.

use frond_fit::{ClosedCurve, Fitter, Outline, crossings, fidelity, island, sugar_maple, white_oak};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1);
    for (name, points) in
        [("sugar-maple", sugar_maple(1)), ("white-oak", white_oak(1)), ("island", island(4))]
    {
        let outline = Outline::new(&points)?;
        let diagonal = outline.diagonal();
        let curve = Fitter::new(&outline, 260)?.finish();
        let bytes = curve.to_bytes(1.5e-4 * diagonal)?;
        let line = ClosedCurve::from_bytes(&bytes)?.polyline(1e-4 * diagonal, 12);
        let near = fidelity(&outline, &line);
        println!(
            "{name}: {} knots, {} copies, {} bytes, {near:?}, {:?} crossings",
            curve.knots.len(),
            curve.copies(),
            bytes.len(),
            crossings(&line, 100).map(|c| c.len())
        );
        if let Some(folder) = &folder {
            std::fs::write(format!("{folder}/{name}.bin"), bytes)?;
        }
    }
    Ok(())
}
