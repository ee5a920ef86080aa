//! What a camera and its files do to a picture.

use frond_core::hash;
use glam::DVec3;

use super::{HEIGHT, WIDTH};

/// Linear light by the curve of sRGB.
pub fn encoded(linear: DVec3) -> DVec3 {
    let curve = |z: f64| {
        let z = z.clamp(0.0, 1.0);
        if z <= 0.003_130_8 { 12.92 * z } else { 1.055 * z.powf(1.0 / 2.4) - 0.055 }
    };
    DVec3::new(curve(linear.x), curve(linear.y), curve(linear.z))
}

/// Three boxes one after the other: near a bell of the given spread in pixels.
pub fn blurred(values: &[f64], spread: f64) -> Vec<f64> {
    let radius = spread.round() as usize;
    let mut all = values.to_vec();
    for _ in 0..3 {
        for y in 0..HEIGHT {
            let row: Vec<f64> = all[y * WIDTH..(y + 1) * WIDTH].to_vec();
            for (x, value) in box_mean(&row, radius).into_iter().enumerate() {
                all[y * WIDTH + x] = value;
            }
        }
        for x in 0..WIDTH {
            let column: Vec<f64> = (0..HEIGHT).map(|y| all[y * WIDTH + x]).collect();
            for (y, value) in box_mean(&column, radius).into_iter().enumerate() {
                all[y * WIDTH + x] = value;
            }
        }
    }
    all
}

fn box_mean(line: &[f64], radius: usize) -> Vec<f64> {
    let at = |i: isize| line[i.clamp(0, line.len() as isize - 1) as usize];
    let radius = radius as isize;
    let mut sum: f64 = (-radius..=radius).map(at).sum();
    (0..line.len() as isize)
        .map(|i| {
            let mean = sum / (2 * radius + 1) as f64;
            sum += at(i + radius + 1) - at(i - radius);
            mean
        })
        .collect()
}

/// A number of a bell of spread 1, of its own for each `i`.
fn bell(seed: u32, i: u32) -> f64 {
    let thrown = |k: u32| f64::from(hash::unit(hash::counter(seed, 4 * i + k))) - 0.5;
    (thrown(0) + thrown(1) + thrown(2) + thrown(3)) * 3.0_f64.sqrt()
}

/// Noise of the sensor, of each colour by itself.
pub fn noise(colours: &mut [DVec3], spread: f64) {
    for (i, colour) in colours.iter_mut().enumerate() {
        let at = |k: u32| spread * bell(71 + k, i as u32);
        *colour += DVec3::new(at(0), at(1), at(2));
    }
}

/// As a JPEG of poor quality has it: blocks of 8 x 8 whose cosines are rounded, the fast ones and colours coarsely.
pub fn blocks(colours: &mut [DVec3], step: f64) {
    // Light and two differences, as in JFIF.
    let mut planes: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(colours.len()));
    for c in colours.iter() {
        let light = 0.299 * c.x + 0.587 * c.y + 0.114 * c.z;
        planes[0].push(light);
        planes[1].push(0.564 * (c.z - light));
        planes[2].push(0.713 * (c.x - light));
    }
    for (k, plane) in planes.iter_mut().enumerate() {
        let coarse = if k == 0 { step } else { 2.0 * step };
        for y in (0..HEIGHT / 8).map(|y| 8 * y) {
            for x in (0..WIDTH / 8).map(|x| 8 * x) {
                round_block(plane, y * WIDTH + x, coarse);
            }
        }
    }
    for (i, c) in colours.iter_mut().enumerate() {
        let (light, blue, red) = (planes[0][i], planes[1][i] / 0.564, planes[2][i] / 0.713);
        let (r, b) = (light + red, light + blue);
        *c = DVec3::new(r, (light - 0.299 * r - 0.114 * b) / 0.587, b);
    }
}

fn cosine(k: usize, x: usize) -> f64 {
    let size = if k == 0 { 1.0 / 8.0_f64.sqrt() } else { 0.5 };
    size * (std::f64::consts::PI * k as f64 * (2 * x + 1) as f64 / 16.0).cos()
}

fn round_block(plane: &mut [f64], start: usize, step: f64) {
    let mut parts = [[0.0; 8]; 8];
    for (v, row) in parts.iter_mut().enumerate() {
        for (u, part) in row.iter_mut().enumerate() {
            let each =
                (0..64).map(|i| plane[start + i / 8 * WIDTH + i % 8] * cosine(u, i % 8) * cosine(v, i / 8));
            let coarse = step * (1.0 + 0.6 * (u + v) as f64);
            *part = (each.sum::<f64>() / coarse).round() * coarse;
        }
    }
    for i in 0..64 {
        let each = (0..64).map(|k| parts[k / 8][k % 8] * cosine(k % 8, i % 8) * cosine(k / 8, i / 8));
        plane[start + i / 8 * WIDTH + i % 8] = each.sum();
    }
}
