//! How far the samples of a grid are from points.

use glam::DVec3;

/// Beyond the surface distances are known for so many samples: the next one across it is among them.
const BEYOND: f64 = 1.5;
/// No sample lies nearer than this to the surface, so that no two of its vertices fall together.
const OFF_SURFACE: f32 = 0.02;

/// Samples at whole numbers, each with its distance to the nearest point, as far as that matters, and the code of that.
pub(super) struct Field {
    pub size: [usize; 3],
    /// Squares of distances; once it is [`Field::signed`], distances to the surface, negative inside.
    pub value: Vec<f32>,
    pub code: Vec<u16>,
    radius: f64,
}

impl Field {
    /// For a surface at `radius` from the points.
    pub fn new(size: [usize; 3], radius: f64) -> Self {
        let count = size.iter().product();
        let far = (radius + BEYOND).powi(2) as f32;
        Self { size, value: vec![far; count], code: vec![0; count], radius }
    }

    pub fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.size[1] + y) * self.size[0] + x
    }

    /// Takes a point in.
    pub fn put(&mut self, point: DVec3, code: u16) {
        let reach = self.radius + BEYOND;
        let place = point.to_array();
        // Casts keep what is below 0 at it.
        let range = |k: usize| {
            let from = ((place[k] - reach).ceil() as usize).min(self.size[k]);
            from..((place[k] + reach).floor() as usize + 1).min(self.size[k])
        };
        let (ys, zs) = (range(1), range(2));
        let [px, py, pz] = place.map(|c| c as f32);
        let far = (reach * reach) as f32;
        let last = (self.size[0] - 1) as f32;
        for z in zs {
            let dz = (z as f32 - pz).powi(2);
            for y in ys.clone() {
                let across = dz + (y as f32 - py).powi(2);
                if across >= far {
                    continue;
                }
                let half = (far - across).sqrt();
                let (from, to) = ((px - half).ceil() as usize, (px + half).floor().min(last) as usize);
                let row = self.index([0, y, z]);
                for x in from..=to {
                    let square = across + (x as f32 - px).powi(2);
                    if square < self.value[row + x] {
                        self.value[row + x] = square;
                        self.code[row + x] = code;
                    }
                }
            }
        }
    }

    /// Distances to the surface, negative inside.
    pub fn signed(&mut self) {
        let radius = self.radius as f32;
        for value in &mut self.value {
            let distance = value.sqrt() - radius;
            *value = if distance < 0.0 { distance.min(-OFF_SURFACE) } else { distance.max(OFF_SURFACE) };
        }
    }

    /// Puts a sample inside that was not.
    pub fn fill(&mut self, index: usize) {
        self.value[index] = -OFF_SURFACE;
    }

    /// Fills what is outside and cannot be come to from the border. What was well-composed stays so: where two samples
    /// outside meet, all between them belong to the same part of the outside, or to the inside.
    pub fn fill_hollows(&mut self) {
        let [nx, ny, nz] = self.size;
        let mut reached = vec![0_u64; self.value.len().div_ceil(64)];
        let mut open = vec![0_usize];
        while let Some(start) = open.pop() {
            let row = start - start % nx;
            let free =
                |reached: &[u64], at: usize| self.value[at] > 0.0 && reached[at >> 6] >> (at & 63) & 1 == 0;
            if !free(&reached, start) {
                continue;
            }
            // A run along x, and from each run beside it one sample.
            let from = (row..start).rev().take_while(|&at| free(&reached, at)).last().unwrap_or(start);
            let to = (start..row + nx).take_while(|&at| free(&reached, at)).last().unwrap_or(start);
            for at in from..=to {
                reached[at >> 6] |= 1 << (at & 63);
            }
            let (y, z) = (row / nx % ny, row / (nx * ny));
            let beside = [
                (y > 0, from.wrapping_sub(nx)),
                (y + 1 < ny, from + nx),
                (z > 0, from.wrapping_sub(nx * ny)),
                (z + 1 < nz, from + nx * ny),
            ];
            for (_, other) in beside.into_iter().filter(|(is, _)| *is) {
                let mut before = false;
                for at in other..=other + (to - from) {
                    let is = free(&reached, at);
                    if is && !before {
                        open.push(at);
                    }
                    before = is;
                }
            }
        }
        for at in 0..self.value.len() {
            if self.value[at] > 0.0 && reached[at >> 6] >> (at & 63) & 1 == 0 {
                self.fill(at);
            }
        }
    }

    /// Edges of the grid that the surface crosses: each becomes two triangles.
    pub fn crossings(&self) -> usize {
        let [nx, ny, nz] = self.size;
        let steps = [1, nx, nx * ny];
        let mut count = 0;
        for z in 0..nz {
            for y in 0..ny {
                let row = self.index([0, y, z]);
                for x in 0..nx {
                    let inside = self.value[row + x] < 0.0;
                    let more = [x + 1 < nx, y + 1 < ny, z + 1 < nz];
                    for (step, more) in steps.iter().zip(more) {
                        count += usize::from(more && (self.value[row + x + step] < 0.0) != inside);
                    }
                }
            }
        }
        count
    }
}
