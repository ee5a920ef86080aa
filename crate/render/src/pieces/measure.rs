//! The measure on an attractor, as weighted points.

use std::collections::BinaryHeap;

use frond_core::shared::{Ranked, Total};
use frond_core::{Affine2, hash};
use glam::DVec2;

use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;

/// A piece of the attractor and its part of the measure: the product of the probabilities of its letters.
#[derive(Clone, Copy, Debug)]
pub struct MassPiece {
    /// From unit coordinates to where the piece is.
    pub map: Affine2,
    /// Its first letters.
    pub letters: Letters,
    /// From 0 to 1.
    pub mass: f64,
}

/// A point of the attractor that stands for some of the measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Where it is, within the unit disc.
    pub position: [f32; 2],
    /// The first letters of its address.
    pub letters: Letters,
    /// Its part of the measure.
    pub mass: f32,
}

/// Takes the attractor apart into about `count` pieces of nearly equal mass, each of one letter or more.
/// With a window, `root` is the map to the screen; pieces outside are dropped, and those too large to fit
/// are taken apart first.
#[must_use]
pub(crate) fn pieces_by_mass(
    frame: &Frame,
    root: Affine2,
    window: Option<Window>,
    count: usize,
) -> Vec<MassPiece> {
    // What has to be taken apart first: pieces that do not fit the window, then the heaviest.
    let rank = |piece: MassPiece| {
        let ranked = |rank| Some(Ranked { key: Total(rank), item: piece });
        if piece.letters.count() == 0 {
            return ranked(f64::INFINITY);
        }
        let Some(window) = window else { return ranked(piece.mass) };
        let extent = window.extent(&piece.map)?;
        let over = extent.size > f64::from(window.width.max(window.height));
        ranked(if over { 1.0 + piece.mass } else { piece.mass })
    };
    let mut heap = BinaryHeap::new();
    heap.extend(rank(MassPiece { map: root, letters: Letters::NONE, mass: 1.0 }));
    // Where most parts fall outside of the window the number may not rise for long.
    let mut patience = 4 * count + 4096;
    while let Some(first) = heap.peek() {
        let enough = heap.len() >= count && first.key.0 <= 1.0;
        if enough || patience == 0 || heap.len() > 2 * count {
            break;
        }
        patience -= 1;
        let Some(Ranked { item: piece, .. }) = heap.pop() else { break };
        for (letter, map) in frame.maps.iter().enumerate() {
            let part = MassPiece {
                map: piece.map * *map,
                letters: piece.letters.then(letter),
                mass: piece.mass * frame.probabilities[letter],
            };
            if part.mass > 0.0 {
                heap.extend(rank(part));
            }
        }
    }
    heap.into_iter().map(|ranked| ranked.item).filter(|piece| piece.letters.count() > 0).collect()
}

/// Points of the attractor in unit coordinates, spread after the measure.
///
/// The attractor is cut into pieces of nearly equal mass once; each call puts one random point into each
/// of them. That is less noisy than the chaos game alone and as true.
#[derive(Clone, Debug)]
pub struct Sampler {
    cells: Vec<MassPiece>,
    orbit: DVec2,
    random: u32,
}

impl Sampler {
    /// A sampler of about `count` points a call.
    #[must_use]
    pub fn new(frame: &Frame, count: usize) -> Self {
        let cells = pieces_by_mass(frame, Affine2::IDENTITY, None, count);
        Self { cells, orbit: frame.anchor, random: 0 }
    }

    /// The next points. Their masses sum to 1.
    pub fn fill(&mut self, frame: &Frame, samples: &mut Vec<Sample>) {
        samples.clear();
        for cell in &self.cells {
            self.random = self.random.wrapping_add(1);
            let mut chance = f64::from(hash::unit(hash::counter(41, self.random)));
            let mut letter = 0;
            for (i, p) in frame.probabilities.iter().enumerate() {
                letter = i;
                chance -= p;
                if chance < 0.0 {
                    break;
                }
            }
            self.orbit = frame.maps[letter].apply(self.orbit);
            let point = cell.map.apply(self.orbit);
            samples.push(Sample {
                position: [point.x as f32, point.y as f32],
                letters: cell.letters,
                mass: cell.mass as f32,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{NASTY, PLAIN, ifs};

    #[test]
    fn the_pieces_have_all_of_the_mass_in_nearly_equal_parts() {
        for name in PLAIN.iter().chain(NASTY) {
            let frame = Frame::of(&ifs(name));
            let pieces = pieces_by_mass(&frame, Affine2::IDENTITY, None, 500);
            let total: f64 = pieces.iter().map(|piece| piece.mass).sum();
            assert!((total - 1.0).abs() < 1e-9, "{name}: {total}");
            assert!(pieces.len() >= 500 && pieces.len() < 1000, "{name}: {}", pieces.len());
            let most = pieces.iter().map(|piece| piece.mass).fold(0.0, f64::max);
            assert!(most < 0.02, "{name}: {most}");
        }
    }

    #[test]
    fn a_close_window_gets_small_pieces_that_touch_it() {
        let frame = Frame::of(&ifs("dragon"));
        let window = Window { width: 100, height: 80 };
        let anchor = frame.anchor;
        let root = Affine2::new(glam::DMat2::IDENTITY * 1e7, DVec2::new(50.0, 40.0) - anchor * 1e7);
        let pieces = pieces_by_mass(&frame, root, Some(window), 200);
        assert!(pieces.len() >= 100, "{}", pieces.len());
        for piece in &pieces {
            assert!(window.extent(&piece.map).unwrap().size <= 100.0);
        }
    }

    #[test]
    fn samples_are_spread_after_the_probabilities_and_differ_from_call_to_call() {
        let ifs = ifs("gasket").with_probabilities(&[0.7, 0.2, 0.1]).unwrap();
        let frame = Frame::of(&ifs);
        let mut sampler = Sampler::new(&frame, 1000);
        let (mut one, mut two) = (Vec::new(), Vec::new());
        sampler.fill(&frame, &mut one);
        sampler.fill(&frame, &mut two);
        assert_ne!(one, two);
        let mut share = [0.0; 3];
        for sample in &one {
            share[Letters::of_code(sample.letters.code()).unwrap()[0]] += sample.mass;
        }
        assert!((share[0] - 0.7).abs() < 1e-5 && (share[2] - 0.1).abs() < 1e-5, "{share:?}");
        assert!(one.iter().all(|s| s.position[0].hypot(s.position[1]) <= 1.0 + 1e-6));
    }

    #[test]
    fn nothing_is_drawn_outside_of_the_window() {
        let frame = Frame::of(&ifs("gasket"));
        let away = Affine2::from_row([10.0, 0.0, 0.0, 10.0, -500.0, 0.0]);
        let window = Window { width: 100, height: 80 };
        assert!(pieces_by_mass(&frame, away, Some(window), 100).is_empty());
    }
}
