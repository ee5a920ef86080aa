//! Plans a path from one shape to another on which it stays in one piece: `cargo run -p frond-locus --example
//! plan_path`.
//!
//! The morph is from a dragon of three maps to the Sierpinski gasket (after Burch & Hart 1997, Fig 7). Its parameters
//! are u, for the linear parts, and v, for the translations; the straight path from (0, 0) to (1, 1) is the usual
//! morph.

use std::error::Error;

use frond_core::{Affine2, Morph, MorphOptions};
use frond_locus::{PathOptions, check_path, find_path};
use glam::{DVec2, DVec3};

fn main() -> Result<(), Box<dyn Error>> {
    let a = Affine2::from_row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]);
    let b = Affine2::from_row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]);
    let dragon = [a, b * a, b * b];
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
    let gasket = corners.map(|corner| Affine2::similitude(0.5, 0.0, corner * 0.5));
    let morph = Morph::new(&dragon, &gasket, &MorphOptions::default())?;

    let options = PathOptions { epsilon: 1e-3, ..PathOptions::default() };
    let straight = check_path(&morph, &[DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)], options.epsilon, 1000);
    println!("straight: holds {}, widest gap {:.4} diameters", straight.holds, straight.gap);

    let plan = find_path(&morph, &options)?;
    println!(
        "planned:  holds {}, widest gap {:.4} diameters, length {:.3}",
        plan.holds,
        plan.gap,
        plan.length()
    );
    for point in &plan.points {
        println!("  u {:.4}, v {:.4}", point.x, point.y);
    }
    Ok(())
}
