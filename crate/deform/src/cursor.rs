//! Where one is in the tree of pieces.

use frond_core::Affine2;

use crate::terms::DEEPEST;

/// A piece of a shape that is bent: the word that names it, and what a [`Bend`](crate::Bend) needs to know of it to
/// place it quickly. It holds nothing on the heap.
#[derive(Clone, Debug, PartialEq)]
pub struct Cursor {
    pub(crate) map: Affine2,
    /// The map of the letters beyond those that are kept.
    pub(crate) deep: Affine2,
    pub(crate) length: u32,
    /// The number of the word of the letters up to the depth of the corners, in the order of a dictionary.
    pub(crate) index: u32,
    pub(crate) letters: [u8; DEEPEST],
}

impl Cursor {
    pub(crate) const WHOLE: Self =
        Self { map: Affine2::IDENTITY, deep: Affine2::IDENTITY, length: 0, index: 0, letters: [0; DEEPEST] };

    /// The map of the piece, unbent.
    #[must_use]
    pub const fn map(&self) -> Affine2 {
        self.map
    }

    /// The number of letters of its word.
    #[must_use]
    pub const fn letters(&self) -> usize {
        self.length as usize
    }

    /// One letter more; letters from `kept` on are only kept as a map.
    #[inline]
    pub(crate) fn child(&self, letter: usize, map: &Affine2, kept: usize) -> Self {
        let mut next = self.clone();
        next.map = self.map * *map;
        match next.letters.get_mut(self.length as usize) {
            Some(slot) if (self.length as usize) < kept => *slot = letter as u8,
            _ => next.deep = self.deep * *map,
        }
        next.length = self.length.saturating_add(1);
        next
    }

    /// The letters that are kept.
    pub(crate) fn kept(&self, kept: usize) -> &[u8] {
        &self.letters[..(self.length as usize).min(kept).min(DEEPEST)]
    }
}
