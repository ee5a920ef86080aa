//! What the pieces of an attractor are drawn on.

use frond_core::Affine2;
use glam::DVec2;

use crate::picture::bitmap::Bitmap;
use crate::pieces::letters::Letters;

/// A pixel that has just been lit.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Column and row.
    pub pixel: (u32, u32),
    /// A point of the attractor in that pixel, in pixels.
    pub point: DVec2,
    /// The first letters of its piece.
    pub letters: Letters,
}

/// A piece of the attractor: its map to the screen, and its first letters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub map: Affine2,
    pub letters: Letters,
}

/// What pieces are drawn on.
#[derive(Debug)]
pub(crate) struct Canvas {
    /// Pixels that are lit.
    pub lit: Bitmap,
    /// How many are.
    pub count: u64,
}

impl Canvas {
    /// Lights the pixel of a point, if it is in the window and dark.
    #[inline]
    pub fn light(&mut self, point: DVec2, letters: Letters, light: &mut impl FnMut(Hit)) {
        let Some(pixel) = self.lit.window().pixel(point) else { return };
        if self.lit.set(pixel) {
            self.count += 1;
            light(Hit { pixel, point, letters });
        }
    }
}
