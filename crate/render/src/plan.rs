//! What to draw for a picture: clouds, and pieces that place them.

mod placed;

use std::ops::Range;

use frond_core::Affine2;
use glam::{DMat2, DVec2};
pub use placed::PlacedPoints;

use crate::coverage::flood::Flood;
use crate::coverage::sweep::{Sweep, Walk};
use crate::picture::window::Window;
use crate::pieces::cut::{Piece, cut, cut_roughly};
use crate::pieces::frame::Frame;
use crate::points::{Instance, Sides, Vertex};

/// Instances of one cloud.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Batch {
    /// Which of the vertices.
    pub vertices: Range<u32>,
    /// Which of the instances.
    pub instances: Range<u32>,
}

impl Batch {
    /// How many points it has.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.vertices.len() as u64 * self.instances.len() as u64
    }
}

/// How fine a [`Plan`] is, in pixels of what is drawn to.
///
/// Pieces of the attractor are followed down to `leaf` pixels; then their tips are taken, one for each
/// cell of `cell` pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// The size of the smallest pieces.
    pub leaf: f64,
    /// The distance of points.
    pub cell: f64,
}

impl Detail {
    /// From coarse to fine. The first leaves no hole in a shape that fills the plane. By the last a pixel is
    /// missed only if the attractor reaches into it by hardly more than a sixteenth.
    pub const LADDER: [Self; 6] = [
        Self { leaf: 0.25, cell: 0.5 },
        Self { leaf: 0.5, cell: 0.25 },
        Self { leaf: 0.5, cell: 0.125 },
        Self { leaf: 0.25, cell: 0.125 },
        Self { leaf: 0.125, cell: 0.0625 },
        Self { leaf: 0.0625, cell: 0.03125 },
    ];
}

/// A picture as points: every piece of the attractor in the window, each with a cloud fine enough for it.
///
/// Composing two short lists on the graphics card gives many points for little work here: a thousand pieces
/// times a thousand points of the attractor are a million. The pieces are taken to the screen in `f64`, so
/// that the picture is crisp however far one zooms in, and rounded there.
#[derive(Debug, Default)]
pub struct Plan {
    /// The clouds, one after the other.
    pub vertices: Vec<Vertex>,
    /// The pieces, those for one cloud together.
    pub instances: Vec<Instance>,
    /// Which pieces get which cloud.
    pub batches: Vec<Batch>,
    /// Whether these are all the pieces, each with all of its points.
    pub exact: bool,
    /// Whether the pieces have colours of their own.
    pub tinted: bool,
    /// Along which sides the pieces are twisted, where the shape is bent.
    pub sides: Sides,
    pieces: Vec<Piece>,
    /// How many times larger than usual the pieces had to be last time, as a power of two.
    doublings: u32,
    made: u32,
}

/// The most pieces of a plan.
const MOST_PIECES: usize = 20_000;
/// The largest pieces, in pixels, that the usual size is doubled to where there are too many.
const LARGEST_PIECE: f64 = 256.0;
/// The number of clouds: each is for pieces of half the size of those before.
const CLOUD_COUNT: i32 = 7;
/// Visits for a cloud.
const VISITS_A_CLOUD: u64 = 1_000_000;
/// Pieces taken by chance where there are too many.
const SOME_PIECES: usize = 48;
/// The finest grid for the cloud of those.
const FINEST_GRID: f64 = 1024.0;

impl Plan {
    /// Plans some points of a picture, whatever pieces overlap.
    pub fn make_roughly(&mut self, frame: &Frame, to_screen: Affine2, window: Window, detail: Detail) {
        self.clear();
        let Some(extent) = window.extent_once(&to_screen) else { return };
        self.exact = false;
        self.improvise(frame, to_screen, window, extent.size, detail);
    }

    fn clear(&mut self) {
        self.vertices.clear();
        self.instances.clear();
        self.batches.clear();
        self.exact = true;
    }

    /// Plans a picture.
    pub fn make(&mut self, frame: &Frame, to_screen: Affine2, window: Window, detail: Detail) {
        self.clear();
        let Some(extent) = window.extent(&to_screen) else { return };
        let seen = extent.size.min(f64::from(window.width.max(window.height)));
        if let Some(size) = self.cut(frame, to_screen, window, seen, detail) {
            self.compose(frame, size, detail);
        } else {
            self.exact = false;
            self.improvise(frame, to_screen, window, extent.size, detail);
        }
    }

    /// Finds the pieces and returns their largest size, or `None` if there are too many.
    fn cut(
        &mut self,
        frame: &Frame,
        to_screen: Affine2,
        window: Window,
        seen: f64,
        detail: Detail,
    ) -> Option<f64> {
        // As many pieces as points in a cloud is the least work here.
        let usual = (seen * detail.cell).sqrt().clamp(8.0 * detail.cell, 64.0);
        // Once in a while a smaller size is tried: the shape may have changed.
        self.made = self.made.wrapping_add(1);
        if self.made.is_multiple_of(16) {
            self.doublings = self.doublings.saturating_sub(1);
        }
        loop {
            let size = usual * f64::from(1_u32 << self.doublings);
            if cut(frame, to_screen, window, size, MOST_PIECES, &mut self.pieces) {
                return Some(size);
            }
            if 2.0 * size > LARGEST_PIECE {
                return None;
            }
            self.doublings += 1;
        }
    }

    /// Gives each piece the coarsest cloud that is fine enough for it.
    fn compose(&mut self, frame: &Frame, size: f64, detail: Detail) {
        for octave in 0..CLOUD_COUNT {
            let upper = size * 0.5_f64.powi(octave);
            let lower = if octave + 1 == CLOUD_COUNT { -1.0 } else { 0.5 * upper };
            let first = self.instances.len() as u32;
            let fits = |piece: &&Piece| piece.size <= upper && piece.size > lower;
            let pieces = self.pieces.iter().filter(fits);
            self.instances.extend(pieces.map(|piece| Instance::new(&piece.map, piece.letters, 1.0)));
            let instances = first..self.instances.len() as u32;
            if !instances.is_empty() {
                let vertices = self.cloud(frame, upper, detail);
                self.batches.push(Batch { vertices, instances });
            }
        }
    }

    /// Adds a cloud for pieces of a size.
    pub(crate) fn cloud(&mut self, frame: &Frame, size: f64, detail: Detail) -> Range<u32> {
        let first = self.vertices.len() as u32;
        let side = (size / detail.cell).ceil().clamp(1.0, 8192.0);
        let half = 0.5 * side;
        let to_grid = Affine2::new(DMat2::from_diagonal(DVec2::splat(half)), DVec2::splat(half));
        let window = Window { width: side as u32, height: side as u32 };
        let mut sweep = Sweep::new(frame, to_grid, window, detail.leaf / detail.cell);
        let vertices = &mut self.vertices;
        let walk = sweep.walk(VISITS_A_CLOUD, |hit| {
            let unit = (hit.point - half) / half;
            vertices.push(Vertex::new([unit.x as f32, unit.y as f32], hit.letters, 0.0));
        });
        if walk != Walk::Complete {
            self.exact = false;
            self.vertices.truncate(first as usize);
            self.flood(frame, side);
        }
        first..self.vertices.len() as u32
    }

    /// Where words explode: large pieces, all if the shape is seen whole, else some; and one cloud that
    /// does not depend on words.
    fn improvise(&mut self, frame: &Frame, to_screen: Affine2, window: Window, whole: f64, detail: Detail) {
        let seen = f64::from(window.width.max(window.height));
        cut_roughly(frame, to_screen, window, whole, SOME_PIECES, &mut self.pieces);
        let pieces = self.pieces.iter();
        self.instances.extend(pieces.map(|piece| Instance::new(&piece.map, piece.letters, 1.0)));
        let cells = (whole.min(2.0 * seen) / detail.cell).max(1.0);
        self.flood(frame, cells);
        self.batches.push(Batch {
            vertices: 0..self.vertices.len() as u32,
            instances: 0..self.instances.len() as u32,
        });
    }

    /// Adds a cloud that does not depend on words.
    fn flood(&mut self, frame: &Frame, cells: f64) {
        let mut flood = Flood::new(frame, cells.min(FINEST_GRID) as u32);
        flood.run(VISITS_A_CLOUD);
        let points = flood.points().iter();
        self.vertices.extend(points.map(|point| Vertex::new(point.position, point.letters, 0.0)));
    }

    /// How many points the picture has.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.batches.iter().map(Batch::points).sum()
    }
}

#[cfg(test)]
mod tests {
    use frond_core::Hull;

    use super::*;
    use crate::coverage::complete::swept_codes;
    use crate::picture::view::View;
    use crate::pieces::letters::Code;
    use crate::testing::{NASTY, PLAIN, ifs};

    const WINDOW: Window = Window { width: 240, height: 180 };

    /// What the graphics card makes of a plan.
    fn draw(plan: &Plan) -> Vec<u32> {
        let mut picture = vec![0_u32; WINDOW.area()];
        for batch in &plan.batches {
            let range = |range: &Range<u32>| range.start as usize..range.end as usize;
            for instance in &plan.instances[range(&batch.instances)] {
                for vertex in &plan.vertices[range(&batch.vertices)] {
                    if let Some((x, y)) = instance.place(vertex, &[0.0; 4], WINDOW) {
                        let pixel = &mut picture[(y * WINDOW.width + x) as usize];
                        *pixel = (*pixel).max(instance.code(vertex));
                    }
                }
            }
        }
        picture
    }

    struct Agreement {
        lit: usize,
        missed: usize,
        extra: usize,
        other_map: usize,
    }

    fn compare(name: &str, view: Option<View>, detail: Detail) -> (Plan, Agreement) {
        let ifs = ifs(name);
        let hull = Hull::of(&ifs);
        let frame = Frame::within(&ifs, &hull);
        let view = view.unwrap_or_else(|| View::fit(&hull, WINDOW.width, WINDOW.height, 0.05));
        let to_screen = view.onto_screen(frame.to_world, WINDOW);
        let (truth, _) = swept_codes(&frame, to_screen, WINDOW, 0.02);
        let truth: Vec<u32> = truth.into_iter().map(Code::code).collect();
        let mut plan = Plan::default();
        plan.make(&frame, to_screen, WINDOW, detail);
        let seen = draw(&plan);
        let pairs = || truth.iter().zip(&seen);
        let agreement = Agreement {
            lit: truth.iter().filter(|code| **code > 0).count(),
            missed: pairs().filter(|(a, b)| **a > 0 && **b == 0).count(),
            extra: pairs().filter(|(a, b)| **a == 0 && **b > 0).count(),
            other_map: pairs()
                .filter(|(a, b)| **a > 0 && **b > 0 && (**a - 1) >> 12 != (**b - 1) >> 12)
                .count(),
        };
        (plan, agreement)
    }

    #[test]
    fn the_points_light_the_pixels_of_the_adaptive_cut() {
        for name in PLAIN {
            let (plan, found) = compare(name, None, Detail::LADDER[5]);
            assert!(plan.exact, "{name}");
            let share = |n: usize| n as f64 / found.lit as f64;
            assert!(share(found.missed) < 0.005, "{name}: {} of {} missed", found.missed, found.lit);
            assert!(share(found.extra) < 0.002, "{name}: {} of {} too many", found.extra, found.lit);
            assert!(share(found.other_map) < 0.001, "{name}: {} of another map", found.other_map);
        }
    }

    #[test]
    fn full_shapes_have_no_speckle_even_when_coarse() {
        for name in ["square", "dragon", "levy"] {
            let (plan, found) = compare(name, None, Detail::LADDER[0]);
            assert!(found.missed * 40 < found.lit, "{name}: {} of {} missed", found.missed, found.lit);
            assert!(plan.points() < 32 * found.lit as u64, "{name}: {}", plan.points());
        }
    }

    #[test]
    fn finer_details_miss_less() {
        for name in ["gasket", "fern", "dragon"] {
            let missed: Vec<usize> =
                Detail::LADDER.iter().map(|detail| compare(name, None, *detail).1.missed).collect();
            assert!(missed[2] * 2 < missed[0] && missed[5] * 2 < missed[2], "{name}: {missed:?}");
        }
    }

    #[test]
    fn close_views_are_as_complete_as_far_ones() {
        // The fern's stems are singular maps: there most of the pieces lie side by side.
        for (name, zoom) in [("dragon", 1e6), ("fern", 1e2), ("fern", 1e5), ("gasket", 1e9)] {
            let ifs = ifs(name);
            let frame = Frame::of(&ifs);
            let at = frame.to_world.apply(frame.anchor);
            let fit = View::fit(&Hull::of(&ifs), WINDOW.width, WINDOW.height, 0.05);
            let view = View { x: at.x, y: at.y, scale: fit.scale * zoom };
            let (plan, found) = compare(name, Some(view), Detail::LADDER[2]);
            assert!(plan.exact && found.lit > 200, "{name} {zoom}: {}", found.lit);
            assert!(found.missed * 50 < found.lit, "{name} {zoom}: {} of {} missed", found.missed, found.lit);
            assert!(found.extra * 100 < found.lit, "{name} {zoom}: {} too many", found.extra);
        }
    }

    #[test]
    fn shapes_that_overlap_without_end_are_planned_within_bounds_and_not_called_exact() {
        for name in NASTY {
            for scale in [1.0, 1e4] {
                let hull = Hull::of(&ifs(name));
                let fit = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
                let view = View { scale: fit.scale * scale, ..fit };
                let (plan, found) = compare(name, Some(view), Detail::LADDER[0]);
                assert!(plan.vertices.len() < 1 << 20 && plan.instances.len() <= MOST_PIECES, "{name}");
                if name.starts_with("overlap") && scale == 1.0 {
                    assert!(!plan.exact, "{name}");
                    assert!(found.missed * 10 < found.lit, "{name}: {} of {}", found.missed, found.lit);
                }
            }
        }
    }

    #[test]
    fn there_is_nothing_to_draw_outside_of_the_window() {
        let view = View { x: 1e9, y: 0.0, scale: 1.0 };
        let (plan, _) = compare("gasket", Some(view), Detail::LADDER[0]);
        assert!(plan.batches.is_empty() && plan.points() == 0 && plan.exact);
    }
}
