//! The pieces that points are drawn for.

use frond_core::Affine2;

use super::place::SLACK;
use crate::picture::window::{Extent, PixelBox, Window};
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;

/// The largest of them, in pixels.
pub const PIECE: f64 = 48.0;
/// The distance of points, in pixels: with less than one to a pixel there would be holes.
pub const SPACING: f64 = 0.85;
/// A second time with points nearer to each other is worth while from such a distance on, and none is nearer than this.
const FINER: (f64, f64) = (0.7, 0.3);
/// Pieces looked at, before they overlap too much.
const MOST_VISITS: u64 = 300_000;

/// Takes an attractor apart into pieces in the window, later maps first.
pub struct Parts<'a> {
    frame: &'a Frame,
    window: Window,
    stack: Vec<(Affine2, Letters)>,
    visits: u64,
    /// Whether it ended since there were too many.
    pub too_many: bool,
}

/// One of them.
pub struct Part {
    /// From unit coordinates to pixels.
    pub map: Affine2,
    /// The first letters of its word, one at least.
    pub letters: Letters,
    /// The longer axis of its ellipse, in pixels.
    pub size: f64,
    pub extent: Extent,
}

impl<'a> Parts<'a> {
    /// Those of the attractor under `to_screen`, from unit coordinates of the frame to pixels.
    pub fn new(frame: &'a Frame, to_screen: Affine2, window: Window) -> Self {
        Self { frame, window, stack: vec![(to_screen, Letters::NONE)], visits: 0, too_many: false }
    }

    /// The next one. Pieces with all of their pixels hidden are left out: nothing of them would be seen, for what is
    /// there is of later maps.
    #[inline]
    pub fn next(&mut self, hidden: impl Fn(PixelBox) -> bool) -> Option<Part> {
        while let Some((map, letters)) = self.stack.pop() {
            self.visits += 1;
            if self.visits > MOST_VISITS {
                self.too_many = true;
                return None;
            }
            let Some(extent) = extent(self.window, &map) else { continue };
            if letters.count() > 0 {
                if hidden(extent.pixels) {
                    continue;
                }
                let size = 2.0 * map.norm();
                if size <= PIECE {
                    return Some(Part { map, letters, size, extent });
                }
            }
            let parts = self.frame.maps.iter().enumerate();
            self.stack.extend(parts.map(|(i, part)| (map * *part, letters.then(i))));
        }
        None
    }
}

/// Where a piece is, with what rounding may add: a piece whose box is left out puts no point anywhere else.
#[inline(never)]
fn extent(window: Window, map: &Affine2) -> Option<Extent> {
    window.extent_within(map, SLACK)
}

/// How near points are the second time, where so many were drawn the first time and there may be about `points` in all.
pub fn finer(first: u64, points: u64) -> Option<f64> {
    let spacing = SPACING * (first as f64 / points.saturating_sub(first).max(1) as f64).sqrt();
    (spacing < FINER.0).then_some(spacing.max(FINER.1))
}
