//! Filling triangles with a photograph: every pixel whose middle lies inside, those on an edge once.

use glam::{DMat2, DVec2};

use super::photo::Photo;
use crate::picture::window::Window;

/// Corners are rounded to so many parts of a pixel, as graphics cards do: from there on everything is whole numbers,
/// so that two triangles never both miss a pixel of the edge between them, nor both take it.
const SUBPIXELS: f64 = 256.0;
/// Beyond so many parts 64 bits do not suffice for a product of two differences.
const LARGEST_EXACT: i64 = 1 << 29;
/// What is further away than any zoom takes it is taken to be here.
const FARTHEST_CORNER: f64 = (1_i64 << 60) as f64;

/// A corner on the screen, in parts of a pixel; `None` for what is no place.
pub(super) type Corner = Option<[i64; 2]>;

/// Where a point of the screen, in pixels, is rounded to.
pub(super) fn corner(pixel: DVec2) -> Corner {
    pixel.is_finite().then(|| {
        let parts = |x: f64| (x * SUBPIXELS).round().clamp(-FARTHEST_CORNER, FARTHEST_CORNER) as i64;
        [parts(pixel.x), parts(pixel.y)]
    })
}

/// Rows of a picture, premultiplied, that triangles are drawn on.
#[derive(Debug)]
pub(super) struct Band {
    pub window: Window,
    /// The row of the picture that is the first here.
    pub top: u32,
    pub pixels: Vec<[u8; 4]>,
}

impl Band {
    pub fn new(window: Window, top: u32) -> Self {
        Self { window, top, pixels: vec![[0; 4]; window.area()] }
    }

    /// Draws a triangle: its corners on the screen and the places of the photograph that they show, under what is
    /// there.
    pub fn fill(&mut self, photo: &Photo, corners: [[i64; 2]; 3], places: [DVec2; 3]) {
        let low = |i: usize| corners[0][i].min(corners[1][i]).min(corners[2][i]);
        let high = |i: usize| corners[0][i].max(corners[1][i]).max(corners[2][i]);
        let columns = pixels(low(0), high(0), 0, self.window.width);
        let rows = pixels(low(1), high(1), self.top, self.window.height);
        if columns.is_empty() || rows.is_empty() {
            return;
        }
        let [a, b, c] = corners.map(|[x, y]| DVec2::new(x as f64, y as f64) / SUBPIXELS);
        let area = (b - a).perp_dot(c - a);
        if area == 0.0 {
            return;
        }
        let slopes = DMat2::from_cols(places[1] - places[0], places[2] - places[0])
            * DMat2::from_cols(b - a, c - a).inverse();
        let texels = photo.size();
        let step = (slopes.x_axis * texels).length().max((slopes.y_axis * texels).length());
        let level = step.log2() as f32;
        let turned = if area > 0.0 { corners } else { [corners[0], corners[2], corners[1]] };
        let near = corners.iter().flatten().all(|x| x.abs() < LARGEST_EXACT);
        let wide = turned.map(|corner| corner.map(i128::from));
        for row in rows {
            let y = i64::from(self.top + row) * SUBPIXELS as i64 + SUBPIXELS as i64 / 2;
            let (first, last) = if near {
                near_span(&turned, y, columns.start, columns.end)
            } else {
                wide_span(&wide, i128::from(y), columns.start, columns.end)
            };
            let line = &mut self.pixels[row as usize * self.window.width as usize..];
            let middle = DVec2::new(0.5, f64::from(self.top + row) + 0.5);
            for x in first..last {
                let slot = &mut line[x as usize];
                if slot[3] == 255 {
                    continue;
                }
                let place = places[0] + slopes * (middle + DVec2::new(f64::from(x), 0.0) - a);
                lay_under(photo.sample(place, level), slot);
            }
        }
    }
}

/// The pixels, of `count` from `first` on, whose middles may lie between two numbers of parts.
fn pixels(low: i64, high: i64, first: u32, count: u32) -> std::ops::Range<u32> {
    let pixel = |parts: i64| parts.div_euclid(SUBPIXELS as i64) - i64::from(first);
    let last = (pixel(high) + 1).clamp(0, i64::from(count)) as u32;
    (pixel(low).clamp(0, i64::from(count)) as u32)..last
}

macro_rules! span {
    ($name:ident, $whole:ty) => {
        /// The pixels of a row, `y` in parts, whose middles lie in a triangle with its corners in the order of the
        /// clock: on its edges only on those at the top and on the left.
        fn $name(corners: &[[$whole; 2]; 3], y: $whole, first: u32, end: u32) -> (u32, u32) {
            let (mut low, mut high) = (<$whole>::from(first), <$whole>::from(end));
            for (i, [ax, ay]) in corners.iter().enumerate() {
                let [bx, by] = corners[(i + 1) % 3];
                let (dx, dy) = (bx - ax, by - ay);
                let owned = dy < 0 || (dy == 0 && dx > 0);
                // What the edge says of pixel x: start + x * step is at least 0 within.
                let start = dx * (y - ay) - dy * (SUBPIXELS as $whole / 2 - ax) - <$whole>::from(!owned);
                let step = -dy * SUBPIXELS as $whole;
                if step == 0 {
                    if start < 0 {
                        return (0, 0);
                    }
                } else if step > 0 {
                    low = low.max(-start.div_euclid(step));
                } else {
                    high = high.min(start.div_euclid(-step) + 1);
                }
            }
            if low < high { (low as u32, high as u32) } else { (0, 0) }
        }
    };
}

span!(near_span, i64);
span!(wide_span, i128);

/// Lays a colour under another, both premultiplied.
fn lay_under(colour: [f32; 4], above: &mut [u8; 4]) {
    let through = 1.0 - f32::from(above[3]) / 255.0;
    for (slot, c) in above.iter_mut().zip(colour) {
        *slot = (f32::from(*slot) + c * through + 0.5) as u8;
    }
}

#[cfg(test)]
mod tests {
    use frond_core::hash::counter;

    use super::*;

    const WINDOW: Window = Window { width: 40, height: 30 };

    /// Something to see through: drawn twice it is darker than once.
    fn veil() -> Photo {
        Photo::new(&[0, 0, 0, 51], 1, 1).unwrap()
    }

    fn drawn(triangles: &[[DVec2; 3]]) -> Vec<u8> {
        let mut band = Band::new(WINDOW, 0);
        for triangle in triangles {
            let corners = triangle.map(|p| corner(p).unwrap());
            band.fill(&veil(), corners, [DVec2::ZERO, DVec2::X, DVec2::Y]);
        }
        band.pixels.iter().map(|pixel| pixel[3]).collect()
    }

    #[test]
    fn a_fan_that_covers_the_window_takes_every_pixel_once() {
        for seed in 0..300 {
            // Corners on middles and edges of pixels too, where ties are decided.
            let coordinate = |i: u32, size: f64| f64::from(counter(seed, i) % 1000) / 1000.0 * size;
            let mut hub = DVec2::new(coordinate(0, 40.0), coordinate(1, 30.0));
            if seed % 3 == 0 {
                hub = hub.floor() + 0.5;
            }
            let far = if seed % 2 == 0 { 200.0 } else { 1e13 };
            let mut angles: Vec<f64> =
                (0..7).map(|i| (f64::from(i) + coordinate(2 + i, 0.9)) / 7.0).collect();
            angles.push(angles[0]);
            let rim: Vec<DVec2> =
                angles.iter().map(|t| hub + DVec2::from_angle(t * std::f64::consts::TAU) * far).collect();
            let fan: Vec<_> = rim.windows(2).map(|pair| [hub, pair[0], pair[1]]).collect();
            let alpha = drawn(&fan);
            assert!(alpha.iter().all(|a| *a == 51), "{seed}: {:?}", alpha.iter().position(|a| *a != 51));
        }
    }

    #[test]
    fn squares_of_pixels_are_theirs_whichever_way_round() {
        let [a, b, c, d] = [(2.5, 3.5), (7.5, 3.5), (7.5, 9.5), (2.5, 9.5)].map(DVec2::from);
        for pair in [[[a, b, c], [a, c, d]], [[c, b, a], [d, c, a]], [[a, b, d], [b, c, d]]] {
            let alpha = drawn(&pair);
            let lit: Vec<_> = (0..WINDOW.area()).filter(|i| alpha[*i] > 0).collect();
            assert_eq!(lit.len(), 30);
            assert!(lit.iter().all(|i| alpha[*i] == 51));
            // The upper and left edges go through middles of pixels and have them, the others do not.
            assert_eq!((lit[0] % 40, lit[0] / 40), (2, 3));
        }
    }

    #[test]
    fn no_triangle_is_too_thin_or_too_far_away() {
        let p = DVec2::new(3.0, 4.0);
        let lines = [[p, p, p], [p, p * 2.0, p * 3.0], [p, p + 1e-9, p + DVec2::X]];
        assert!(drawn(&lines).iter().all(|a| *a == 0));
        let far = DVec2::new(1e300, -1e300);
        assert!(drawn(&[[far, far * 0.5, -far]]).len() == WINDOW.area());
        assert_eq!(corner(DVec2::new(f64::NAN, 0.0)), None);
        assert_eq!(corner(DVec2::new(0.0, f64::INFINITY)), None);
    }
}
