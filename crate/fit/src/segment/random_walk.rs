//! Where a random walk over the pixels of a picture ends that does not like to cross edges: in leaf or in ground.

use super::oklab::apart;
use super::working_picture::WorkingPicture;

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// How likely it is to be leaf by its colour, 0 to 1.
    Likely(f32),
    /// 0 or 1: it was said.
    Certain(f32),
}

impl Known {
    fn prior(&self) -> f32 {
        match *self {
            Self::Likely(p) | Self::Certain(p) => p,
        }
    }
}

/// How likely a walk is to end where it is, by the colour there, beside a step over no edge.
const STAY: f32 = 0.05;

/// A step over the sharpest edge is this likely beside one over none.
const LEAST_STEP: f32 = 1e-3;

/// What is likely is compared between squares of so many pixels to each side of their middles.
const SIDE: isize = 3;

/// An edge is where what is likely changes by this from square to square.
const CHANGE: f32 = 0.14;

/// A step over such an edge is at least this likely beside one over none.
const LEAST_CHANGED: f32 = 0.02;

/// The most rounds of conjugate gradients, and how much is left of the error at the end.
const MOST_ROUNDS: usize = 150;
const REST: f64 = 1e-3;

/// Neighbours to whom a pixel keeps the weights: columns and rows to the right and down.
const AHEAD: [(usize, isize); 4] = [(1, 0), (1, 1), (0, 1), (1, -1)];

/// The weights of steps between neighbours by sides and corners: 1 where colours are the same, next to nothing over
/// an edge.
#[derive(Clone, Debug)]
pub struct RandomWalk {
    width: usize,
    height: usize,
    /// For each of [`AHEAD`], by pixels.
    weights: [Vec<f32>; 4],
}

impl RandomWalk {
    pub fn new(picture: &WorkingPicture) -> Self {
        let (width, height) = (picture.width, picture.height);
        let mut steps: [Vec<f32>; 4] = std::array::from_fn(|_| vec![f32::NAN; width * height]);
        let (mut sum, mut count) = (0.0_f64, 0_usize);
        for (steps, &(right, down)) in steps.iter_mut().zip(&AHEAD) {
            for (i, step) in steps.iter_mut().enumerate() {
                if let Some(j) = neighbour(i, right, down, width, height) {
                    *step = apart(picture.colours[i], picture.colours[j]);
                    sum += f64::from(*step);
                    count += 1;
                }
            }
        }
        // Boykov & Jolly's and Grady's weights, with the mean of the picture for the noise in it.
        let mean = (sum / count.max(1) as f64).max(1e-6) as f32;
        for (steps, &(right, down)) in steps.iter_mut().zip(&AHEAD) {
            let long = ((right as f32).powi(2) + (down as f32).powi(2)).sqrt();
            for step in steps {
                *step = if step.is_nan() { 0.0 } else { ((-*step / (2.0 * mean)).exp() + LEAST_STEP) / long };
            }
        }
        Self { width, height, weights: steps }
    }

    /// How likely a walk from each pixel is to end in the leaf: the harmonic function of Grady ("Random walks for image
    /// segmentation", 2006) with what colours say as priors ("Multilabel random walker image segmentation using prior
    /// models", 2005). It solves (L + s) x = s p by conjugate gradients.
    pub fn solve(&self, known: &[Known]) -> Vec<f32> {
        let count = self.width * self.height;
        let mut x: Vec<f32> = known.iter().map(Known::prior).collect();
        let free: Vec<bool> = known.iter().map(|known| matches!(known, Known::Likely(_))).collect();
        let weights = self.weighted(known);
        let mut diagonal = vec![STAY; count];
        for (weights, &(right, down)) in weights.iter().zip(&AHEAD) {
            for (i, &weight) in weights.iter().enumerate() {
                if let Some(j) = neighbour(i, right, down, self.width, self.height) {
                    diagonal[i] += weight;
                    diagonal[j] += weight;
                }
            }
        }
        let mut product = vec![0.0; count];
        self.multiply(&weights, &diagonal, &x, &mut product);
        let mut rest: Vec<f32> =
            (0..count).map(|i| if free[i] { STAY * known[i].prior() - product[i] } else { 0.0 }).collect();
        let mut way: Vec<f32> = rest.iter().zip(&diagonal).map(|(r, d)| r / d).collect();
        let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| f64::from(a * b)).sum::<f64>();
        let mut energy = dot(&rest, &way);
        let enough = REST * REST * energy;
        for _ in 0..MOST_ROUNDS {
            if energy <= enough || energy < 1e-12 {
                break;
            }
            self.multiply(&weights, &diagonal, &way, &mut product);
            for (product, &free) in product.iter_mut().zip(&free) {
                if !free {
                    *product = 0.0;
                }
            }
            let far = energy / dot(&way, &product).max(1e-30);
            for i in 0..count {
                x[i] += far as f32 * way[i];
                rest[i] -= far as f32 * product[i];
            }
            let next: f64 = (0..count).map(|i| f64::from(rest[i] * rest[i] / diagonal[i])).sum();
            let turn = (next / energy) as f32;
            energy = next;
            for i in 0..count {
                way[i] = rest[i] / diagonal[i] + turn * way[i];
            }
        }
        x
    }

    /// The weights of steps with what is known: in grass each blade has edges, and only where what is likely changes
    /// from one side to the other does the leaf end (after Bai & Sapiro, "A geodesic framework for fast interactive
    /// image and video segmentation and matting", 2007).
    fn weighted(&self, known: &[Known]) -> [Vec<f32>; 4] {
        let (width, height) = (self.width as isize, self.height as isize);
        let values: Vec<f32> = known.iter().map(Known::prior).collect();
        let mean = squares_mean(&values, self.width, self.height);
        let at = |x: isize, y: isize| mean[(y.clamp(0, height - 1) * width + x.clamp(0, width - 1)) as usize];
        let mut weights = self.weights.clone();
        for (weights, &(right, down)) in weights.iter_mut().zip(&AHEAD) {
            let right = right as isize;
            for (i, weight) in weights.iter_mut().enumerate() {
                let (x, y) = (i as isize % width, i as isize / width);
                let here = at(x - SIDE * right, y - SIDE * down);
                let there = at(x + (SIDE + 1) * right, y + (SIDE + 1) * down);
                *weight *= (-0.5 * ((here - there) / CHANGE).powi(2)).exp() + LEAST_CHANGED;
            }
        }
        weights
    }

    fn multiply(&self, weights: &[Vec<f32>; 4], diagonal: &[f32], x: &[f32], out: &mut [f32]) {
        for ((out, d), x) in out.iter_mut().zip(diagonal).zip(x) {
            *out = d * x;
        }
        let width = self.width;
        let take = |out: &mut [f32], weights: &[f32], x: &[f32]| {
            out.iter_mut().zip(weights).zip(x).for_each(|((out, weight), x)| *out -= weight * x);
        };
        for (weights, &(right, down)) in weights.iter().zip(&AHEAD) {
            // Where there is no neighbour the weight is zero, and any index will do.
            let ahead = (right as isize + down * width as isize) as usize;
            if down < 0 {
                let back = (width - right).min(x.len());
                take(&mut out[back..], &weights[back..], x);
                take(out, &weights[back..], &x[back..]);
            } else {
                let ahead = ahead.min(x.len());
                take(&mut out[ahead..], weights, x);
                take(out, weights, &x[ahead..]);
            }
        }
    }
}

/// The mean of the square around each value.
fn squares_mean(values: &[f32], width: usize, height: usize) -> Vec<f32> {
    let side = SIDE as usize;
    let span = |at: usize, most: usize| at.saturating_sub(side)..(at + side + 1).min(most);
    let mut rows = Vec::with_capacity(values.len());
    for row in values.chunks_exact(width) {
        rows.extend((0..width).map(|x| {
            let around = &row[span(x, width)];
            around.iter().sum::<f32>() / around.len() as f32
        }));
    }
    let mut means = Vec::with_capacity(values.len());
    for y in 0..height {
        let around = span(y, height);
        let count = around.len() as f32;
        means.extend((0..width).map(|x| around.clone().map(|y| rows[y * width + x]).sum::<f32>() / count));
    }
    means
}

fn neighbour(i: usize, right: usize, down: isize, width: usize, height: usize) -> Option<usize> {
    let (x, y) = (i % width + right, (i / width).checked_add_signed(down)?);
    (x < width && y < height).then_some(y * width + x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: usize, light: impl Fn(usize, usize) -> f32) -> WorkingPicture {
        let colours: Vec<_> = (0..width * 20).map(|i| [light(i % width, i / width), 0.0, 0.0]).collect();
        WorkingPicture { width, height: 20, factor: 1, light: colours.clone(), colours }
    }

    #[test]
    fn one_word_fills_its_side_of_an_edge() {
        let halves = picture(40, |x, _| if x < 23 { 0.3 } else { 0.8 });
        let mut known = vec![Known::Likely(0.5); 800];
        known[10 * 40 + 3] = Known::Certain(1.0);
        known[4 * 40 + 36] = Known::Certain(0.0);
        let x = RandomWalk::new(&halves).solve(&known);
        assert!((0..800).all(|i| (x[i] > 0.5) == (i % 40 < 23)));
        assert_eq!((x[403], x[196]), (1.0, 0.0));
    }

    #[test]
    fn it_is_what_it_should_solve() {
        let waves = picture(25, |x, y| 0.5 + 0.2 * ((x * y) as f32 * 0.3).sin());
        let known: Vec<_> = (0..500)
            .map(|i| {
                if i % 97 == 5 { Known::Certain((i % 2) as f32) } else { Known::Likely((i % 7) as f32 / 6.0) }
            })
            .collect();
        let walk = RandomWalk::new(&waves);
        let (x, weights) = (walk.solve(&known), walk.weighted(&known));
        // The value of each free pixel is the mean of its neighbours and of what is known of it.
        for i in 0..500 {
            let Known::Likely(p) = known[i] else { continue };
            let (mut sum, mut all) = (STAY * p, STAY);
            for (weights, &(right, down)) in weights.iter().zip(&AHEAD) {
                for (j, k) in (0..500).filter_map(|j| Some((j, neighbour(j, right, down, 25, 20)?))) {
                    if j == i || k == i {
                        sum += weights[j] * x[if j == i { k } else { j }];
                        all += weights[j];
                    }
                }
            }
            assert!((x[i] - sum / all).abs() < 0.01, "pixel {i}: {} {}", x[i], sum / all);
        }
        assert!(x.iter().all(|x| (-0.01..=1.01).contains(x)));
    }

    #[test]
    fn a_leaf_ends_where_it_is_likely_to_and_not_at_every_blade() {
        // Stripes all over, and leaf at the left by a little.
        let stripes = picture(40, |x, _| if x % 2 == 0 { 0.3 } else { 0.6 });
        let known: Vec<_> = (0..800).map(|i| Known::Likely(if i % 40 < 17 { 0.9 } else { 0.3 })).collect();
        let x = RandomWalk::new(&stripes).solve(&known);
        assert!((0..800).all(|i| (x[i] > 0.5) == (i % 40 < 17)));
    }

    #[test]
    fn a_line_of_pixels_is_a_picture_too() {
        let of = |height: usize| WorkingPicture {
            width: 1,
            height,
            factor: 1,
            colours: vec![[0.5, 0.0, 0.0]; height],
            light: Vec::new(),
        };
        assert_eq!(RandomWalk::new(&of(1)).solve(&[Known::Likely(0.7)]), [0.7]);
        let x = RandomWalk::new(&of(9)).solve(&[Known::Likely(0.25); 9]);
        assert!(x.iter().all(|x| (x - 0.25).abs() < 1e-5));
    }
}
