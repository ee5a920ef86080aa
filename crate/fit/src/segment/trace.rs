//! The line round a piece of a mask.

use glam::DVec2;

use super::Tracer;
use super::binary_image::Bits;
use super::components::{Component, parts};
use super::contour::{Field, area};
use super::mask::Mask;
use super::notice::{Notice, TraceError};
use crate::outline::{MAX_OUTLINE, thinned};

/// Holes of so few pixels, and smaller parts of a piece than this, are specks that nobody misses.
const LEAST_HOLE: usize = 16;
const SEEN_HOLE: usize = 2000;

/// The line round a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// Counter-clockwise, closed, the first not repeated; in pixels, y up, from the lower left corner of the picture.
    /// At most [`MAX_OUTLINE`].
    pub points: Vec<DVec2>,
    /// What may be amiss.
    pub notices: Vec<Notice>,
}

impl Traced {
    /// The area inside, in pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        let Some(&first) = self.points.first() else { return 0.0 };
        self.sides().map(|(a, b)| (a - first).perp_dot(b - first)).sum::<f64>() / 2.0
    }

    /// The length all round, in pixels.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.sides().map(|(a, b)| a.distance(b)).sum()
    }

    fn sides(&self) -> impl Iterator<Item = (DVec2, DVec2)> {
        self.points.iter().copied().zip(self.points.iter().copied().cycle().skip(1))
    }
}

impl Tracer {
    /// The line round a piece of a mask of this picture, at a fraction of a pixel: where the likeness to the leaf
    /// crosses the mask's level, and between pixels where the mask was mended.
    ///
    /// # Errors
    /// Where there is no such piece, or it is too small.
    pub fn outline(&self, mask: &Mask, component: usize) -> Result<Traced, TraceError> {
        let count = mask.components.len();
        let Some(part) = mask.components.get(component) else { return Err(TraceError::NoPiece { count }) };
        if (mask.width, mask.height) != (self.width, self.height) {
            return Err(TraceError::NoPiece { count: 0 });
        }
        let [left, top, right, bottom] = part.bounds;
        // Two pixels round it: smoothing pushes the line out by less.
        let (left, top) = (left.saturating_sub(2), top.saturating_sub(2));
        let (right, bottom) = ((right + 2).min(self.width), (bottom + 2).min(self.height));
        let mut filled = Bits::new(right - left, bottom - top);
        for (y, row) in filled.on.chunks_exact_mut(right - left).enumerate() {
            let start = (top + y) * self.width + left;
            for (on, &label) in row.iter_mut().zip(&mask.labels[start..]) {
                *on = label == component as u32;
            }
        }
        let values = (0..filled.on.len()).map(|i| {
            let (x, y) = (left + i % filled.width, top + i / filled.width);
            self.depth(mask, filled.on[i], y * self.width + x)
        });
        let field = Field {
            width: filled.width,
            height: filled.height,
            values: smooth(&values.collect::<Vec<_>>(), filled.width),
        };
        let (x0, y0) = (left as f64, (self.height - top) as f64);
        let mut points: Vec<DVec2> = field.contour().iter().map(|p| DVec2::new(x0 + p.x, y0 - p.y)).collect();
        // Marching goes clockwise.
        points.reverse();
        points.dedup_by(|a, b| a.distance_squared(*b) < 1e-12);
        if points.len() < 4 || area(&points) < 1.0 {
            return Err(TraceError::TooSmall);
        }
        let mut notices = Vec::new();
        if part.touches_border {
            notices.push(Notice::TouchesBorder);
        }
        let holes = holes(mask, component, &filled);
        if holes > 0 {
            notices.push(Notice::Holes(holes));
        }
        if points.len() > MAX_OUTLINE {
            notices.push(Notice::Thinned(points.len()));
            points = thinned(&points, MAX_OUTLINE);
        }
        Ok(Traced { points, notices })
    }

    /// How far inside a pixel is, -1 to 1.
    fn depth(&self, mask: &Mask, on: bool, i: usize) -> f32 {
        if let Some(cover) = &mask.cover {
            let soft = f32::from(cover[i]) / 127.5 - 1.0;
            return match (on, soft > 0.0) {
                (true, true) | (false, false) => soft,
                (true, false) => 0.5,
                (false, true) => -0.5,
            };
        }
        let seen = match &self.frame {
            Some(frame) if !mask.framed => frame.whole(self.width, self.height),
            _ => &self.inner,
        };
        let Some(choice) = seen.stands_out() else { return if on { 0.5 } else { -0.5 } };
        let soft = {
            let value = f64::from(choice.likeness[i]) - mask.level;
            // From the middle to either class: there an edge that is cut by a pixel is straight.
            let half =
                if value > 0.0 { choice.level.bright - mask.level } else { mask.level - choice.level.dark };
            let inside = (value / half.max(4.0)).clamp(-1.0, 1.0);
            if mask.inverted { -inside } else { inside }
        };
        match (on, soft > 0.0) {
            (true, true) | (false, false) => soft as f32,
            (true, false) => 0.5,
            (false, true) => -0.5,
        }
    }
}

/// How many holes that can be seen a piece has, or had before they were filled; `piece` is it with a rim round it.
fn holes(mask: &Mask, component: usize, piece: &Bits) -> usize {
    let least = (mask.components[component].area / SEEN_HOLE).max(LEAST_HOLE);
    let filled =
        mask.filled.iter().filter(|(at, area)| *area >= least && mask.labels[*at] == component as u32);
    let open = parts(piece, false, false);
    let seen = |hole: &&Component| !hole.touches_border && hole.area >= least;
    filled.count() + open.all.iter().filter(seen).count()
}

/// Each value averaged with its neighbours: 1, 2, 1 across and down.
fn smooth(values: &[f32], width: usize) -> Vec<f32> {
    let height = values.len() / width.max(1);
    let row = |x: usize, y: usize| {
        let at = |x: usize| values[y * width + x];
        at(x.saturating_sub(1)) + 2.0 * at(x) + at((x + 1).min(width - 1))
    };
    let across: Vec<f32> = (0..values.len()).map(|i| row(i % width, i / width)).collect();
    let column = |x: usize, y: usize| {
        let at = |y: usize| across[y * width + x];
        (at(y.saturating_sub(1)) + 2.0 * at(y) + at((y + 1).min(height - 1))) / 16.0
    };
    (0..values.len()).map(|i| column(i % width, i / width)).collect()
}
