//! From three maps to a picture: `cargo run --release -p frond-render --example rasterize > triangle.ppm`.

use std::io::Write;

use frond_core::{Affine2, Colouring, Ifs};
use frond_render::{RasterOptions, rasterize};
use glam::{DMat2, DVec2};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Each map halves the plane towards a corner: the attractor is Sierpinski's triangle.
    let corners = [DVec2::new(0.0, 0.0), DVec2::new(1.0, 0.0), DVec2::new(0.5, 0.75_f64.sqrt())];
    let half = DMat2::from_diagonal(DVec2::splat(0.5));
    let ifs = Ifs::new(corners.map(|corner| Affine2::new(half, corner * 0.5)).to_vec())?;

    // Without a view all of it is shown. Colouring::Map gives each third a colour of its own.
    let (width, height) = (512, 448);
    let options = RasterOptions { width, height, colouring: Colouring::Map, ..RasterOptions::default() };
    let pixels = rasterize(&ifs, &options)?;

    // RGBA with straight alpha, row 0 on top; a PPM has no alpha, so that it is laid on white.
    let mut file = format!("P6 {width} {height} 255\n").into_bytes();
    for &[r, g, b, alpha] in pixels.as_chunks::<4>().0 {
        let on_white = |c: u8| 255 - ((255 - u32::from(c)) * u32::from(alpha) / 255) as u8;
        file.extend([on_white(r), on_white(g), on_white(b)]);
    }
    std::io::stdout().write_all(&file)?;
    Ok(())
}
