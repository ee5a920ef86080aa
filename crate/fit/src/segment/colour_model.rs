//! Which colours leaf and ground have: a mixture of bells each, as in GrabCut (Rother, Kolmogorov & Blake 2004), with
//! shade as one more way to differ.

use glam::{DMat3, DVec3};

use super::oklab::{Oklab, apart};

/// The most bells of a mixture.
const MOST_BELLS: usize = 5;

/// How many times samples go to the nearest bell and bells to the middle of their samples.
const ROUNDS: usize = 6;

/// What is so near a middle, by the square of its distance, is of one colour with it.
const NEAR: f32 = 4e-4;

/// What no bell is narrower than: the steps of colours, noise, and what compression does.
const LEAST_SPREAD: DVec3 = DVec3::new(0.03, 0.012, 0.012);

/// What is like no sample is so likely: one in fifty, evenly over all colours.
const ANYTHING: f64 = 0.02 / 0.09;

/// A bell over colours.
#[derive(Clone, Debug)]
struct Bell {
    middle: DVec3,
    /// Of what is farther from it by this form than by another it is less likely: of what is darker, and of what is
    /// lighter.
    inverse: [DMat3; 2],
    /// Its share divided by the root of the determinant.
    height: f64,
}

/// A mixture of bells over colours.
#[derive(Clone, Debug, Default)]
pub struct ColourModel(Vec<Bell>);

fn vector([l, a, b]: Oklab) -> DVec3 {
    DVec3::new(f64::from(l), f64::from(a), f64::from(b))
}

fn outer(p: DVec3) -> DMat3 {
    DMat3::from_cols(p * p.x, p * p.y, p * p.z)
}

impl Bell {
    /// The square of how far a colour is from its middle, in spreads.
    fn far(&self, colour: DVec3) -> f64 {
        let off = colour - self.middle;
        let lighter = usize::from(off.dot(self.middle) > 0.0);
        off.dot(self.inverse[lighter] * off)
    }
}

impl ColourModel {
    /// Of colours with their weights. `shade` is how much light differs, by its cube root, towards dark and towards
    /// light: in a shadow or in a corner a bell goes on along the ray to black. Empty where nothing has weight.
    pub fn new(colours: &[Oklab], weights: &[f32], shade: [f64; 2]) -> Self {
        let owners = groups(colours, weights);
        let all: f64 = weights.iter().copied().map(f64::from).sum();
        let count = if all > 0.0 { owners.iter().max().map_or(0, |most| most + 1) } else { 0 };
        let bell = |k: usize| {
            let of = || {
                let each = owners.iter().zip(colours).zip(weights);
                each.filter(|((owner, _), _)| **owner == k).map(|((_, &c), &w)| (vector(c), f64::from(w)))
            };
            let weight: f64 = of().map(|(_, w)| w).sum();
            // What is that seldom is an edge or a speck.
            if weight <= 0.01 * all {
                return None;
            }
            let middle = of().map(|(c, w)| c * w).sum::<DVec3>() / weight;
            let spread = of().fold(DMat3::ZERO, |sum, (c, w)| sum + outer(c - middle) * w) * (1.0 / weight);
            let least = DMat3::from_diagonal(LEAST_SPREAD * LEAST_SPREAD);
            let spreads = shade.map(|shade| spread + least + outer(middle) * (shade * shade));
            let root = |spread: &DMat3| spread.determinant().max(1e-30).sqrt();
            let wide = 0.5 * spreads.iter().map(root).sum::<f64>();
            let height = weight / all / (wide * (2.0 * std::f64::consts::PI).powf(1.5));
            Some(Bell { middle, inverse: spreads.map(|spread| spread.inverse()), height })
        };
        Self((0..count).filter_map(bell).collect())
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How likely a colour is.
    pub fn density(&self, colour: Oklab) -> f64 {
        let colour = vector(colour);
        let each = self.0.iter().map(|bell| bell.height * (-0.5 * bell.far(colour)).exp());
        each.sum::<f64>() + ANYTHING
    }

    /// How far a colour is from the nearest bell, in spreads.
    pub fn distance(&self, colour: Oklab) -> f64 {
        let colour = vector(colour);
        let each = self.0.iter().map(|bell| bell.far(colour));
        each.fold(f64::INFINITY, f64::min).max(0.0).sqrt()
    }
}

/// Which of a few groups of like colours each colour is of: k means, whose middles begin at the most frequent colour
/// and then each time at the one that is farthest for its weight.
pub fn groups(colours: &[Oklab], weights: &[f32]) -> Vec<usize> {
    let mut middles: Vec<Oklab> = Vec::new();
    let nearest = |middles: &[Oklab], colour: Oklab| {
        let each = middles.iter().enumerate().map(|(k, &middle)| (k, apart(colour, middle)));
        each.min_by(|a, b| a.1.total_cmp(&b.1))
    };
    while middles.len() < MOST_BELLS {
        let score = |i: usize| {
            let far = nearest(&middles, colours[i]).map_or(1.0, |(_, far)| (far - NEAR).max(0.0));
            far * weights[i]
        };
        let best = (0..colours.len()).map(|i| (i, score(i))).max_by(|a, b| a.1.total_cmp(&b.1));
        match best {
            Some((i, score)) if score > 0.0 => middles.push(colours[i]),
            _ => break,
        }
    }
    let mut groups = vec![0; colours.len()];
    for _ in 0..ROUNDS {
        let mut sums = vec![([0.0_f32; 3], 0.0_f32); middles.len()];
        for ((group, &colour), &weight) in groups.iter_mut().zip(colours).zip(weights) {
            let Some((k, _)) = nearest(&middles, colour) else { continue };
            *group = k;
            let (sum, all) = &mut sums[k];
            *all += weight;
            for (sum, value) in sum.iter_mut().zip(colour) {
                *sum += weight * value;
            }
        }
        for (middle, (sum, all)) in middles.iter_mut().zip(sums) {
            if all > 0.0 {
                *middle = sum.map(|z| z / all);
            }
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    const DESK: Oklab = [0.85, 0.01, 0.03];
    const LEAF: Oklab = [0.5, -0.08, 0.09];

    #[test]
    fn a_shadow_is_of_the_ground_and_a_leaf_is_not() {
        let desk = ColourModel::new(&[DESK], &[1.0], [0.12; 2]);
        let shadow = DESK.map(|z| 0.8 * z);
        assert!(desk.distance(shadow) < 2.0, "{}", desk.distance(shadow));
        assert!(desk.distance(LEAF) > 4.0, "{}", desk.distance(LEAF));
        // A shadow is not lighter.
        let darker = ColourModel::new(&[DESK], &[1.0], [0.12, 0.0]);
        assert_eq!(darker.distance(shadow), desk.distance(shadow));
        assert!(darker.distance(DESK.map(|z| 1.15 * z)) > 1.5 * desk.distance(DESK.map(|z| 1.15 * z)));
        // Without shade it is another colour.
        assert!(ColourModel::new(&[DESK], &[1.0], [0.0; 2]).distance(shadow) > 4.0);
    }

    #[test]
    fn each_colour_of_a_mixture_is_likely() {
        let both = ColourModel::new(&[DESK, LEAF, [0.2, 0.2, 0.2]], &[3.0, 1.0, 0.0], [0.0; 2]);
        for colour in [DESK, LEAF] {
            assert!(both.distance(colour) < 0.1 && both.density(colour) > 100.0);
        }
        assert!(both.density([0.2, 0.2, 0.2]) < 1.0);
        assert!(ColourModel::new(&[DESK], &[0.0], [0.1; 2]).is_empty());
        assert!(ColourModel::new(&[], &[], [0.1; 2]).is_empty());
    }
}
