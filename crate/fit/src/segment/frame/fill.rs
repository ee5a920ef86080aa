//! A picture as if the ground inside its frame went on.

use crate::segment::binary_image::Bits;

const NOWHERE: u32 = u32::MAX;

/// The picture without a frame: each pixel of it has the colour of a pixel inside that is near it.
#[inline(never)]
pub fn without(rgba: &[u8], around: &Bits) -> Vec<u8> {
    let (width, height) = (around.width, around.height);
    let mut from: Vec<u32> =
        around.on.iter().enumerate().map(|(i, &on)| if on { NOWHERE } else { i as u32 }).collect();
    let far = |i: usize, source: u32| {
        let (x, y) = (source as usize % width, source as usize / width);
        let square = |a: usize, b: usize| a.abs_diff(b) as u64 * a.abs_diff(b) as u64;
        square(i % width, x) + square(i / width, y)
    };
    // The nearest of those that neighbours have found: down, then up (Danielsson 1980).
    let mut look = |i: usize, x: isize, y: isize| {
        let (nx, ny) = ((i % width) as isize + x, (i / width) as isize + y);
        if nx < 0 || ny < 0 || nx >= width as isize || ny >= height as isize {
            return;
        }
        let source = from[ny as usize * width + nx as usize];
        if source != NOWHERE && (from[i] == NOWHERE || far(i, source) < far(i, from[i])) {
            from[i] = source;
        }
    };
    for y in 0..height {
        for x in 0..width {
            [(-1, 0), (-1, -1), (0, -1), (1, -1)].iter().for_each(|&(dx, dy)| look(y * width + x, dx, dy));
        }
        for x in (0..width).rev() {
            look(y * width + x, 1, 0);
        }
    }
    for y in (0..height).rev() {
        for x in (0..width).rev() {
            [(1, 0), (1, 1), (0, 1), (-1, 1)].iter().for_each(|&(dx, dy)| look(y * width + x, dx, dy));
        }
        for x in 0..width {
            look(y * width + x, -1, 0);
        }
    }
    let mut seen = rgba.to_vec();
    for (i, &source) in from.iter().enumerate() {
        if around.on[i] && source != NOWHERE {
            let at = 4 * source as usize;
            seen[4 * i..4 * i + 4].copy_from_slice(&rgba[at..at + 4]);
        }
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_filled_has_the_nearest_colour() {
        // Two colours within, side by side, in a frame of two pixels.
        let (width, height) = (9, 8);
        let inside = |x: usize, y: usize| (2..7).contains(&x) && (2..6).contains(&y);
        let on = (0..width * height).map(|i| !inside(i % width, i / width)).collect();
        let rgba: Vec<u8> = (0..width * height)
            .flat_map(|i| match (inside(i % width, i / width), i % width < 4) {
                (false, _) => [0, 0, 0, 0],
                (_, true) => [10, 20, 30, 255],
                _ => [90, 80, 70, 255],
            })
            .collect();
        let seen = without(&rgba, &Bits { width, height, on });
        for (i, pixel) in seen.chunks_exact(4).enumerate() {
            assert_eq!(pixel, if i % width < 4 { [10, 20, 30, 255] } else { [90, 80, 70, 255] }, "{i}");
        }
        let all = Bits { width, height, on: vec![true; width * height] };
        assert_eq!(without(&rgba, &all), rgba);
    }
}
