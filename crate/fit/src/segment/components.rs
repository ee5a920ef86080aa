//! Pieces of a mask, and the holes in them.

use std::ops::Range;

use frond_core::shared::sort_indices;

use super::binary_image::{Bits, find};

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

/// Pixels side by side in a row that belong to a piece: the first, the first behind them, and the piece.
#[derive(Clone, Copy)]
struct Run {
    start: u32,
    end: u32,
    label: u32,
}

/// Pieces, and which pixels belong to each.
pub struct Parts {
    runs: Vec<Run>,
    pixels: usize,
    pub all: Vec<Component>,
}

/// Which runs hang together: each knows an earlier one, the first of all itself.
struct Union(Vec<u32>);

impl Union {
    fn first(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            let next = self.0[self.0[i as usize] as usize];
            self.0[i as usize] = next;
            i = next;
        }
        i
    }

    fn join(&mut self, i: u32, j: u32) {
        let (i, j) = (self.first(i), self.first(j));
        self.0[i.max(j) as usize] = i.min(j);
    }
}

/// Finds the pieces of what is `on`, by corners too if `corners`, in the order of their first pixel.
pub fn parts(bits: &Bits, on: bool, corners: bool) -> Parts {
    let width = bits.width;
    let mut runs: Vec<Run> = Vec::new();
    let mut union = Union(Vec::new());
    let reach = u32::from(corners);
    let mut above = 0..0;
    for (y, row) in bits.on.chunks_exact(width.max(1)).enumerate() {
        let (begin, first) = ((y * width) as u32, runs.len());
        // Runs of the row above that may touch the next one of this row; places are counted as in this row.
        let mut before = above.start;
        let mut x = 0;
        while let Some(from) = find(row, x, on) {
            x = find(row, from, !on).unwrap_or(width);
            let run = Run { start: begin + from as u32, end: begin + x as u32, label: NONE };
            let label = runs.len() as u32;
            union.0.push(label);
            let below = |run: &Run| [run.start + width as u32, run.end + width as u32];
            while before < above.end && below(&runs[before])[1] + reach <= run.start {
                before += 1;
            }
            let mut next = before;
            while next < above.end && below(&runs[next])[0] < run.end + reach {
                union.join(next as u32, label);
                next += 1;
            }
            runs.push(run);
        }
        above = first..runs.len();
    }
    let mut all: Vec<Component> = Vec::new();
    for i in 0..runs.len() {
        let first = union.first(i as u32) as usize;
        let (start, end) = (runs[i].start as usize, runs[i].end as usize);
        let (y, x, behind) = (start / width, start % width, (end - 1) % width + 1);
        if first == i {
            runs[i].label = all.len() as u32;
            let bounds = [x, y, behind, y + 1];
            all.push(Component { area: end - start, bounds, at: [x, y], touches_border: false });
        } else {
            runs[i].label = runs[first].label;
            let part = &mut all[runs[i].label as usize];
            let [left, top, right, _] = part.bounds;
            part.area += end - start;
            part.bounds = [left.min(x), top, right.max(behind), y + 1];
        }
    }
    for part in &mut all {
        let [left, top, right, bottom] = part.bounds;
        part.touches_border = left == 0 || top == 0 || right == width || bottom == bits.height;
    }
    Parts { runs, pixels: bits.on.len(), all }
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
        for run in &mut self.runs {
            run.label = new[run.label as usize];
        }
        self.runs.retain(|run| run.label != NONE);
        self.all = order.iter().map(|&i| self.all[i]).collect();
        self
    }

    /// Pixels side by side, and the piece that they belong to, in order.
    pub fn runs(&self) -> impl Iterator<Item = (Range<usize>, usize)> {
        self.runs.iter().map(|run| (run.start as usize..run.end as usize, run.label as usize))
    }

    /// The piece of each pixel, or [`NONE`].
    #[inline(never)]
    pub fn labels(&self) -> Vec<u32> {
        let mut labels = vec![NONE; self.pixels];
        for run in &self.runs {
            labels[run.start as usize..run.end as usize].fill(run.label);
        }
        labels
    }

    /// The piece of one pixel.
    pub fn of(&self, pixel: usize) -> Option<usize> {
        let run = self.runs.partition_point(|run| run.end as usize <= pixel);
        self.runs.get(run).filter(|run| run.start as usize <= pixel).map(|run| run.label as usize)
    }

    /// What belongs to any piece.
    pub fn bits(&self, width: usize, height: usize) -> Bits {
        self.bits_where(width, height, |_| true)
    }

    /// What belongs to these pieces.
    #[inline(never)]
    pub fn bits_where(&self, width: usize, height: usize, of: impl Fn(usize) -> bool) -> Bits {
        let mut bits = Bits::new(width, height);
        for (run, _) in self.runs().filter(|(_, label)| of(*label)) {
            bits.on[run].fill(true);
        }
        bits
    }
}

/// Fills holes of at most `most` pixels, but for those in which a pixel is `open`. A pixel of each that was filled, and
/// how many it has.
#[inline(never)]
pub fn fill_holes(bits: &mut Bits, most: usize, open: impl Fn(usize) -> bool) -> Vec<(usize, usize)> {
    let holes = parts(bits, false, false);
    let mut filled: Vec<bool> =
        holes.all.iter().map(|hole| !hole.touches_border && hole.area <= most).collect();
    for (mut run, label) in holes.runs() {
        filled[label] = filled[label] && !run.any(&open);
    }
    for (run, _) in holes.runs().filter(|(_, label)| filled[*label]) {
        bits.on[run].fill(true);
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

    /// The pieces by trying, pixel by pixel, which hang together.
    fn by_flood(bits: &Bits, on: bool, corners: bool) -> (Vec<u32>, usize) {
        let (width, height) = (bits.width, bits.height);
        let mut labels = vec![NONE; width * height];
        let mut count = 0;
        for start in 0..labels.len() {
            let mut open = if bits.on[start] == on && labels[start] == NONE { vec![start] } else { continue };
            labels[start] = count;
            while let Some(i) = open.pop() {
                let (x, y) = (i % width, i / width);
                for ny in y.saturating_sub(1)..(y + 2).min(height) {
                    for nx in x.saturating_sub(1)..(x + 2).min(width) {
                        let near = ny * width + nx;
                        if (corners || nx == x || ny == y) && bits.on[near] == on && labels[near] == NONE {
                            labels[near] = count;
                            open.push(near);
                        }
                    }
                }
            }
            count += 1;
        }
        (labels, count as usize)
    }

    #[test]
    fn runs_hang_together_as_pixels_do() {
        for (width, height) in [(1, 1), (1, 9), (9, 1), (2, 2), (17, 13), (40, 30)] {
            for seed in 0..20_u32 {
                let dense = 0.2 + 0.03 * seed as f32;
                let is_on = |i: u32| frond_core::hash::unit(frond_core::hash::counter(seed, i)) < dense;
                let bits = Bits { width, height, on: (0..(width * height) as u32).map(is_on).collect() };
                for (on, corners) in [(true, true), (true, false), (false, false), (false, true)] {
                    let found = parts(&bits, on, corners);
                    let (labels, count) = by_flood(&bits, on, corners);
                    assert_eq!((found.labels(), found.all.len()), (labels.clone(), count));
                    for (label, part) in found.all.iter().enumerate() {
                        let own: Vec<usize> =
                            (0..labels.len()).filter(|&i| labels[i] == label as u32).collect();
                        let side = |of: &dyn Fn(&usize) -> usize| {
                            let least = own.iter().map(of).min().unwrap();
                            (least, own.iter().map(of).max().unwrap() + 1)
                        };
                        let ((left, right), (top, bottom)) = (side(&|i| i % width), side(&|i| i / width));
                        assert_eq!(part.bounds, [left, top, right, bottom]);
                        assert_eq!((part.area, part.at), (own.len(), [own[0] % width, own[0] / width]));
                        let border = left == 0 || top == 0 || right == width || bottom == height;
                        assert_eq!(part.touches_border, border);
                    }
                    let each = (0..labels.len()).map(|i| found.of(i).map_or(NONE, |label| label as u32));
                    assert!(each.eq(labels.iter().copied()));
                }
            }
        }
    }
}
