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
        let (tones, depths) = self.depths(mask);
        let mut filled = Bits::new(right - left, bottom - top);
        let mut values = vec![0.0; filled.on.len()];
        let rows = filled.on.chunks_exact_mut(right - left).zip(values.chunks_exact_mut(right - left));
        for (y, (row, values)) in rows.enumerate() {
            let start = (top + y) * self.width + left;
            for (on, &label) in row.iter_mut().zip(&mask.labels[start..]) {
                *on = label == component as u32;
            }
            match tones {
                Some(tones) => {
                    for ((value, &on), &tone) in values.iter_mut().zip(&*row).zip(&tones[start..]) {
                        *value = depths[usize::from(on)][usize::from(tone)];
                    }
                }
                None => values.iter_mut().zip(&*row).for_each(|(value, &on)| *value = mended(on)),
            }
        }
        let field =
            Field { width: filled.width, height: filled.height, values: smooth(&values, filled.width) };
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

    /// How far inside a pixel is, -1 to 1: its tone, and what comes of each, first where it is off, then where it is
    /// on. With no tones nothing stands out.
    #[inline(never)]
    fn depths<'a>(&'a self, mask: &'a Mask) -> (Option<&'a [u8]>, [[f32; 256]; 2]) {
        let of = |soft: &dyn Fn(u8) -> f32| {
            let mut depths = [[0.0; 256]; 2];
            for (on, depths) in [false, true].into_iter().zip(&mut depths) {
                for (tone, depth) in (0..=u8::MAX).zip(depths) {
                    let soft = soft(tone);
                    *depth = if on == (soft > 0.0) { soft } else { mended(on) };
                }
            }
            depths
        };
        if let Some(cover) = &mask.cover {
            return (Some(cover), of(&|tone| f32::from(tone) / 127.5 - 1.0));
        }
        let seen = match &self.frame {
            Some(frame) if !mask.framed => frame.whole(self.width, self.height),
            _ => &self.inner,
        };
        let Some(choice) = seen.stands_out() else { return (None, [[0.0; 256]; 2]) };
        let soft = |tone: u8| {
            let value = f64::from(tone) - mask.level;
            // From the middle to either class: there an edge that is cut by a pixel is straight.
            let half =
                if value > 0.0 { choice.level.bright - mask.level } else { mask.level - choice.level.dark };
            let inside = (value / half.max(4.0)).clamp(-1.0, 1.0);
            if mask.inverted { -inside as f32 } else { inside as f32 }
        };
        (Some(&choice.likeness), of(&soft))
    }
}

/// How far inside a pixel is where the mask was mended.
fn mended(on: bool) -> f32 {
    if on { 0.5 } else { -0.5 }
}

/// How many holes that can be seen a piece has, or had before they were filled; `piece` is it with a rim round it.
#[inline(never)]
fn holes(mask: &Mask, component: usize, piece: &Bits) -> usize {
    let least = (mask.components[component].area / SEEN_HOLE).max(LEAST_HOLE);
    let filled =
        mask.filled.iter().filter(|(at, area)| *area >= least && mask.labels[*at] == component as u32);
    let open = parts(piece, false, false);
    let seen = |hole: &&Component| !hole.touches_border && hole.area >= least;
    filled.count() + open.all.iter().filter(seen).count()
}

/// Each value averaged with its neighbours: 1, 2, 1 across and down.
#[inline(never)]
fn smooth(values: &[f32], width: usize) -> Vec<f32> {
    let mut across = vec![0.0; values.len()];
    for (row, sums) in values.chunks_exact(width).zip(across.chunks_exact_mut(width)) {
        let sum = |x: usize| row[x.saturating_sub(1)] + 2.0 * row[x] + row[(x + 1).min(width - 1)];
        (sums[0], sums[width - 1]) = (sum(0), sum(width - 1));
        for (near, sum) in row.windows(3).zip(&mut sums[1..]) {
            *sum = near[0] + 2.0 * near[1] + near[2];
        }
    }
    let height = values.len() / width;
    let row = |y: usize| &across[y * width..(y + 1) * width];
    let mut smoothed = Vec::with_capacity(values.len());
    for y in 0..height {
        let (above, here, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(height - 1)));
        smoothed.extend(above.iter().zip(here).zip(below).map(|((a, b), c)| (a + 2.0 * b + c) / 16.0));
    }
    smoothed
}
