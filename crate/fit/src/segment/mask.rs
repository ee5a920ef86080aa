//! What of a picture is leaf, and what is asked of it.

use super::components::{self, Component};
use super::notice::Notice;
use super::stroke::Stroke;

/// How a mask is to be drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaskOptions {
    /// -1 to 1: less or more of the picture is taken for the leaf than was found by itself, which is 0.
    pub threshold: f64,
    /// Whether the leaf is what the ground was taken for.
    pub invert: bool,
    /// Whether stalks are taken off.
    pub remove_stalks: bool,
    /// What was said of places: this is leaf, this is not. It goes for what is like them, too. One that says “leaf” on
    /// a frame that was left out ([`Notice::Surrounded`]) has the whole picture looked at.
    pub hints: Vec<Stroke>,
    /// Strokes of the brush, the first one first. They hold whatever the threshold is, and nowhere else.
    pub strokes: Vec<Stroke>,
}

/// What of a picture is leaf, and in which pieces.
#[derive(Clone, Debug)]
pub struct Mask {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) labels: Vec<u32>,
    pub(super) components: Vec<Component>,
    /// A pixel of each hole that was filled, and how many it had.
    pub(super) filled: Vec<(usize, usize)>,
    pub(super) notices: Vec<Notice>,
    pub(super) level: f64,
    pub(super) inverted: bool,
    /// How much each pixel is leaf, where it was told by colours.
    pub(super) cover: Option<Vec<u8>>,
    /// Whether a frame was left out.
    pub(super) framed: bool,
}

impl Mask {
    /// Pixels across and down.
    #[must_use]
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// 255 inside and 0 outside, row after row from the top.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        self.labels.iter().map(|&label| if label == components::NONE { 0 } else { 255 }).collect()
    }

    /// Its pieces, the largest first.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// What may be amiss.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// How much like the leaf a pixel must be, in 0 to 255.
    #[must_use]
    pub fn level(&self) -> f64 {
        self.level
    }
}
