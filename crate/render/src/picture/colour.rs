//! What colour a piece has: the CPU twin of `shader/colour.wgsl`.

use bytemuck::{Pod, Zeroable};
use frond_core::Colouring;

use crate::pieces::letters::Letters;

/// The colours of Okabe & Ito (2008), which most people with colour-blindness can tell apart.
pub(crate) const OKABE_ITO: [[u8; 3]; 7] = [
    [0xe6, 0x9f, 0x00],
    [0x56, 0xb4, 0xe9],
    [0x00, 0x9e, 0x73],
    [0xf0, 0xe4, 0x42],
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0xcc, 0x79, 0xa7],
];

/// How far the pieces of a piece are lightened or darkened, at most.
const MOST_SHADING: f32 = 0.5;

/// Everything that turns codes and densities into colours, as the shader reads it: a uniform buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Colours {
    /// One colour a map, sRGB from 0 to 1, repeated to the end.
    pub palette: [[f32; 4]; 64],
    /// Width and height of the picture that is read.
    pub source: [i32; 2],
    /// Pixels of the source for each pixel that is written: 2 for a picture drawn twice as large.
    pub factor: f32,
    /// The number of maps.
    pub maps: f32,
    /// How much the letters after the first lighten and darken: 0 to colour by map.
    pub contrast: f32,
    /// What densities are multiplied by, see [`crate::tone`].
    pub gain: f32,
    /// 1 to multiply colours by alpha, as a canvas wants them, 0 to leave them.
    pub premultiply: f32,
    /// 1 where codes are colours, 0 where they are letters.
    pub tinted: f32,
    /// How steep tones are, see [`crate::tone`].
    pub slope: f32,
    /// What the densest colours go towards: 1 for white, on a dark ground, 0 for black, on a light one.
    pub towards: f32,
    /// Uniform buffers come in sixteens of bytes.
    pub unused: [f32; 2],
}

impl Colours {
    /// The colours of an IFS of `maps` maps; an empty palette stands for that of Okabe and Ito.
    #[must_use]
    pub fn new(colouring: Colouring, palette: &[[u8; 3]], maps: usize) -> Self {
        let palette = if palette.is_empty() { &OKABE_ITO } else { palette };
        let colour = |i: usize| palette[i % palette.len()].map(|c| f32::from(c) / 255.0);
        Self {
            palette: std::array::from_fn(|i| {
                let [r, g, b] = colour(i);
                [r, g, b, 1.0]
            }),
            source: [0, 0],
            factor: 1.0,
            maps: maps.max(1) as f32,
            contrast: if colouring == Colouring::Address { MOST_SHADING } else { 0.0 },
            gain: 0.0,
            premultiply: 0.0,
            tinted: 0.0,
            slope: 1.0,
            towards: 1.0,
            unused: [0.0; 2],
        }
    }

    /// The colour of a lit pixel, from its code: a colour itself, or letters.
    ///
    /// The second letter moves the colour of the first towards white or black in equal steps, the third
    /// does so in finer ones.
    #[must_use]
    pub fn colour(&self, code: u32) -> [f32; 3] {
        if self.tinted > 0.5 {
            let packed = code.wrapping_sub(1);
            return [packed >> 16, packed >> 8, packed].map(|c| (c & 255) as f32 / 255.0);
        }
        let [first, second, third] = Letters::of_code(code).unwrap_or_default();
        let [r, g, b, _] = self.palette[first];
        let place = (second as f32 + (third as f32 + 0.5) / self.maps) / self.maps;
        let shift = (place - 0.5) * 2.0 * self.contrast;
        let towards = if shift > 0.0 { 1.0 } else { 0.0 };
        [r, g, b].map(|c| c + (towards - c) * shift.abs())
    }
}

/// A palette whose mean luminance (with squares in place of sRGB's curve) is less is made for a light ground: that of
/// Okabe and Ito has 0.34, the one of the page for light paper 0.23.
const LIGHT_GROUND_LUMINANCE: f32 = 0.28;

/// Whether a palette is made for a light ground: its colours are dark. An empty one stands for that of Okabe and Ito.
#[must_use]
pub(crate) fn is_for_light_ground(palette: &[[u8; 3]]) -> bool {
    let square = |c: u8| (f32::from(c) / 255.0) * (f32::from(c) / 255.0);
    let luminance = |[r, g, b]: &[u8; 3]| 0.2126 * square(*r) + 0.7152 * square(*g) + 0.0722 * square(*b);
    let total: f32 = palette.iter().map(luminance).sum();
    total < LIGHT_GROUND_LUMINANCE * palette.len() as f32
}

/// A colour, sRGB from 0 to 1, as 24 bits: the red ones first.
#[must_use]
pub(crate) fn pack_colour(colour: [f64; 3]) -> u32 {
    // A cast of NaN gives 0.
    colour.iter().fold(0, |packed, c| packed << 8 | (c.clamp(0.0, 1.0) * 255.0).round() as u32)
}

/// The code of a lit pixel that has such a colour.
#[must_use]
pub(crate) fn code_of_colour(packed: u32) -> u32 {
    packed + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(letters: [usize; 3]) -> u32 {
        letters.iter().fold(Letters::NONE, |word, &letter| word.then(letter)).code()
    }

    #[test]
    fn by_map_only_the_first_letter_counts() {
        let colours = Colours::new(Colouring::Map, &[[255, 0, 0], [0, 0, 255]], 4);
        assert_eq!(colours.colour(code([0, 3, 1])), [1.0, 0.0, 0.0]);
        assert_eq!(colours.colour(code([3, 0, 0])), [0.0, 0.0, 1.0]);
        assert_eq!(colours.colour(code([2, 1, 0])), [1.0, 0.0, 0.0], "the palette repeats");
    }

    #[test]
    fn by_address_later_pieces_are_lighter() {
        let colours = Colours::new(Colouring::Address, &[], 3);
        let light = |letters| colours.colour(code(letters)).iter().sum::<f32>();
        let words = [[1, 0, 0], [1, 0, 2], [1, 1, 0], [1, 1, 2], [1, 2, 0], [1, 2, 2]];
        assert!(words.windows(2).all(|pair| light(pair[0]) < light(pair[1])));
        // The middle of the middle is the map's own colour.
        let by_map = Colours::new(Colouring::Map, &[], 3);
        let (a, b) = (colours.colour(code([1, 1, 1])), by_map.colour(code([1, 1, 1])));
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6));
        assert!(colours.colour(code([63, 63, 63])).iter().all(|c| c.is_finite()));
    }

    #[test]
    fn colours_of_their_own_come_back_from_their_codes() {
        let colours = Colours { tinted: 1.0, ..Colours::new(Colouring::Grid, &[], 3) };
        for colour in [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 51.0 / 255.0]] {
            let code = code_of_colour(pack_colour(colour));
            assert!(code > 0, "0 is dark");
            assert_eq!(colours.colour(code), colour.map(|c| c as f32));
        }
        assert_eq!(pack_colour([f64::NAN, -3.0, 9.0]), 255);
    }

    #[test]
    fn a_palette_tells_for_which_ground_it_is_made() {
        // Those of the page, for light paper and for a dark stage.
        let light = [[0xc4, 0x78, 0x00], [0x00, 0x72, 0xb2], [0x00, 0x83, 0x5f], [0x8f, 0x85, 0x00]];
        let dark = [[0xe6, 0x9f, 0x00], [0x56, 0xb4, 0xe9], [0x00, 0x9e, 0x73], [0xf0, 0xe4, 0x42]];
        assert!(is_for_light_ground(&light) && is_for_light_ground(&[[0, 0, 0]]));
        assert!(!is_for_light_ground(&dark) && !is_for_light_ground(&[]) && !is_for_light_ground(&OKABE_ITO));
    }

    #[test]
    fn the_uniform_buffer_has_the_size_that_the_shader_declares() {
        assert_eq!(size_of::<Colours>(), 64 * 16 + 48);
    }
}
