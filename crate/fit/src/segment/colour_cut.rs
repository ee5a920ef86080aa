//! A leaf told from its ground by colour, where it lies in its own shadow: what no line in one channel can.

use super::binary_image::Bits;
use super::channel::border;
use super::colour_model::{ColourModel, groups};
use super::hint::Hints;
use super::oklab::apart;
use super::otsu::{histogram, split};
use super::palette::Palette;
use super::random_walk::{Known, RandomWalk};
use super::stroke::Stroke;
use super::working_picture::WorkingPicture;

/// How much the cube root of light differs on the ground, towards dark for a shadow and towards light, and on a leaf:
/// what is lighter than the ground may well be a leaf that shines.
const GROUND_SHADE: [f64; 2] = [0.13, 0.03];
const LEAF_SHADE: [f64; 2] = [0.05, 0.05];

/// How far from the ground's colours the line may be drawn, in spreads.
const LINE: (f64, f64) = (2.6, 6.0);

/// The most that colours say: a leaf is e to this times as likely as ground.
const MOST_SAID: f64 = 5.0;

/// What is said of a pixel by a hint beside it: more than colours can.
const HINTED: f64 = 9.0;

/// What is so near a hint is what it says, until colours are known.
const LIKE: f32 = 0.3;

/// The least part that colours beside hints are of those of leaf and ground.
const HINT_SHARE: f32 = 0.05;

/// How often what was found is looked at for the colours of leaf and ground, and found anew.
const ROUNDS: usize = 2;

/// A picture whose colours are known.
#[derive(Clone, Debug)]
pub struct ColourCut {
    pub picture: WorkingPicture,
    palette: Palette,
    walk: RandomWalk,
    /// Of each pixel, 1 where it is taken for leaf at first: its colour is far from those of the ground.
    start: Vec<f32>,
    /// How much of the border each colour is.
    ground: Vec<f32>,
}

impl ColourCut {
    pub fn new(width: usize, height: usize, rgba: &[u8]) -> Self {
        let picture = WorkingPicture::new(width, height, rgba);
        let palette = Palette::new(&picture.colours);
        let walk = RandomWalk::new(&picture);
        let ground = ground_weights(&picture, &palette);
        let start = unlike_ground(&palette, &ground);
        Self { picture, palette, walk, start, ground }
    }

    /// Whether any of it is unlike the ground.
    pub fn finds_any(&self) -> bool {
        300.0 * self.start.iter().sum::<f32>() > self.start.len() as f32
    }

    /// Begins with what was found otherwise, at the size of the picture.
    pub fn start_from(&mut self, found: &Bits) {
        self.start.fill(0.0);
        let part = 1.0 / (self.picture.factor * self.picture.factor) as f32;
        for (i, _) in found.on.iter().enumerate().filter(|(_, on)| **on) {
            let (x, y) = (i % found.width / self.picture.factor, i / found.width / self.picture.factor);
            self.start[y * self.picture.width + x] += part;
        }
    }

    /// How much each pixel of the working size is leaf, 0 to 1. `more` is how much likelier leaf is than it seems, by
    /// its logarithm.
    pub fn inside(&self, hints: &[Stroke], more: f64) -> Vec<f32> {
        let mut hints = Hints::new(&self.picture, hints);
        let first = |i: usize| match hints.near[i] {
            near if near > LIKE => 1.0,
            near if near < -LIKE => 0.0,
            _ => self.start[i],
        };
        let mut inside: Vec<f32> = (0..self.palette.of.len()).map(first).collect();
        for round in 0..=ROUNDS {
            let likely = self.likely(&inside, &hints, round == 0);
            if round == 0 && hints.any() {
                hints.spread(&self.picture, |i| part(likely[self.palette.of[i] as usize]));
            }
            let known = self.known(&likely, &hints, more);
            inside = self.walk.solve(&known);
        }
        inside
    }

    /// Whether there is colour in the picture: without, nothing tells shade from leaf.
    pub fn has_colour(&self) -> bool {
        let counts = self.palette.weights(|_| 1.0);
        let coloured = |[_, a, b]: [f32; 3]| a.hypot(b) > 0.02;
        let each = self.palette.colours.iter().zip(&counts).filter(|(colour, _)| coloured(**colour));
        100.0 * each.map(|(_, count)| count).sum::<f32>() > self.palette.of.len() as f32
    }

    /// How likely each colour is to be leaf, by its logarithm, from what is leaf and ground so far, and hints. Ground
    /// is always what the border is, and at first nothing else but what was said to be.
    fn likely(&self, inside: &[f32], hints: &Hints, first: bool) -> Vec<f64> {
        let colours = &self.palette.colours;
        let said = |sign: f32| self.palette.weights(|i| (sign * hints.near[i] - LIKE).max(0.0));
        let mut ground = self.ground.clone();
        if !first {
            let found = self.palette.weights(|i| (0.5 - inside[i]).max(0.0));
            ground.iter_mut().zip(&found).for_each(|(ground, found)| *ground += found);
        }
        teach(&mut ground, &said(-1.0));
        let ground = ColourModel::new(colours, &ground, GROUND_SHADE);
        let mut leaf = self.palette.weights(|i| (inside[i] - 0.5).max(0.0));
        let mut said = said(1.0);
        // What ground is as like as leaf tells nothing of other places.
        for (said, &colour) in said.iter_mut().zip(colours) {
            *said *= ((ground.distance(colour) - 1.0) / 2.0).clamp(0.0, 1.0) as f32;
        }
        teach(&mut leaf, &said);
        let leaf = ColourModel::new(colours, &leaf, LEAF_SHADE);
        colours
            .iter()
            .map(|&colour| match (leaf.is_empty(), ground.is_empty()) {
                (true, _) => -MOST_SAID,
                (false, true) => MOST_SAID,
                _ => (leaf.density(colour) / ground.density(colour)).ln().clamp(-MOST_SAID, MOST_SAID),
            })
            .collect()
    }

    /// What is known of each pixel by colours and hints.
    fn known(&self, likely: &[f64], hints: &Hints, more: f64) -> Vec<Known> {
        let known = |i: usize| {
            if let Some(leaf) = hints.said[i] {
                return Known::Certain(if leaf { 1.0 } else { 0.0 });
            }
            let says = likely[self.palette.of[i] as usize] + HINTED * f64::from(hints.near[i]) + more;
            Known::Likely(part(says))
        };
        (0..self.palette.of.len()).map(known).collect()
    }
}

/// How likely it is that is so much likelier than not, by its logarithm.
fn part(says: f64) -> f32 {
    (1.0 / (1.0 + (-says).exp())) as f32
}

/// A hint is small, and means what is like it elsewhere as well: together hints have a share of all.
fn teach(found: &mut [f32], said: &[f32]) {
    let (all, hinted): (f32, f32) = (found.iter().sum(), said.iter().sum());
    let much = (HINT_SHARE * all / hinted.max(1e-6)).max(1.0);
    found.iter_mut().zip(said).for_each(|(found, said)| *found += much * said);
}

/// 1 for pixels whose colours are far from those of the ground, else 0.
fn unlike_ground(palette: &Palette, ground: &[f32]) -> Vec<f32> {
    let model = ColourModel::new(&palette.colours, ground, GROUND_SHADE);
    let far: Vec<f64> = palette.colours.iter().map(|&colour| model.distance(colour)).collect();
    let byte = |far: f64| (20.0 * far).clamp(0.0, 255.0) as u8;
    let values: Vec<u8> = palette.of.iter().map(|&of| byte(far[of as usize])).collect();
    let line = split(&histogram(&values)).map_or(LINE.1, |level| level.level / 20.0).clamp(LINE.0, LINE.1);
    palette.of.iter().map(|&of| if far[of as usize] > line { 1.0 } else { 0.0 }).collect()
}

/// How much of the border of the picture each colour is, but for what comes in from its middle: a leaf that is cut by
/// the border, the hand that holds it.
fn ground_weights(picture: &WorkingPicture, palette: &Palette) -> Vec<f32> {
    let (width, height) = (picture.width, picture.height);
    let mut rim = vec![0.0_f32; width * height];
    border(width, height).for_each(|i| rim[i] = 1.0);
    let mut weights = palette.weights(|i| rim[i]);
    let inner = palette.weights(|i| 1.0 - rim[i]);
    let groups = groups(&palette.colours, &weights);
    let count = groups.iter().max().map_or(0, |most| most + 1);
    let share = |of: &[f32], k: usize| {
        let middle = mean(palette, &groups, &weights, k);
        let near = |i: &usize| groups[*i] == k && apart(palette.colours[*i], middle) < 0.004;
        let all: f32 = of.iter().sum();
        (0..of.len()).filter(near).map(|i| of[i]).sum::<f32>() / all.max(1.0)
    };
    let strange: Vec<bool> = (0..count)
        .map(|k| {
            let (rim, inner) = (share(&weights, k), share(&inner, k));
            rim < 0.3 && inner > 1.5 * rim
        })
        .collect();
    if strange.iter().any(|strange| !strange) {
        for (weight, &group) in weights.iter_mut().zip(&groups) {
            if strange[group] {
                *weight = 0.0;
            }
        }
    }
    weights
}

fn mean(palette: &Palette, groups: &[usize], weights: &[f32], k: usize) -> [f32; 3] {
    let each = || (0..groups.len()).filter(|&i| groups[i] == k);
    let all: f32 = each().map(|i| weights[i]).sum();
    std::array::from_fn(|c| each().map(|i| weights[i] * palette.colours[i][c]).sum::<f32>() / all.max(1e-6))
}
