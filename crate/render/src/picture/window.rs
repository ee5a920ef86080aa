//! The pixels of a picture.

use frond_core::Affine2;
use glam::DVec2;

/// A picture of `width` x `height` pixels, pixel (0, 0) in the upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// A box of pixels, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelBox {
    /// First and last column.
    pub x: (u32, u32),
    /// First and last row.
    pub y: (u32, u32),
}

/// What the image of the unit disc takes up on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The pixels of its bounding box within the window.
    pub pixels: PixelBox,
    /// The longer side of the box, in pixels.
    pub size: f64,
    /// Half its sides, in pixels.
    pub reach: DVec2,
    /// Whether the box is all within the window.
    pub inside: bool,
}

impl Extent {
    /// Whether the box lies within one pixel.
    #[inline]
    #[must_use]
    pub fn one_pixel(&self) -> bool {
        let PixelBox { x, y } = self.pixels;
        self.inside && x.0 == x.1 && y.0 == y.1
    }
}

impl Window {
    /// Number of pixels.
    #[must_use]
    pub fn area(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The pixel that a point is in, if it is in the picture.
    #[inline]
    #[must_use]
    pub fn pixel(self, point: DVec2) -> Option<(u32, u32)> {
        // Comparisons with NaN are false, which drops it.
        let inside = point.x >= 0.0
            && point.y >= 0.0
            && point.x < f64::from(self.width)
            && point.y < f64::from(self.height);
        inside.then_some((point.x as u32, point.y as u32))
    }

    /// Where the image of the unit disc under `map` lies, or `None` if it misses the picture.
    #[inline]
    #[must_use]
    pub fn extent(self, map: &Affine2) -> Option<Extent> {
        self.extent_within(map, 0.0)
    }

    /// The same, compiled once: [`Self::extent`] becomes a part of whatever asks, and a module that is sent larger.
    #[inline(never)]
    pub(crate) fn extent_once(self, map: &Affine2) -> Option<Extent> {
        self.extent(map)
    }

    /// Where what is at most `slack` pixels away from that image lies.
    #[inline]
    #[must_use]
    pub fn extent_within(self, map: &Affine2, slack: f64) -> Option<Extent> {
        let m = map.linear;
        // The reach of an ellipse along an axis is the length of that row of its matrix.
        let reach = DVec2::new(
            (m.x_axis.x * m.x_axis.x + m.y_axis.x * m.y_axis.x).sqrt(),
            (m.x_axis.y * m.x_axis.y + m.y_axis.y * m.y_axis.y).sqrt(),
        ) + DVec2::splat(slack);
        let (low, high) = (map.translation - reach, map.translation + reach);
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        let touches = high.x >= 0.0 && high.y >= 0.0 && low.x < width && low.y < height;
        if !touches || self.area() == 0 {
            return None;
        }
        let inside = low.x >= 0.0 && low.y >= 0.0 && high.x < width && high.y < height;
        // Casts of floats to integers cut off at 0 and at the largest.
        let pixels = PixelBox {
            x: (low.x as u32, (high.x as u32).min(self.width - 1)),
            y: (low.y as u32, (high.y as u32).min(self.height - 1)),
        };
        // In WebAssembly `f64::max` is a call: it looks for NaN, which has not come so far.
        let size = 2.0 * if reach.x < reach.y { reach.y } else { reach.x };
        Some(Extent { pixels, size, reach, inside })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { width: 100, height: 100 };

    #[test]
    fn what_is_outside_or_no_number_has_no_pixel() {
        for point in [(-0.1, 5.0), (100.0, 5.0), (f64::NAN, 5.0), (5.0, f64::INFINITY)] {
            assert_eq!(WINDOW.pixel(point.into()), None);
        }
        assert_eq!(WINDOW.pixel(DVec2::new(99.9, 0.0)), Some((99, 0)));
        let far = Affine2::from_row([1.0, 0.0, 0.0, 1.0, 120.0, 5.0]);
        assert!(WINDOW.extent(&far).is_none());
        assert!(WINDOW.extent(&Affine2::from_row([f64::NAN; 6])).is_none());
        assert!(Window { width: 0, height: 0 }.extent(&Affine2::IDENTITY).is_none());
    }

    #[test]
    fn slack_is_on_all_sides() {
        let map = Affine2::from_row([3.0, 0.0, 0.0, 2.0, -4.0, 50.0]);
        assert!(WINDOW.extent(&map).is_none());
        let extent = WINDOW.extent_within(&map, 1.5).unwrap();
        assert_eq!((extent.pixels, extent.size), (PixelBox { x: (0, 0), y: (46, 53) }, 9.0));
        assert!(WINDOW.extent_within(&map, f64::NAN).is_none());
    }

    #[test]
    fn extents_are_those_of_the_ellipse() {
        let map = Affine2::from_row([3.0, 4.0, 0.0, 2.0, 50.0, 1.0]);
        let extent = WINDOW.extent(&map).unwrap();
        assert_eq!(extent.pixels, PixelBox { x: (45, 55), y: (0, 3) });
        assert!((extent.size - 10.0).abs() < 1e-12 && !extent.inside && !extent.one_pixel());
        let small = Affine2::from_row([0.2, 0.0, 0.0, 0.2, 7.5, 7.5]);
        assert!(WINDOW.extent(&small).unwrap().one_pixel());
        // A box that ends within the first pixel but begins outside is not all in that pixel.
        let corner = Affine2::from_row([0.4, 0.0, 0.0, 0.4, 0.2, 0.5]);
        assert!(!WINDOW.extent(&corner).unwrap().one_pixel());
    }
}
