//! Whole pictures of attractors at rest, quickly enough for every frame of what moves.
//!
//! Each piece of an attractor is an affine image of all of it, so that one cloud of points serves them all. The
//! attractor is taken apart into pieces of some pixels, later maps first. A piece whose pixels are all lit is dropped;
//! the points of the others are drawn through their maps.

pub(crate) mod cloud;

use frond_core::Affine2;

use self::cloud::{Cloud, Clouds, LANES};
use crate::coverage::flood::{CloudPoint, Flood};
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

/// The largest pieces that points are drawn for, in pixels.
const PIECE: f64 = 48.0;
/// The distance of points, in pixels: with less than one to a pixel there would be holes.
const SPACING: f64 = 0.85;
/// A second time with points nearer to each other is worth while from such a distance on, and none is nearer than this.
const FINER: (f64, f64) = (0.7, 0.3);
/// Points for each pixel of the window, and on top, before pieces overlap too much; and pieces looked at.
const MOST_POINTS: (u64, u64) = (6, 500_000);
const MOST_VISITS: u64 = 300_000;
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
        // A row and a pixel more than there are: points outside of the window go there.
        splats.codes.resize(window.area() + window.width as usize + 1, ShortCode::default());
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
            return;
        }
        let first = self.points;
        let spacing = SPACING * (first as f64 / points.saturating_sub(first).max(1) as f64).sqrt();
        if spacing < FINER.0 {
            self.pieces(frame, to_screen, spacing.max(FINER.1));
        }
    }

    /// Draws all pieces in the window, later ones first. Returns whether these were not too many.
    fn pieces(&mut self, frame: &Frame, to_screen: Affine2, spacing: f64) -> bool {
        let mut clouds = Clouds::new(frame, PIECE, spacing);
        let most = self.points + MOST_POINTS.0 * self.window.area() as u64 + MOST_POINTS.1;
        let mut visits = 0;
        let mut stack = vec![(to_screen, Letters::NONE)];
        while let Some((map, letters)) = stack.pop() {
            visits += 1;
            if visits > MOST_VISITS || self.points > most {
                return false;
            }
            let Some(extent) = self.window.extent_once(&map) else { continue };
            if letters.count() > 0 {
                if all_lit(&self.codes, self.window, extent.pixels) {
                    continue;
                }
                let size = 2.0 * map.norm();
                if size <= PIECE {
                    self.stamp(&map, letters, clouds.for_size(size), &extent);
                    continue;
                }
            }
            stack.extend(frame.maps.iter().enumerate().map(|(i, part)| (map * *part, letters.then(i))));
        }
        true
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
            if let Some(extent) = self.window.extent_once(&piece.map) {
                self.stamp(&piece.map, piece.letters, &cloud, &extent);
            }
        }
    }

    fn stamp(&mut self, map: &Affine2, letters: Letters, cloud: &Cloud, extent: &Extent) {
        self.points += cloud.points.len() as u64;
        let place = Placement::new(map, self.window, extent);
        let known = letters.count() >= KEPT;
        let code = ShortCode::of(letters, self.maps);
        place.each(cloud, |at, point| {
            if let Some(pixel) = self.codes.get_mut(at) {
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

/// How a cloud is put on the pixels.
struct Placement {
    linear: [f32; 4],
    /// In pixels from a corner of the piece's box, so that `f32` is exact to a thousandth however large the picture.
    translation: [f32; 2],
    /// The first pixel of the window from that corner, in numbers that wrap around, and its sides.
    low: [u32; 2],
    size: [u32; 2],
}

/// Added to a number from 0 to 2^22, this leaves the nearest integer in its low bits.
const TO_INTEGER: f32 = 8_388_608.0;
const INTEGER_BITS: u32 = 0x007f_ffff;

impl Placement {
    fn new(map: &Affine2, window: Window, extent: &Extent) -> Self {
        let corner = (map.translation - extent.reach).floor() - 1.0;
        let [a, b, c, d, e, f] = map.to_row();
        Self {
            linear: [a, b, c, d].map(|x| x as f32),
            // The nearest integer to what is half a pixel less is the pixel.
            translation: [(e - corner.x - 0.5) as f32, (f - corner.y - 0.5) as f32],
            low: [(-corner.x) as i64 as u32, (-corner.y) as i64 as u32],
            size: [window.width, window.height],
        }
    }

    /// Tells where each point is among the pixels, and which it is; behind the last of them for one outside.
    #[inline]
    fn each(&self, cloud: &Cloud, mut put: impl FnMut(usize, &CloudPoint)) {
        let [a, b, c, d] = self.linear;
        let [e, f] = self.translation;
        let [width, height] = self.size;
        for ([xs, ys], points) in cloud.places.iter().zip(cloud.points.chunks(LANES)) {
            let mut places = [0_u32; LANES];
            for k in 0..LANES {
                let x = (a * xs[k] + b * ys[k] + e + TO_INTEGER).to_bits() & INTEGER_BITS;
                let y = (c * xs[k] + d * ys[k] + f + TO_INTEGER).to_bits() & INTEGER_BITS;
                let (x, y) = (x.wrapping_sub(self.low[0]), y.wrapping_sub(self.low[1]));
                let y = if x < width { y } else { height };
                places[k] = y.min(height).wrapping_mul(width).wrapping_add(x.min(width));
            }
            for (place, point) in places.into_iter().zip(points) {
                put(place as usize, point);
            }
        }
    }
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
    fn points_of_large_pieces_in_large_pictures_are_where_they_belong() {
        let window = Window { width: 8000, height: 6000 };
        let points: Vec<CloudPoint> = (0..500)
            .map(|i| {
                let at = |seed| frond_core::hash::unit(frond_core::hash::counter(seed, i)) * 1.6 - 0.8;
                CloudPoint { position: [at(1), at(2)], letters: Letters::NONE }
            })
            .collect();
        let cloud = Cloud::of(points);
        for row in
            [[3900.0, 300.0, -200.0, 2900.0, 4000.3, 3000.4], [9000.0, 0.0, 0.0, 9000.0, -2000.2, 7000.1]]
        {
            let map = Affine2::from_row(row);
            let place = Placement::new(&map, window, &window.extent(&map).unwrap());
            let (mut within, mut differ) = (0, 0);
            place.each(&cloud, |at, point| {
                let exact = map.apply(glam::Vec2::from(point.position).as_dvec2());
                let pixel = window.pixel(exact).map(|(x, y)| (y * window.width + x) as usize);
                within += u32::from(pixel.is_some());
                differ += u32::from(pixel.unwrap_or(at.max(window.area())) != at);
            });
            assert!(within > 50 && differ <= 2, "{row:?}: {differ} of {within}");
        }
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
