//! Decides whether one attractor is in one piece: `cargo run -p frond-locus --example decide`.
//!
//! The maps are those of the Sierpinski gasket, at full size and a little smaller. The gasket is connected, as its
//! pieces share three points. Smaller pieces are apart.

use frond_core::{Affine2, Ifs, IfsError};
use frond_locus::{Options, Scratch, certificate, connectedness, decide_bounds};
use glam::DVec2;

fn main() -> Result<(), IfsError> {
    for scale in [0.5, 0.49] {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        let maps = corners.map(|corner| Affine2::similitude(scale, 0.0, corner * (1.0 - scale)));
        println!("Three maps that shrink by {scale}:");

        // The quick answer, for one of many parameters. The memory it works in can be used again.
        let bounds = decide_bounds(&maps, 1e-4, 20_000, &mut Scratch::default());
        println!(
            "  state {:?}, gap from {:.6} to {:.6} diameters",
            bounds.sample.state, bounds.lower, bounds.upper
        );

        // The full answer. `Connected` and `Disconnected` are proved; here epsilon is a part of the diameter, too.
        let ifs = Ifs::new(maps.to_vec())?;
        let options = Options { epsilon: 1e-4, ..Options::default() };
        let answer = connectedness(&ifs, &options);
        println!(
            "  verdict {:?}, gap from {:.6} to {:.6}",
            answer.verdict, answer.gap.lower, answer.gap.upper
        );

        // What shows it: a reason to be connected, or a certificate of being disconnected.
        if let Some(reason) = answer.reason {
            println!("  evidence: {}", reason.text());
            println!("  proved for the numbers as given: {}", reason.is_proof());
        }
        if let Some(found) = certificate(&ifs, &options) {
            println!(
                "  evidence: maps on the sides {:?} of a cut; a polygon of {} corners, {} pairs of words are apart",
                found.side,
                found.polygon.len(),
                found.pairs.len()
            );
        }
    }
    Ok(())
}
