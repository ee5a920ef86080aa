//! The shuffled terms at a place of a piece, one by one, with nothing on the heap.

use frond_core::{Affine, Dim2};

use crate::shuffle::cursor::Cursor;
use crate::shuffle::spin::{Spin, Turning};
use crate::shuffle::terms::{DEEPEST, Terms, Weights};

/// The maps of a shape and how they turn displacements.
#[derive(Clone, Debug)]
pub(crate) struct Raw<D: Turning = Dim2> {
    pub maps: Vec<Affine<D>>,
    pub factors: Vec<D::Matrix>,
    /// The point that each map leaves where it is.
    pub fixed: Vec<D::Vector>,
    pub turned: bool,
}

impl<D: Turning> Raw<D> {
    pub fn new(maps: &[Affine<D>], spin: Spin) -> Self {
        Self {
            maps: maps.to_vec(),
            factors: maps.iter().map(|map| spin.factor(map)).collect(),
            fixed: maps.iter().map(|map| map.fixed_point().unwrap_or(map.translation)).collect(),
            turned: maps.iter().any(|map| spin.factor(map) != D::IDENTITY),
        }
    }

    /// The factors, or none where nothing turns.
    pub fn turning(&self) -> &[D::Matrix] {
        if self.turned { &self.factors } else { &[] }
    }

    /// The letter whose fixed point is nearest.
    pub fn nearest(&self, point: D::Vector) -> usize {
        let distance = |i: &usize| D::length(self.fixed[*i] - point);
        (0..self.fixed.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    }

    /// Visits the shuffled terms of the points that the piece's map takes `zs` to, those that are not the plain
    /// displacement: which point it is, where the term takes its displacement from, what turns it, and its weight.
    ///
    /// With s_k the point that the letters beyond k come to and R_k the map of the letters kb + 1 to k in reverse, term
    /// k looks at H R_k s_k, H being the first kb letters (Fujimoto et al., eq 17): one step each for all terms.
    ///
    /// A word that is too short goes on with the letter whose fixed point is nearest, over and over.
    #[inline]
    pub fn visit<const N: usize>(
        &self,
        terms: &Terms,
        weights: &Weights,
        cursor: &Cursor<D>,
        kept: usize,
        zs: [D::Vector; N],
        add: impl FnMut(usize, D::Vector, D::Matrix, f64),
    ) {
        // Room is cleared for each piece: less of it where little is needed.
        match terms.depth() {
            0 => (),
            1..12 => self.visit_within::<N, 13>(terms, weights, cursor.kept(kept), cursor, zs, add),
            _ => self.visit_within::<N, { DEEPEST + 1 }>(terms, weights, cursor.kept(kept), cursor, zs, add),
        }
    }

    #[inline]
    fn visit_within<const N: usize, const ROOM: usize>(
        &self,
        terms: &Terms,
        weights: &Weights,
        word: &[u8],
        cursor: &Cursor<D>,
        zs: [D::Vector; N],
        mut add: impl FnMut(usize, D::Vector, D::Matrix, f64),
    ) {
        let last = terms.depth();
        let mut points = zs.map(|z| cursor.deep.apply(z));
        // The letters beyond the last term's are no more than a map; a tint may have kept some of them.
        let (word, beyond) = word.split_at(word.len().min(last));
        for &letter in beyond.iter().rev() {
            points = points.map(|point| self.maps[usize::from(letter)].apply(point));
        }
        // The points of the code behind each letter.
        let mut behind = [[D::ZERO; N]; ROOM];
        behind[word.len()] = points;
        for (k, &letter) in word.iter().enumerate().rev() {
            points = points.map(|point| self.maps[usize::from(letter)].apply(point));
            behind[k] = points;
        }
        let on = if word.len() < last { zs.map(|z| self.nearest(z)) } else { [0; N] };
        for (i, &on) in on.iter().enumerate() {
            if i > 0 && word.len() >= last {
                break;
            }
            // Long words are the same for all points; short ones go on in a way of their own.
            let those = if word.len() >= last { 0..N } else { i..i + 1 };
            let letter = |i: usize| word.get(i).map_or(on, |&letter| usize::from(letter));
            for family in &terms.families {
                let head = (0..family.kb).fold(Affine::IDENTITY, |map, i| map * self.maps[letter(i)]);
                let (mut block, mut factor) = (Affine::IDENTITY, D::IDENTITY);
                for (k, rests) in behind.iter().enumerate().take(family.end).skip(family.kb + 1) {
                    let letter = letter(k - 1);
                    block = self.maps[letter] * block;
                    if self.turned {
                        factor = factor * self.factors[letter];
                    }
                    let weight = if k < family.first { 0.0 } else { weights.list[family.slot(k)] };
                    if weight > 0.0 {
                        let map = if family.kb == 0 { block } else { head * block };
                        for i in those.clone() {
                            let rest = if k <= word.len() { rests[i] } else { self.fixed[on] };
                            add(i, map.apply(rest), factor, weight);
                        }
                    }
                }
            }
        }
    }
}
