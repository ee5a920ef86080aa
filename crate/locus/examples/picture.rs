//! The picture of the documentation, a locus and a path that stays in it: `cargo run --release -p frond-locus --example
//! picture > crate/locus/picture.svg`.

use frond_core::{Affine2, Morph, MorphOptions};
use frond_locus::{Bounds, LocusGrid, PathOptions, State, find_path};
use glam::DVec2;

/// Samples across, and what one is drawn as.
const SAMPLES: usize = 150;
const CELL: f64 = 4.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let a = Affine2::from_row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]);
    let b = Affine2::from_row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]);
    let dragon = [a, b * a, b * b];
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
    let gasket = corners.map(|corner| Affine2::similitude(0.5, 0.0, corner * 0.5));
    let morph = Morph::new(&dragon, &gasket, &MorphOptions::default())?;

    let grid = LocusGrid::new(Bounds::default(), SAMPLES, SAMPLES)?;
    let locus = grid.locus(&morph, 1e-3);
    let plan = find_path(&morph, &PathOptions { epsilon: 1e-3, ..PathOptions::default() })?;

    let side = SAMPLES as f64 * CELL;
    println!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60%\" viewBox=\"0 0 {side} {side}\" role=\"img\">"
    );
    println!("<title>Parameters over which a morph is in one piece, and a path through them</title>");
    // Runs of samples that hold together, row by row; v points up.
    let mut runs = String::new();
    for y in 0..SAMPLES {
        let holds = |x: usize| matches!(locus.sample(x, y).state, State::Connected | State::Touching);
        let mut x = 0;
        while x < SAMPLES {
            let length = (x..SAMPLES).take_while(|&x| holds(x)).count();
            if length > 0 {
                let across = length as f64 * CELL;
                runs += &format!(
                    "M{} {}h{across}v{CELL}h-{across}z",
                    x as f64 * CELL,
                    (SAMPLES - 1 - y) as f64 * CELL
                );
            }
            x += length.max(1);
        }
    }
    println!("<path fill=\"#2b7fb8\" fill-opacity=\"0.65\" d=\"{runs}\"/>");
    let at = |u: f64, v: f64| format!("{:.1} {:.1}", (u + 1.0) / 3.0 * side, (2.0 - v) / 3.0 * side);
    let line: Vec<String> = plan.points.iter().map(|point| at(point.x, point.y)).collect();
    println!("<path fill=\"none\" stroke=\"#c47800\" stroke-width=\"5\" d=\"M{}\"/>", line.join("L"));
    for point in [plan.points.first(), plan.points.last()].into_iter().flatten() {
        let place = at(point.x, point.y);
        println!("<path stroke=\"#c47800\" stroke-width=\"18\" stroke-linecap=\"round\" d=\"M{place}h0\"/>");
    }
    println!("</svg>");
    Ok(())
}
