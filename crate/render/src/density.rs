//! How dense the measure lies in each pixel.

mod carried;
mod contrast;

pub(crate) use contrast::Contrast;

use crate::coverage::sweep::Sweep;
use crate::picture::colour::Colours;
use crate::picture::tone::Tone;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::measure::{MassPiece, Sample, Sampler, pieces_by_mass};

/// What a density picture is drawn from: pieces of nearly equal mass, each filled with the same samples,
/// in as many passes as one likes.
#[derive(Clone, Debug)]
pub struct Density {
    /// The pieces, on the screen.
    pub pieces: Vec<MassPiece>,
    /// Makes the samples of each pass.
    pub sampler: Sampler,
    /// What the mass of a pixel is multiplied by to have the mean over the lit pixels 1.
    pub gain: f32,
    /// How many pixels are lit, roughly.
    pub lit: usize,
    /// How masses become tones.
    pub tone: Tone,
}

/// The mean is taken over blocks of so many pixels each way: it need not be exact, only steady.
const BLOCK_SIDE: u32 = 8;
/// Visits for counting the lit blocks.
const COUNTING_VISITS: u64 = 150_000;

impl Density {
    /// The density of the attractor in a view, from about `pieces` pieces of `samples` samples each.
    #[must_use]
    pub fn new(frame: &Frame, view: View, window: Window, pieces: usize, samples: usize) -> Self {
        let to_screen = view.onto_screen(frame.to_world, window);
        let pieces = pieces_by_mass(frame, to_screen, Some(window), pieces);
        let seen: f64 = pieces
            .iter()
            .filter(|piece| window.pixel(piece.map.apply(frame.anchor)).is_some())
            .map(|piece| piece.mass)
            .sum();
        let blocks =
            Window { width: window.width.div_ceil(BLOCK_SIDE), height: window.height.div_ceil(BLOCK_SIDE) };
        let coarse = view.onto_target(frame.to_world, window, 1.0 / f64::from(BLOCK_SIDE));
        let mut lit = 0_usize;
        Sweep::new(frame, coarse, blocks, 0.5).run(COUNTING_VISITS, |_| lit += 1);
        let lit = lit.max(1) * (BLOCK_SIDE * BLOCK_SIDE) as usize;
        let gain = if seen > 0.0 { (lit as f64 / seen) as f32 } else { 0.0 };
        let tone = Contrast::of(frame).tone(&pieces, window);
        Self { pieces, sampler: Sampler::new(frame, samples), gain, lit, tone }
    }

    /// What sums over one pass are multiplied by to have 1 for a middle tone.
    #[must_use]
    pub fn tone_gain(&self) -> f32 {
        // In the mean over the measure a pixel has at least what it has in the mean over the pixels. Where pieces
        // overlap without end, what they tell one by one is too little.
        if self.gain > 0.0 { (1.0 / (self.tone.middle * f64::from(self.gain)).max(1.0)) as f32 } else { 0.0 }
    }

    /// Adds one pass on the CPU: for each pixel the sum of weighted colours, and of weights, which mean
    /// 1 over the lit pixels. Returns the number of points.
    pub fn accumulate(
        &mut self,
        frame: &Frame,
        colours: &Colours,
        window: Window,
        samples: &mut Vec<Sample>,
        sums: &mut [[f32; 4]],
    ) -> usize {
        self.sampler.fill(frame, samples);
        for piece in &self.pieces {
            let heavy = piece.mass as f32 * self.gain;
            for sample in samples.iter() {
                let point = piece.map.apply(glam::Vec2::from(sample.position).as_dvec2());
                let Some((x, y)) = window.pixel(point) else { continue };
                let weight = sample.mass * heavy;
                let [r, g, b] = colours.colour(piece.letters.join(sample.letters).code());
                let sum = &mut sums[y as usize * window.width as usize + x as usize];
                *sum = [sum[0] + weight * r, sum[1] + weight * g, sum[2] + weight * b, sum[3] + weight];
            }
        }
        self.pieces.len() * samples.len()
    }
}

#[cfg(test)]
mod tests {
    use frond_core::{Colouring, Hull};

    use super::*;
    use crate::testing::ifs;

    const WINDOW: Window = Window { width: 96, height: 64 };

    fn sums(name: &str, view: Option<View>) -> Vec<[f32; 4]> {
        let ifs = ifs(name);
        let hull = Hull::of(&ifs);
        let frame = Frame::within(&ifs, &hull);
        let view = view.unwrap_or_else(|| View::fit(&hull, WINDOW.width, WINDOW.height, 0.05));
        let colours = Colours::new(Colouring::Density, &[], ifs.len());
        let mut density = Density::new(&frame, view, WINDOW, 200, 500);
        let mut sums = vec![[0.0; 4]; WINDOW.area()];
        density.accumulate(&frame, &colours, WINDOW, &mut Vec::new(), &mut sums);
        sums
    }

    #[test]
    fn the_mean_over_the_lit_pixels_is_near_one() {
        for name in ["square", "fern", "dragon", "overlap"] {
            let sums = sums(name, None);
            let lit: Vec<f32> = sums.iter().map(|sum| sum[3]).filter(|w| *w > 0.0).collect();
            let mean = lit.iter().sum::<f32>() / lit.len() as f32;
            assert!((0.7..3.0).contains(&mean), "{name}: {mean}");
        }
    }

    #[test]
    fn an_even_measure_gives_an_even_picture() {
        let sums = sums("square", None);
        // Well inside of the square.
        let middle: Vec<f32> =
            (20..40).flat_map(|y| (40..60).map(move |x| (x, y))).map(|(x, y)| sums[y * 96 + x][3]).collect();
        let mean = middle.iter().sum::<f32>() / middle.len() as f32;
        let spread = middle.iter().map(|w| (w - mean).powi(2)).sum::<f32>() / middle.len() as f32;
        // 100,000 points in some 3,000 pixels: chance alone would give a deviation of 0.17.
        assert!(spread.sqrt() / mean < 0.2, "{} {mean}", spread.sqrt());
    }

    #[test]
    fn a_view_of_nothing_is_dark() {
        let sums = sums("gasket", Some(View { x: 1e6, y: 0.0, scale: 10.0 }));
        assert!(sums.iter().all(|sum| *sum == [0.0; 4]));
    }
}
