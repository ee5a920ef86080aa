//! The colours of a picture, each once, with which of them each pixel has.

use super::oklab::Oklab;

/// How wide a box of like colours is: in light, and in hue.
const STEPS: [f32; 3] = [0.02, 0.01, 0.01];

/// Boxes of like colours that come in a picture.
#[derive(Clone, Debug)]
pub struct Palette {
    /// The mean colour of each box.
    pub colours: Vec<Oklab>,
    /// The box of each pixel.
    pub of: Vec<u32>,
}

impl Palette {
    pub fn new(pixels: &[Oklab]) -> Self {
        let key = |colour: &Oklab| -> u32 {
            let [l, a, b]: [u32; 3] =
                std::array::from_fn(|k| ((colour[k] / STEPS[k]).round() as i32 + 64).clamp(0, 127) as u32);
            (l << 14) | (a << 7) | b
        };
        let mut places = vec![u32::MAX; 1 << 21];
        let mut sums: Vec<([f32; 3], f32)> = Vec::new();
        let mut of = Vec::with_capacity(pixels.len());
        for colour in pixels {
            let place = &mut places[key(colour) as usize];
            if *place == u32::MAX {
                *place = sums.len() as u32;
                sums.push(([0.0; 3], 0.0));
            }
            let (sum, count) = &mut sums[*place as usize];
            for (sum, value) in sum.iter_mut().zip(colour) {
                *sum += value;
            }
            *count += 1.0;
            of.push(*place);
        }
        Self { colours: sums.iter().map(|(sum, count)| sum.map(|z| z / count)).collect(), of }
    }

    /// How much weight each colour has, where each pixel has its own.
    pub fn weights(&self, weight: impl Fn(usize) -> f32) -> Vec<f32> {
        let mut weights = vec![0.0; self.colours.len()];
        for (i, &of) in self.of.iter().enumerate() {
            weights[of as usize] += weight(i);
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn like_colours_are_one() {
        let palette =
            Palette::new(&[[0.5, 0.1, 0.0], [0.9, 0.0, 0.0], [0.504, 0.102, 0.0], [9.0, -9.0, 0.0]]);
        assert_eq!(palette.of, [0, 1, 0, 2]);
        assert!((palette.colours[0][0] - 0.502).abs() < 1e-6);
        assert_eq!(palette.weights(|i| i as f32), [2.0, 1.0, 3.0]);
    }
}
