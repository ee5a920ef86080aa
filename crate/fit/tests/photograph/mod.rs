//! Photographs of leaves, made by program, of which it is known what is leaf: light adds up as it does in a camera, and
//! is written with the curve of sRGB.

pub mod flaws;
pub mod grounds;
pub mod set;

use glam::{DVec2, DVec3};

pub const WIDTH: usize = 420;
pub const HEIGHT: usize = 320;

/// A picture and what of it is leaf.
pub struct Photograph {
    pub name: &'static str,
    pub rgba: Vec<u8>,
    pub truth: Vec<bool>,
}

/// Whatever has a colour at each place. Colours are linear light, red, green and blue from 0 to 1; places are pixels
/// from the lower left corner.
pub type Paint = Box<dyn Fn(DVec2) -> DVec3>;

/// A leaf or whatever else lies there, from below to above.
pub struct Thing {
    pub outline: Vec<DVec2>,
    pub paint: Paint,
    pub leaf: bool,
    /// How far its shadow falls, how soft it is, in pixels, and which part of the light it takes.
    pub shadow: (DVec2, f64, f64),
}

/// All that is seen, and the light on it.
pub struct Scene {
    pub ground: Paint,
    pub things: Vec<Thing>,
    /// How much light falls on each place; 1 is even.
    pub light: Box<dyn Fn(DVec2) -> f64>,
    /// What shines on leaves beside their own colour.
    pub glare: Box<dyn Fn(DVec2) -> f64>,
}

impl Scene {
    /// In linear light, and what is leaf.
    fn seen(&self) -> (Vec<DVec3>, Vec<bool>) {
        let mut colours: Vec<DVec3> = (0..WIDTH * HEIGHT).map(|i| (self.ground)(middle(i))).collect();
        let mut leaf = vec![0.0_f64; WIDTH * HEIGHT];
        for thing in &self.things {
            let cover = covered(&thing.outline);
            let (away, soft, depth) = thing.shadow;
            let moved: Vec<DVec2> = thing.outline.iter().map(|&p| p + away).collect();
            let shadow = flaws::blurred(&covered(&moved), soft);
            for i in 0..colours.len() {
                let at = middle(i);
                // Light of the sky is a little bluer than that of the lamp, and so are shadows.
                colours[i] *= DVec3::ONE - shadow[i] * depth * DVec3::new(1.0, 0.99, 0.96);
                let shine = DVec3::splat((self.glare)(at));
                colours[i] = colours[i].lerp((thing.paint)(at) + shine, cover[i]);
                let is_leaf = if thing.leaf { 1.0 } else { 0.0 };
                leaf[i] += (is_leaf - leaf[i]) * cover[i];
            }
        }
        for (i, colour) in colours.iter_mut().enumerate() {
            *colour *= (self.light)(middle(i));
        }
        (colours, leaf.iter().map(|&part| part > 0.5).collect())
    }

    /// Takes the picture: `flaws` has it before its bytes are written.
    pub fn photograph(&self, name: &'static str, flaws: impl Fn(&mut [DVec3])) -> Photograph {
        let (linear, truth) = self.seen();
        let mut encoded: Vec<DVec3> = linear.iter().map(|&colour| flaws::encoded(colour)).collect();
        flaws(&mut encoded);
        let rgba = encoded.iter().flat_map(|c| {
            let byte = |z: f64| (255.0 * z).round().clamp(0.0, 255.0) as u8;
            [byte(c.x), byte(c.y), byte(c.z), 255]
        });
        Photograph { name, rgba: rgba.collect(), truth }
    }
}

fn middle(i: usize) -> DVec2 {
    DVec2::new((i % WIDTH) as f64 + 0.5, (HEIGHT - 1 - i / WIDTH) as f64 + 0.5)
}

/// How much of each pixel lies inside a polygon: by four rows a pixel, each as fine as can be.
pub fn covered(points: &[DVec2]) -> Vec<f64> {
    const FINE: usize = 4;
    let mut cover = vec![0.0; WIDTH * HEIGHT];
    let mut cuts: Vec<f64> = Vec::new();
    for row in 0..FINE * HEIGHT {
        let y = (row as f64 + 0.5) / FINE as f64;
        cuts.clear();
        for (i, &a) in points.iter().enumerate() {
            let b = points[(i + 1) % points.len()];
            if (a.y > y) != (b.y > y) {
                cuts.push(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
            }
        }
        cuts.sort_by(f64::total_cmp);
        let line = &mut cover[(HEIGHT - 1 - row / FINE) * WIDTH..][..WIDTH];
        for pair in cuts.chunks_exact(2) {
            let first = pair[0].floor().clamp(0.0, WIDTH as f64) as usize;
            let last = pair[1].ceil().clamp(0.0, WIDTH as f64) as usize;
            for (x, cover) in line.iter_mut().enumerate().take(last).skip(first) {
                let part = pair[1].min(x as f64 + 1.0) - pair[0].max(x as f64);
                *cover += part.max(0.0) / FINE as f64;
            }
        }
    }
    cover
}
