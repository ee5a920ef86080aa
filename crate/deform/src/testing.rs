//! Shapes for the tests beside the code.

use frond_core::Affine3;
use glam::{DQuat, DVec3};

/// The gasket tetrahedron, its pieces of this scale.
pub fn gasket3(scale: f64) -> Vec<Affine3> {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    corners.map(|c| Affine3::similitude(scale, DQuat::IDENTITY, c * (1.0 - scale))).to_vec()
}

/// A cube in so many parts each way, of which some are kept.
pub fn grid3(parts: u8, keep: impl Fn([u8; 3]) -> bool) -> Vec<Affine3> {
    let s = 1.0 / f64::from(parts);
    let cells = (0..parts).flat_map(|z| (0..parts).flat_map(move |y| (0..parts).map(move |x| [x, y, z])));
    let map =
        |cell: [u8; 3]| Affine3::similitude(s, DQuat::IDENTITY, DVec3::from_array(cell.map(f64::from)) * s);
    cells.filter(|&cell| keep(cell)).map(map).collect()
}
