//! Points as large as the space between them: a CPU twin of `shader/solid/splat.wgsl`.

use bytemuck::{Pod, Zeroable};

use super::points::OBJECT_BIT;
use super::{DepthBuffer, MAX_OBJECTS};

/// Half pixels that a point has come are kept above this bit of a code, until its holes are filled.
const TRAVEL_BIT: u32 = 24;
/// The part of a code that says what is seen.
pub(super) const SEEN_MASK: u32 = (1 << TRAVEL_BIT) - 1;
/// The longest step, in pixels: points go as far as all steps together.
const WIDEST_SPLAT: i32 = 8;

/// How points grow by steps of one length, as the shader reads it: a uniform buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct SplatStep {
    /// Width and height, in pixels.
    pub size: [i32; 2],
    /// Pixels a unit at depth 1.
    pub focal: f32,
    /// The length of a step, in pixels.
    pub step: i32,
    /// The space between the points of each object, in units of space: four in a row.
    pub gaps: [f32; MAX_OBJECTS],
}

impl SplatStep {
    /// What closes the space between points of these gaps, the longest steps first; `nearest` is the nearest depth
    /// there is. Nothing where no gap is wider than a pixel.
    #[must_use]
    pub fn steps(size: [i32; 2], focal: f32, nearest: f32, gaps: &[f32]) -> Vec<Self> {
        let widest = gaps.iter().copied().fold(0.0, f32::max) * focal / nearest;
        let gaps = std::array::from_fn(|i| gaps.get(i).copied().unwrap_or(0.0));
        let step = |k: u32| Self { size, focal, step: WIDEST_SPLAT >> k, gaps };
        (0..=WIDEST_SPLAT.ilog2()).map(step).filter(|splat| widest >= splat.step as f32).collect()
    }

    /// A depth buffer in which every point has been offered to the pixels a step away.
    #[must_use]
    pub fn apply(&self, buffer: &DepthBuffer) -> DepthBuffer {
        let [width, height] = self.size;
        let mut splat = DepthBuffer::new(buffer.width(), buffer.height());
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            let mut best = Offer::of(self, buffer, x, y, 0);
            for k in (0..9).filter(|&k| k != 4) {
                let (dx, dy) = (k % 3 - 1, k / 3 - 1);
                // Half pixels, as long as a step is.
                let far = if dx != 0 && dy != 0 { 2.828_427 } else { 2.0 };
                let come = (far * self.step as f32).round() as u32;
                let next = Offer::of(self, buffer, x + self.step * dx, y + self.step * dy, come);
                if next.code != 0 && next.come <= next.reach && next.before(&best) {
                    best = next;
                }
            }
            if best.code != 0 {
                splat.put(
                    x as u32,
                    y as u32,
                    best.depth,
                    best.code & SEEN_MASK | best.come.min(255) << TRAVEL_BIT,
                );
            }
        }
        splat
    }
}

/// What a pixel is offered.
struct Offer {
    code: u32,
    depth: f32,
    come: u32,
    /// How far it may come.
    reach: u32,
    gap: f32,
}

impl Offer {
    fn of(splat: &SplatStep, buffer: &DepthBuffer, x: i32, y: i32, come: u32) -> Self {
        let [width, height] = splat.size;
        let at = (y * width + x) as usize;
        let inside = x >= 0 && y >= 0 && x < width && y < height;
        let code = if inside { buffer.codes()[at] } else { 0 };
        if code == 0 {
            return Self { code, depth: 0.0, come, reach: 0, gap: 0.0 };
        }
        let depth = buffer.depth()[at];
        let gap = splat.gaps[((((code & SEEN_MASK) - 1) >> OBJECT_BIT) as usize).min(MAX_OBJECTS - 1)];
        let reach = (2.0 * gap * splat.focal / depth).min(255.0) as u32;
        Self { code, depth, come: come + (code >> TRAVEL_BIT), reach, gap }
    }

    /// Whether it is rather seen: what is clearly nearer is, and of one surface what has come less far.
    fn before(&self, other: &Self) -> bool {
        if other.code == 0 || self.depth + 2.0 * self.gap < other.depth {
            return true;
        }
        other.depth + 2.0 * other.gap >= self.depth && self.come < other.come
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps(gap: f32) -> Vec<SplatStep> {
        SplatStep::steps([40, 40], 100.0, 10.0, &[gap, gap])
    }

    fn splat(buffer: &DepthBuffer, gap: f32) -> DepthBuffer {
        steps(gap).iter().fold(buffer.clone(), |buffer, splat| splat.apply(&buffer))
    }

    #[test]
    fn points_of_a_surface_close_it_and_stay_near() {
        let mut buffer = DepthBuffer::new(40, 40);
        for (y, x) in (10..30).step_by(5).flat_map(|y| (10..30).step_by(5).map(move |x| (y, x))) {
            buffer.put(x, y, 10.0, 1);
        }
        // Five pixels at this depth.
        let closed = splat(&buffer, 0.5);
        for (at, &code) in closed.codes().iter().enumerate() {
            let (x, y) = (at % 40, at / 40);
            let far = |v: usize| (10_usize.saturating_sub(v)).max(v.saturating_sub(25));
            if far(x) == 0 && far(y) == 0 {
                assert_eq!(code & SEEN_MASK, 1, "({x}, {y})");
            }
            assert!(code == 0 || far(x).max(far(y)) <= 5, "({x}, {y})");
        }
        // Points are where they were.
        assert_eq!(closed.codes()[10 * 40 + 10], 1);
        assert_eq!(splat(&buffer, 0.1).lit(), 16 * 5);
        assert!(steps(0.01).is_empty());
        assert_eq!(steps(100.0).iter().map(|s| s.step).collect::<Vec<_>>(), [8, 4, 2, 1]);
    }

    #[test]
    fn what_is_clearly_nearer_covers_what_is_behind_and_nothing_else() {
        let mut buffer = DepthBuffer::new(40, 40);
        buffer.put(20, 20, 10.0, 1);
        for (x, depth) in [(22, 30.0), (18, 10.5)] {
            buffer.put(x, 20, depth, 1 + (1 << OBJECT_BIT));
        }
        let seen = splat(&buffer, 0.5);
        let at = |x: usize| seen.codes()[20 * 40 + x] & SEEN_MASK;
        assert_eq!((at(22), at(20), at(18)), (1, 1, 1 + (1 << OBJECT_BIT)));
    }

    #[test]
    fn nothing_and_what_is_endless_is_no_harm() {
        assert_eq!(splat(&DepthBuffer::new(40, 40), 1.0).lit(), 0);
        for gap in [f32::NAN, f32::INFINITY, 0.0, -1.0] {
            let mut buffer = DepthBuffer::new(40, 40);
            buffer.put(0, 0, 10.0, 1);
            assert!(splat(&buffer, gap).lit() <= 16 * 16);
        }
    }
}
