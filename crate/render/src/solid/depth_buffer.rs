//! How far away the nearest piece is, pixel by pixel.

/// A picture in depth: what a [`Traversal`](super::Traversal) leaves.
#[derive(Clone, Debug)]
pub struct DepthBuffer {
    width: u32,
    height: u32,
    /// Depths, row by row from the top; infinite where nothing is.
    depth: Vec<f32>,
    /// What is seen: 0 where nothing is.
    codes: Vec<u32>,
    /// Above the pixels: the largest depth of each two by two of the level below, up to a single one.
    levels: Vec<Level>,
}

#[derive(Clone, Debug)]
struct Level {
    width: usize,
    farthest: Vec<f32>,
}

impl DepthBuffer {
    /// With nothing to be seen. Sides of 0 are taken as 1.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        let (width, height) = (width.max(1), height.max(1));
        let pixels = width as usize * height as usize;
        let (mut across, mut down) = (width as usize, height as usize);
        let mut levels = Vec::new();
        while across > 1 || down > 1 {
            (across, down) = (across.div_ceil(2), down.div_ceil(2));
            levels.push(Level { width: across, farthest: vec![f32::INFINITY; across * down] });
        }
        Self { width, height, depth: vec![f32::INFINITY; pixels], codes: vec![0; pixels], levels }
    }

    /// What was made elsewhere, row by row from the top; `None` where it is no picture. It knows no more of boxes than
    /// of their pixels.
    #[must_use]
    pub fn of(width: u32, depth: Vec<f32>, codes: Vec<u32>) -> Option<Self> {
        let height = u32::try_from(depth.len() / width.max(1) as usize).ok()?;
        let whole = width > 0 && height > 0 && depth.len() == width as usize * height as usize;
        let levels = Vec::new();
        (whole && codes.len() == depth.len()).then_some(Self { width, height, depth, codes, levels })
    }

    /// Pixels a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Depths, row by row from the top; infinite where nothing is.
    #[must_use]
    pub fn depth(&self) -> &[f32] {
        &self.depth
    }

    /// What is seen, row by row from the top: 0 where nothing is.
    #[must_use]
    pub fn codes(&self) -> &[u32] {
        &self.codes
    }

    /// Pixels that something is seen at.
    #[must_use]
    pub fn lit(&self) -> usize {
        self.codes.iter().filter(|&&code| code != 0).count()
    }

    /// Puts something at a pixel, unless what is there is nearer.
    pub fn put(&mut self, x: u32, y: u32, depth: f32, code: u32) {
        let width = self.width as usize;
        let (mut x, mut y) = (x as usize, y as usize);
        let at = y * width + x;
        if depth >= self.depth[at] {
            return;
        }
        let mut before = std::mem::replace(&mut self.depth[at], depth);
        self.codes[at] = code;
        // A level changes only where this was the farthest of its four.
        let (mut across, mut down) = (width, self.height as usize);
        for index in 0..self.levels.len() {
            let below = if index == 0 { &self.depth } else { &self.levels[index - 1].farthest };
            let (left, top) = (x & !1, y & !1);
            let mut farthest = f32::NEG_INFINITY;
            for row in top..(top + 2).min(down) {
                for column in left..(left + 2).min(across) {
                    farthest = farthest.max(below[row * across + column]);
                }
            }
            let level = &mut self.levels[index];
            (x, y) = (x / 2, y / 2);
            let cell = &mut level.farthest[y * level.width + x];
            if *cell != before || *cell == farthest {
                break;
            }
            before = std::mem::replace(cell, farthest);
            (across, down) = (level.width, down.div_ceil(2));
        }
    }

    /// Whether all pixels of a box, both ends included, hold something nearer than `depth`.
    #[must_use]
    pub fn hides(&self, [x0, y0, x1, y1]: [u32; 4], depth: f32) -> bool {
        let (mut x0, mut y0, mut x1, mut y1) = (x0 as usize, y0 as usize, x1 as usize, y1 as usize);
        let (mut farthest, mut width) = (&self.depth, self.width as usize);
        for level in &self.levels {
            // A few more are looked at than need be: cells of a level stick out of the box.
            if x1 - x0 < 4 && y1 - y0 < 4 {
                break;
            }
            (x0, y0, x1, y1) = (x0 / 2, y0 / 2, x1 / 2, y1 / 2);
            (farthest, width) = (&level.farthest, level.width);
        }
        (y0..=y1).all(|y| (x0..=x1).all(|x| farthest[y * width + x] < depth))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_stays_and_boxes_know_their_farthest() {
        let mut seed = 7_u64;
        let mut next = move |most: u32| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((seed >> 33) % u64::from(most)) as u32
        };
        for (width, height) in [(1, 1), (7, 3), (16, 16), (33, 20)] {
            let mut buffer = DepthBuffer::new(width, height);
            let mut truth = vec![f32::INFINITY; (width * height) as usize];
            for step in 0..3000 {
                let (x, y, depth) = (next(width), next(height), next(1000) as f32);
                buffer.put(x, y, depth, step + 1);
                let held = &mut truth[(y * width + x) as usize];
                *held = held.min(depth);
                let (x0, y0) = (next(width), next(height));
                let (x1, y1) = (x0 + next(width - x0), y0 + next(height - y0));
                let farthest = (y0..=y1)
                    .flat_map(|y| (x0..=x1).map(move |x| (y * width + x) as usize))
                    .map(|at| truth[at])
                    .fold(0.0, f32::max);
                // Cells of a level may stick out of the box, which can only make it hide less.
                for depth in [farthest, 0.5 * farthest] {
                    assert!(!buffer.hides([x0, y0, x1, y1], depth));
                }
            }
            assert_eq!(buffer.depth(), &truth[..]);
            let all = truth.iter().copied().fold(0.0, f32::max);
            let whole = [0, 0, width - 1, height - 1];
            assert!(!buffer.hides(whole, all) && (all == f32::INFINITY || buffer.hides(whole, all + 1.0)));
        }
    }
}
