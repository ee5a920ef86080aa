//! From twenty maps of space to a picture: `cargo run --release -p frond-render --example solid > sponge.ppm`.

use std::io::Write;

use frond_core::{Affine3, Colouring, Ifs3};
use frond_render::Colours;
use frond_render::solid::{Camera, Lamp, Lighting, Traversal, light};
use glam::{DQuat, DVec3};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Menger's sponge: a cube of 27, without the middle one and those in the middle of a face.
    let maps = (0..27)
        .map(|k| DVec3::new(f64::from(k % 3) - 1.0, f64::from(k / 3 % 3) - 1.0, f64::from(k / 9) - 1.0))
        .filter(|at| at.to_array().iter().filter(|x| **x == 0.0).count() < 2)
        .map(|at| Affine3::similitude(1.0 / 3.0, DQuat::IDENTITY, at * (2.0 / 3.0)))
        .collect();
    let sponge = Ifs3::new(maps)?;

    // Where the eye is: around the origin, at a distance of 5, turned and raised, with a field of view of 0.75.
    let camera = Camera::around(DVec3::ZERO, 5.0, 0.6, 0.45, 0.75)?;

    // The traversal splits pieces until they are as small as pixels and keeps the nearest. It may rest after any step.
    let side = 700;
    let mut traversal = Traversal::new(std::slice::from_ref(&sponge), &camera, side, side);
    while !traversal.run(10_000) {}
    eprintln!("{} of {} pixels are lit", traversal.depth_buffer().lit(), side * side);

    // What it leaves is a depth buffer. Light makes a picture of it, in which each twentieth has a colour of its own.
    let colours = Colours::new(Colouring::Map, &[], sponge.len());
    let lamp = Lamp::new(&Lighting::default(), &camera, [side, side], 1, traversal.range());
    let pixels = light(traversal.depth_buffer(), &lamp, &colours, None);

    // RGBA with straight alpha; a PPM has no alpha, so that it is laid on white.
    let mut file = format!("P6 {side} {side} 255\n").into_bytes();
    for &[r, g, b, alpha] in pixels.as_chunks::<4>().0 {
        let on_white = |c: u8| 255 - ((255 - u32::from(c)) * u32::from(alpha) / 255) as u8;
        file.extend([on_white(r), on_white(g), on_white(b)]);
    }
    std::io::stdout().write_all(&file)?;
    Ok(())
}
