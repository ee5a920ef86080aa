//! Where balls are seen in a picture.

use glam::DVec3;

use super::Camera;

/// A piece whose ball is smaller than this, in pixels across, is a pixel.
pub(super) const PIXEL_SIZE: f64 = 1.0;

/// A picture, or a band of its rows, before an eye at the origin that looks along z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    /// Pixels a unit at depth 1.
    pub focal: f64,
    /// The pixel that the eye looks at.
    pub middle: [f64; 2],
    /// Columns, and the rows of the band: its first one, and the one after its last.
    pub width: u32,
    pub rows: [u32; 2],
    /// Nearer than this nothing is seen.
    pub near: f64,
    /// The farthest that a corner of the picture is from its axis, at depth 1.
    reach: f64,
}

/// What a ball takes up in the picture.
pub(super) enum Footprint {
    None,
    Pixel([u32; 2]),
    /// The pixels of the band that it may reach, both ends included, and its nearest depth.
    Box([u32; 4], f64),
}

impl Lens {
    /// The rows from `rows[0]` on, before `rows[1]`, of a picture of this size.
    pub fn new(camera: &Camera, [width, height]: [u32; 2], rows: [u32; 2], near: f64) -> Self {
        let focal = camera.focal(height);
        let (across, down) = (0.5 * f64::from(width), 0.5 * f64::from(height));
        let rows = [rows[0], rows[1].max(rows[0] + 1)];
        Self {
            focal,
            middle: [across, down],
            width: width.max(1),
            rows,
            near,
            reach: across.hypot(down) / focal,
        }
    }

    /// Where a ball is seen.
    pub fn footprint(&self, ball: DVec3, radius: f64) -> Footprint {
        let (width, [top, end]) = (f64::from(self.width), self.rows.map(f64::from));
        if ball.z + radius <= self.near {
            return Footprint::None;
        }
        let nearest = ball.z - radius;
        if nearest <= self.near {
            // The eye may be within: all of the picture, unless it lies to a side.
            let aside = ball.x.hypot(ball.y) - radius;
            let beyond = aside > self.reach * (ball.z + radius);
            let whole = [0, 0, self.width - 1, self.rows[1] - self.rows[0] - 1];
            // What is that near and no larger is let go: nobody holds a thing against the eye to see it.
            return if beyond || radius < 0.5 * self.near {
                Footprint::None
            } else {
                Footprint::Box(whole, self.near)
            };
        }
        let scale = self.focal / ball.z;
        let (x, y) = (self.middle[0] + scale * ball.x, self.middle[1] - scale * ball.y);
        if 2.0 * radius * scale <= PIXEL_SIZE {
            let inside = x >= 0.0 && y >= top && x < width && y < end;
            // The row is found first: in all bands rounding takes a piece to one.
            let pixel = || Footprint::Pixel([x as u32, y as u32 - self.rows[0]]);
            return if inside { pixel() } else { Footprint::None };
        }
        // The ball is within the cone of this slope around its middle's, by its nearest depth.
        let reach = |along: f64| {
            let off = radius * (1.0 + (along / ball.z).powi(2)).sqrt();
            self.focal * off / nearest
        };
        let (dx, dy) = (reach(ball.x), reach(ball.y));
        let (x0, x1, y0, y1) = (x - dx, x + dx, y - dy, y + dy);
        if x1 < 0.0 || y1 < top || x0 >= width || y0 >= end {
            return Footprint::None;
        }
        let column = |x: f64| x.clamp(0.0, width - 1.0) as u32;
        let row = |y: f64| y.clamp(top, end - 1.0) as u32 - self.rows[0];
        Footprint::Box([column(x0), row(y0), column(x1), row(y1)], nearest)
    }
}
