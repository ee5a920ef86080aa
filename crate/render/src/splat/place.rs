//! Where a piece puts the points of a cloud: the CPU twin of `shader/splat.wgsl`.
//!
//! All of it is whole numbers, so that a graphics card comes to the same pixels as the processor: it may fuse or
//! reorder what it does to floats.

use frond_core::Affine2;
use glam::Vec2;
use wide::i16x8;

use super::cloud::{Cloud, LANES};
use super::whole::{LOW_SHIFT, split};
use crate::coverage::flood::CloudPoint;
use crate::picture::window::{Extent, Window};

/// Linear parts of a piece are parts of that part of a pixel.
const PIXEL: f64 = 1024.0;
/// Places are parts of 2^-25 of a pixel: of a piece of up to 62 pixels no point wraps around into its box once more.
pub const SHIFT: u32 = 25;

/// How a cloud is put on the pixels by a piece that is not larger than [`PIECE`](super::parts::PIECE).
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Row by row, high parts first.
    pub linear: [[[i16; 2]; 2]; 2],
    /// From the first pixel of the piece's box, in parts of a pixel that wrap around.
    pub translation: [u32; 2],
    /// The place of that first pixel, row after row.
    pub corner: u32,
    /// The pixels of the box each way; no point is put outside of it.
    pub size: [u32; 2],
    /// The pixels of a row of the picture.
    width: u32,
}

/// Places that a picture needs behind its pixels, for points outside of them: as many as a point may be along a row
/// from the first pixel of a box, since the next point waits where it goes to the same place.
pub const BEHIND: usize = 1 << (u32::BITS - SHIFT);
/// What is said of the box of a piece that is wholly in the picture: more pixels than it has, so that no point is
/// asked whether it is in.
const WITHIN: [u32; 2] = [BEHIND as u32; 2];
/// So much larger than a piece its box is, in pixels, that no point is rounded out of it.
pub const SLACK: f64 = 1e-4;

impl Placement {
    /// For a piece with this extent, where a row of the picture has `width` places.
    pub fn new(map: &Affine2, width: u32, extent: &Extent) -> Self {
        let pixel = f64::from(1_u32 << SHIFT);
        let [a, b, c, d, e, f] = map.to_row();
        let (x, y) = (extent.pixels.x, extent.pixels.y);
        Self {
            linear: [[a, b], [c, d]].map(|row| {
                let [a, b] = row.map(|x| split(x * PIXEL));
                [[a[0], b[0]], [a[1], b[1]]]
            }),
            translation: [e - f64::from(x.0), f - f64::from(y.0)].map(|x| (x * pixel) as i64 as u32),
            corner: y.0 * width + x.0,
            size: if extent.inside { WITHIN } else { [x.1 - x.0 + 1, y.1 - y.0 + 1] },
            width,
        }
    }

    /// Tells the place of each point, row after row, and which point it is; of one outside one of [`BEHIND`] places
    /// from `behind` on, so that a point needs no choice.
    #[inline]
    pub fn each(&self, cloud: &Cloud, behind: u32, mut put: impl FnMut(u32, &CloudPoint)) {
        let rows = self.linear.map(|row| row.map(|[a, b]| i16x8::new([a, b, a, b, a, b, a, b])));
        for (halves, points) in cloud.places.iter().zip(cloud.points.chunks(LANES)) {
            let mut at = [[0_u32; LANES]; 2];
            for (axis, [row, small]) in rows.into_iter().enumerate() {
                let (mut whole, mut rest, mut more) = ([0; LANES], [0; LANES], [0; LANES]);
                for (half, [high, low]) in halves.iter().enumerate() {
                    let lanes = 4 * half..4 * half + 4;
                    whole[lanes.clone()].copy_from_slice(&row.dot(*high).to_array());
                    rest[lanes.clone()].copy_from_slice(&small.dot(*high).to_array());
                    more[lanes].copy_from_slice(&row.dot(*low).to_array());
                }
                for k in 0..LANES {
                    let rest: i32 = i32::wrapping_add(rest[k], more[k]) >> LOW_SHIFT;
                    let sum = i32::wrapping_add(whole[k], rest) as u32;
                    at[axis][k] = sum.wrapping_add(self.translation[axis]) >> SHIFT;
                }
            }
            let mut places = [0_u32; LANES];
            for k in 0..LANES {
                let row = at[1][k].wrapping_mul(self.width).wrapping_add(self.corner);
                places[k] = row.wrapping_add(at[0][k]);
            }
            if self.size != WITHIN {
                for k in 0..LANES {
                    let inside = (at[0][k] < self.size[0]) & (at[1][k] < self.size[1]);
                    places[k] = if inside { places[k] } else { behind.wrapping_add(at[0][k]) };
                }
            }
            for (place, point) in places.into_iter().zip(points) {
                put(place, point);
            }
        }
    }
}

/// The same of a piece of any size, by floats, of points in the window alone.
pub fn each_of_large(map: &Affine2, window: Window, cloud: &Cloud, mut put: impl FnMut(u32, &CloudPoint)) {
    for point in &cloud.points {
        if let Some((x, y)) = window.pixel(map.apply(Vec2::from(point.position).as_dvec2())) {
            put(y * window.width + x, point);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::window::PixelBox;
    use crate::pieces::letters::Letters;

    const WINDOW: Window = Window { width: 8000, height: 6000 };

    fn cloud() -> Cloud {
        let at = |seed, i| frond_core::hash::unit(frond_core::hash::counter(seed, i)) * 1.6 - 0.8;
        let points = (0..500).map(|i| [at(1, i), at(2, i)]).filter(|[x, y]| x * x + y * y <= 1.0);
        Cloud::of(points.map(|position| CloudPoint { position, letters: Letters::NONE }).collect())
    }

    #[test]
    fn points_of_pieces_anywhere_in_large_pictures_are_where_they_belong() {
        let area = WINDOW.area() as u32;
        for row in [
            [24.0, 0.0, 0.0, 24.0, 3000.3, 2000.4],
            [-10.0, 15.0, 12.0, 16.0, 7960.7, 5970.2],
            [17.0, 16.0, -17.0, 16.0, 2.6, -3.3],
            [0.0, 24.0, -24.0, 0.0, 7999.2, 5999.1],
            [0.0, 9.0, 0.0, 1.0, -2.2, 900.1],
        ] {
            let map = Affine2::from_row(row);
            let (mut within, mut differ) = (0, 0);
            Placement::new(&map, WINDOW.width, &WINDOW.extent_within(&map, SLACK).unwrap()).each(
                &cloud(),
                area,
                |at, point| {
                    let exact = WINDOW.pixel(map.apply(Vec2::from(point.position).as_dvec2()));
                    within += u32::from(exact.is_some());
                    assert!(at < area + BEHIND as u32);
                    differ += u32::from(exact.map_or(area, |(x, y)| y * WINDOW.width + x) != at.min(area));
                },
            );
            assert!(within > 50 && differ <= 2, "{row:?}: {differ} of {within}");
        }
    }

    #[test]
    fn no_point_is_put_outside_of_the_box_of_its_piece() {
        // Of the last column of points the box has none, though they are in the window.
        let map = Affine2::from_row([20.0, 0.0, 0.0, 20.0, 100.5, 100.5]);
        let mut extent = WINDOW.extent(&map).unwrap();
        (extent.pixels.x.1, extent.inside) = (110, false);
        let mut most = 0;
        Placement::new(&map, WINDOW.width, &extent).each(&cloud(), WINDOW.area() as u32, |at, _| {
            most = most.max(if at < WINDOW.area() as u32 { at % WINDOW.width } else { 0 });
        });
        assert_eq!(most, 110);
    }

    #[test]
    fn no_point_on_the_rim_of_a_piece_is_rounded_out_of_its_box() {
        let mut near = 0;
        for i in 0..3000 {
            let random = |seed, least: f64| {
                least + f64::from(frond_core::hash::unit(frond_core::hash::counter(seed, i)))
            };
            let (angle, size, flat) = (random(1, 0.0) * 6.3, random(2, 0.01) * 23.0, random(3, 0.0));
            let (sin, cos) = angle.sin_cos();
            let row = [size * cos, -size * sin * flat, size * sin, size * cos * flat];
            let reach = [row[0].hypot(row[1]), row[2].hypot(row[3])];
            // Its rim meets the border of pixels, all but a few parts of a million of a pixel.
            let at = reach.map(|reach| 500.0 + reach.fract() * f64::from(i % 2) - 1e-6 * random(4, -0.5));
            let at = if i % 2 == 0 { [at[0] - reach[0].fract(), at[1] - reach[1].fract()] } else { at };
            let map = Affine2::from_row([row[0], row[1], row[2], row[3], at[0], at[1]]);
            let rim = [[row[0] / reach[0], row[1] / reach[0]], [row[2] / reach[1], row[3] / reach[1]]];
            let rim = rim.into_iter().flat_map(|[x, y]| [[x, y], [-x, -y]]);
            let point =
                |[x, y]: [f64; 2]| CloudPoint { position: [x as f32, y as f32], letters: Letters::NONE };
            let extent = WINDOW.extent_within(&map, SLACK).unwrap();
            assert!(extent.inside);
            let PixelBox { x, y } = extent.pixels;
            Placement::new(&map, WINDOW.width, &extent).each(
                &Cloud::of(rim.map(point).collect()),
                0,
                |at, _| {
                    let (column, line) = (at % WINDOW.width, at / WINDOW.width);
                    assert!(
                        column >= x.0 && column <= x.1 && line >= y.0 && line <= y.1,
                        "{map:?}: {column}, {line}"
                    );
                    near += u32::from(column == x.0 || column == x.1 || line == y.0 || line == y.1);
                },
            );
        }
        assert!(near > 5000, "{near}");
    }
}
