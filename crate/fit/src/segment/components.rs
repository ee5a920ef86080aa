//! Pieces of a mask, and the holes in them.

use frond_core::shared::sort_indices;

use super::binary_image::Bits;

/// A piece of a mask whose pixels hang together by their sides or corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Component {
    /// In pixels.
    pub area: usize,
    /// Left, top, right and bottom in pixels; right and bottom are the first that are outside.
    pub bounds: [usize; 4],
    /// Column and row of a pixel of it.
    pub at: [usize; 2],
    /// Whether it reaches the border of the picture.
    pub touches_border: bool,
}

/// No piece.
pub const NONE: u32 = u32::MAX;

/// Pieces and to which of them each pixel belongs.
pub struct Parts {
    pub labels: Vec<u32>,
    pub all: Vec<Component>,
}

/// Finds the pieces of what is `on`, by corners too if `corners`, in the order of their first pixel.
pub fn parts(bits: &Bits, on: bool, corners: bool) -> Parts {
    let (width, height) = (bits.width, bits.height);
    let mut labels = vec![NONE; width * height];
    let mut all = Vec::new();
    let mut open = Vec::new();
    for start in 0..labels.len() {
        if bits.on[start] != on || labels[start] != NONE {
            continue;
        }
        let label = all.len() as u32;
        let (x, y) = (start % width, start / width);
        let mut part = Component { area: 0, bounds: [x, y, x + 1, y + 1], at: [x, y], touches_border: false };
        labels[start] = label;
        open.push(start);
        while let Some(i) = open.pop() {
            let (x, y) = (i % width, i / width);
            part.area += 1;
            let [left, top, right, bottom] = part.bounds;
            part.bounds = [left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1)];
            for ny in y.saturating_sub(1)..(y + 2).min(height) {
                for nx in x.saturating_sub(1)..(x + 2).min(width) {
                    let near = ny * width + nx;
                    if (corners || nx == x || ny == y) && bits.on[near] == on && labels[near] == NONE {
                        labels[near] = label;
                        open.push(near);
                    }
                }
            }
        }
        let [left, top, right, bottom] = part.bounds;
        part.touches_border = left == 0 || top == 0 || right == width || bottom == height;
        all.push(part);
    }
    Parts { labels, all }
}

impl Parts {
    /// Drops the pieces that are smaller than `least`, sorts the others by area, largest first, and keeps `most` of
    /// them.
    pub fn largest(mut self, least: usize, most: usize) -> Self {
        let mut order: Vec<usize> = (0..self.all.len()).filter(|&i| self.all[i].area >= least).collect();
        sort_indices(&mut order, &|i, j| self.all[j].area.cmp(&self.all[i].area));
        order.truncate(most);
        let mut new = vec![NONE; self.all.len()];
        for (place, &i) in order.iter().enumerate() {
            new[i] = place as u32;
        }
        for label in self.labels.iter_mut().filter(|label| **label != NONE) {
            *label = new[*label as usize];
        }
        self.all = order.iter().map(|&i| self.all[i]).collect();
        self
    }

    /// What belongs to any piece.
    pub fn bits(&self, width: usize, height: usize) -> Bits {
        Bits { width, height, on: self.labels.iter().map(|&label| label != NONE).collect() }
    }
}

/// Fills holes of at most `most` pixels, but for those in which a pixel is `open`. A pixel of each that was filled, and
/// how many it has.
pub fn fill_holes(bits: &mut Bits, most: usize, open: impl Fn(usize) -> bool) -> Vec<(usize, usize)> {
    let holes = parts(bits, false, false);
    let mut filled: Vec<bool> =
        holes.all.iter().map(|hole| !hole.touches_border && hole.area <= most).collect();
    for (i, &label) in holes.labels.iter().enumerate() {
        if label != NONE && open(i) {
            filled[label as usize] = false;
        }
    }
    for (on, &label) in bits.on.iter_mut().zip(&holes.labels) {
        *on |= label != NONE && filled[label as usize];
    }
    let of = |(hole, _): (&Component, &bool)| (hole.at[1] * bits.width + hole.at[0], hole.area);
    holes.all.iter().zip(&filled).filter(|(_, filled)| **filled).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(rows: &[&str]) -> Bits {
        let on = rows.iter().flat_map(|row| row.bytes().map(|byte| byte == b'#')).collect();
        Bits { width: rows[0].len(), height: rows.len(), on }
    }

    #[test]
    fn pieces_hang_together_by_corners_and_holes_do_not() {
        let mut bits = drawn(&["........", ".###....", ".#.#.##.", ".###.##.", "....#...", ".......#"]);
        let found = parts(&bits, true, true).largest(2, 9);
        assert_eq!(found.all.len(), 1);
        assert_eq!(found.all[0].bounds, [1, 1, 7, 5]);
        assert_eq!((found.all[0].area, found.all[0].touches_border), (13, false));
        let all = parts(&bits, true, true).largest(1, 9);
        assert!(all.all[1].touches_border);
        assert_eq!(fill_holes(&mut bits, 1, |_| false), [(2 * 8 + 2, 1)]);
        assert!(bits.on[2 * 8 + 2]);
    }

    #[test]
    fn holes_that_are_large_or_kept_open_stay() {
        let ring = drawn(&["####", "#..#", "####"]);
        let mut bits = ring.clone();
        fill_holes(&mut bits, 1, |_| false);
        assert_eq!(bits, ring);
        fill_holes(&mut bits, 9, |i| i == 5);
        assert_eq!(bits, ring);
        fill_holes(&mut bits, 9, |_| false);
        assert_eq!(bits.count(), 12);
    }
}
