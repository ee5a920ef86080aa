//! What a graphics card needs to draw the points of a picture: those of all clouds, and the pieces that place them.

use bytemuck::{Pod, Zeroable};
use frond_core::Affine2;

use super::cloud::{COUNT, Clouds};
use super::parts::{PIECE, Part, Parts, SPACING, finer};
use super::place::{Placement, SHIFT};
use super::whole::{LOW_SHIFT, split_point};
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::{KEPT, kept_letters};

/// A picture as points: all pieces of the attractor in the window, each with the points of a cloud.
#[derive(Debug, Default)]
pub struct SplatPlan {
    /// The points of the clouds.
    pub points: Vec<PlannedPoint>,
    /// The pieces.
    pub pieces: Vec<PlacedPiece>,
    /// How many points the pieces place.
    pub count: u64,
    /// The letters of a code that are kept.
    pub kept: u32,
    /// The places of a row.
    width: u32,
    /// The clouds of a frame, for as long as it is drawn, at each distance of points.
    clouds: [Option<(f64, Clouds)>; 2],
}

/// What `shader/splat.wgsl` calls `Point`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct PlannedPoint {
    /// High parts first.
    position: [[i16; 2]; 2],
    letters: u32,
}

/// What `shader/splat.wgsl` calls `Piece`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct PlacedPiece {
    /// Row by row, high parts first.
    linear: [[[i16; 2]; 2]; 2],
    translation: [u32; 2],
    corner: u32,
    size: [u16; 2],
    letters: u32,
    points: [u32; 2],
}

/// Where the count of letters begins in a piece.
const COUNT_BIT: u32 = 6 * KEPT as u32;
/// Points for each pixel of the window, and on top, before pieces overlap too much: a card that draws them all takes as
/// long as for planning them.
const MOST_POINTS: (u64, u64) = (16, 4_000_000);

impl SplatPlan {
    /// Forgets the shape: the next one is of another frame.
    pub fn forget(&mut self) {
        self.clouds = [None, None];
    }

    /// Plans the attractor under `to_screen`, from unit coordinates of the frame to pixels, where a row of the window
    /// has `width` places. Returns whether pieces do not overlap too much for that; if they do, the plan is of no use.
    pub fn make(&mut self, frame: &Frame, to_screen: Affine2, window: Window, width: u32) -> bool {
        self.points.clear();
        self.pieces.clear();
        self.count = 0;
        self.width = width;
        self.kept = kept_letters(frame.maps.len());
        to_screen.is_finite() && self.add(frame, to_screen, window, 0, SPACING)
    }

    /// Adds points nearer to each other where about `points` of them in all make that worth while, as
    /// [`Splats::draw`](super::Splats::draw) does.
    pub fn refine(&mut self, frame: &Frame, to_screen: Affine2, window: Window, points: u64) -> bool {
        finer(self.count, points).is_none_or(|spacing| self.add(frame, to_screen, window, 1, spacing))
    }

    fn add(&mut self, frame: &Frame, to_screen: Affine2, window: Window, round: usize, spacing: f64) -> bool {
        let kept = self.clouds[round].take().filter(|(of, _)| *of == spacing);
        let (_, mut clouds) = kept.unwrap_or_else(|| (spacing, Clouds::new(frame, PIECE, spacing)));
        let most = self.count + MOST_POINTS.0 * window.area() as u64 + MOST_POINTS.1;
        let mut ranges = [None; COUNT];
        let mut parts = Parts::new(frame, to_screen, window);
        while let Some(Part { map, letters, size, extent }) = parts.next(|_| false) {
            let which = clouds.which(size);
            let points = *ranges[which].get_or_insert_with(|| {
                let first = self.points.len() as u32;
                self.points.extend(clouds.get(which).points.iter().map(|point| PlannedPoint {
                    position: split_point(point.position),
                    letters: point.letters.packed(),
                }));
                [first, self.points.len() as u32 - first]
            });
            let Placement { linear, translation, corner, size, .. } =
                Placement::new(&map, self.width, &extent);
            self.pieces.push(PlacedPiece {
                linear,
                translation,
                corner,
                size: size.map(|side| side as u16),
                letters: letters.with_count(),
                points,
            });
            self.count += u64::from(points[1]);
            if self.count > most {
                parts.too_many = true;
                break;
            }
        }
        self.clouds[round] = Some((spacing, clouds));
        !parts.too_many
    }

    /// Places the points of pieces as a card does, from the one of this number on and about so many points: tells the
    /// place of each and its code. Returns the number of the next piece.
    pub fn place(&self, from: usize, mut budget: u64, mut put: impl FnMut(usize, u32)) -> usize {
        let mut at = from;
        while let Some(piece) = self.pieces.get(at).filter(|_| budget > 0) {
            let [first, count] = piece.points;
            budget = budget.saturating_sub(u64::from(count));
            for point in &self.points[first as usize..(first + count) as usize] {
                if let Some([x, y]) = piece.pixel(point.position) {
                    put((piece.corner + y * self.width + x) as usize, piece.code(point.letters, self.kept));
                }
            }
            at += 1;
        }
        at
    }
}

impl PlacedPiece {
    /// Where a point is from the first pixel of the box, if it is in the box.
    #[inline]
    fn pixel(&self, [high, low]: [[i16; 2]; 2]) -> Option<[u32; 2]> {
        let dot =
            |[a, b]: [i16; 2], [x, y]: [i16; 2]| i32::from(a) * i32::from(x) + i32::from(b) * i32::from(y);
        let along = |axis: usize| {
            let [row, small] = self.linear[axis];
            let rest = (dot(small, high) + dot(row, low)) >> LOW_SHIFT;
            ((dot(row, high) + rest) as u32).wrapping_add(self.translation[axis]) >> SHIFT
        };
        let (x, y) = (along(0), along(1));
        (x < u32::from(self.size[0]) && y < u32::from(self.size[1])).then_some([x, y])
    }

    /// The code of a point with these letters.
    #[inline]
    fn code(&self, letters: u32, kept: u32) -> u32 {
        let count = self.letters >> COUNT_BIT;
        ((self.letters & ((1 << COUNT_BIT) - 1) | letters >> (6 * count)) & kept) + 1
    }
}

#[cfg(test)]
mod tests {
    use frond_core::{Affine2, Hull, Ifs};

    use super::*;
    use crate::picture::view::View;
    use crate::pieces::letters::Code;
    use crate::splat::Splats;
    use crate::testing::{NASTY, PLAIN, ifs, some_ifs};

    const WINDOW: Window = Window { width: 250, height: 180 };
    /// Places of a row: more than pixels.
    const ROW: u32 = 256;

    /// The codes of a plan that is placed in portions, those of the processor, and whether there is a plan.
    fn both(ifs: &Ifs, zoom: f64, points: u64) -> Option<[Vec<u32>; 2]> {
        let hull = Hull::of(ifs);
        let frame = Frame::within(ifs, &hull);
        let fit = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
        let at = frame.to_world.apply(frame.anchor);
        let view = if zoom > 1.0 { View { x: at.x, y: at.y, scale: fit.scale * zoom } } else { fit };
        let to_screen = view.onto_screen(frame.to_world, WINDOW);
        let mut plan = SplatPlan::default();
        if !plan.make(&frame, to_screen, WINDOW, ROW) {
            return None;
        }
        let splats = Splats::draw(&frame, to_screen, WINDOW, points);
        // A card has more points to spare.
        if !splats.whole {
            return None;
        }
        if points > 0 {
            assert!(plan.refine(&frame, to_screen, WINDOW, points));
        }
        let mut placed = vec![0; (ROW * WINDOW.height) as usize];
        let mut next = 0;
        while next < plan.pieces.len() {
            next = plan.place(next, 5000, |at, code| placed[at] = placed[at].max(code));
        }
        let rows = placed.chunks(ROW as usize);
        assert!(rows.clone().all(|row| row[WINDOW.width as usize..].iter().all(|code| *code == 0)));
        let placed = rows.flat_map(|row| &row[..WINDOW.width as usize]).copied().collect();
        Some([placed, splats.codes.into_iter().map(Code::code).collect()])
    }

    #[test]
    fn a_plan_has_the_pixels_of_the_processor_bit_for_bit() {
        let random = (0..frond_testing::cases(40)).map(|seed| (format!("some {seed}"), some_ifs(seed)));
        let plain = PLAIN.iter().map(|name| ((*name).to_owned(), ifs(name)));
        let mut seen = 0;
        for (name, ifs) in plain.chain(random) {
            for zoom in [1.0, 300.0] {
                let Some([placed, drawn]) = both(&ifs, zoom, 0) else { continue };
                let lit = drawn.iter().filter(|code| **code > 0).count();
                assert!(placed == drawn, "{name} x{zoom}, {lit} lit");
                seen += usize::from(lit > 100);
            }
        }
        assert!(seen > PLAIN.len() + 20, "{seen}");
    }

    #[test]
    fn more_maps_than_32_have_the_same_two_letters() {
        let side = Affine2::from_row([0.09, 0.0, 0.0, 0.09, 0.0, 0.0]);
        let maps = (0..49).map(|i| {
            Affine2::from_row([1.0, 0.0, 0.0, 1.0, f64::from(i % 7) * 0.13, f64::from(i / 7) * 0.13]) * side
        });
        let [placed, drawn] = both(&Ifs::new(maps.collect()).unwrap(), 1.0, 0).unwrap();
        assert!(placed == drawn && drawn.iter().filter(|code| **code > 0).count() > 1000);
    }

    #[test]
    fn points_nearer_to_each_other_are_added() {
        let [coarse, _] = both(&ifs("gasket"), 1.0, 0).unwrap();
        let [fine, drawn] = both(&ifs("gasket"), 1.0, 4_000_000).unwrap();
        assert!(
            fine.iter().zip(&coarse).all(|(fine, coarse)| fine >= coarse) && fine != coarse && fine == drawn
        );
    }

    #[test]
    fn what_overlaps_without_end_has_no_plan() {
        for name in NASTY.iter().filter(|name| name.starts_with("overlap")) {
            let hull = Hull::of(&ifs(name));
            let frame = Frame::within(&ifs(name), &hull);
            let view = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
            let mut plan = SplatPlan::default();
            assert!(!plan.make(&frame, view.onto_screen(frame.to_world, WINDOW), WINDOW, ROW), "{name}");
            assert!(plan.count < 10_000_000, "{name}: {}", plan.count);
        }
    }
}
