//! A hint spreads from where it was drawn over what looks the same there, and stops at edges.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::oklab::apart;
use super::stroke::Stroke;
use super::working_picture::WorkingPicture;

/// A hint goes so many times as far around it as it is long: who means something large draws a long line. What is leaf
/// and does not look so is a spot on it; what is no leaf is a thing, as large as another leaf.
const LEAF_REACH: f32 = 0.5;
const GROUND_REACH: f32 = 1.2;

/// Colours that change by so much from pixel to pixel are as far as a hint goes.
const EDGE: f32 = 0.08;

/// What is likely to be leaf changes by so much from pixel to pixel without an edge, and beyond that by so much where a
/// hint ends.
const LIKELY_NOISE: f32 = 0.3;
const LIKELY_EDGE: f32 = 0.33;

/// Beyond so many times that nothing is left of a hint.
const MOST: f32 = 4.0;

/// What was said of the pixels of a picture, and how much of it holds around them.
#[derive(Clone, Debug)]
pub struct Hints {
    /// For each pixel what was painted on it, if anything: leaf or not.
    pub said: Vec<Option<bool>>,
    /// 1 for leaf to -1 for ground, less with the distance.
    pub near: Vec<f32>,
    /// How far it reaches, in pixels, from each pixel that something was said of.
    reach: Vec<f32>,
}

impl Hints {
    pub fn new(picture: &WorkingPicture, strokes: &[Stroke]) -> Self {
        let (width, height) = (picture.width, picture.height);
        let mut said = vec![None; width * height];
        let mut reach = vec![0.0; width * height];
        for stroke in strokes {
            let small = stroke.shrunk(picture.factor);
            let times = if stroke.keep { LEAF_REACH } else { GROUND_REACH };
            let far = times * (small.long() + 2.0 * small.radius) as f32;
            small.pixels(width, height, |i| {
                said[i] = Some(stroke.keep);
                reach[i] = far.max(1.0);
            });
        }
        let mut hints = Self { said, near: Vec::new(), reach };
        hints.spread(picture, |_| 0.0);
        hints
    }

    /// Whether anything was said.
    pub fn any(&self) -> bool {
        self.said.iter().any(Option::is_some)
    }

    /// Spreads them anew, and stops where it changes how likely it is to be leaf, 0 to 1, as well.
    pub fn spread(&mut self, picture: &WorkingPicture, likely: impl Fn(usize) -> f32) {
        let noise = usual_step(picture);
        let fading = |leaf: bool| {
            let from = (0..self.said.len())
                .filter(|&i| self.said[i] == Some(leaf))
                .map(|i| (i, self.reach[i]))
                .collect();
            spread(picture, &likely, from, noise)
        };
        let near = fading(true).iter().zip(fading(false)).map(|(leaf, ground)| leaf - ground).collect();
        self.near = near;
    }
}

/// What is between a pixel and the next without an edge: three in four differ by less.
fn usual_step(picture: &WorkingPicture) -> f32 {
    let pairs = picture.colours.chunks_exact(picture.width).flat_map(|row| row.windows(2));
    let mut steps: Vec<f32> = pairs.map(|pair| apart(pair[0], pair[1])).collect();
    if steps.is_empty() {
        return 0.0;
    }
    let place = steps.len() * 3 / 4;
    steps.select_nth_unstable_by(place, f32::total_cmp).1.sqrt()
}

/// A pixel that can be reached, the nearest first.
#[derive(PartialEq)]
struct Reached {
    far: f32,
    at: usize,
    /// How many pixels further it is 1 more.
    reach: f32,
}

impl Eq for Reached {}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.far.total_cmp(&self.far).then(other.at.cmp(&self.at))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// 1 where it begins, and less the longer the way there is, where edges are long ways: geodesic distances (Bai & Sapiro
/// 2007; Criminisi, Sharp & Blake 2008), by Dijkstra.
fn spread(
    picture: &WorkingPicture,
    likely: impl Fn(usize) -> f32,
    from: Vec<(usize, f32)>,
    noise: f32,
) -> Vec<f32> {
    let (width, height) = (picture.width, picture.height);
    let mut far = vec![MOST; width * height];
    let mut open = BinaryHeap::new();
    for (at, reach) in from {
        far[at] = 0.0;
        open.push(Reached { far: 0.0, at, reach });
    }
    while let Some(Reached { far: here, at, reach }) = open.pop() {
        if here > far[at] {
            continue;
        }
        let (x, y) = (at % width, at / width);
        for ny in y.saturating_sub(1)..(y + 2).min(height) {
            for nx in x.saturating_sub(1)..(x + 2).min(width) {
                let next = ny * width + nx;
                let long = if nx == x || ny == y { 1.0 } else { std::f32::consts::SQRT_2 };
                let change = apart(picture.colours[at], picture.colours[next]).sqrt();
                let colours = (change - noise).max(0.0) / EDGE;
                let kinds = ((likely(at) - likely(next)).abs() - LIKELY_NOISE).max(0.0) / LIKELY_EDGE;
                let there = here + long / reach + colours + kinds;
                if there < far[next] {
                    far[next] = there;
                    open.push(Reached { far: there, at: next, reach });
                }
            }
        }
    }
    far.iter().map(|&far| if far < MOST { (-far).exp() } else { 0.0 }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hint_fades_with_the_way_and_stops_at_edges() {
        let colours: Vec<_> = (0..40 * 10).map(|i| [if i % 40 < 25 { 0.4 } else { 0.8 }, 0.0, 0.0]).collect();
        let picture = WorkingPicture { width: 40, height: 10, factor: 1, colours, light: Vec::new() };
        let stroke = |x, keep| Stroke { points: vec![[x, 0.0], [x, 10.0]], radius: 1.0, keep };
        let leaf = Hints::new(&picture, &[stroke(3.0, true)]);
        let at = |hints: &Hints, x: usize| hints.near[5 * 40 + x];
        assert_eq!(leaf.said[5 * 40 + 3], Some(true));
        assert_eq!(leaf.said[5 * 40 + 9], None);
        assert_eq!(at(&leaf, 3), 1.0);
        assert!(at(&leaf, 10) > at(&leaf, 20) && at(&leaf, 24) > 0.02 && at(&leaf, 25) < 0.2 * at(&leaf, 24));
        let both = Hints::new(&picture, &[stroke(3.0, true), stroke(38.0, false)]);
        assert!(at(&both, 16) > 0.05 && at(&both, 30) < -0.2);
        // The same colours are likely to be leaf as far as here.
        let mut ends = Hints::new(&picture, &[stroke(3.0, true)]);
        ends.spread(&picture, |i| if i % 40 < 12 { 0.95 } else { 0.1 });
        assert_eq!(at(&ends, 10), at(&leaf, 10));
        assert!(at(&ends, 13) < 0.3 * at(&leaf, 13));
        assert!(Hints::new(&picture, &[]).near.iter().all(|&near| near == 0.0));
    }
}
