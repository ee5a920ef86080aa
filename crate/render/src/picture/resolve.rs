//! From what was drawn to the picture that is shown: the CPU twin of `shader/resolve.wgsl`.

use crate::picture::colour::Colours;
use crate::picture::tone::{cover, glow, respond, tone};
use crate::picture::window::Window;

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

    /// Texel and weight, clamped to the source.
    fn tap(&self, k: i32, source: [i32; 2]) -> (usize, f32) {
        let (dx, dy) = (k & 1, k >> 1);
        let x = (self.base[0] + dx).clamp(0, source[0] - 1);
        let y = (self.base[1] + dy).clamp(0, source[1] - 1);
        let along = |d: i32, part: f32| if d == 1 { part } else { 1.0 - part };
        ((y * source[0] + x) as usize, along(dx, self.part[0]) * along(dy, self.part[1]))
    }
}

/// One pixel of the picture from codes (see [`crate::Letters`]), 0 being dark: red, green, blue, alpha.
#[must_use]
pub fn resolve_codes(colours: &Colours, codes: &[u32], pixel: [i32; 2]) -> [f32; 4] {
    let taps = Taps::of(pixel, colours.factor);
    let tap = |k| {
        let (index, weight) = taps.tap(k, colours.source);
        (codes[index], weight)
    };
    let first = tap(0);
    // Most pixels are settled by one of these.
    if taps.part == [0.0; 2] {
        return whole(colours, first.0);
    }
    let all = [first, tap(1), tap(2), tap(3)];
    if all.iter().all(|(code, _)| *code == first.0) {
        return whole(colours, first.0);
    }
    let sum = all.iter().fold([0.0_f32; 4], |sum, (code, weight)| {
        let colour = whole(colours, *code);
        std::array::from_fn(|i| sum[i] + weight * colour[i])
    });
    finish(colours, sum, cover(sum[3]), 0.0)
}

/// The whole picture of [`resolve_codes`] as bytes, row after row. Quicker than pixel by pixel.
#[must_use]
pub(crate) fn picture_of_codes(colours: &Colours, codes: &[u32], window: Window) -> Vec<u8> {
    let along = |pixels: u32, source: i32| -> Vec<(usize, usize)> {
        let last = (source - 1).max(0);
        let place = |i| ((f64::from(i) as f32 + 0.5) * colours.factor - 0.5).floor() as i32;
        let clamp = |i: i32| i.clamp(0, last) as usize;
        (0..pixels).map(|i| (clamp(place(i)), clamp(place(i) + 1))).collect()
    };
    let columns = along(window.width, colours.source[0]);
    let width = colours.source[0] as usize;
    // Neighbours mostly show the same piece.
    let (mut known, mut bytes) = (0, [0; 4]);
    let mut picture = Vec::with_capacity(window.area() * 4);
    for (y, (above, below)) in along(window.height, colours.source[1]).into_iter().enumerate() {
        let (above, below) = (&codes[above * width..][..width], &codes[below * width..][..width]);
        for (x, &(left, right)) in columns.iter().enumerate() {
            let code = above[left];
            let same = code == above[right] && code == below[left] && code == below[right];
            if !same {
                picture.extend(to_bytes(resolve_codes(colours, codes, [x as i32, y as i32])));
                continue;
            }
            if code != known {
                (known, bytes) = (code, to_bytes(whole(colours, code)));
            }
            picture.extend(bytes);
        }
    }
    picture
}

/// The whole picture of [`resolve_density`] as bytes, row after row.
#[must_use]
pub(crate) fn picture_of_density(colours: &Colours, sums: &[[f32; 4]], window: Window) -> Vec<u8> {
    let rows = 0..window.height as i32;
    let pixels = rows.flat_map(|y| (0..window.width as i32).map(move |x| [x, y]));
    pixels.flat_map(|at| to_bytes(resolve_density(colours, sums, at))).collect()
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
    fn bytes_are_rounded_and_bounded() {
        assert_eq!(to_bytes([0.0, 1.0, 0.5, 2.0]), [0, 255, 128, 255]);
        assert_eq!(to_bytes([f32::NAN, -1.0, 0.1, 0.999]), [0, 0, 26, 255]);
    }
}
