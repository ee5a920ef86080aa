//! The picture of the documentation, a fern on its way to a tree: `cargo run --release -p frond-core --example picture
//! > crate/core/picture.svg`.

use frond_core::{Affine2, ChaosGame, Hull, Ifs, Morph, MorphOptions};
use glam::{DVec2, IVec2};

const POINTS: usize = 1400;
const STAGES: usize = 5;
const COLOURS: [&str; 4] = ["#8f8500", "#00835f", "#2b7fb8", "#c47800"];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let fern = [
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
        [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
        [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
    ];
    let tree = [
        [0.04, 0.0, 0.0, 0.5, 0.0, 0.0],
        [0.514, -0.3467, 0.3467, 0.514, 0.0, 0.44],
        [0.4443, 0.3728, -0.3728, 0.4443, 0.0, 0.36],
        [0.3565, -0.0501, 0.0501, 0.3565, 0.0, 0.44],
    ];
    let [fern, tree] = [fern, tree].map(|rows| rows.map(Affine2::from_row));
    let morph = Morph::new(&fern, &tree, &MorphOptions::default())?;

    println!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100%\" viewBox=\"0 0 4000 1000\" role=\"img\">"
    );
    println!("<title>A fern, a tree, and three stages of the way between them</title>");
    println!("<g fill=\"none\" stroke-width=\"11\" stroke-linecap=\"round\">");
    for stage in 0..STAGES {
        let t = stage as f64 / (STAGES - 1) as f64;
        let ifs = Ifs::new(morph.at(t, t))?;
        let hull = Hull::of(&ifs);
        let size = hull.max() - hull.min();
        let scale = f64::min(740.0 / size.x, 960.0 / size.y);
        let left = 400.0 + 800.0 * stage as f64 - 0.5 * scale * size.x;
        let (mut points, mut pieces) = (vec![0.0; 2 * POINTS], vec![0; POINTS]);
        ChaosGame::new(&ifs, 7).fill(&mut points, &mut pieces);
        for (piece, colour) in COLOURS.iter().enumerate() {
            let mine = points.chunks(2).zip(&pieces).filter(|(_, of)| usize::from(**of) == piece);
            let mut dots: Vec<IVec2> = mine
                .map(|(at, _)| (DVec2::new(f64::from(at[0]), f64::from(at[1])) - hull.min()) * scale)
                .map(|at| DVec2::new(left + at.x, 980.0 - at.y).round().as_ivec2())
                .collect();
            // Neighbours follow each other, so that steps are written in few letters.
            dots.sort_by_key(|dot| (dot.y / 12, dot.x, dot.y));
            dots.dedup();
            let mut last = IVec2::ZERO;
            let step = |dot: IVec2| {
                let by = dot - std::mem::replace(&mut last, dot);
                format!("m{}{}{}h0", by.x, if by.y < 0 { "" } else { " " }, by.y)
            };
            println!("<path stroke=\"{colour}\" d=\"{}\"/>", dots.into_iter().map(step).collect::<String>());
        }
    }
    println!("</g>\n</svg>");
    Ok(())
}
