//! Points as the graphics card gets them: the CPU twin of `shader/points.wgsl`.

use bytemuck::{Pod, Zeroable};
use frond_core::Affine2;

use crate::letters::{CODES, KEPT, Letters};
use crate::window::Window;

/// A point of a cloud: one for each vertex.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// Where it is, within the unit disc.
    pub position: [f32; 2],
    /// The first letters of its address, packed.
    pub letters: u32,
    /// Its part of the measure; of no use where there is no density.
    pub mass: f32,
}

/// A piece of the attractor, which places a cloud on the screen: one for each instance.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Instance {
    /// The linear part, row by row: pixels a unit.
    pub linear: [f32; 4],
    /// The translation, in pixels from the upper left corner.
    pub translation: [f32; 2],
    /// The first letters of its word, packed, and from bit 18 on their count.
    pub letters: u32,
    /// Its part of the measure, scaled.
    pub mass: f32,
}

/// Where the count of letters begins in [`Instance::letters`].
const COUNT: u32 = 18;

impl Vertex {
    /// A point of a cloud.
    #[must_use]
    pub fn new(position: [f32; 2], letters: Letters, mass: f32) -> Self {
        Self { position, letters: letters.packed(), mass }
    }
}

impl Instance {
    /// A piece, rounded to `f32` on the screen.
    #[must_use]
    pub fn new(map: &Affine2, letters: Letters, mass: f32) -> Self {
        let [a, b, c, d, e, f] = map.to_row().map(|x| x as f32);
        let count = u32::from(letters.count()) << COUNT;
        Self { linear: [a, b, c, d], translation: [e, f], letters: letters.packed() | count, mass }
    }

    /// The pixel that a point of a cloud falls on under this piece, if it is in the window.
    #[must_use]
    pub fn place(&self, vertex: &Vertex, window: Window) -> Option<(u32, u32)> {
        let [x, y] = vertex.position;
        let [a, b, c, d] = self.linear;
        let pixel =
            [a * x + b * y + self.translation[0], c * x + d * y + self.translation[1]].map(f32::floor);
        let inside = pixel[0] >= 0.0
            && pixel[1] >= 0.0
            && pixel[0] < window.width as f32
            && pixel[1] < window.height as f32;
        inside.then_some((pixel[0] as u32, pixel[1] as u32))
    }

    /// The code of such a point: the letters of the piece, then those of the point.
    #[must_use]
    pub fn code(&self, vertex: &Vertex) -> u32 {
        let count = self.letters >> COUNT;
        let packed = self.letters & ((1 << COUNT) - 1);
        (packed | (vertex.letters >> (6 * count))) + 1
    }

    /// The depth of a code: larger is nearer.
    #[must_use]
    pub fn depth(code: u32) -> f32 {
        code as f32 / CODES as f32
    }
}

const _: () = assert!(KEPT as u32 * 6 == COUNT, "three letters of six bits lie below the count");

#[cfg(test)]
mod tests {
    use super::*;

    fn word(letters: &[usize]) -> Letters {
        letters.iter().fold(Letters::NONE, |word, &letter| word.then(letter))
    }

    #[test]
    fn codes_are_those_of_joined_words() {
        let whole = [9, 63, 20, 4];
        for cut in 0..4 {
            let instance = Instance::new(&Affine2::IDENTITY, word(&whole[..cut]), 1.0);
            let vertex = Vertex::new([0.0, 0.0], word(&whole[cut..]), 1.0);
            assert_eq!(instance.code(&vertex), word(&whole).code(), "cut after {cut}");
        }
    }

    #[test]
    fn points_fall_on_the_pixels_that_hold_them() {
        let window = Window { width: 10, height: 8 };
        let instance = Instance::new(&Affine2::from_row([4.0, 1.0, 0.5, -2.0, 5.0, 4.0]), Letters::NONE, 1.0);
        let at = |x, y| instance.place(&Vertex::new([x, y], Letters::NONE, 1.0), window);
        assert_eq!(at(0.0, 0.0), Some((5, 4)));
        assert_eq!(at(1.0, 0.9), Some((9, 2)));
        for outside in [(2.0, 0.0), (-2.0, 0.0), (0.0, 3.0), (0.0, -3.0), (f32::NAN, 0.0)] {
            assert_eq!(at(outside.0, outside.1), None);
        }
    }

    #[test]
    fn depths_tell_all_codes_apart() {
        // In the 24 bits of the coarsest depth buffer.
        let step = 1.0 / f32::from(u16::MAX) / 256.0;
        for code in [0, 1, 2, CODES / 2, CODES - 2] {
            assert!(Instance::depth(code + 1) - Instance::depth(code) > 8.0 * step);
        }
        assert!(Instance::depth(CODES - 1) < 1.0);
    }

    #[test]
    fn the_layouts_are_those_of_the_vertex_buffers() {
        assert_eq!((size_of::<Vertex>(), size_of::<Instance>()), (16, 32));
    }
}
