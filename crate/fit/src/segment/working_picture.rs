//! A picture at the size at which colours are told apart.

use super::oklab::{Linear, Oklab, oklab};

/// The most pixels of it: a step of the random walk goes over all.
const MOST_PIXELS: usize = 160_000;

/// A picture made smaller by a whole number, each pixel the mean light of a square.
#[derive(Clone, Debug)]
pub struct WorkingPicture {
    pub width: usize,
    pub height: usize,
    /// The side of a square, in pixels of the picture.
    pub factor: usize,
    pub colours: Vec<Oklab>,
    /// The same as linear light.
    pub light: Vec<[f32; 3]>,
}

impl WorkingPicture {
    pub fn new(width: usize, height: usize, rgba: &[u8]) -> Self {
        let mut factor = 1;
        while width.div_ceil(factor) * height.div_ceil(factor) > MOST_PIXELS {
            factor += 1;
        }
        let (across, down) = (width.div_ceil(factor), height.div_ceil(factor));
        let linear = Linear::new();
        let mut light = Vec::with_capacity(across * down);
        let mut sums = vec![[0.0_f32; 4]; across];
        for rows in rgba.chunks(4 * width * factor) {
            sums.fill([0.0; 4]);
            for row in rows.chunks_exact(4 * width) {
                for (x, pixel) in row.chunks_exact(4).enumerate() {
                    let sum = &mut sums[x / factor];
                    for (sum, light) in sum.iter_mut().zip(linear.of(pixel)) {
                        *sum += light;
                    }
                    sum[3] += 1.0;
                }
            }
            light.extend(sums.iter().map(|[r, g, b, count]| [r / count, g / count, b / count]));
        }
        let colours = light.iter().map(|&light| oklab(light)).collect();
        Self { width: across, height: down, factor, colours, light }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_are_the_mean_of_their_light() {
        // Stripes of black and white, half the light of white: 0.7937 is the cube root of 0.5.
        let (width, height) = (1501, 901);
        let rgba: Vec<u8> = (0..width * height)
            .flat_map(|i| if (i % width) % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] })
            .collect();
        let small = WorkingPicture::new(width, height, &rgba);
        assert_eq!((small.width, small.height, small.factor), (501, 301, 3));
        let pair = small.colours[0][0].powi(3) + small.colours[1][0].powi(3);
        assert!((pair - 1.0).abs() < 1e-3, "{pair}");
    }
}
