//! What densities there are in a view: what their tone goes by.
//!
//! Nothing is counted on the screen, over which a shape slides. Each piece is a copy of the whole, so that it tells
//! the masses of its pixels by itself: if it has the mass *p* and is *r* pixels large, the logarithm of the mass of a
//! pixel is `ln p - d ln r + c` in the mean over the measure. Here *d* is the dimension of the measure, `sum p ln p /
//! sum p ln r` over the maps (Young, "Dimension, entropy and Lyapunov exponents", 1982, for maps that keep angles and
//! pieces that do not overlap; for others it is near), with which it does not matter how far pieces are taken apart;
//! *c* is of the shape alone, and counted once on a grid that lies in its frame. The variance grows by the same amount
//! for each map on the way down to a pixel. So tones are steady while one zooms and pans, and go by what is seen.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::picture::tone::Tone;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::measure::{MassPiece, Sampler, pieces_by_mass};

/// How the masses of pixels of a shape vary.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contrast {
    /// How the mass within a radius goes with it.
    dimension: f64,
    /// How much the variance of its logarithm grows while the radius falls by a factor of e.
    growth: f64,
    /// What is left of the mean of the logarithm, and of its variance, when all that is taken off.
    rest: Spread,
}

/// A mean and a variance.
#[derive(Clone, Copy, Debug, Default)]
struct Spread {
    mean: f64,
    variance: f64,
}

/// Cells of the grid each way, and the pieces and samples of each that are counted there.
const CELLS: u32 = 96;
const COUNTED: (usize, usize) = (384, 96);
/// The smallest size of a piece that counts, in pixels.
const LEAST_SIZE: f64 = 1e-4;
/// Nearer to the edges of the window, in its sides, pieces count less and less.
const FADE: f64 = 0.25;
/// Where none counts, all do.
const LEAST_WEIGHT: f64 = 1e-9;

impl Contrast {
    /// What is known of a shape.
    pub fn of(frame: &Frame) -> Self {
        // Means over the maps: of the logarithms of mass and size, of their squares and their product.
        let (mut mass, mut size) = (Spread::default(), Spread::default());
        let mut both = 0.0;
        for (map, part) in frame.maps.iter().zip(&frame.probabilities).filter(|(_, part)| **part > 0.0) {
            let (own, small) = (part.ln(), map.norm().max(LEAST_SIZE).ln());
            mass.add(*part, own);
            size.add(*part, small);
            both += part * own * small;
        }
        let shrinks = size.mean < 0.0;
        let dimension = if shrinks { (mass.mean / size.mean).clamp(0.0, 2.0) } else { 2.0 };
        let drift = mass.mean - dimension * size.mean;
        let square = mass.variance - 2.0 * dimension * both + dimension * dimension * size.variance;
        let growth = if shrinks { (square - drift * drift).max(0.0) / -size.mean } else { 0.0 };
        let mut contrast = Self { dimension, growth, rest: Spread::default() };

        let half = 0.5 * f64::from(CELLS);
        let grid = Affine2::new(DMat2::from_diagonal(DVec2::splat(half)), DVec2::splat(half));
        let pieces = pieces_by_mass(frame, grid, None, COUNTED.0);
        let (counted, told) = (counted(frame, &pieces), contrast.told(&pieces, None));
        contrast.rest =
            Spread { mean: counted.mean - told.mean, variance: (counted.variance - told.variance).max(0.0) };
        contrast
    }

    /// The tone of what is seen of pieces on the screen.
    pub fn tone(&self, pieces: &[MassPiece], window: Window) -> Tone {
        let told = self.told(pieces, Some(window));
        // No pixel has more than all.
        Tone::of(told.mean.clamp(-600.0, 0.0), told.variance.sqrt())
    }

    /// What pieces tell of the logarithm of the mass of a pixel: with a window those in its middle above all.
    fn told(&self, pieces: &[MassPiece], window: Option<Window>) -> Spread {
        let (mut total, mut depth, mut logs) = (0.0, 0.0, Spread::default());
        for piece in pieces {
            let part = piece.mass * window.map_or(1.0, |window| weight(piece, window));
            let size = piece.map.norm().max(LEAST_SIZE).ln();
            total += part;
            depth += part * size.max(0.0);
            logs.add(part, piece.mass.ln() - self.dimension * size);
        }
        let mean = logs.mean / total;
        if !(total > 0.0 && mean.is_finite()) {
            return self.rest;
        }
        let between = (logs.variance / total - mean * mean).max(0.0);
        let within = self.growth * (depth / total);
        Spread { mean: self.rest.mean + mean, variance: self.rest.variance + between + within }
    }
}

impl Spread {
    /// While it is summed: a value, and its square.
    fn add(&mut self, part: f64, value: f64) {
        self.mean += part * value;
        self.variance += part * value * value;
    }
}

/// How much a piece counts: what leaves the window has ceased to count before.
fn weight(piece: &MassPiece, window: Window) -> f64 {
    let within = |at: f64, pixels: u32| {
        let part = at / f64::from(pixels);
        part.min(1.0 - part)
    };
    let at = piece.map.translation;
    let inside = (within(at.x, window.width).min(within(at.y, window.height)) / FADE).clamp(0.0, 1.0);
    LEAST_WEIGHT + inside * inside * (3.0 - 2.0 * inside)
}

/// What is counted in the cells of a grid: the mean of the logarithm of the mass of a cell, and its variance, over the
/// measure, so that an empty sky does not count.
fn counted(frame: &Frame, pieces: &[MassPiece]) -> Spread {
    let window = Window { width: CELLS, height: CELLS };
    // The mass of each cell, and the sum of the squares of the masses of its samples.
    let mut cells = vec![[0.0_f64; 2]; window.area()];
    let mut samples = Vec::new();
    Sampler::new(frame, COUNTED.1).fill(frame, &mut samples);
    for piece in pieces {
        for sample in &samples {
            let point = piece.map.apply(glam::Vec2::from(sample.position).as_dvec2());
            let Some((x, y)) = window.pixel(point) else { continue };
            let mass = piece.mass * f64::from(sample.mass);
            let sums = &mut cells[(y * CELLS + x) as usize];
            *sums = [sums[0] + mass, sums[1] + mass * mass];
        }
    }
    let (mut total, mut chance, mut logs) = (0.0, 0.0, Spread::default());
    for [mass, square] in cells.into_iter().filter(|[mass, _]| *mass > 0.0) {
        total += mass;
        logs.add(mass, mass.ln());
        // Of n samples the logarithm is off by 1 / sqrt n.
        chance += square / mass;
    }
    if total <= 0.0 {
        return Spread::default();
    }
    let mean = logs.mean / total;
    Spread { mean: mean - 0.5 * chance / total, variance: (logs.variance - chance) / total - mean * mean }
}

#[cfg(test)]
mod tests {
    use frond_core::Hull;

    use crate::density::Density;
    use crate::picture::tone::{Tone, glow, respond, tone};
    use crate::picture::view::View;
    use crate::picture::window::Window;
    use crate::pieces::frame::Frame;
    use crate::testing::ifs;

    const WINDOW: Window = Window { width: 320, height: 240 };

    fn tone_of(name: &str, weights: &[f64], look: impl Fn(View) -> View) -> Tone {
        let ifs = ifs(name);
        let ifs = if weights.is_empty() { ifs } else { ifs.with_probabilities(weights).unwrap() };
        let hull = Hull::of(&ifs);
        let view = look(View::fit(&hull, WINDOW.width, WINDOW.height, 0.05));
        Density::new(&Frame::within(&ifs, &hull), view, WINDOW, 384, 64).tone
    }

    /// What is seen of a pixel of such a mass, on a dark ground: how much there is of it, and how light.
    fn seen(tone_of: Tone, mass: f64) -> [f32; 2] {
        let density = (mass / tone_of.middle) as f32;
        let response = respond(density, tone_of.slope);
        [tone(density, response), glow(response)]
    }

    /// Two looks that differ by a step: the view that is shown, step by step.
    type Look = fn(View, f64) -> View;

    #[test]
    fn tones_are_steady_while_one_zooms_and_pans() {
        let zoom: Look = |view, step| View { scale: view.scale * 1.02_f64.powf(step), ..view };
        let pan: Look = |view, step| View { x: view.x + 2.0 * step / view.scale, ..view };
        let shapes: [(&str, &[f64]); 6] = [
            ("gasket", &[]),
            ("gasket", &[0.6, 0.3, 0.1]),
            ("carpet", &[]),
            ("fern", &[0.01, 0.85, 0.07, 0.07]),
            ("dragon", &[]),
            ("spiral", &[0.9, 0.1]),
        ];
        for (name, weights) in shapes {
            for (what, look) in [("zoom", zoom), ("pan", pan)] {
                let tones: Vec<_> =
                    (0..70).map(|i| tone_of(name, weights, |view| look(view, f64::from(i)))).collect();
                let mut worst = 0.0_f32;
                for pair in tones.windows(2) {
                    // Of what has a dimension from 0 to 2 a pixel loses so much while one zooms.
                    let most = if what == "zoom" { 1.02_f64.powi(-2) } else { 1.0 };
                    let shrunk = (pair[1].middle / pair[0].middle).clamp(most, 1.0);
                    for deviations in [-1.0, 0.0, 1.0] {
                        let mass = pair[0].middle * (deviations / f64::from(pair[0].slope)).exp();
                        let [before, after] = [seen(pair[0], mass), seen(pair[1], mass * shrunk)];
                        let jump = (before[0] - after[0]).abs().max((before[1] - after[1]).abs());
                        worst = worst.max(jump);
                    }
                }
                assert!(worst < 0.04, "{name} {weights:?} {what}: {worst}");
            }
        }
    }

    #[test]
    fn there_is_a_tone_wherever_one_looks() {
        for view in [
            View { x: 1e6, y: 0.0, scale: 10.0 },
            View { x: 1e300, y: 0.0, scale: 1e280 },
            View { x: 0.0, y: 0.0, scale: 1e-290 },
            View { x: 0.25, y: 0.433, scale: 1e14 },
        ] {
            let tone = tone_of("gasket", &[], |_| view);
            assert!(tone.middle.is_finite() && tone.middle > 0.0, "{view:?} {tone:?}");
            assert!((0.6..=1.8).contains(&tone.slope), "{view:?} {tone:?}");
        }
    }

    #[test]
    fn weights_that_differ_make_a_gentler_slope() {
        let [even, uneven, most] = [&[][..], &[0.5, 0.3, 0.2], &[0.7, 0.2, 0.1]]
            .map(|weights| tone_of("gasket", weights, |view| view).slope);
        assert!(even > uneven && uneven > most, "{even} {uneven} {most}");
    }
}
