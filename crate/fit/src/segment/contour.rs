//! The line round a shape, finer than its pixels.

use glam::DVec2;

/// A field of numbers on the centres of pixels: above zero inside. Beyond its border it is -1.
pub struct Field {
    pub width: usize,
    pub height: usize,
    pub values: Vec<f32>,
}

/// The corners of a cell of four pixels, from the upper left one clockwise on the screen.
const CORNERS: [(isize, isize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];

impl Field {
    fn at(&self, x: isize, y: isize) -> f32 {
        if x < 0 || y < 0 || x >= self.width as isize || y >= self.height as isize {
            return -1.0;
        }
        self.values[y as usize * self.width + x as usize]
    }

    /// The longest way round by area: where the field, straight between neighbouring pixels, is zero (marching squares,
    /// told apart at saddles by the mean). In pixels from the upper left corner, y down; empty where all is outside.
    #[inline(never)]
    pub fn contour(&self) -> Vec<DVec2> {
        let (columns, rows) = (self.width + 1, self.height + 1);
        // A cell's upper left pixel is (x - 1, y - 1). Ways start at edges with the inside on the right, which a way
        // enters through the left side of a cell.
        let mut seen = vec![false; columns * rows];
        let mut best: (f64, Vec<DVec2>) = (0.0, Vec::new());
        let outside = vec![-1.0; self.width];
        for y in 0..rows {
            let row = |y: usize| self.values.get(y * self.width..(y + 1) * self.width).unwrap_or(&outside);
            let (above, here) = (if y == 0 { &outside[..] } else { row(y - 1) }, row(y));
            for x in 1..columns {
                if above[x - 1] <= 0.0 && here[x - 1] > 0.0 && !seen[y * columns + x] {
                    let way = self.walk(x, y, &mut seen);
                    let area = area(&way).abs();
                    if area > best.0 {
                        best = (area, way);
                    }
                }
            }
        }
        best.1
    }

    /// Follows a way from cell (x, y), which it enters through its left side, back to there. The inside is on its right
    /// (on the screen).
    #[inline(never)]
    fn walk(&self, x: usize, y: usize, seen: &mut [bool]) -> Vec<DVec2> {
        let columns = self.width + 1;
        let start = (x, y);
        let (mut x, mut y, mut side) = (x, y, 3);
        let mut way = Vec::new();
        loop {
            if side == 3 {
                // The way is closed where it began.
                if seen[y * columns + x] {
                    break;
                }
                seen[y * columns + x] = true;
            }
            let corner = |k: usize| {
                let (dx, dy) = CORNERS[k % 4];
                let (px, py) = (x as isize - 1 + dx, y as isize - 1 + dy);
                (self.at(px, py), DVec2::new(px as f64 + 0.5, py as f64 + 0.5))
            };
            // Side k runs from corner k to corner k + 1; here the first is inside and the second is not.
            let ((inner, a), (outer, b)) = (corner(side), corner(side + 1));
            let share = f64::from(inner) / (f64::from(inner) - f64::from(outer));
            way.push(a.lerp(b, share.clamp(0.0, 1.0)));
            let inside = |k: usize| corner(k).0 > 0.0;
            let middle = (0..4).map(|k| corner(k).0).sum::<f32>() > 0.0;
            // Round the corner that is outside, unless the next is outside, too. At a saddle the middle decides.
            let out = match (inside(side + 2), inside(side + 3)) {
                (true, false) => {
                    if middle {
                        side + 1
                    } else {
                        side + 3
                    }
                }
                (true, true) => side + 1,
                (false, true) => side + 2,
                (false, false) => side + 3,
            };
            (x, y, side) = match out % 4 {
                0 => (x, y - 1, 2),
                1 => (x + 1, y, 3),
                2 => (x, y + 1, 0),
                _ => (x - 1, y, 1),
            };
            if (x, y, side) == (start.0, start.1, 3) {
                break;
            }
        }
        way
    }
}

/// The area inside a closed polyline, negative where it runs clockwise (with y up).
pub fn area(points: &[DVec2]) -> f64 {
    let Some(&first) = points.first() else { return 0.0 };
    0.5 * points.windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first)).sum::<f64>()
}
