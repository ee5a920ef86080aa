//! Pictures made on the CPU.

use frond_core::{Affine2, Colouring, Hull, Ifs};
use frond_deform::Bend;
use thiserror::Error;

use crate::bent::{AnchorError, Bent, complete_codes, draft_codes};
use crate::coverage::complete::codes;
use crate::density::Density;
use crate::picture::colour::{Colours, is_for_light_ground};
use crate::picture::resolve::{picture_of_codes, picture_of_density};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::Code;
use crate::splat::{Splats, close_holes};

/// What [`rasterize`] draws.
#[derive(Clone, Copy, Debug)]
pub struct RasterOptions<'a> {
    /// Pixels a row, at most [`MAX_SIDE`].
    pub width: u32,
    /// Rows, at most [`MAX_SIDE`].
    pub height: u32,
    /// What part of the plane. Default: all of the attractor, at rest, with a margin of a twentieth.
    pub view: Option<View>,
    /// How pieces are coloured.
    pub colouring: Colouring,
    /// One sRGB colour a map, repeated when there are more maps; empty for Okabe and Ito's.
    pub palette: &'a [[u8; 3]],
    /// Whether edges are smoothed. Either way the same pixels are lit.
    pub smooth: bool,
    /// How bright a density is: 1 by default.
    pub exposure: f32,
    /// Whether the picture is for a light ground: what is dense is darkened there, and else lightened. By default it is
    /// where the colours of the palette are dark.
    pub light_ground: Option<bool>,
    /// Whether points are enough, as many as are drawn within a frame of what moves: the shape is whole and smooth, but
    /// some pixels that it hardly reaches into are left out, and densities are a little softer.
    pub draft: bool,
    /// What bends the attractor. It must have been made for the same maps.
    pub bend: Option<&'a Bend>,
}

impl Default for RasterOptions<'_> {
    fn default() -> Self {
        Self {
            width: 320,
            height: 240,
            view: None,
            colouring: Colouring::Map,
            palette: &[],
            smooth: true,
            exposure: 1.0,
            light_ground: None,
            draft: false,
            bend: None,
        }
    }
}

impl RasterOptions<'_> {
    fn is_light(&self) -> bool {
        self.light_ground.unwrap_or_else(|| is_for_light_ground(self.palette))
    }
}

/// The longest side of a picture, in pixels.
pub const MAX_SIDE: u32 = 8192;

/// Why nothing was drawn.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum RenderError {
    /// A side is too long.
    #[error("A picture of {width} x {height} pixels is too large. Give at most 8192 either way.")]
    TooLarge {
        /// The width that was asked for.
        width: u32,
        /// The height that was asked for.
        height: u32,
    },
    /// The view is no view.
    #[error("The view must have finite numbers and a scale above 0.")]
    View,
}

impl RenderError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooLarge { .. } => "picture-too-large",
            Self::View => "view",
        }
    }
}

/// Draws an attractor: RGBA with straight alpha, row 0 on top, on a transparent background.
///
/// Every pixel that the attractor reaches into by a sixteenth of a pixel or more is lit, mostly those that it
/// only just touches as well, and none without a point of it. Where pieces overlap, those of later maps lie on top.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn rasterize(ifs: &Ifs, options: &RasterOptions<'_>) -> Result<Vec<u8>, RenderError> {
    match options.bend {
        Some(bend) => rasterize_bent(ifs, bend, options),
        None => rasterize_unbent(ifs, options),
    }
}

/// The same, bent by this, whatever the options say of a bend: without what draws an attractor at rest.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn rasterize_bent(ifs: &Ifs, bend: &Bend, options: &RasterOptions<'_>) -> Result<Vec<u8>, RenderError> {
    let Some(mut ground) = Ground::new(ifs, options)? else { return Ok(Vec::new()) };
    let anchor_error = AnchorError::of(&ground.frame, bend);
    let bent = |(view, window), fine| Bent::new(&ground.frame, bend, &anchor_error, (view, window), fine);
    let place = (ground.view, ground.window);
    if options.colouring == Colouring::Density {
        let bent = bent(place, (ground.window, 1.0));
        let density = Density::bent(&bent, BENT_DENSITY.0, BENT_DENSITY.1, BENT_DENSITY.2);
        Ok(ground.picture_of_density(density, None, options))
    } else {
        let (fine, scale) = ground.fine(options);
        let bent = bent(place, (fine, scale));
        let coloured = options.colouring == Colouring::Grid && bent.has_colours();
        ground.colours.tinted = f32::from(u8::from(coloured));
        let codes = if options.draft {
            let mut codes = draft_codes(&bent, coloured);
            if options.smooth {
                close_holes(&mut codes, fine);
            }
            codes
        } else {
            complete_codes(&bent, CERTAIN_REACH * scale, coloured)
        };
        Ok(ground.picture_of_codes(&codes, options))
    }
}

/// The same of an attractor at rest, whatever bends it: what draws nothing else has no need of the rest of the program.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn rasterize_unbent(ifs: &Ifs, options: &RasterOptions<'_>) -> Result<Vec<u8>, RenderError> {
    if options.colouring == Colouring::Density {
        rasterize_density(ifs, options)
    } else {
        rasterize_colours(ifs, options)
    }
}

/// The density of an attractor at rest, whatever colouring the options ask for.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn rasterize_density(ifs: &Ifs, options: &RasterOptions<'_>) -> Result<Vec<u8>, RenderError> {
    let Some(mut ground) = Ground::new(ifs, options)? else { return Ok(Vec::new()) };
    let density = Density::new(&ground.frame, ground.view, ground.window, 128, 512);
    let to_screen = ground.view.onto_screen(ground.frame.to_world, ground.window);
    Ok(ground.picture_of_density(density, Some(to_screen), options))
}

/// An attractor at rest in the colours of its pieces: without what draws densities.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn rasterize_colours(ifs: &Ifs, options: &RasterOptions<'_>) -> Result<Vec<u8>, RenderError> {
    let Some(mut ground) = Ground::new(ifs, options)? else { return Ok(Vec::new()) };
    let Ground { frame, view, window, .. } = &ground;
    let (fine, scale) = ground.fine(options);
    let to_fine = view.onto_target(frame.to_world, *window, scale);
    let codes = if options.draft {
        let mut splats = Splats::draw(frame, to_fine, fine, POINTS_OF_DRAFT);
        if options.smooth {
            close_holes(&mut splats.codes, fine);
        }
        splats.codes
    } else {
        codes(frame, to_fine, fine, CERTAIN_REACH * scale).0
    };
    Ok(ground.picture_of_codes(&codes, options))
}

/// What every picture begins with.
struct Ground {
    frame: Frame,
    view: View,
    window: Window,
    colours: Colours,
}

impl Ground {
    /// None where there are no pixels.
    fn new(ifs: &Ifs, options: &RasterOptions<'_>) -> Result<Option<Self>, RenderError> {
        let &RasterOptions { width, height, .. } = options;
        if width > MAX_SIDE || height > MAX_SIDE {
            return Err(RenderError::TooLarge { width, height });
        }
        if options.view.is_some_and(|view| !view.is_valid()) {
            return Err(RenderError::View);
        }
        let hull = Hull::of(ifs);
        let window = Window { width, height };
        if window.area() == 0 {
            return Ok(None);
        }
        let view = options.view.unwrap_or_else(|| View::fit(&hull, width, height, 0.05));
        let colours = Colours::new(options.colouring, options.palette, ifs.len());
        Ok(Some(Self { frame: Frame::within(ifs, &hull), view, window, colours }))
    }

    /// The pixels that codes are found for, and how many there are each way for one of the picture.
    fn fine(&self, options: &RasterOptions<'_>) -> (Window, f64) {
        let factor = if options.smooth { 2 } else { 1 };
        let Window { width, height } = self.window;
        (Window { width: width * factor, height: height * factor }, f64::from(factor))
    }

    fn picture_of_codes<C: Code>(&mut self, codes: &[C], options: &RasterOptions<'_>) -> Vec<u8> {
        let (fine, scale) = self.fine(options);
        self.colours.source = [fine.width as i32, fine.height as i32];
        self.colours.factor = scale as f32;
        picture_of_codes(&self.colours, codes, self.window)
    }

    /// With the map to the screen, where nothing is bent.
    fn picture_of_density(
        &mut self,
        density: Density,
        at_rest: Option<Affine2>,
        options: &RasterOptions<'_>,
    ) -> Vec<u8> {
        self.colours.slope = density.tone.slope;
        self.colours.towards = if options.is_light() { 0.0 } else { 1.0 };
        let place = (self.window, if options.draft { DENSITY_SPACING.0 } else { DENSITY_SPACING.1 });
        let mut sums = vec![[0.0; 4]; self.window.area()];
        let gain = if density.carry(&self.frame, at_rest, &self.colours, place, &mut sums) {
            density.tone_gain()
        } else {
            let points = if options.draft { POINTS_A_PIXEL.0 } else { POINTS_A_PIXEL.1 };
            throw(&self.frame, density, self.window, &self.colours, (points, &mut sums))
        };
        self.colours.source = [self.window.width as i32, self.window.height as i32];
        self.colours.gain = gain * options.exposure.max(0.0);
        picture_of_density(&self.colours, &sums)
    }
}

/// How far, in pixels, the attractor must reach into a pixel to light it for certain.
pub(crate) const CERTAIN_REACH: f64 = 0.0625;
/// About how many points a draft has.
const POINTS_OF_DRAFT: u64 = 1_500_000;
/// The density of a bent attractor: the size of its pieces, their number at most, and points in a pass.
const BENT_DENSITY: (f64, usize, usize) = (16.0, 60_000, 65_536);

/// How far from each other the masses of densities lie, in pixels: of drafts, and of what is complete.
const DENSITY_SPACING: (f64, f64) = (0.8, 0.4);
/// Where a density is left to chance: points a lit pixel, of drafts and of what is complete, and at most in all.
const POINTS_A_PIXEL: (usize, usize) = (8, 40);
const MOST_POINTS: usize = 40_000_000;

/// Finds the densities of the pixels by chance. Returns what multiplied by makes a middle tone 1.
fn throw(
    frame: &Frame,
    mut density: Density,
    window: Window,
    colours: &Colours,
    (points_a_pixel, sums): (usize, &mut [[f32; 4]]),
) -> f32 {
    let mut samples = Vec::new();
    let wanted = (density.lit * points_a_pixel).min(MOST_POINTS);
    let (mut points, mut passes) = (0, 0_u16);
    while points < wanted && !density.pieces.is_empty() {
        points += density.accumulate(frame, colours, window, &mut samples, sums);
        passes += 1;
    }
    density.tone_gain() / f32::from(passes.max(1))
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use frond_core::adaptive_cut;
    use glam::DVec2;

    use super::*;
    use crate::testing::{NASTY, PLAIN, ifs, of_rows, point_attractor};

    fn options(width: u32, height: u32) -> RasterOptions<'static> {
        RasterOptions { width, height, ..RasterOptions::default() }
    }

    /// Pixels that are not transparent.
    fn lit(picture: &[u8], width: u32) -> HashSet<(u32, u32)> {
        let alpha = picture.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[3] > 0);
        alpha.map(|(i, _)| (i as u32 % width, i as u32 / width)).collect()
    }

    #[test]
    fn the_lit_pixels_are_those_of_the_adaptive_cut() {
        let (width, height) = (120, 90);
        for name in PLAIN {
            let ifs = ifs(name);
            let hull = Hull::of(&ifs);
            let view = View::fit(&hull, width, height, 0.05);
            let picture = rasterize(&ifs, &options(width, height)).unwrap();
            let ours = lit(&picture, width);
            // Points of the attractor to stand for each piece: a pixel holds the piece, or some of it.
            let frame = Frame::within(&ifs, &hull);
            let stand_ins: Vec<_> =
                frame.tips.iter().chain([&frame.anchor]).map(|p| frame.to_world.apply(*p)).collect();
            let window = Window { width, height };
            let to_screen = view.onto_screen(Affine2::IDENTITY, window);
            let mut cut = HashSet::new();
            let outcome = adaptive_cut(&ifs, 0.06 / view.scale, 30_000_000, |map, _| {
                let points = stand_ins.iter().map(|p| to_screen.apply(map.apply(*p)));
                cut.extend(points.filter_map(|p| window.pixel(p)));
            });
            assert!(outcome.complete, "{name}");
            let missed = cut.difference(&ours).count() as f64 / cut.len() as f64;
            let extra = ours.difference(&cut).count() as f64 / ours.len() as f64;
            assert!(missed < 0.005, "{name}: {missed} of {} missed", cut.len());
            assert!(extra < 0.0075, "{name}: {extra} of {} too many", ours.len());
        }
    }

    #[test]
    fn smoothing_lights_the_same_pixels() {
        for name in ["dragon", "gasket", "fern"] {
            let ifs = ifs(name);
            let smooth = lit(&rasterize(&ifs, &options(200, 150)).unwrap(), 200);
            let sharp =
                lit(&rasterize(&ifs, &RasterOptions { smooth: false, ..options(200, 150) }).unwrap(), 200);
            let differ = smooth.symmetric_difference(&sharp).count() as f64 / sharp.len() as f64;
            assert!(differ < 0.005, "{name}: {differ}");
        }
    }

    #[test]
    fn shapes_that_overlap_without_end_are_drawn_all_the_same() {
        for name in NASTY {
            let ifs = ifs(name);
            let picture = rasterize(&ifs, &options(160, 120)).unwrap();
            let ours = lit(&picture, 160);
            let frame = Frame::of(&ifs);
            let to_screen = View::fit(&Hull::of(&ifs), 160, 120, 0.05)
                .onto_screen(frame.to_world, Window { width: 160, height: 120 });
            // Every point of the chaos game falls on a lit pixel or next to one.
            let mut point = frame.anchor;
            for i in 0..20_000 {
                let letter = frond_core::hash::counter(9, i) as usize % frame.maps.len();
                point = frame.maps[letter].apply(point);
                let at = to_screen.apply(point);
                let near = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))).any(|(dx, dy)| {
                    let (x, y) = (at.x + f64::from(dx), at.y + f64::from(dy));
                    x >= 0.0 && y >= 0.0 && ours.contains(&(x as u32, y as u32))
                });
                assert!(near, "{name}: {at} is dark");
            }
        }
    }

    #[test]
    fn filled_shapes_have_no_holes() {
        for name in ["square", "overlap", "dragon"] {
            let ifs = ifs(name);
            let frame = Frame::of(&ifs);
            let view = View { scale: 2000.0, ..View::fit(&Hull::of(&ifs), 100, 100, 0.0) };
            let middle = frame.to_world.apply(frame.anchor);
            // Around a point deep inside: the middle of the square, the fixed point of the overlap.
            let centre = match name {
                "square" => DVec2::new(0.37, 0.61),
                "dragon" => DVec2::new(0.58, 0.25),
                _ => middle,
            };
            let view = View { x: centre.x, y: centre.y, ..view };
            let picture = rasterize(&ifs, &RasterOptions { view: Some(view), ..options(100, 100) }).unwrap();
            assert_eq!(lit(&picture, 100).len(), 10_000, "{name}");
        }
    }

    #[test]
    fn later_maps_lie_on_top() {
        let palette = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];
        let colours = |rows: &[[f64; 6]]| {
            let options = RasterOptions { palette: &palette, ..options(60, 60) };
            let picture = rasterize(&of_rows(rows), &options).unwrap();
            let opaque = picture.chunks_exact(4).filter(|p| p[3] == 255);
            opaque.map(|p| [p[0], p[1], p[2]]).collect::<HashSet<_>>()
        };
        // A square whose third quarter is covered by the same map once more.
        let [a, b, c, d] =
            [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]].map(|[e, f]| [0.5, 0.0, 0.0, 0.5, e, f]);
        let seen = colours(&[a, b, c, d]);
        assert!(palette.iter().all(|colour| seen.contains(colour)), "{seen:?}");
        let covered = colours(&[c, a, b, c]);
        assert!(!covered.contains(&palette[0]) && covered.contains(&palette[3]), "{covered:?}");
    }

    #[test]
    fn a_point_lights_one_pixel_at_any_size() {
        for at in [DVec2::ZERO, DVec2::new(1e6, -3e5), DVec2::new(1e-9, 1e-12)] {
            for smooth in [false, true] {
                let options = RasterOptions { smooth, ..options(50, 40) };
                let picture = rasterize(&point_attractor(at), &options).unwrap();
                assert_eq!(lit(&picture, 50).len(), 1, "{at} {smooth}");
            }
        }
    }

    #[test]
    fn size_and_place_do_not_change_the_picture() {
        let gasket = ifs("gasket");
        let sharp = RasterOptions { smooth: false, ..options(120, 100) };
        let reference = lit(&rasterize(&gasket, &sharp).unwrap(), 120);
        for (size, moved) in [(1e-12, 0.0), (1e12, 0.0), (1e12, 1e12), (1.0, 1e5)] {
            let by = Affine2::from_row([size, 0.0, 0.0, size, moved, -moved]);
            let other = gasket.conjugate(by).unwrap();
            let lit = lit(&rasterize(&other, &sharp).unwrap(), 120);
            let differ = lit.symmetric_difference(&reference).count();
            assert!(differ * 100 < reference.len(), "{size} {moved}: {differ}");
        }
    }

    #[test]
    fn deep_zooms_show_the_same_shape_again() {
        // The gasket around its corner, the fixed point of its first map, is its own twice as large.
        let gasket = ifs("gasket");
        let at = |scale: f64| {
            let view = View { x: 0.0, y: 0.0, scale };
            let options = RasterOptions { view: Some(view), smooth: false, ..options(200, 200) };
            lit(&rasterize(&gasket, &options).unwrap(), 200)
        };
        let reference = at(150.0);
        assert!(reference.len() > 1000);
        for doublings in [1, 10, 35] {
            let differ = at(150.0 * 2.0_f64.powi(doublings)).symmetric_difference(&reference).count();
            // The first view holds the rest of the shape as well, which later ones do not.
            assert!(differ < reference.len() / 2, "{doublings}: {differ}");
        }
        let differ = at(150.0 * 2.0_f64.powi(12)).symmetric_difference(&at(150.0 * 2.0_f64.powi(34))).count();
        assert!(differ * 100 < reference.len(), "{differ}");
    }

    #[test]
    fn densities_light_only_what_the_shape_lights() {
        for name in ["gasket", "fern", "overlap"] {
            let ifs = ifs(name);
            let density = RasterOptions { colouring: Colouring::Density, ..options(120, 90) };
            let dense = lit(&rasterize(&ifs, &density).unwrap(), 120);
            let whole = lit(&rasterize(&ifs, &options(120, 90)).unwrap(), 120);
            let outside = dense.difference(&whole).count();
            assert!(outside * 200 < whole.len(), "{name}: {outside}");
            assert!(dense.len() * 2 > whole.len(), "{name}: {} of {}", dense.len(), whole.len());
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_refused_and_no_pixels_are_no_pixels() {
        let gasket = ifs("gasket");
        for (width, height) in [(0, 0), (0, 10), (10, 0)] {
            assert_eq!(rasterize(&gasket, &options(width, height)), Ok(Vec::new()));
        }
        let error = rasterize(&gasket, &options(9000, 1)).unwrap_err();
        assert_eq!(
            (error, error.code()),
            (RenderError::TooLarge { width: 9000, height: 1 }, "picture-too-large")
        );
        for bad in [f64::NAN, 0.0, f64::INFINITY] {
            let view = Some(View { x: 0.0, y: 0.0, scale: bad });
            assert_eq!(rasterize(&gasket, &RasterOptions { view, ..options(9, 9) }), Err(RenderError::View));
        }
        let away = Some(View { x: 1e300, y: 0.0, scale: 1e280 });
        assert!(
            lit(&rasterize(&gasket, &RasterOptions { view: away, ..options(9, 9) }).unwrap(), 9).is_empty()
        );
    }
}
