//! The shuffled terms of each piece of a level.

use frond_core::{Dim2, Dimension};
use glam::DVec2;

use crate::shuffle::means::Means;
use crate::shuffle::terms::{Family, Terms};

/// Walks the levels of the tree of words, with what is known of the words behind each family's head: which number the
/// reversed word has, and what turns the displacement.
///
/// All families and levels together cost little more than the words of the finest level (each word is its parent's
/// and one letter more).
pub(crate) struct Words<'a, D: Dimension = Dim2> {
    terms: &'a Terms,
    factors: &'a [D::Matrix],
    tails: Vec<Tails<D>>,
}

struct Tails<D: Dimension> {
    reversed: Vec<u32>,
    /// Empty where nothing turns.
    turns: Vec<D::Matrix>,
}

impl<'a, D: Dimension> Words<'a, D> {
    /// `factors` of all maps, none if nothing turns; `maps` is their number.
    pub fn new(terms: &'a Terms, factors: &'a [D::Matrix]) -> Self {
        let turns = if factors.is_empty() { Vec::new() } else { vec![D::IDENTITY] };
        let tails =
            terms.families.iter().map(|_| Tails { reversed: vec![0], turns: turns.clone() }).collect();
        Self { terms, factors, tails }
    }

    /// Goes on to level k, from 1 on in order, and visits for each family that has a term there each word of k
    /// letters: the family, the number of the word, that of the word that it is sent to, and what turns it.
    pub fn advance(
        &mut self,
        k: usize,
        maps: usize,
        mut visit: impl FnMut(&Family, usize, usize, &D::Matrix),
    ) {
        let same = D::IDENTITY;
        for (family, tails) in self.terms.families.iter().zip(&mut self.tails) {
            if k <= family.kb || k >= family.end {
                continue;
            }
            // The words so far, one letter longer: in reverse it comes first.
            let lead = tails.reversed.len() as u32;
            tails.reversed = tails
                .reversed
                .iter()
                .flat_map(|&reversed| (0..maps as u32).map(move |letter| letter * lead + reversed))
                .collect();
            if !tails.turns.is_empty() {
                let longer = |turn: &D::Matrix| {
                    let turn = *turn;
                    self.factors.iter().map(move |factor| turn * *factor)
                };
                tails.turns = tails.turns.iter().flat_map(longer).collect();
            }
            if k < family.first {
                continue;
            }
            let (heads, count) = (maps.pow(family.kb as u32), tails.reversed.len());
            for head in 0..heads {
                for (tail, &reversed) in tails.reversed.iter().enumerate() {
                    let turn = tails.turns.get(tail).unwrap_or(&same);
                    visit(family, head * count + tail, head * count + reversed as usize, turn);
                }
            }
        }
    }
}

/// What is shuffled, point by point.
pub(crate) trait Source {
    /// The displacement at a point.
    fn at(&self, point: DVec2) -> DVec2;
    /// Its means over pieces.
    fn means(&self, means: &Means) -> Vec<DVec2>;
    /// Whether it has a direction that turns.
    const TURNS: bool;
}

impl Source for crate::Mesh {
    const TURNS: bool = true;

    fn at(&self, point: DVec2) -> DVec2 {
        Self::at(self, point)
    }

    fn means(&self, means: &Means) -> Vec<DVec2> {
        means.of(self)
    }
}

/// 1 everywhere, in x: so the weights of all terms together are found as displacements are.
pub(crate) struct One;

impl Source for One {
    const TURNS: bool = false;

    fn at(&self, _: DVec2) -> DVec2 {
        DVec2::X
    }

    fn means(&self, means: &Means) -> Vec<DVec2> {
        vec![DVec2::X; means.count()]
    }
}
