//! From what was drawn to the picture that is shown: the CPU twin of `shader/resolve.wgsl`.

use crate::picture::colour::Colours;
use crate::picture::tone::{cover, glow, respond, tone};
use crate::picture::window::Window;
use crate::pieces::letters::Code;

/// A source of four texels around a point, with their weights: how pictures are shrunk to half (each
/// pixel is the mean of four), copied, and magnified (in between) alike.
struct Taps {
    base: [i32; 2],
    part: [f32; 2],
}

impl Taps {
    fn of(pixel: [i32; 2], factor: f32) -> Self {
        let place = pixel.map(|i| (i as f32 + 0.5) * factor - 0.5);
        let base = place.map(f32::floor);
        Self { base: base.map(|b| b as i32), part: [place[0] - base[0], place[1] - base[1]] }
    }

    /// The place of a texel, clamped to the source.
    fn tap(&self, k: i32, source: [i32; 2]) -> usize {
        let (dx, dy) = (k & 1, k >> 1);
        let x = (self.base[0] + dx).clamp(0, source[0] - 1);
        let y = (self.base[1] + dy).clamp(0, source[1] - 1);
        (y * source[0] + x) as usize
    }

    fn weight(&self, k: i32) -> f32 {
        let along = |d: i32, part: f32| if d == 1 { part } else { 1.0 - part };
        along(k & 1, self.part[0]) * along(k >> 1, self.part[1])
    }
}

/// One pixel of the picture from codes (see [`crate::Letters`]), 0 being dark: red, green, blue, alpha.
#[must_use]
pub fn resolve_codes(colours: &Colours, codes: &[u32], pixel: [i32; 2]) -> [f32; 4] {
    let taps = Taps::of(pixel, colours.factor);
    blend(colours, &taps, [0, 1, 2, 3].map(|k| codes[taps.tap(k, colours.source)]))
}

/// The same of the four codes around it.
fn blend(colours: &Colours, taps: &Taps, codes: [u32; 4]) -> [f32; 4] {
    // Most pixels are settled by one of these.
    if taps.part == [0.0; 2] || codes.iter().all(|code| *code == codes[0]) {
        return whole(colours, codes[0]);
    }
    let mut sum = [0.0_f32; 4];
    for (k, code) in (0..).zip(codes) {
        let (weight, colour) = (taps.weight(k), whole(colours, code));
        for (sum, part) in sum.iter_mut().zip(colour) {
            *sum += weight * part;
        }
    }
    finish(colours, sum, cover(sum[3]), 0.0)
}

/// The whole picture of [`resolve_codes`] as bytes, row after row. Many times quicker than pixel by pixel.
#[must_use]
pub(crate) fn picture_of_codes<C: Code>(colours: &Colours, codes: &[C], window: Window) -> Vec<u8> {
    let mut picture = vec![0; window.area() * 4];
    let width = colours.source[0] as usize;
    let mut mixer = Mixer { colours, known: vec![([u32::MAX; 4], [0; 4]); MIXTURES] };
    if colours.factor == 2.0 && window.width as usize * 2 == width {
        let rows = codes.chunks_exact(2 * width).zip(picture.chunks_exact_mut(2 * width));
        for (rows, pixels) in rows {
            let (above, below) = rows.split_at(width);
            let blocks =
                above.chunks(2 * BLOCK).zip(below.chunks(2 * BLOCK)).zip(pixels.chunks_mut(4 * BLOCK));
            for ((above, below), pixels) in blocks {
                let first = above[0];
                if all_are(above, first) && all_are(below, first) {
                    if first > C::default() {
                        let pixel = mixer.mix([first; 4]);
                        pixels.chunks_exact_mut(4).for_each(|place| place.copy_from_slice(&pixel));
                    }
                    continue;
                }
                let fours = above.chunks_exact(2).zip(below.chunks_exact(2)).zip(pixels.chunks_exact_mut(4));
                for ((above, below), pixel) in fours {
                    pixel.copy_from_slice(&mixer.mix([above[0], above[1], below[0], below[1]]));
                }
            }
        }
        return picture;
    }
    for (i, pixel) in picture.chunks_exact_mut(4).enumerate() {
        let at = [(i % window.width as usize) as i32, (i / window.width as usize) as i32];
        let taps = Taps::of(at, colours.factor);
        let four = [0, 1, 2, 3].map(|k| codes[taps.tap(k, colours.source)]);
        let bytes = if four.iter().all(|code| *code == four[0]) {
            mixer.mix(four)
        } else {
            to_bytes(blend(colours, &taps, four.map(C::code)))
        };
        pixel.copy_from_slice(&bytes);
    }
    picture
}

/// Whether a row is of one code: all at once, rather than up to the first that is another one.
#[inline(never)]
fn all_are<C: Code>(row: &[C], first: C) -> bool {
    row.iter().fold(true, |same, code| same & (*code == first))
}

/// Pixels that are looked at together, and how many mixtures are remembered.
const BLOCK: usize = 16;
const MIXTURES: usize = 1024;

/// Makes a pixel of four, and remembers what it made: there are few colours, and so few mixtures.
struct Mixer<'a> {
    colours: &'a Colours,
    known: Vec<([u32; 4], [u8; 4])>,
}

impl Mixer<'_> {
    #[inline]
    fn mix<C: Code>(&mut self, four: [C; 4]) -> [u8; 4] {
        let mut four = four.map(C::code);
        if self.colours.contrast == 0.0 && self.colours.tinted == 0.0 {
            // By map, pieces of a map are of one colour.
            four = four.map(|code| code.saturating_sub(1) & !0xfff | u32::from(code > 0));
        }
        // Each is multiplied by itself: none waits for another one.
        let [a, b, c, d] = four;
        let hash = a.wrapping_mul(0x9e37_79b1)
            ^ b.wrapping_mul(0x85eb_ca6b)
            ^ c.wrapping_mul(0xc2b2_ae35)
            ^ d.wrapping_mul(0x27d4_eb2f);
        let place = &mut self.known[(hash >> 16) as usize % MIXTURES];
        if place.0 != four {
            let even = Taps { base: [0; 2], part: [0.5; 2] };
            *place = (four, to_bytes(blend(self.colours, &even, four)));
        }
        place.1
    }
}

/// The whole picture of [`resolve_density`] as bytes, row after row. Many times quicker than pixel by pixel.
#[must_use]
pub(crate) fn picture_of_density(colours: &Colours, sums: &[[f32; 4]]) -> Vec<u8> {
    let tones = Tones::new(colours.slope);
    let mut picture = vec![0; sums.len() * 4];
    for (sum, pixel) in sums.iter().zip(picture.chunks_exact_mut(4)) {
        if sum[3] > 0.0 {
            let [alpha, light] = tones.at(sum[3] * colours.gain);
            pixel.copy_from_slice(&to_bytes(finish(colours, *sum, alpha, light)));
        }
    }
    picture
}

/// Alpha and light of densities, in a table by the exponents of their numbers and the first digits after them: what is
/// between two of its entries is off by less than a screen shows.
struct Tones {
    table: Vec<[f32; 2]>,
}

/// Digits that are looked at, and the exponents: what is thinner is all but nothing, and the densest are all alike.
const DIGITS: u32 = 4;
const EXPONENTS: (i32, i32) = (-40, 21);

impl Tones {
    fn new(slope: f32) -> Self {
        let count = ((EXPONENTS.1 - EXPONENTS.0) as u32) << DIGITS;
        let entry = |i: u32| {
            let density = f32::from_bits(Self::first() + (i << (23 - DIGITS)));
            let response = respond(density, slope);
            [tone(density, response), glow(response)]
        };
        Self { table: (0..=count).map(entry).collect() }
    }

    /// The number of the smallest density in the table.
    const fn first() -> u32 {
        ((127 + EXPONENTS.0) as u32) << 23
    }

    #[inline]
    fn at(&self, density: f32) -> [f32; 2] {
        let place = density.to_bits().saturating_sub(Self::first());
        let (i, part) = (place >> (23 - DIGITS), place & ((1 << (23 - DIGITS)) - 1));
        let part = part as f32 / (1 << (23 - DIGITS)) as f32;
        match self.table.get(i as usize..i as usize + 2) {
            Some([low, high]) => std::array::from_fn(|k| low[k] + (high[k] - low[k]) * part),
            _ => self.table[self.table.len() - 1],
        }
    }
}

/// A pixel that is all of one piece, or of none.
fn whole(colours: &Colours, code: u32) -> [f32; 4] {
    if code == 0 {
        return [0.0; 4];
    }
    let [r, g, b] = colours.colour(code);
    [r, g, b, 1.0]
}

/// One pixel of the picture from densities of the same size: sums of weighted colours, and of weights.
#[must_use]
pub fn resolve_density(colours: &Colours, sums: &[[f32; 4]], [x, y]: [i32; 2]) -> [f32; 4] {
    let sum = sums[(y * colours.source[0] + x) as usize];
    let density = sum[3] * colours.gain;
    let response = respond(density, colours.slope);
    finish(colours, sum, tone(density, response), glow(response))
}

/// The mean colour of a sum, moved away from the ground, with an alpha.
fn finish(colours: &Colours, sum: [f32; 4], alpha: f32, light: f32) -> [f32; 4] {
    if sum[3] <= 0.0 {
        return [0.0; 4];
    }
    let scale = 1.0 + (alpha - 1.0) * colours.premultiply;
    let [r, g, b] = [sum[0], sum[1], sum[2]].map(|c| {
        let mean = c / sum[3];
        (mean + (colours.towards - mean) * light) * scale
    });
    [r, g, b, alpha]
}

/// A colour as bytes, as a graphics card rounds it.
#[must_use]
pub fn to_bytes(colour: [f32; 4]) -> [u8; 4] {
    colour.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8)
}

#[cfg(test)]
mod tests {
    use frond_core::Colouring;

    use super::*;

    fn colours(source: [i32; 2], factor: f32) -> Colours {
        let palette = [[255, 0, 0], [0, 0, 255]];
        Colours { source, factor, ..Colours::new(Colouring::Map, &palette, 2) }
    }

    /// The code of a pixel of the second map.
    const BLUE: u32 = (1 << 12) + 1;

    #[test]
    fn a_picture_of_the_same_size_is_copied() {
        let codes = [0, 1, BLUE, 0];
        let colours = colours([2, 2], 1.0);
        assert_eq!(resolve_codes(&colours, &codes, [0, 0]), [0.0; 4]);
        assert_eq!(resolve_codes(&colours, &codes, [1, 0]), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(resolve_codes(&colours, &codes, [0, 1]), [0.0, 0.0, 1.0, 1.0]);
    }

    #[test]
    fn half_size_is_the_coverage_of_four() {
        let colours = colours([4, 2], 2.0);
        let codes = [1, 0, 0, 0, BLUE, 0, 0, 0];
        let [r, g, b, alpha] = resolve_codes(&colours, &codes, [0, 0]);
        assert_eq!([r, g, b], [0.5, 0.0, 0.5]);
        assert_eq!(alpha, cover(0.5));
        assert_eq!(resolve_codes(&colours, &codes, [1, 0]), [0.0; 4], "nothing lit, nothing shown");
        let premultiplied = Colours { premultiply: 1.0, ..colours };
        assert_eq!(resolve_codes(&premultiplied, &codes, [0, 0])[0], 0.5 * cover(0.5));
    }

    #[test]
    fn twice_the_size_keeps_the_middle_of_a_lit_area_whole() {
        let colours = colours([3, 3], 0.5);
        for pixel in [[2, 2], [0, 0], [5, 5]] {
            assert_eq!(resolve_codes(&colours, &[1; 9], pixel), [1.0, 0.0, 0.0, 1.0]);
        }
        let mut codes = [1; 9];
        codes[0] = 0;
        assert!(resolve_codes(&colours, &codes, [1, 1])[3] < 1.0);
    }

    #[test]
    fn whole_pictures_are_those_of_their_pixels() {
        for (factor, source) in
            [(2.0, [22, 14]), (1.0, [11, 7]), (0.5, [6, 4]), (0.25, [3, 2]), (0.125, [2, 1])]
        {
            let colours = colours(source, factor);
            let code = |i: i32| frond_core::hash::pcg(i as u32 / 3) % 3 * (BLUE - 1) / 2;
            let codes: Vec<u32> = (0..source[0] * source[1]).map(code).collect();
            let window = Window { width: 11, height: 7 };
            let each = (0..7).flat_map(|y| (0..11).map(move |x| [x, y]));
            let each: Vec<u8> = each.flat_map(|at| to_bytes(resolve_codes(&colours, &codes, at))).collect();
            assert_eq!(picture_of_codes(&colours, &codes, window), each, "{factor}");
            assert!(each.iter().any(|byte| *byte > 0) && each.contains(&0));
        }
    }

    #[test]
    fn densities_mix_colours_and_take_their_alpha_from_the_tone() {
        let colours = Colours { gain: 2.0, slope: 1.5, ..colours([1, 1], 1.0) };
        let [r, g, b, alpha] = resolve_density(&colours, &[[0.05, 0.0, 0.15, 0.2]], [0, 0]);
        assert!((r - 0.25).abs() < 1e-6 && g == 0.0 && (b - 0.75).abs() < 1e-6);
        assert_eq!(alpha, tone(0.4, respond(0.4, 1.5)));
        assert_eq!(resolve_density(&colours, &[[0.0; 4]], [0, 0]), [0.0; 4]);
        // What is dense is farther from the ground, light or dark.
        let dense =
            |towards| resolve_density(&Colours { towards, ..colours }, &[[1.0, 0.0, 3.0, 4.0]], [0, 0]);
        let ([light, _, lit, one], [dark, _, dim, all]) = (dense(1.0), dense(0.0));
        assert!(light > 0.5 && lit > 0.85 && dark < 0.15 && dim < 0.45, "{light} {lit} {dark} {dim}");
        assert_eq!([one, all], [1.0; 2]);
    }

    #[test]
    fn whole_pictures_of_densities_are_those_of_their_pixels() {
        for (slope, towards) in [(0.6, 1.0), (1.1, 0.0), (1.8, 1.0)] {
            let weights = (-300..200).map(|i| (i as f32 * 0.1).exp2()).chain([0.0, f32::INFINITY]);
            let sums: Vec<_> = weights.map(|w| [0.9 * w, 0.2 * w, 0.5 * w, w]).collect();
            let colours = Colours { gain: 0.7, slope, towards, ..colours([sums.len() as i32, 1], 1.0) };
            let each =
                (0..sums.len() as i32).flat_map(|x| to_bytes(resolve_density(&colours, &sums, [x, 0])));
            let whole = picture_of_density(&colours, &sums);
            assert_eq!(whole.len(), 4 * sums.len());
            assert!(whole.iter().zip(each).all(|(a, b)| a.abs_diff(b) <= 1), "{slope}");
        }
    }

    #[test]
    fn bytes_are_rounded_and_bounded() {
        assert_eq!(to_bytes([0.0, 1.0, 0.5, 2.0]), [0, 255, 128, 255]);
        assert_eq!(to_bytes([f32::NAN, -1.0, 0.1, 0.999]), [0, 0, 26, 255]);
    }
}
