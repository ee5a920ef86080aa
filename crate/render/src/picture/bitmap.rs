//! Which pixels are lit, one bit each.

use crate::picture::window::{PixelBox, Window};

/// A picture of one bit a pixel, that answers quickly whether a whole box is lit.
#[derive(Clone, Debug)]
pub struct Bitmap {
    window: Window,
    stride: usize,
    words: Vec<u64>,
}

impl Bitmap {
    /// Nothing lit.
    #[must_use]
    pub fn new(window: Window) -> Self {
        let mut bitmap = Self { window, stride: 0, words: Vec::new() };
        bitmap.reset(window);
        bitmap
    }

    /// Nothing lit, in the same memory.
    pub fn reset(&mut self, window: Window) {
        self.window = window;
        self.stride = (window.width as usize).div_ceil(64);
        self.words.clear();
        self.words.resize(self.stride * window.height as usize, 0);
    }

    /// Its size.
    #[inline]
    #[must_use]
    pub fn window(&self) -> Window {
        self.window
    }

    /// Number of lit pixels.
    #[must_use]
    pub fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether a pixel of the picture is lit; others are not.
    #[inline]
    #[must_use]
    pub fn get(&self, (x, y): (u32, u32)) -> bool {
        x < self.window.width && y < self.window.height && self.words[self.word(x, y)] >> (x % 64) & 1 == 1
    }

    /// Lights a pixel of the picture; whether it was dark.
    #[inline]
    pub fn set(&mut self, (x, y): (u32, u32)) -> bool {
        if x >= self.window.width || y >= self.window.height {
            return false;
        }
        let word = self.word(x, y);
        let bit = 1 << (x % 64);
        let dark = self.words[word] & bit == 0;
        self.words[word] |= bit;
        dark
    }

    /// Lights those of which this is true, of one element a pixel, row after row; the others become dark.
    pub(crate) fn light_where<T>(&mut self, pixels: &[T], is_lit: impl Fn(&T) -> bool) {
        let width = self.window.width.max(1) as usize;
        for (row, words) in pixels.chunks_exact(width).zip(self.words.chunks_exact_mut(self.stride)) {
            for (pixels, word) in row.chunks(64).zip(words) {
                // A byte a pixel first, which is done of many at a time.
                let mut lit = [0_u8; 64];
                for (lit, pixel) in lit.iter_mut().zip(pixels) {
                    *lit = u8::from(is_lit(pixel));
                }
                let (eights, _) = lit.as_chunks();
                *word = eights.iter().rev().fold(0, |word, eight| word << 8 | gathered(*eight));
            }
        }
    }

    /// Tells of each dark pixel whose eight neighbours are lit.
    pub(crate) fn each_hole(&self, mut tell: impl FnMut((u32, u32))) {
        let word = |y: usize, at: usize| self.words[y * self.stride + at];
        // The neighbours to the left and to the right of each pixel of a word, in its place.
        let left = |y, at| word(y, at) << 1 | if at > 0 { word(y, at - 1) >> 63 } else { 0 };
        let right = |y, at| word(y, at) >> 1 | if at + 1 < self.stride { word(y, at + 1) << 63 } else { 0 };
        let row = |y, at| left(y, at) & word(y, at) & right(y, at);
        for y in 1..(self.window.height as usize).saturating_sub(1) {
            for at in 0..self.stride {
                let beside = left(y, at) & right(y, at);
                let mut holes = !word(y, at) & beside;
                if holes != 0 {
                    holes &= row(y - 1, at) & row(y + 1, at);
                }
                while holes != 0 {
                    tell((at as u32 * 64 + holes.trailing_zeros(), y as u32));
                    holes &= holes - 1;
                }
            }
        }
    }

    /// The place of a pixel in an array of one element a pixel, row after row.
    #[inline]
    #[must_use]
    pub fn index(&self, (x, y): (u32, u32)) -> usize {
        y as usize * self.window.width as usize + x as usize
    }

    #[inline]
    fn word(&self, x: u32, y: u32) -> usize {
        y as usize * self.stride + x as usize / 64
    }

    /// Whether all pixels of a box within the picture are lit.
    #[inline]
    #[must_use]
    pub fn all(&self, pixels: PixelBox) -> bool {
        let (first, last) = (pixels.x.0 as usize / 64, pixels.x.1 as usize / 64);
        let from = u64::MAX << (pixels.x.0 % 64);
        let to = u64::MAX >> (63 - pixels.x.1 % 64);
        let rows = pixels.y.0 as usize..pixels.y.1 as usize + 1;
        if first == last {
            let mask = from & to;
            for y in rows {
                if self.words[y * self.stride + first] & mask != mask {
                    return false;
                }
            }
            return true;
        }
        for y in rows {
            let row = &self.words[y * self.stride..][..self.stride];
            if row[first] & from != from
                || row[last] & to != to
                || row[first + 1..last].iter().any(|word| *word != u64::MAX)
            {
                return false;
            }
        }
        true
    }
}

/// The lowest bits of eight bytes, side by side: the product brings that of the byte i to the bit 56 + i.
#[inline]
fn gathered(eight: [u8; 8]) -> u64 {
    u64::from_le_bytes(eight).wrapping_mul(0x0102_0408_1020_4080) >> 56
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_is_lit_when_each_of_its_pixels_is() {
        for (x0, x1) in [(0, 0), (3, 63), (63, 64), (0, 199), (130, 199), (64, 127)] {
            let pixels = PixelBox { x: (x0, x1), y: (1, 3) };
            let mut bitmap = Bitmap::new(Window { width: 200, height: 5 });
            for y in 1..=3 {
                for x in x0..=x1 {
                    assert!(!bitmap.all(pixels));
                    assert!(bitmap.set((x, y)) && !bitmap.set((x, y)));
                }
            }
            assert!(bitmap.all(pixels));
            assert_eq!(bitmap.count() as u32, 3 * (x1 - x0 + 1));
            assert!(!bitmap.get((x0, 4)) && bitmap.get((x1, 3)));
        }
    }

    #[test]
    fn pixels_of_which_something_is_true_are_lit() {
        let window = Window { width: 150, height: 4 };
        let pixels: Vec<u8> = (0..600).map(|i| (frond_core::hash::pcg(i) % 3) as u8).collect();
        let mut bitmap = Bitmap::new(window);
        bitmap.set((3, 3));
        bitmap.light_where(&pixels, |pixel| *pixel == 2);
        for (i, pixel) in (0..).zip(&pixels) {
            assert_eq!(bitmap.get((i % 150, i / 150)), *pixel == 2, "{i}");
        }
        assert_eq!(bitmap.count(), pixels.iter().filter(|pixel| **pixel == 2).count());
    }

    #[test]
    fn pixels_outside_are_never_lit() {
        let mut bitmap = Bitmap::new(Window { width: 10, height: 10 });
        assert!(!bitmap.set((10, 0)) && !bitmap.set((0, 10)));
        assert!(!bitmap.get((10, 0)) && !bitmap.get((0, 10)));
        assert_eq!(bitmap.count(), 0);
    }
}
