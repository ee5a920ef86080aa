//! Where one is in the tree of pieces.

use frond_core::{Affine, Dim2, Dimension};

use crate::shuffle::terms::DEEPEST;

/// A piece of a shape that is bent: the word that names it, and what a [`Bend`](crate::Bend) or a
/// [`Bend3`](crate::Bend3) needs to know of it to place it quickly. It holds nothing on the heap.
#[derive(Clone, Debug, PartialEq)]
pub struct Cursor<D: Dimension = Dim2> {
    pub(crate) map: Affine<D>,
    /// The map of the letters beyond those that are kept.
    pub(crate) deep: Affine<D>,
    pub(crate) length: u32,
    /// The number of the word of the letters up to the depth of the corners, in the order of a dictionary.
    pub(crate) index: u32,
    pub(crate) letters: [u8; DEEPEST],
}

impl<D: Dimension> Cursor<D> {
    pub(crate) const WHOLE: Self =
        Self { map: Affine::IDENTITY, deep: Affine::IDENTITY, length: 0, index: 0, letters: [0; DEEPEST] };

    /// The map of the piece, unbent.
    #[must_use]
    pub const fn map(&self) -> Affine<D> {
        self.map
    }

    /// The number of letters of its word.
    #[must_use]
    pub const fn letters(&self) -> usize {
        self.length as usize
    }

    /// One letter more; letters from `kept` on are only kept as a map, and those from `counted` on do not count for
    /// the number of the word.
    #[inline]
    pub(crate) fn child(&self, letter: usize, maps: &[Affine<D>], kept: usize, counted: usize) -> Self {
        let map = &maps[letter];
        let mut next = self.clone();
        next.map = self.map * *map;
        if self.letters() < counted {
            next.index = self.index * maps.len() as u32 + letter as u32;
        }
        match next.letters.get_mut(self.length as usize) {
            Some(slot) if (self.length as usize) < kept => *slot = letter as u8,
            _ => next.deep = self.deep * *map,
        }
        next.length = self.length.saturating_add(1);
        next
    }

    /// The point of the whole that the letters beyond the first so many take `z` to.
    #[inline]
    pub(crate) fn behind(&self, letters: usize, kept: usize, maps: &[Affine<D>], z: D::Vector) -> D::Vector {
        let rest = self.kept(kept).get(letters..).unwrap_or(&[]);
        rest.iter().rev().fold(self.deep.apply(z), |point, &letter| maps[usize::from(letter)].apply(point))
    }

    /// The letters that are kept.
    pub(crate) fn kept(&self, kept: usize) -> &[u8] {
        &self.letters[..(self.length as usize).min(kept).min(DEEPEST)]
    }
}
