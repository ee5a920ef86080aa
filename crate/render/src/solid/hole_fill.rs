//! Closing the holes of a surface of points: a CPU twin of `shader/solid/hole_fill.wgsl`.

use super::DepthBuffer;
use super::around::NOTHING_DEPTH;
use super::splat::SEEN_MASK;

/// How many of the nine pixels around a hole, itself included, lie before it.
const NEARER_NEIGHBOURS: usize = 5;
/// How much nearer they are, in pixels at their depth.
const DEPTH_STEP: f32 = 6.0;

/// A depth buffer in which what most neighbours lie before is taken for a hole, and filled with the nearest of them.
#[must_use]
pub fn fill_holes(buffer: &DepthBuffer, focal: f32) -> DepthBuffer {
    let (width, height) = (buffer.width() as i32, buffer.height() as i32);
    let at = |x: i32, y: i32| {
        let inside = x >= 0 && y >= 0 && x < width && y < height;
        inside.then(|| (y * width + x) as usize).filter(|&at| buffer.codes()[at] != 0)
    };
    let depth = |x: i32, y: i32| at(x, y).map_or(NOTHING_DEPTH, |at| buffer.depth()[at]);
    let mut filled = DepthBuffer::new(buffer.width(), buffer.height());
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        let own = depth(x, y);
        let (mut before, mut nearest, mut from) = (0, NOTHING_DEPTH, (x, y));
        for k in 0..9 {
            let next = (x + k % 3 - 1, y + k / 3 - 1);
            let there = depth(next.0, next.1);
            before += usize::from(there < own - DEPTH_STEP / focal * there);
            if there < nearest {
                (nearest, from) = (there, next);
            }
        }
        let from = if before < NEARER_NEIGHBOURS { (x, y) } else { from };
        if let Some(from) = at(from.0, from.1) {
            filled.put(x as u32, y as u32, buffer.depth()[from], buffer.codes()[from] & SEEN_MASK);
        }
    }
    filled
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_holes_close_and_borders_stay() {
        let mut buffer = DepthBuffer::new(9, 9);
        for (y, x) in (1..8).flat_map(|y| (1..8).map(move |x| (y, x))) {
            if (x, y) != (4, 4) {
                buffer.put(x, y, if (x, y) == (2, 5) { 30.0 } else { 10.0 }, 7);
            }
        }
        let filled = fill_holes(&buffer, 100.0);
        assert_eq!(filled.lit(), 49);
        assert!(filled.depth().iter().all(|&depth| depth == 10.0 || depth == f32::INFINITY));
        assert_eq!(fill_holes(&DepthBuffer::new(3, 3), 100.0).lit(), 0);
    }
}
