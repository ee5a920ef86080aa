//! Small pieces of space: in single precision, the parts of a piece side by side.

use frond_core::MAX_MAPS;
use glam::{Mat3A, Vec3A, Vec4};

use super::DepthBuffer;
use super::lens::{Lens, PIXEL_SIZE};
use super::points::OBJECT_BIT;
use super::shape::{LANES, Shape};
use crate::pieces::letters::Letters;

const MOST_GROUPS: usize = MAX_MAPS.div_ceil(LANES);
/// The longest word: what is that deep is a pixel, whatever its size.
pub(super) const LONGEST_WORD: u32 = 400;

/// A piece before the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct FinePiece {
    pub linear: Mat3A,
    /// The middle of a ball around it, and its radius: a bound that may be taken closer when it is looked into.
    pub centre: Vec3A,
    pub radius: f32,
    pub letters: Letters,
    pub depth: u32,
}

/// What goes down from one piece to its pixels. All pieces that are open are of one object.
#[derive(Clone, Debug)]
pub(super) struct Fine {
    open: Vec<FinePiece>,
    focal: f32,
    middle: [f32; 2],
    width: f32,
    /// The first row, and the one after the last.
    rows: [f32; 2],
    near: f32,
    /// Where the parts of the piece at hand are seen: columns, rows, depths, radii.
    x: [[f32; LANES]; MOST_GROUPS],
    y: [[f32; LANES]; MOST_GROUPS],
    z: [[f32; LANES]; MOST_GROUPS],
    radius: [[f32; LANES]; MOST_GROUPS],
    /// The letters, the farthest part first: as they were for the piece before, put right for each.
    order: Vec<u8>,
}

impl Fine {
    pub fn new(lens: &Lens) -> Self {
        let blank = [[0.0; LANES]; MOST_GROUPS];
        Self {
            open: Vec::new(),
            focal: lens.focal as f32,
            middle: lens.middle.map(|v| v as f32),
            width: lens.width as f32,
            rows: lens.rows.map(|v| v as f32),
            near: lens.near as f32,
            x: blank,
            y: blank,
            z: blank,
            radius: blank,
            order: Vec::new(),
        }
    }

    /// Opens a piece.
    pub fn open(&mut self, piece: FinePiece) {
        self.open.push(piece);
    }

    pub fn is_done(&self) -> bool {
        self.open.is_empty()
    }

    /// Looks into the piece that was opened last, if there is one: how many parts were looked at.
    pub fn step(&mut self, shape: &Shape, object: u32, buffer: &mut DepthBuffer) -> Option<usize> {
        let mut piece = self.open.pop()?;
        if !shape.similar {
            piece.radius = piece.radius.min(stretch(&piece.linear) * shape.radius as f32 * ROUNDED_UP);
        }
        let code = |letters: Letters| 1 + (letters.packed() | object << OBJECT_BIT);
        let (centre, radius) = (piece.centre, piece.radius);
        let nearest = centre.z - radius;
        if centre.z + radius <= self.near {
            return Some(1);
        }
        let scale = self.focal / centre.z;
        let (x, y) = (self.middle[0] + scale * centre.x, self.middle[1] - scale * centre.y);
        if nearest <= self.near {
            // What is that near and no larger is let go, as larger pieces are.
            if radius < 0.5 * self.near {
                return Some(1);
            }
        } else {
            if 2.0 * radius * scale <= PIXEL_SIZE as f32 {
                self.put(buffer, x, y, centre.z, code(piece.letters));
                return Some(1);
            }
            // The ball is within the cone of this slope around its middle's, by its nearest depth.
            let (slope, reach) = (centre / centre.z, self.focal * radius / nearest);
            let slope = (slope * slope + 1.0).to_array();
            let (dx, dy) = (reach * slope[0].sqrt(), reach * slope[1].sqrt());
            let (x0, x1, y0, y1) = (x - dx, x + dx, y - dy, y + dy);
            let (width, [top, end]) = (self.width, self.rows);
            if x1 < 0.0 || y1 < top || x0 >= width || y0 >= end {
                return Some(1);
            }
            let column = |x: f32| x.max(0.0).min(width - 1.0) as u32;
            let row = |y: f32| y.max(top).min(end - 1.0) as u32 - top as u32;
            let pixels = [column(x0), row(y0), column(x1), row(y1)];
            if buffer.hides(pixels, nearest) {
                return Some(1);
            }
            if piece.depth >= LONGEST_WORD {
                let [x0, y0, x1, y1] = pixels;
                buffer.put(u32::midpoint(x0, x1), u32::midpoint(y0, y1), centre.z, code(piece.letters));
                return Some(1);
            }
        }
        self.look_into(&piece, shape, object, buffer);
        Some(1 + shape.maps.len())
    }

    /// Draws the parts of a piece that are pixels, and opens the others, so that the nearest comes next.
    fn look_into(&mut self, piece: &FinePiece, shape: &Shape, object: u32, buffer: &mut DepthBuffer) {
        let count = shape.maps.len();
        let (linear, centre) = (piece.linear, piece.centre);
        let [a, b, c] = [linear.x_axis, linear.y_axis, linear.z_axis];
        let focal = Vec4::splat(self.focal);
        for (k, group) in shape.groups.iter().enumerate() {
            let along =
                |a: f32, b: f32, c: f32, middle: f32| group.x * a + group.y * b + (group.z * c + middle);
            let z = along(a.z, b.z, c.z, centre.z);
            let scale = focal / z;
            let x = along(a.x, b.x, c.x, centre.x) * scale + self.middle[0];
            let y = Vec4::splat(self.middle[1]) - along(a.y, b.y, c.y, centre.y) * scale;
            self.x[k] = x.to_array();
            self.y[k] = y.to_array();
            self.z[k] = z.to_array();
            self.radius[k] = (group.size * piece.radius).to_array();
        }
        if self.order.len() != count {
            self.order = (0..count as u8).collect();
        }
        // Nothing of it is farther before the rest than its nearest depth.
        let nearest = centre.z - piece.radius;
        let all = nearest > self.near
            && 2.0 * piece.radius * shape.largest * self.focal <= PIXEL_SIZE as f32 * nearest;
        if all {
            for at in 0..count {
                let letter = usize::from(self.order[count - 1 - at]);
                self.put_part(piece, letter, object, buffer);
            }
            return;
        }
        self.sort();
        for at in 0..count {
            let letter = usize::from(self.order[at]);
            let (z, radius) = (self.z.as_flattened()[letter], self.radius.as_flattened()[letter]);
            if 2.0 * radius * self.focal <= PIXEL_SIZE as f32 * z {
                if z - radius > self.near {
                    self.put_part(piece, letter, object, buffer);
                }
                continue;
            }
            let group = &shape.groups[letter / LANES];
            let lane = letter % LANES;
            let offset = Vec3A::new(group.x[lane], group.y[lane], group.z[lane]);
            self.open.push(FinePiece {
                linear: linear * shape.linear[letter],
                centre: linear * offset + centre,
                radius,
                letters: piece.letters.then(letter),
                depth: piece.depth + 1,
            });
        }
    }

    /// The farthest first. Pieces of a shape mostly lie alike: little is out of order.
    fn sort(&mut self) {
        let z = self.z.as_flattened();
        for at in 1..self.order.len() {
            let letter = self.order[at];
            let depth = z[usize::from(letter)];
            let mut to = at;
            while to > 0 && z[usize::from(self.order[to - 1])] < depth {
                self.order[to] = self.order[to - 1];
                to -= 1;
            }
            self.order[to] = letter;
        }
    }

    #[inline]
    fn put_part(&self, piece: &FinePiece, letter: usize, object: u32, buffer: &mut DepthBuffer) {
        let at = |list: &[[f32; LANES]; MOST_GROUPS]| list.as_flattened()[letter];
        let code = 1 + (piece.letters.then(letter).packed() | object << OBJECT_BIT);
        self.put(buffer, at(&self.x), at(&self.y), at(&self.z), code);
    }

    #[inline]
    fn put(&self, buffer: &mut DepthBuffer, x: f32, y: f32, z: f32, code: u32) {
        let [top, end] = self.rows;
        if x >= 0.0 && y >= top && x < self.width && y < end {
            // The row is found first: in all bands rounding takes a piece to one.
            buffer.put(x as u32, y as u32 - top as u32, z, code);
        }
    }
}

/// Bounds are taken this much larger: rounding must not make them too small.
const ROUNDED_UP: f32 = 1.0 + 1e-5;

/// An upper bound of how much a matrix stretches: exact for similitudes.
fn stretch(m: &Mat3A) -> f32 {
    let gram = m.transpose() * *m;
    // It is symmetric: sums along its columns are those along its rows.
    (gram.x_axis.abs() + gram.y_axis.abs() + gram.z_axis.abs()).max_element().sqrt()
}
