//! How far points of a piece may be from where its anchors say.

use frond_core::hash;
use frond_deform::{Bend, Cursor};
use glam::DVec2;

use super::placed::Sides;
use crate::pieces::frame::Frame;

/// How far from each other, in units of the plane, a point of a piece may be where the bend takes it and where it
/// would be if the bend took the piece along with its anchors: by the number of letters of the piece's word.
///
/// The deep terms of a bend are small but everywhere; what they come to is looked up at points all over the shape,
/// which needs no knowledge of the formula. It is an estimate, and taken twice.
#[derive(Clone, Debug, Default)]
pub struct AnchorError {
    by_letters: Vec<f64>,
}

/// Words that are looked at, and their longest.
const WORDS_SAMPLED: u32 = 96;
const LONGEST_WORD: usize = 64;

impl AnchorError {
    /// Looks at a bend.
    pub fn of(frame: &Frame, bend: &Bend) -> Self {
        let sides = Sides::of(bend.anchors(), frame.to_world);
        let mut by_letters = Vec::new();
        let maps = frame.maps.len() as u32;
        for word in 0..WORDS_SAMPLED {
            let mut path = vec![(bend.whole(), 0)];
            while let Some((cursor, _)) = path.last() {
                if path.len() > LONGEST_WORD || bend.even(cursor) {
                    break;
                }
                let letter = (hash::counter(word, path.len() as u32) % maps.max(1)) as usize;
                path.push((bend.child(cursor, letter), letter));
            }
            let Some((deep, _)) = path.last() else { continue };
            by_letters.resize(by_letters.len().max(path.len() - 1), 0.0);
            for tip in [frame.anchor, frame.tips.first().copied().unwrap_or(DVec2::ZERO)] {
                let seen = bend.point(deep, frame.to_world.apply(tip));
                Self::climb(frame, bend, &sides, &path, tip, seen, &mut by_letters);
            }
        }
        Self { by_letters }
    }

    /// Notes how far off each piece along a word would have had a point.
    fn climb(
        frame: &Frame,
        bend: &Bend,
        sides: &Sides,
        path: &[(Cursor, usize)],
        tip: DVec2,
        seen: DVec2,
        by_letters: &mut [f64],
    ) {
        let mut point = tip;
        for (letters, pair) in path.windows(2).enumerate().rev() {
            let [(cursor, _), (_, letter)] = pair else { continue };
            point = frame.maps[*letter].apply(point);
            let off = (sides.placed(bend.displaced(cursor)).at(point) - seen).length();
            by_letters[letters] = by_letters[letters].max(if off.is_finite() { off } else { 0.0 });
        }
    }

    /// For a piece of so many letters.
    #[inline]
    pub fn at(&self, letters: usize) -> f64 {
        self.by_letters.get(letters).map_or(0.0, |off| 2.0 * off)
    }
}
