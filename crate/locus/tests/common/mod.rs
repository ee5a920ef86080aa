//! The morph of Burch & Hart's Fig 7, reconstructed, which tests and benches of several crates take.

use frond_core::{Affine2, Morph, MorphOptions};
use glam::DVec2;

/// Heighway's dragon as three maps {w1, w2 w1, w2 w2}, on its way to the Sierpinski gasket.
pub fn dragon_to_gasket() -> Morph {
    let a = Affine2::from_row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]);
    let b = Affine2::from_row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]);
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
    let gasket = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
    Morph::new(&[a, b * a, b * b], &gasket, &MorphOptions::default()).expect("three maps each")
}
