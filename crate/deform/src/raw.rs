//! The shuffled terms at a place of a piece, one by one, with nothing on the heap.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::cursor::Cursor;
use crate::spin::Spin;
use crate::terms::{DEEPEST, Terms, Weights};

/// The maps of a shape and how they turn displacements.
#[derive(Clone, Debug)]
pub(crate) struct Raw {
    pub maps: Vec<Affine2>,
    pub factors: Vec<DMat2>,
    /// The point that each map leaves where it is.
    pub fixed: Vec<DVec2>,
    pub turned: bool,
}

impl Raw {
    pub fn new(maps: &[Affine2], spin: Spin) -> Self {
        Self {
            maps: maps.to_vec(),
            factors: maps.iter().map(|map| spin.factor(map)).collect(),
            fixed: maps.iter().map(|map| map.fixed_point().unwrap_or(map.translation)).collect(),
            turned: maps.iter().any(|map| spin.factor(map) != DMat2::IDENTITY),
        }
    }

    /// The factors, or none where nothing turns.
    pub fn turning(&self) -> &[DMat2] {
        if self.turned { &self.factors } else { &[] }
    }

    /// The letter whose fixed point is nearest.
    pub fn nearest(&self, point: DVec2) -> usize {
        let distance = |i: &usize| self.fixed[*i].distance_squared(point);
        (0..self.fixed.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    }

    /// Visits the shuffled terms of the point that the piece's map takes `z` to, those that are not the plain
    /// displacement: where each takes its displacement from, what turns it, and its weight.
    ///
    /// With s_k the point that the letters beyond k come to and R_k the map of the letters kb + 1 to k in reverse, term
    /// k looks at H R_k s_k, H being the first kb letters (Fujimoto et al., eq 17): one step each for all terms.
    ///
    /// A word that is too short goes on with the letter whose fixed point is nearest, over and over.
    #[inline]
    pub fn visit(
        &self,
        terms: &Terms,
        weights: &Weights,
        cursor: &Cursor,
        kept: usize,
        z: DVec2,
        mut add: impl FnMut(DVec2, DMat2, f64),
    ) {
        let word = cursor.kept(kept);
        let last = terms.depth();
        if last == 0 {
            return;
        }
        // The points of the code behind each letter.
        let mut behind = [DVec2::ZERO; DEEPEST + 1];
        let mut point = cursor.deep.apply(z);
        behind[word.len()] = point;
        for (k, &letter) in word.iter().enumerate().rev() {
            point = self.maps[usize::from(letter)].apply(point);
            behind[k] = point;
        }
        let on = if word.len() < last { self.nearest(z) } else { 0 };
        let letter = |i: usize| word.get(i).map_or(on, |&letter| usize::from(letter));
        for family in &terms.families {
            let head = (0..family.kb).fold(Affine2::IDENTITY, |map, i| map * self.maps[letter(i)]);
            let (mut block, mut factor) = (Affine2::IDENTITY, DMat2::IDENTITY);
            for (k, &rest) in behind.iter().enumerate().take(family.end).skip(family.kb + 1) {
                let i = letter(k - 1);
                block = self.maps[i] * block;
                if self.turned {
                    factor *= self.factors[i];
                }
                let weight = if k < family.first { 0.0 } else { weights.list[family.slot(k)] };
                if weight > 0.0 {
                    let rest = if k <= word.len() { rest } else { self.fixed[on] };
                    add(head.apply(block.apply(rest)), factor, weight);
                }
            }
        }
    }
}
