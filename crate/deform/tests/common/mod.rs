//! Shapes and bends for tests.
#![allow(dead_code, reason = "each test file takes what it needs")]

use frond_core::Affine2;
use frond_deform::{Bend, Continuity, Cursor, Mesh, Roughness, Settings, Spin};
use glam::{DMat2, DVec2};

pub fn gasket() -> Vec<Affine2> {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.3, 0.8)];
    corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5)).to_vec()
}

/// The gasket, but its first piece is mirrored, so that displacements are, too.
pub fn mirrored() -> Vec<Affine2> {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.75_f64.sqrt())];
    let mut maps = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5)).to_vec();
    let axis = DMat2::from_angle(std::f64::consts::FRAC_PI_6);
    maps[0].linear *= axis * DMat2::from_diagonal(DVec2::new(1.0, -1.0)) * axis.transpose();
    maps
}

/// A square in so many parts each way, of which some may be left out.
pub fn square(parts: u32, keep: fn(u32) -> bool) -> Vec<Affine2> {
    let s = 1.0 / f64::from(parts);
    let corner = |i| DVec2::new(f64::from(i % parts), f64::from(i / parts)) * s;
    (0..parts * parts).filter(|&i| keep(i)).map(|i| Affine2::similitude(s, 0.0, corner(i))).collect()
}

/// Pieces at the corners of a regular polygon that just touch.
pub fn polygon(sides: u32) -> Vec<Affine2> {
    let angle = std::f64::consts::TAU / f64::from(sides);
    let sum: f64 = (1..=sides / 4).map(|k| (angle * f64::from(k)).cos()).sum();
    let r = 1.0 / (2.0 * (1.0 + sum));
    let corner = |i| DVec2::splat(0.5) + 0.5 * DVec2::from_angle(0.3 + angle * f64::from(i));
    (0..sides).map(|i| Affine2::similitude(r, 0.0, corner(i) * (1.0 - r))).collect()
}

pub fn fern() -> Vec<Affine2> {
    [
        [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
        [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
    ]
    .map(Affine2::from_row)
    .to_vec()
}

pub fn twindragon() -> Vec<Affine2> {
    [[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]].map(Affine2::from_row).to_vec()
}

pub fn fern_mesh(list: &[(f64, f64)]) -> Mesh {
    let list = list.iter().map(|&pair| DVec2::from(pair)).collect();
    Mesh::new(DVec2::new(-3.0, 0.0), DVec2::new(3.0, 10.2), 4, 4, list).unwrap()
}

/// A mesh over the unit square.
pub fn unit_mesh(list: &[(f64, f64)]) -> Mesh {
    let list = list.iter().map(|&pair| DVec2::from(pair)).collect();
    Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, list).unwrap()
}

pub fn bumps(size: f64) -> Vec<(f64, f64)> {
    (0..16).map(|i| (size * f64::from(i * 7 % 16 - 8), size * f64::from(i * 5 % 16 - 8))).collect()
}

pub fn settings(kb: f64, ke: f64, delta: f64, spin: Spin, continuity: Continuity) -> Settings {
    Settings { kb, ke, roughness: Roughness::Constant(delta), spin, continuity, superposed: true }
}

pub fn cursor(bend: &Bend, code: &[u8]) -> Cursor {
    code.iter().fold(bend.whole(), |cursor, &letter| bend.child(&cursor, usize::from(letter)))
}
