//! A photograph on a sheet that is bent.

mod bent;
mod fill;
mod photo;
#[cfg(test)]
mod tests;

use frond_core::Affine2;
use glam::{DMat2, DVec2};

pub use self::bent::BentSheet;
use self::fill::{Band, Corner, corner};
pub use self::photo::{Level, Photo, PhotoError};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::raster::{MAX_SIDE, RenderError};

/// A rectangle of square cells, wherever their corners have gone: what a photograph is stretched over. At rest it lies
/// on [0, aspect] x [0, 1].
///
/// Neighbouring cells share their corners, so that it cannot tear.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    aspect: f64,
    side: usize,
    corners: Vec<[f32; 2]>,
}

impl Sheet {
    /// The most cells along a side.
    pub const FINEST: usize = 729;
    /// As many cells along a side as it takes for a smooth bend to look smooth.
    const SMOOTH: usize = 192;

    /// A sheet that is not bent.
    #[must_use]
    pub fn at_rest(aspect: f64) -> Self {
        Self::new(aspect, 1, |place| place)
    }

    /// A sheet of `side` x `side` cells (1 to [`Sheet::FINEST`]) whose corners are where `bent` takes those of the
    /// sheet at rest. An `aspect` that is none counts as 1.
    #[must_use]
    pub fn new(aspect: f64, side: usize, mut bent: impl FnMut(DVec2) -> DVec2) -> Self {
        let aspect = if aspect > 0.0 && aspect.is_finite() { aspect } else { 1.0 };
        let side = side.clamp(1, Self::FINEST);
        let size = DVec2::new(aspect, 1.0) / side as f64;
        let place = |i: usize| DVec2::new((i % (side + 1)) as f64, (i / (side + 1)) as f64) * size;
        let corners = (0..(side + 1) * (side + 1)).map(|i| bent(place(i)).as_vec2().to_array()).collect();
        Self { aspect, side, corners }
    }

    /// The maps whose attractor the sheet at rest is: `parts` x `parts`, x first, from the lower left, as the letters
    /// of crate/deform count.
    #[must_use]
    pub fn maps(aspect: f64, parts: usize) -> Vec<Affine2> {
        let scale = DMat2::from_diagonal(DVec2::splat(1.0 / parts as f64));
        let place = |i: usize| DVec2::new((i % parts) as f64 * aspect, (i / parts) as f64) / parts as f64;
        (0..parts * parts).map(|i| Affine2::new(scale, place(i))).collect()
    }

    /// Cells along a side for so many letters of `parts` x `parts` maps: one for each piece, more where these are too
    /// large to bend smoothly, and no more than `most`. The second number is how many letters pieces have that are
    /// whole cells or consist of some.
    #[must_use]
    pub fn resolution(parts: usize, ke: f64, most: usize) -> (usize, usize) {
        let parts = parts.max(2);
        let (mut side, mut letters) = (1, 0);
        while f64::from(letters) < ke && side * parts <= most.min(Self::FINEST) {
            side *= parts;
            letters += 1;
        }
        let finer = Self::SMOOTH.min(most).div_ceil(side).max(1);
        (side * if side * finer <= most { finer } else { 1 }, letters as usize)
    }

    /// Width over height at rest.
    #[must_use]
    pub const fn aspect(&self) -> f64 {
        self.aspect
    }

    /// Cells along a side.
    #[must_use]
    pub const fn side(&self) -> usize {
        self.side
    }

    /// Where the corners of the cells are, row by row from the lower left.
    #[must_use]
    pub fn corners(&self) -> &[[f32; 2]] {
        &self.corners
    }

    /// The same, to be moved.
    pub fn corners_mut(&mut self) -> &mut [[f32; 2]] {
        &mut self.corners
    }

    /// The place of the photograph that corner `i` shows: (0, 0) is the upper left, (1, 1) the lower right.
    #[must_use]
    pub fn place(&self, i: usize) -> DVec2 {
        let across = self.side + 1;
        DVec2::new((i % across) as f64, (self.side - i / across) as f64) / self.side as f64
    }

    /// The corners of all triangles, two for each `step` x `step` cells, from the front to the back: where the sheet is
    /// folded over, what lies lower in the picture covers what is above. `step` is a divisor of [`Sheet::side`].
    pub fn triangles(&self, step: usize) -> impl Iterator<Item = [u32; 3]> {
        let (across, step) = (self.side as u32 + 1, step.max(1));
        let along = move || (0..across - 1).step_by(step);
        let (right, up) = (step as u32, step as u32 * across);
        along().flat_map(move |row| {
            along().flat_map(move |column| {
                let a = row * across + column;
                [[a, a + right, a + up], [a + right, a + right + up, a + up]]
            })
        })
    }

    /// How many cells to draw as one, each way, so that a sheet that is crumpled together does not keep whoever draws
    /// it busy for minutes: as few as possible with no more than `most` layers on the average over the window. `screen`
    /// is where the corners are on it.
    #[must_use]
    pub fn step(&self, screen: &[DVec2], window: Window, most: f64) -> usize {
        let end = DVec2::new(f64::from(window.width), f64::from(window.height));
        let work = |triangle: [u32; 3]| {
            let [a, b, c] = triangle.map(|i| screen[i as usize]);
            let low = a.min(b).min(c).clamp(DVec2::ZERO, end);
            let size = a.max(b).max(c).clamp(DVec2::ZERO, end) - low;
            // Half of its box, as far as it is in the window, and what it takes to begin a row.
            let work = 0.5 * size.x * size.y + size.y;
            if work > 0.0 { work } else { 0.0 }
        };
        let fits =
            |step: &usize| self.triangles(*step).map(work).sum::<f64>() <= most * (end.x * end.y).max(1.0);
        let divisors = (1..=self.side).filter(|step| self.side.is_multiple_of(*step));
        divisors.into_iter().find(fits).unwrap_or(self.side)
    }

    /// The view that shows all of it, with `margin` of the shorter side left free.
    #[must_use]
    pub fn fit(&self, width: u32, height: u32, margin: f64) -> View {
        let all = self.corners.iter().filter(|c| c[0].is_finite() && c[1].is_finite());
        let points = all.map(|c| DVec2::new(f64::from(c[0]), f64::from(c[1])));
        let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (min, max) = points.fold(start, |(min, max), p| (min.min(p), max.max(p)));
        let (min, max) = if min.x <= max.x { (min, max) } else { (DVec2::ZERO, DVec2::ONE) };
        let sides = DVec2::new(f64::from(width.max(1)), f64::from(height.max(1)));
        let free = sides * (1.0 - 2.0 * margin.clamp(0.0, 0.45));
        let (centre, extent) = ((min + max) / 2.0, (max - min).max(DVec2::splat(1e-9)));
        View { x: centre.x, y: centre.y, scale: (free / extent).min_element() }
    }
}

/// What [`draw_sheet`] draws.
#[derive(Clone, Copy, Debug)]
pub struct SheetOptions {
    /// Pixels a row, at most [`MAX_SIDE`].
    pub width: u32,
    /// Rows, at most [`MAX_SIDE`].
    pub height: u32,
    /// What part of the plane. Default: all of the sheet with a margin of a twentieth.
    pub view: Option<View>,
    /// Whether edges are smoothed: four samples a pixel.
    pub smooth: bool,
}

/// Rows that are drawn at once: what is held in memory besides the picture.
const ROWS_AT_ONCE: u32 = 256;
/// The most layers on the average before a sheet is drawn coarser.
const MOST_LAYERS: f64 = 40.0;

/// Draws a photograph on a sheet: RGBA with straight alpha, row 0 on top, on a transparent background. Where the sheet
/// is folded over, what is lower in the picture lies on top; corners that are no numbers leave holes.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn draw_sheet(photo: &Photo, sheet: &Sheet, options: &SheetOptions) -> Result<Vec<u8>, RenderError> {
    let &SheetOptions { width, height, .. } = options;
    if width > MAX_SIDE || height > MAX_SIDE {
        return Err(RenderError::TooLarge { width, height });
    }
    if options.view.is_some_and(|view| !view.is_valid()) {
        return Err(RenderError::View);
    }
    let window = Window { width, height };
    let mut picture = Vec::with_capacity(window.area() * 4);
    if window.area() == 0 {
        return Ok(picture);
    }
    let view = options.view.unwrap_or_else(|| sheet.fit(width, height, 0.05));
    let factor = if options.smooth { 2 } else { 1 };
    let screen: Vec<DVec2> = on_target(sheet, view, window, f64::from(factor)).collect();
    let step = sheet.step(&screen, Window { width: width * factor, height: height * factor }, MOST_LAYERS);
    let corners: Vec<Corner> = screen.into_iter().map(corner).collect();
    for top in (0..height).step_by(ROWS_AT_ONCE as usize) {
        let rows = ROWS_AT_ONCE.min(height - top);
        let mut band = Band::new(Window { width: width * factor, height: rows * factor }, top * factor);
        for triangle in sheet.triangles(step) {
            let [Some(a), Some(b), Some(c)] = triangle.map(|i| corners[i as usize]) else { continue };
            band.fill(photo, [a, b, c], triangle.map(|i| sheet.place(i as usize)));
        }
        resolve(&band.pixels, Window { width, height: rows }, factor as usize, &mut picture);
    }
    Ok(picture)
}

/// Where the corners of a sheet are on a target of `factor` times as many pixels as the window, each way.
pub(crate) fn on_target(
    sheet: &Sheet,
    view: View,
    window: Window,
    factor: f64,
) -> impl Iterator<Item = DVec2> {
    let middle = DVec2::new(f64::from(window.width), f64::from(window.height)) * 0.5;
    let scale = DVec2::new(view.scale, -view.scale) * factor;
    sheet.corners.iter().map(move |&[x, y]| {
        (DVec2::new(f64::from(x), f64::from(y)) - DVec2::new(view.x, view.y)) * scale + middle * factor
    })
}

/// Makes straight pixels of `factor` x `factor` premultiplied ones each: the CPU twin of `sheet_resolve` in
/// `shader/sheet.wgsl`.
fn resolve(pixels: &[[u8; 4]], window: Window, factor: usize, picture: &mut Vec<u8>) {
    let across = window.width as usize * factor;
    for y in 0..window.height as usize {
        for x in 0..window.width as usize {
            let mut sum = [0_u32; 4];
            for row in 0..factor {
                for pixel in &pixels[(y * factor + row) * across + x * factor..][..factor] {
                    (0..4).for_each(|i| sum[i] += u32::from(pixel[i]));
                }
            }
            let (count, alpha) = ((factor * factor) as u32, sum[3]);
            let straight = |c: u32| (c * 255 + alpha / 2).checked_div(alpha).unwrap_or(0).min(255) as u8;
            picture.extend([straight(sum[0]), straight(sum[1]), straight(sum[2])]);
            picture.push(((alpha + count / 2) / count) as u8);
        }
    }
}
