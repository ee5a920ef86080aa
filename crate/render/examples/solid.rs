//! Draws attractors of space into files of RGBA pixels: `cargo run --release -p frond-render --example solid --
//! FOLDER`.

use std::time::Instant;

use frond_core::{Affine3, Ifs3};
use frond_render::solid::{Camera, Lamp, Lighting, Traversal, light};
use frond_render::{Colouring, Look};
use glam::{DQuat, DVec3};

fn scaled(corners: &[DVec3], scale: f64) -> Vec<Affine3> {
    corners.iter().map(|&c| Affine3::similitude(scale, DQuat::IDENTITY, c * (1.0 - scale))).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| ".".to_owned());
    let side = 700;
    let tetra = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)];
    let tetra: Vec<DVec3> = tetra.map(|(x, y, z)| DVec3::new(x, y, z)).to_vec();
    let sponge: Vec<DVec3> = (0..27)
        .map(|k| DVec3::new(f64::from(k % 3) - 1.0, f64::from(k / 3 % 3) - 1.0, f64::from(k / 9) - 1.0))
        .filter(|p| p.to_array().iter().filter(|x| **x == 0.0).count() < 2)
        .collect();
    let octahedron: Vec<DVec3> = DVec3::AXES.iter().flat_map(|&a| [a * 1.4, a * -1.4]).collect();
    for (name, maps) in [
        ("tetrahedron", scaled(&tetra, 0.5)),
        ("sponge", scaled(&sponge, 1.0 / 3.0)),
        ("octahedron", scaled(&octahedron, 0.5)),
    ] {
        let ifs = Ifs3::new(maps)?;
        let camera = Camera::around(DVec3::ZERO, 5.0, 0.6, 0.45, 0.75)?;
        let start = Instant::now();
        let mut traversal = Traversal::new(std::slice::from_ref(&ifs), &camera, side, side);
        let mut visited = 0;
        while !traversal.run(10_000) {
            visited += 10_000;
        }
        let carved = start.elapsed();
        let look = Look::new(Colouring::Map, &[], ifs.len());
        let lamp = Lamp::new(&Lighting::default(), &camera, [side, side], 1, traversal.range());
        let pixels = light(traversal.depth_buffer(), &lamp, &look);
        println!(
            "{name}: {} lit, {visited} pieces, {carved:?}, light {:?}",
            traversal.depth_buffer().lit(),
            start.elapsed() - carved
        );
        std::fs::write(format!("{folder}/{name}-{side}.rgba"), pixels)?;
    }
    Ok(())
}
