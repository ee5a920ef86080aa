//! A photograph and its reductions.

use glam::DVec2;
use thiserror::Error;

/// A picture that is drawn on a [`Sheet`](crate::Sheet), with all its halvings down to one pixel, so that it neither
/// flickers nor grinds where it is shown small.
#[derive(Clone, Debug)]
pub struct Photo {
    levels: Vec<Level>,
}

/// One size of a picture: premultiplied alpha, row 0 on top.
#[derive(Clone, Debug)]
pub struct Level {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue, alpha, row after row.
    pub pixels: Vec<[u8; 4]>,
}

/// Why there is no such photograph.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum PhotoError {
    /// No pixels, or a side that no graphics card is sure to take.
    #[error(
        "A picture of {width} x {height} pixels cannot be bent. Give 1 to 4096 either way: make it smaller."
    )]
    Size {
        /// Pixels a row.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// Not four bytes a pixel.
    #[error("The picture needs {wanted} bytes, four a pixel, and got {found}.")]
    Bytes {
        /// As many as there should be.
        wanted: usize,
        /// As many as there were.
        found: usize,
    },
}

impl PhotoError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Size { .. } => "photo-size",
            Self::Bytes { .. } => "photo-bytes",
        }
    }
}

impl Photo {
    /// The longest side, in pixels.
    pub const LARGEST: u32 = 4096;

    /// A picture from RGBA bytes with straight alpha, row 0 on top.
    ///
    /// # Errors
    /// [`PhotoError`].
    pub fn new(rgba: &[u8], width: u32, height: u32) -> Result<Self, PhotoError> {
        let side = 1..=Self::LARGEST;
        if !side.contains(&width) || !side.contains(&height) {
            return Err(PhotoError::Size { width, height });
        }
        let wanted = width as usize * height as usize * 4;
        if rgba.len() != wanted {
            return Err(PhotoError::Bytes { wanted, found: rgba.len() });
        }
        let premultiplied = |&[r, g, b, a]: &[u8; 4]| {
            let times = |c: u8| ((u32::from(c) * u32::from(a) + 127) / 255) as u8;
            [times(r), times(g), times(b), a]
        };
        let pixels: Vec<[u8; 4]> = rgba.as_chunks::<4>().0.iter().map(premultiplied).collect();
        let mut levels = vec![Level { width, height, pixels }];
        while let Some(next) = levels.last().and_then(Level::halved) {
            levels.push(next);
        }
        Ok(Self { levels })
    }

    /// Its sizes, the largest first; each next one is half as large, rounded down, the last one pixel.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Width over height.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        let size = self.size();
        size.x / size.y
    }

    pub(super) fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.levels[0].width), f64::from(self.levels[0].height))
    }

    /// Its colour at a place, (0, 0) being the upper left corner and (1, 1) the lower right, in between two sizes:
    /// bilinear in each. `level` is 0 for the largest, 1 for half of it, and so on. Premultiplied, 0 to 255.
    #[must_use]
    pub fn sample(&self, place: DVec2, level: f32) -> [f32; 4] {
        let last = self.levels.len() - 1;
        let level = if level > 0.0 { level.min(last as f32) } else { 0.0 };
        let part = level.fract();
        let first = self.levels[level as usize].bilinear(place);
        if part == 0.0 {
            return first;
        }
        let second = self.levels[(level as usize + 1).min(last)].bilinear(place);
        std::array::from_fn(|i| first[i] + (second[i] - first[i]) * part)
    }
}

impl Level {
    /// Half as many pixels each way, rounded down but one at least: each the mean of those it stands for.
    fn halved(&self) -> Option<Self> {
        if self.width == 1 && self.height == 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let across =
            |x: u32, from: u32, to: u32| (x * from / to) as usize..((x + 1) * from).div_ceil(to) as usize;
        let mut pixels = Vec::with_capacity(width as usize * height as usize);
        for y in 0..height {
            let rows = across(y, self.height, height);
            for x in 0..width {
                let columns = across(x, self.width, width);
                let count = (rows.len() * columns.len()) as u32;
                let mut sum = [count / 2; 4];
                for row in rows.clone() {
                    for pixel in &self.pixels[row * self.width as usize..][columns.clone()] {
                        (0..4).for_each(|i| sum[i] += u32::from(pixel[i]));
                    }
                }
                pixels.push(sum.map(|c| (c / count) as u8));
            }
        }
        Some(Self { width, height, pixels })
    }

    fn bilinear(&self, place: DVec2) -> [f32; 4] {
        let axis = |t: f64, count: u32| {
            let last = f64::from(count - 1);
            // Not a clamp, which would let NaN pass.
            let at = (t * f64::from(count) - 0.5).max(0.0).min(last);
            let base = at as usize;
            (base, (base + 1).min(count as usize - 1), (at - base as f64) as f32)
        };
        let ((x0, x1, px), (y0, y1, py)) = (axis(place.x, self.width), axis(place.y, self.height));
        let row = |y: usize| &self.pixels[y * self.width as usize..][..self.width as usize];
        let (above, below) = (row(y0), row(y1));
        std::array::from_fn(|i| {
            let mix = |row: &[[u8; 4]]| {
                let (a, b) = (f32::from(row[x0][i]), f32::from(row[x1][i]));
                a + (b - a) * px
            };
            let (a, b) = (mix(above), mix(below));
            a + (b - a) * py
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_that_cannot_be_are_refused() {
        let code = |bytes: &[u8], w, h| Photo::new(bytes, w, h).map(|_| ()).map_err(|e| e.code());
        assert_eq!(code(&[], 0, 1), Err("photo-size"));
        assert_eq!(code(&[], 1, 5000), Err("photo-size"));
        assert_eq!(code(&[0; 5], 1, 1), Err("photo-bytes"));
        assert_eq!(code(&[0; 4], 1, 1), Ok(()));
    }

    #[test]
    fn halvings_keep_the_mean_and_end_in_one_pixel() {
        let bytes: Vec<u8> = (0..8 * 4).flat_map(|i| [(i * 8) as u8, 255 - (i * 7) as u8, 9, 255]).collect();
        let photo = Photo::new(&bytes, 8, 4).unwrap();
        let sizes: Vec<_> = photo.levels().iter().map(|l| (l.width, l.height)).collect();
        assert_eq!(sizes, [(8, 4), (4, 2), (2, 1), (1, 1)]);
        let mean = (0..32).map(|i| i * 8).sum::<u32>() / 32;
        assert!(photo.levels()[3].pixels[0][0].abs_diff(mean as u8) <= 2);
        // Odd sides, where a pixel stands for parts of three.
        let odd = Photo::new(&[90; 7 * 3 * 4], 7, 3).unwrap();
        assert!(
            odd.levels().iter().all(|level| level.pixels.iter().all(|p| *p == odd.levels()[0].pixels[0]))
        );
    }

    #[test]
    fn the_middle_of_a_pixel_is_the_pixel_and_no_place_is_outside() {
        let bytes: Vec<u8> = (0..12).flat_map(|i| [i as u8 * 20, 0, 0, 255]).collect();
        let photo = Photo::new(&bytes, 4, 3).unwrap();
        for (x, y, i) in [(0, 0, 0), (3, 0, 3), (2, 1, 6), (3, 2, 11)] {
            let place = DVec2::new((f64::from(x) + 0.5) / 4.0, (f64::from(y) + 0.5) / 3.0);
            assert_eq!(photo.sample(place, 0.0)[0], f32::from(i as u8 * 20));
        }
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -3.0, 1e300] {
            for level in [0.0, 1.5, f32::NAN, f32::INFINITY, -4.0] {
                assert!(photo.sample(DVec2::new(bad, 0.5), level)[3] > 254.0, "{bad} {level}");
            }
        }
    }

    #[test]
    fn what_cannot_be_seen_has_no_colour() {
        let photo = Photo::new(&[255, 0, 0, 0, 0, 0, 255, 255], 2, 1).unwrap();
        // Half-way: the red of the pixel that is not there does not bleed in.
        assert_eq!(photo.sample(DVec2::new(0.5, 0.5), 0.0), [0.0, 0.0, 127.5, 127.5]);
    }
}
