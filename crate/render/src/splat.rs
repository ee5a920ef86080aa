//! Whole pictures of attractors at rest, quickly enough for every frame of what moves.
//!
//! Each piece of an attractor is an affine image of all of it, so that one cloud of points serves them all. The
//! attractor is taken apart into pieces of some pixels, later maps first. A piece whose pixels are all lit is dropped;
//! the points of the others are drawn through their maps.

pub(crate) mod cloud;
mod parts;
mod place;
mod plan;
mod whole;

use frond_core::Affine2;

use self::cloud::{Cloud, Clouds};
use self::parts::{PIECE, Parts, SPACING, finer};
use self::place::{BEHIND, Placement, each_of_large};
pub use self::plan::SplatPlan;
use crate::coverage::flood::Flood;
use crate::picture::bitmap::Bitmap;
use crate::picture::window::{Extent, PixelBox, Window};
use crate::pieces::cut::cut_roughly;
use crate::pieces::frame::Frame;
use crate::pieces::letters::{Code, KEPT, Letters, ShortCode};

/// The codes of a picture, drawn as points.
#[derive(Debug)]
pub struct Splats {
    window: Window,
    /// One a pixel, row after row.
    pub codes: Vec<ShortCode>,
    /// Whether all pieces were drawn: false where they overlap too much for that.
    pub whole: bool,
    /// The number of maps.
    maps: usize,
    /// How many points were drawn.
    pub points: u64,
}

/// Points for each pixel of the window, and on top, before pieces overlap too much.
const MOST_POINTS: (u64, u64) = (6, 500_000);
/// Where they do: points in all, the pieces drawn of a close view, and the points of a cloud times its maps.
const ROUGH_POINTS: f64 = 3.0e6;
const ROUGH_PIECES: usize = 32;
const ROUGH_STEPS: f64 = 1.5e6;

impl Splats {
    /// Draws the attractor under `to_screen`, from unit coordinates of the frame to pixels, with about `points` points
    /// where that makes it finer.
    #[must_use]
    pub fn draw(frame: &Frame, to_screen: Affine2, window: Window, points: u64) -> Self {
        let mut splats = Self { window, codes: Vec::new(), whole: true, maps: frame.maps.len(), points: 0 };
        // Points outside of the window go behind it.
        splats.codes.resize(window.area() + BEHIND, ShortCode::default());
        if to_screen.is_finite() {
            splats.all(frame, to_screen, points);
        }
        splats.codes.truncate(window.area());
        splats
    }

    fn all(&mut self, frame: &Frame, to_screen: Affine2, points: u64) {
        self.whole = self.pieces(frame, to_screen, SPACING);
        if !self.whole {
            self.rough(frame, to_screen);
        } else if let Some(spacing) = finer(self.points, points) {
            self.pieces(frame, to_screen, spacing);
        }
    }

    /// Draws all pieces in the window, later ones first. Returns whether these were not too many.
    fn pieces(&mut self, frame: &Frame, to_screen: Affine2, spacing: f64) -> bool {
        let mut clouds = Clouds::new(frame, PIECE, spacing);
        let most = self.points + MOST_POINTS.0 * self.window.area() as u64 + MOST_POINTS.1;
        let mut parts = Parts::new(frame, to_screen, self.window);
        while let Some(part) = parts.next(|pixels| all_lit(&self.codes, self.window, pixels)) {
            let which = clouds.which(part.size);
            self.stamp(&part.map, part.letters, clouds.get(which), &part.extent);
            if self.points > most {
                return false;
            }
        }
        !parts.too_many
    }

    /// Draws some large pieces with one cloud, whatever they overlap: all maps of a shape that is seen whole, some
    /// pieces of a close view.
    fn rough(&mut self, frame: &Frame, to_screen: Affine2) {
        let Some(extent) = self.window.extent_once(&to_screen) else { return };
        let seen = f64::from(self.window.width.max(self.window.height));
        let mut pieces = Vec::new();
        cut_roughly(frame, to_screen, self.window, extent.size, ROUGH_PIECES, &mut pieces);
        let count = pieces.len().max(1) as f64;
        let most = (ROUGH_POINTS / count).min(ROUGH_STEPS / frame.steps.len().max(1) as f64);
        let side = (extent.size.min(2.0 * seen) / SPACING).min(most.sqrt()).max(16.0);
        let mut flood = Flood::new(frame, side as u32);
        flood.run(u64::MAX);
        let cloud = Cloud::of(flood.into_points());
        for piece in pieces {
            self.points += cloud.points.len() as u64;
            each_of_large(&piece.map, self.window, &cloud, |at, point| {
                if let Some(pixel) = self.codes.get_mut(at as usize) {
                    *pixel = (*pixel).max(ShortCode::of(piece.letters.join(point.letters), self.maps));
                }
            });
        }
    }

    fn stamp(&mut self, map: &Affine2, letters: Letters, cloud: &Cloud, extent: &Extent) {
        self.points += cloud.points.len() as u64;
        let place = Placement::new(map, self.window.width, extent);
        let known = letters.count() >= KEPT;
        let code = ShortCode::of(letters, self.maps);
        place.each(cloud, self.window.area() as u32, |at, point| {
            if let Some(pixel) = self.codes.get_mut(at as usize) {
                let code = if known { code } else { ShortCode::of(letters.join(point.letters), self.maps) };
                *pixel = (*pixel).max(code);
            }
        });
    }
}

/// Whether all pixels of a box are lit.
#[inline(never)]
pub(crate) fn all_lit<C: Code>(codes: &[C], window: Window, pixels: PixelBox) -> bool {
    let width = window.width as usize;
    (pixels.y.0..=pixels.y.1).all(|y| {
        let row = &codes[y as usize * width..][pixels.x.0 as usize..=pixels.x.1 as usize];
        // All of a row at once, rather than up to the first that is dark: many at a time.
        row.iter().fold(true, |lit, code| lit & (*code > C::default()))
    })
}

/// Lights each dark pixel whose eight neighbours are lit, as the one to its left is. Points leave out about one of
/// a hundred pixels of a full area; where a pixel of the picture is made of four, this lights none that was dark.
pub(crate) fn close_holes<C: Code>(codes: &mut [C], window: Window) {
    let width = window.width as usize;
    let mut lit = Bitmap::new(window);
    lit.light_where(codes, |code| *code > C::default());
    lit.each_hole(|(x, y)| {
        let at = y as usize * width + x as usize;
        codes[at] = codes[at - 1];
    });
}

#[cfg(test)]
mod tests {
    use frond_core::{Hull, Ifs};
    use glam::DVec2;

    use super::*;
    use crate::coverage::complete::{codes, swept_codes};
    use crate::picture::view::View;
    use crate::testing::{NASTY, PLAIN, ifs, some_ifs};

    const WINDOW: Window = Window { width: 320, height: 240 };
    /// Points enough for the finest spacing in so small a picture, and too few for a second time.
    const MANY: u64 = 4_000_000;
    const FEW: u64 = 0;

    fn screen(ifs: &Ifs, zoom: f64) -> (Frame, Affine2) {
        let hull = Hull::of(ifs);
        let frame = Frame::within(ifs, &hull);
        let fit = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
        let at = frame.to_world.apply(frame.anchor);
        let view = if zoom > 1.0 { View { x: at.x, y: at.y, scale: fit.scale * zoom } } else { fit };
        let to_screen = view.onto_screen(frame.to_world, WINDOW);
        (frame, to_screen)
    }

    /// One more than the first letter of each pixel, 0 where it is dark.
    fn firsts(codes: &[ShortCode]) -> Vec<u8> {
        let first = |code: &ShortCode| Letters::of_code(code.code()).map_or(0, |[first, ..]| first as u8 + 1);
        codes.iter().map(first).collect()
    }

    fn share(of: &[u8], truth: &[u8], differ: impl Fn(u8, u8) -> bool) -> f64 {
        let found = of.iter().zip(truth).filter(|(a, b)| differ(**a, **b)).count();
        found as f64 / truth.iter().filter(|code| **code > 0).count().max(1) as f64
    }

    /// Squares of two pixels that are dark in the midst of a lit area of six.
    fn holes(drawn: &[u8], truth: &[u8]) -> usize {
        let width = WINDOW.width as usize;
        let all = |codes: &[u8], x: usize, y: usize, side: usize, lit: bool| {
            (y..y + side).all(|y| codes[y * width + x..][..side].iter().all(|code| (*code > 0) == lit))
        };
        let places = (2..WINDOW.height as usize - 4).flat_map(|y| (2..width - 4).map(move |x| (x, y)));
        places.filter(|&(x, y)| all(drawn, x, y, 2, false) && all(truth, x - 2, y - 2, 6, true)).count()
    }

    #[test]
    fn points_light_what_a_sweep_lights_and_leave_no_hole() {
        for name in PLAIN {
            for zoom in [1.0, 300.0] {
                let (frame, to_screen) = screen(&ifs(name), zoom);
                let truth = firsts(&swept_codes(&frame, to_screen, WINDOW, 0.01).0);
                for points in [FEW, MANY] {
                    let splats = Splats::draw(&frame, to_screen, WINDOW, points);
                    assert!(splats.whole, "{name}");
                    let drawn = firsts(&splats.codes);
                    let extra = share(&drawn, &truth, |a, b| a > 0 && b == 0);
                    assert!(extra <= 0.0005, "{name} x{zoom}: {extra} too many");
                    // Lévy's curve is full of gaps of about a pixel.
                    let holes = holes(&drawn, &truth);
                    assert!(holes == 0 || (*name == "levy" && points == FEW), "{name} x{zoom}: {holes}");
                    let missed = share(&drawn, &truth, |a, b| a == 0 && b > 0);
                    // What is thin has pixels that it hardly reaches into.
                    let full = ["square", "carpet", "dragon"].contains(name);
                    let most = if points == FEW { 0.25 } else { 0.1 } * if full { 0.3 } else { 1.0 };
                    assert!(missed < most, "{name} x{zoom} {points}: {missed} missed");
                }
            }
        }
    }

    #[test]
    fn with_a_sweep_of_what_is_dark_they_are_the_picture_of_a_sweep() {
        let random = (0..frond_testing::cases(60)).map(|seed| (format!("some {seed}"), some_ifs(seed)));
        let plain = PLAIN.iter().map(|name| ((*name).to_owned(), ifs(name)));
        let (mut seen, mut lit) = (0, 0);
        for (name, ifs) in plain.chain(random) {
            let (frame, to_screen) = screen(&ifs, 1.0);
            let (truth, progress) = swept_codes(&frame, to_screen, WINDOW, 0.125);
            if progress != crate::Progress::Complete {
                continue;
            }
            let (drawn, progress) = codes(&frame, to_screen, WINDOW, 0.125);
            assert_eq!(progress, crate::Progress::Complete, "{name}");
            let (truth, drawn) = (firsts(&truth), firsts(&drawn));
            let count = truth.iter().filter(|code| **code > 0).count();
            let missed = truth.iter().zip(&drawn).filter(|(a, b)| a > b).count();
            // A point on the border of two pixels may fall into either, and a sweep leaves out what hardly reaches in.
            assert!(missed * 2000 <= count, "{name}: {missed} of {count} missed or of an earlier map");
            let more = truth.iter().zip(&drawn).filter(|(a, b)| a < b).count();
            if more > 0 {
                // It leaves out what hardly reaches in: one that looks more closely finds that, too.
                let (closely, _) = swept_codes(&frame, to_screen, WINDOW, 0.002);
                let invented = firsts(&closely).iter().zip(&drawn).filter(|(a, b)| a < b).count();
                assert!(
                    invented * 2000 <= count.max(2000),
                    "{name}: {invented} of {count} lit or of a later map"
                );
            }
            if count >= 2000 {
                assert!(more * 200 <= count, "{name}: {more} of {count} lit or of a later map");
            }
            (seen, lit) = (seen + 1, lit + count);
        }
        assert!(seen > PLAIN.len() + 20 && lit > 100_000, "{seen} {lit}");
    }

    #[test]
    fn three_letters_are_those_of_a_sweep_but_for_pixels_that_are_hardly_reached() {
        for name in ["gasket", "dragon", "fern", "carpet"] {
            let (frame, to_screen) = screen(&ifs(name), 1.0);
            let (truth, _) = swept_codes(&frame, to_screen, WINDOW, 0.125);
            let (drawn, _) = codes(&frame, to_screen, WINDOW, 0.125);
            let lit = truth.iter().filter(|code| code.code() > 0).count();
            let differ = truth.iter().zip(&drawn).filter(|(a, b)| a != b).count();
            assert!(differ * 25 < lit, "{name}: {differ} of {lit}");
        }
    }

    #[test]
    fn shapes_that_overlap_without_end_are_drawn_within_bounds_and_near_every_point() {
        let most = MOST_POINTS.0 * WINDOW.area() as u64 + MOST_POINTS.1 + ROUGH_POINTS as u64;
        for name in NASTY {
            for zoom in [1.0, 1e4] {
                let (frame, to_screen) = screen(&ifs(name), zoom);
                let splats = Splats::draw(&frame, to_screen, WINDOW, FEW);
                assert!(splats.points <= most + 200_000, "{name} x{zoom}: {}", splats.points);
                if zoom > 1.0 {
                    continue;
                }
                let (mut point, mut far) = (frame.anchor, 0);
                for i in 0..5000 {
                    point =
                        frame.maps[frond_core::hash::counter(9, i) as usize % frame.maps.len()].apply(point);
                    let at = to_screen.apply(point);
                    let near = (-2..=2).any(|dy| {
                        (-2..=2).any(|dx| {
                            let pixel = WINDOW.pixel(at + DVec2::new(f64::from(dx), f64::from(dy)));
                            pixel.is_some_and(|(x, y)| {
                                splats.codes[(y * WINDOW.width + x) as usize].code() > 0
                            })
                        })
                    });
                    far += u32::from(!near);
                }
                assert!(far < 50, "{name}: {far} of 5000");
            }
        }
    }

    #[test]
    fn close_views_are_drawn_in_little_more_time_than_far_ones() {
        for (name, zoom) in
            [("dragon", 1e2), ("dragon", 1e6), ("dragon", 1e9), ("gasket", 1e9), ("fern", 1e5)]
        {
            let (frame, to_screen) = screen(&ifs(name), zoom);
            let splats = Splats::draw(&frame, to_screen, WINDOW, FEW);
            let lit = splats.codes.iter().filter(|code| code.code() > 0).count();
            assert!(splats.whole && lit > 300, "{name} x{zoom}: {lit}");
            assert!(splats.points < 20 * lit as u64 + 200_000, "{name} x{zoom}: {} for {lit}", splats.points);
        }
    }

    #[test]
    fn what_is_no_picture_is_dark() {
        let frame = Frame::of(&ifs("gasket"));
        let away = Affine2::from_row([9.0, 0.0, 0.0, 9.0, -500.0, 0.0]);
        for map in
            [away, Affine2::from_row([f64::NAN; 6]), Affine2::from_row([1e300, 0.0, 0.0, 1e300, 0.0, 0.0])]
        {
            let splats = Splats::draw(&frame, map, WINDOW, MANY);
            assert!(map.is_finite() || splats.codes.iter().all(|code| code.code() == 0));
        }
        let none = Window { width: 0, height: 0 };
        assert!(Splats::draw(&frame, Affine2::IDENTITY, none, MANY).codes.is_empty());
    }

    #[test]
    fn a_dark_pixel_among_eight_that_are_lit_is_closed_and_no_other() {
        let window = Window { width: 70, height: 8 };
        let mut splats = Splats {
            window,
            codes: vec![ShortCode::of(Letters::NONE, 1); window.area()],
            whole: true,
            maps: 1,
            points: 0,
        };
        for (x, y) in [(0, 3), (63, 2), (64, 5), (69, 5), (30, 0), (30, 7), (10, 4), (11, 4)] {
            splats.codes[y * 70 + x] = ShortCode::default();
        }
        close_holes(&mut splats.codes, window);
        let dark: Vec<_> = (0..window.area())
            .filter(|at| splats.codes[*at].code() == 0)
            .map(|at| (at % 70, at / 70))
            .collect();
        assert_eq!(dark, [(30, 0), (0, 3), (10, 4), (11, 4), (69, 5), (30, 7)]);
    }
}
