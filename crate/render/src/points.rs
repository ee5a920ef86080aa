//! Points as the graphics card gets them: the CPU twin of `shader/points.wgsl`.

use bytemuck::{Pod, Zeroable};
use frond_core::Affine2;

use crate::picture::window::Window;
use crate::pieces::letters::{CODES, KEPT, Letters};

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
    /// What is added to a point, times how far along the one side and along the other it is: see `Sides`.
    pub twist: [f32; 2],
    /// Its colour, eight bits each, where pieces have colours of their own.
    pub tint: u32,
}

/// From the unit disc to how far along two sides a point is, row by row: for pieces that are bent as a
/// parallelogram is taken to any quadrilateral.
pub type Sides = [f32; 4];

/// Where the count of letters begins in [`Instance::letters`].
const COUNT_BIT: u32 = 18;

impl Vertex {
    /// The middle of a cloud.
    pub const DOT: Self = Self { position: [0.0; 2], letters: 0, mass: 1.0 };

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
        Self {
            linear: [a, b, c, d],
            translation: [e, f],
            letters: letters.with_count(),
            mass,
            twist: [0.0; 2],
            tint: 0,
        }
    }

    /// One point in the middle of a pixel, with a code: to be drawn of the vertex [`Vertex::DOT`].
    #[must_use]
    pub fn dot((x, y): (u32, u32), code: u32) -> Self {
        let packed = code.saturating_sub(1);
        Self {
            linear: [0.0; 4],
            translation: [x as f32 + 0.5, y as f32 + 0.5],
            letters: packed & ((1 << COUNT_BIT) - 1),
            mass: 1.0,
            twist: [0.0; 2],
            tint: packed,
        }
    }

    /// Where a point of a cloud is put by this piece, in pixels.
    #[inline]
    #[must_use]
    pub fn at(&self, vertex: &Vertex, sides: &Sides) -> [f32; 2] {
        let [x, y] = vertex.position;
        let [a, b, c, d] = self.linear;
        let turn = (sides[0] * x + sides[1] * y) * (sides[2] * x + sides[3] * y);
        [
            a * x + b * y + self.translation[0] + self.twist[0] * turn,
            c * x + d * y + self.translation[1] + self.twist[1] * turn,
        ]
    }

    /// The pixel that a point of a cloud falls on under this piece, if it is in the window.
    #[must_use]
    pub fn place(&self, vertex: &Vertex, sides: &Sides, window: Window) -> Option<(u32, u32)> {
        let pixel = self.at(vertex, sides).map(f32::floor);
        let inside = pixel[0] >= 0.0
            && pixel[1] >= 0.0
            && pixel[0] < window.width as f32
            && pixel[1] < window.height as f32;
        inside.then_some((pixel[0] as u32, pixel[1] as u32))
    }

    /// The code of such a point: the letters of the piece, then those of the point.
    #[must_use]
    pub fn code(&self, vertex: &Vertex) -> u32 {
        let count = self.letters >> COUNT_BIT;
        let packed = self.letters & ((1 << COUNT_BIT) - 1);
        (packed | (vertex.letters >> (6 * count))) + 1
    }

    /// The depth of a code: larger is nearer.
    #[must_use]
    pub fn depth(code: u32) -> f32 {
        code as f32 / CODES as f32
    }
}

const _: () = assert!(KEPT as u32 * 6 == COUNT_BIT, "three letters of six bits lie below the count");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::colour::code_of_colour;

    fn word(letters: &[usize]) -> Letters {
        letters.iter().fold(Letters::NONE, |word, &letter| word.then(letter))
    }

    #[test]
    fn dots_lie_in_their_pixel_and_have_their_code_whatever_it_is() {
        let window = Window { width: 8, height: 8 };
        for code in [word(&[9, 63, 20, 4]).code(), word(&[0]).code(), code_of_colour(0x00ff_ee01)] {
            let dot = Instance::dot((3, 7), code);
            assert_eq!(dot.place(&Vertex::DOT, &[1.0; 4], window), Some((3, 7)));
            // Either is what the shader takes, with colours of their own or without.
            assert!(dot.code(&Vertex::DOT) == code || dot.tint + 1 == code);
            assert!(Instance::depth(dot.code(&Vertex::DOT)) <= 1.0);
        }
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
        let at = |x, y| instance.place(&Vertex::new([x, y], Letters::NONE, 1.0), &[0.0; 4], window);
        assert_eq!(at(0.0, 0.0), Some((5, 4)));
        assert_eq!(at(1.0, 0.9), Some((9, 2)));
        for outside in [(2.0, 0.0), (-2.0, 0.0), (0.0, 3.0), (0.0, -3.0), (f32::NAN, 0.0)] {
            assert_eq!(at(outside.0, outside.1), None);
        }
    }

    #[test]
    fn twists_take_a_square_to_a_quadrilateral() {
        let window = Window { width: 100, height: 100 };
        let mut instance =
            Instance::new(&Affine2::from_row([20.0, 0.0, 0.0, 20.0, 50.5, 50.5]), Letters::NONE, 1.0);
        instance.twist = [8.0, -4.0];
        let sides = [1.0, 0.0, 0.0, 1.0];
        let at = |x, y| instance.place(&Vertex::new([x, y], Letters::NONE, 1.0), &sides, window);
        assert_eq!(at(1.0, 0.0), Some((70, 50)), "the sides through the middle stay");
        assert_eq!((at(1.0, 1.0), at(-1.0, -1.0)), (Some((78, 66)), Some((38, 26))));
        assert_eq!((at(-1.0, 1.0), at(1.0, -1.0)), (Some((22, 74)), Some((62, 34))));
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
        assert_eq!((size_of::<Vertex>(), size_of::<Instance>()), (16, 44));
    }
}
