//! Pictures of a bent attractor.
//!
//! A bend takes each piece of the attractor somewhere of its own. Pieces are taken apart, word by word, until the bend
//! is so even inside of one that its anchors say where all of it goes: then the piece is [`Placed`] by one map, and
//! drawn as if nothing were bent, a [`BentPlan`] as points by the graphics card, a [`BentSweep`] on the processor.

mod anchor_error;
mod cutter;
mod density;
mod draft;
mod eye;
mod moving;
mod placed;
mod plan;
mod sweep;
#[cfg(test)]
mod tests;

use frond_deform::{Bend, Continuity, Cursor};
use glam::DVec2;

pub use anchor_error::AnchorError;
pub use cutter::{Cut, Cutter, Piece};
pub use draft::{complete_codes, draft_codes};
pub use eye::Eye;
pub use moving::Moving;
pub use placed::{Placed, Sides};
pub use plan::BentPlan;
pub use sweep::BentSweep;

use crate::picture::colour::pack_colour;
use crate::picture::view::View;
use crate::picture::window::{Extent, Window};
use crate::pieces::frame::Frame;

/// A bent attractor and how it is looked at.
#[derive(Debug)]
pub struct Bent<'a> {
    /// The attractor.
    pub frame: &'a Frame,
    /// What bends it.
    pub bend: &'a Bend,
    /// What is drawn to.
    pub window: Window,
    pub(crate) eye: Eye,
    pub(crate) sides: Sides,
    anchor_error: &'a AnchorError,
    /// Points of the unit disc where large pieces are looked at.
    probes: Vec<DVec2>,
    /// Larger ones, in pixels, are.
    small: f64,
    /// No point is displaced by more pixels.
    reach: f64,
}

/// How finely pieces are cut, in pixels of what is drawn to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// The size of the largest pieces.
    pub size: f64,
    /// Pieces of this size are not cut any more, even if the bend is uneven inside of them.
    pub floor: f64,
    /// How far out of the window pieces are kept, for when the mesh moves; and whether they are to hold for whatever
    /// the mesh does.
    pub margin: Option<f64>,
    /// Whether pieces are to be placed by affine maps.
    pub affine: bool,
    /// The largest part of the measure that a piece may have.
    pub mass: f64,
    /// How far off a point of a piece may be drawn.
    pub tolerance: f64,
}

impl Fineness {
    /// Complete, with pieces of at most a size.
    pub const fn complete(size: f64) -> Self {
        Self { size, floor: 0.0, margin: None, affine: false, mass: 1.0, tolerance: 1.0 / 64.0 }
    }
}

/// What to do with a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// None of it is seen.
    Outside,
    /// It is to be taken apart.
    Split,
    /// It can be drawn so.
    Whole(Placed),
    /// It is drawn so, because smaller ones are not asked for.
    Rough(Placed),
}

/// Pieces below this many pixels are even enough, those below the second are looked at in one place.
const EVEN_SIZE: f64 = 1.5;
const ONE_PROBE_SIZE: f64 = 12.0;
/// How much a piece may be twisted that is to be placed by an affine map, in pixels.
const MOST_TWIST: f64 = 0.25;
/// How many tips of a large piece are looked at, and of its parts.
const TIPS_PROBED: (usize, usize) = (4, 12);
/// How much farther off a point may be than those that are looked at.
const UNSEEN_FACTOR: f64 = 3.0;
/// The same for a piece that still has uneven parts: it goes with its anchors if all of it is within this.
const SPECK_SIZE: f64 = 0.5;

impl<'a> Bent<'a> {
    /// A bent attractor in a view of `window`, drawn with `factor` times as many pixels each way as `target` has.
    /// `anchor_error` is that of the frame and the bend.
    #[must_use]
    pub fn new(
        frame: &'a Frame,
        bend: &'a Bend,
        anchor_error: &'a AnchorError,
        (view, window): (View, Window),
        (target, factor): (Window, f64),
    ) -> Self {
        let eye = Eye::new(view, window, factor);
        let sides = Sides::of(bend.anchors(), frame.to_world);
        // Tips may be anchors, which are never off.
        let inner = frame.maps.iter().flat_map(|map| frame.tips.iter().map(|tip| map.apply(*tip)));
        let probes =
            frame.tips.iter().copied().take(TIPS_PROBED.0).chain(inner.take(TIPS_PROBED.1)).collect();
        let reach = bend.reach() * eye.scale();
        // What is read off a grid or a triangulation has folds.
        let folds =
            matches!(bend.continuity(), Continuity::Splat | Continuity::Average | Continuity::Published);
        let small = if folds { EVEN_SIZE } else { ONE_PROBE_SIZE };
        Self { frame, bend, window: target, eye, sides, anchor_error, probes, small, reach }
    }

    /// Where the anchors of a piece say that it goes.
    #[inline]
    pub fn placed(&self, cursor: &Cursor) -> Placed {
        self.sides.placed(bend_to(self.bend.displaced(cursor), &self.eye))
    }

    /// Looks at a piece whose word has so many letters and that has a part of the measure. With the verdict comes
    /// where the piece may be seen.
    pub fn judge(
        &self,
        cursor: &Cursor,
        letters: usize,
        mass: f64,
        fineness: &Fineness,
    ) -> (Verdict, Option<Extent>) {
        let margin = fineness.margin.unwrap_or(0.0);
        let rest = self.eye.onto(&(cursor.map() * self.frame.to_world));
        let far = self.window.extent_within(&rest, self.reach + margin);
        if far.is_none() {
            return (Verdict::Outside, None);
        }
        let placed = self.placed(cursor);
        let (size, wobble) = (placed.size(), placed.wobble());
        let anchor_error = self.anchor_error.at(letters) * self.eye.scale();
        let even = self.bend.even(cursor);
        let (smooth, off) = if even {
            let miss = self.miss(cursor, &placed, size);
            (miss <= fineness.tolerance, UNSEEN_FACTOR * miss)
        } else {
            (fineness.margin.is_none() && anchor_error <= fineness.tolerance, anchor_error)
        };
        let near = self.window.extent_within(&placed.map, wobble + off + fineness.tolerance + margin);
        if near.is_none() {
            return (Verdict::Outside, None);
        }
        let straight = !fineness.affine || wobble <= MOST_TWIST;
        let large = size.max(2.0 * rest.norm());
        let fits = smooth && straight && size <= fineness.size && mass <= fineness.mass;
        let speck = !even && large + anchor_error <= SPECK_SIZE;
        // Each piece needs a colour, so that the whole shape has to be taken apart at least once.
        let verdict = if letters == 0 {
            Verdict::Split
        } else if fits || speck {
            Verdict::Whole(placed)
        } else if large <= fineness.floor {
            Verdict::Rough(placed)
        } else {
            Verdict::Split
        };
        (verdict, near)
    }

    /// How far points of a piece are from where its anchors say.
    fn miss(&self, cursor: &Cursor, placed: &Placed, size: f64) -> f64 {
        if size <= EVEN_SIZE {
            return 0.0;
        }
        let off = |point: &DVec2| {
            let seen = self.eye.at(self.bend.point(cursor, self.frame.to_world.apply(*point)));
            (seen - placed.at(*point)).length()
        };
        let middle = off(&self.frame.anchor);
        if size <= self.small {
            return middle;
        }
        self.probes.iter().map(off).fold(middle, f64::max)
    }

    /// The colour that the bend carries to a piece, eight bits each; 0 where it carries none.
    pub fn tint(&self, cursor: &Cursor) -> u32 {
        let middle = self.frame.to_world.apply(self.frame.anchor);
        self.bend.colour(cursor, middle).map_or(0, pack_colour)
    }

    /// Whether the bend carries colours.
    #[must_use]
    pub fn has_colours(&self) -> bool {
        self.bend.colour(&self.bend.whole(), self.frame.to_world.translation).is_some()
    }
}

/// What is seen of points of the plane.
#[inline]
fn bend_to(points: [DVec2; 4], eye: &Eye) -> [DVec2; 4] {
    points.map(|point| eye.at(point))
}
