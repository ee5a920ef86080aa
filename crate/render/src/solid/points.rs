//! Points of space on the screen: the CPU twin of `shader/solid/points.wgsl`.

use bytemuck::{Pod, Zeroable};
use frond_core::{Affine3, ChaosGame3, Ifs3, adaptive_cut3, affinity_dimension};

use super::{Camera, DepthBuffer};
use crate::pieces::letters::Letters;

/// A camera as the shader reads it: a uniform buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Eye {
    /// Row by row, from space to right, up and away; the last column moves.
    pub rows: [[f32; 4]; 3],
    /// Width and height, in pixels.
    pub size: [f32; 2],
    /// Pixels a unit at depth 1.
    pub focal: f32,
    /// The nearest depth that is seen.
    pub near: f32,
    /// The farthest depth there is; the others are unused.
    pub far: [f32; 4],
}

/// A point of a cloud.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex3 {
    /// Where it is.
    pub position: [f32; 3],
    /// The first letters of its address, packed.
    pub letters: u32,
}

/// A piece, which places a cloud in space: one for each instance.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Instance3 {
    /// Row by row, the translation last.
    pub rows: [[f32; 4]; 3],
    /// The first letters of its word, packed, and from bit 18 on their count.
    pub letters: u32,
    /// The object's number, where codes have it.
    pub object: u32,
}

/// Points of a system: one cloud, and the pieces that place it.
#[derive(Clone, Debug, Default)]
pub struct Cloud {
    /// Points of the whole attractor.
    pub vertices: Vec<Vertex3>,
    /// Pieces that together are all of it.
    pub instances: Vec<Instance3>,
    /// About how far points are from each other, in units of space.
    pub gap: f32,
}

/// Letters count from this bit on, objects in codes.
pub(super) const OBJECT_BIT: u32 = 18;

/// The fewest points of a cloud that is placed several times.
const FEWEST_CLOUD_POINTS: usize = 400;

/// Pieces that together are all of it, no more than `most`, and none that is much larger than another: each is given as
/// many points.
fn instances(ifs: &Ifs3, number: u32, most: usize) -> Vec<Instance3> {
    let mut found: Vec<(Affine3, usize)> = vec![(Affine3::IDENTITY, 0)];
    let mut size = 1.0;
    loop {
        size *= 0.8;
        let mut pieces = Vec::new();
        if size < 1e-6 || !adaptive_cut3(ifs, size, most, |map, first| pieces.push((*map, first))).complete {
            break;
        }
        found = pieces;
    }
    let whole = found.len() == 1;
    let instance = |(map, first): &(Affine3, usize)| {
        let letters = if whole { Letters::NONE } else { Letters::NONE.then(*first) };
        Instance3 {
            rows: rows(map),
            letters: letters.packed() | u32::from(letters.count()) << 18,
            object: number << OBJECT_BIT,
        }
    };
    found.iter().map(instance).collect()
}

pub(super) fn rows(map: &Affine3) -> [[f32; 4]; 3] {
    let row = |k: usize| {
        let (r, t) = (map.linear.row(k), map.translation[k]);
        [r.x, r.y, r.z, t].map(|x| x as f32)
    };
    [row(0), row(1), row(2)]
}

impl Eye {
    /// The eye of a camera in a picture, for depths from `near` to `far`.
    #[must_use]
    pub fn new(camera: &Camera, width: u32, height: u32, [near, far]: [f32; 2]) -> Self {
        let place = Affine3::new(camera.turn, -(camera.turn * camera.eye));
        Self {
            rows: rows(&place),
            size: [width as f32, height as f32],
            focal: camera.focal(height) as f32,
            near,
            far: [far.max(near * 1.001), 0.0, 0.0, 0.0],
        }
    }

    /// Puts a point of a piece where the eye sees it.
    pub fn draw(&self, buffer: &mut DepthBuffer, point: &Vertex3, piece: &Instance3) {
        let dot = |row: &[f32; 4], p: [f32; 3]| row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
        let place = [0, 1, 2].map(|k| dot(&piece.rows[k], point.position));
        let [x, y, z] = [0, 1, 2].map(|k| dot(&self.rows[k], place));
        let [width, height] = self.size;
        let scale = self.focal / z;
        let (column, row) = ((0.5 * width + scale * x).floor(), (0.5 * height - scale * y).floor());
        if z > self.near && column >= 0.0 && row >= 0.0 && column < width && row < height {
            let letters = piece.letters & 0x3_ffff | point.letters >> (6 * (piece.letters >> 18));
            buffer.put(column as u32, row as u32, z, (piece.object | letters) + 1);
        }
    }
}

/// The space that each of `count` points has to itself, if they are spread over something of the system's dimension and
/// of the size of `vertices`. Chance leaves larger holes than that, and larger points would hide what is fine: filling
/// holes closes most.
pub(super) fn gap(ifs: &Ifs3, vertices: &[Vertex3], count: usize) -> f32 {
    let reach = |k: usize| {
        let of = |v: &Vertex3| v.position[k];
        let high = vertices.iter().map(of).fold(f32::NEG_INFINITY, f32::max);
        let low = vertices.iter().map(of).fold(f32::INFINITY, f32::min);
        high - low
    };
    let radius = 0.5 * (0..3).map(reach).map(|side| side * side).sum::<f32>().sqrt();
    let dimension = affinity_dimension(ifs).clamp(1.0, 3.0);
    let gap = f64::from(radius) * (count.max(1) as f64).powf(-1.0 / dimension);
    if gap.is_finite() { gap as f32 } else { 0.0 }
}

impl Cloud {
    /// About `count` points of a system that is object `number`, from a seed.
    #[must_use]
    pub fn new(ifs: &Ifs3, number: u32, count: usize, seed: u32) -> Self {
        let instances = instances(ifs, number, count / FEWEST_CLOUD_POINTS);
        let share = (count / instances.len().max(1)).max(1);
        let mut game = ChaosGame3::new(ifs, seed);
        let mut positions = vec![0.0_f32; 3 * share];
        let mut pieces = vec![0_u8; share];
        let made = game.fill(&mut positions, &mut pieces);
        let vertices: Vec<Vertex3> = positions
            .chunks_exact(3)
            .zip(&pieces)
            .take(made)
            .map(|(p, &piece)| Vertex3 {
                position: [p[0], p[1], p[2]],
                letters: Letters::NONE.then(usize::from(piece)).packed(),
            })
            .collect();
        let gap = gap(ifs, &vertices, vertices.len() * instances.len());
        Self { vertices, instances, gap }
    }

    /// How many points are drawn.
    #[must_use]
    pub fn points(&self) -> usize {
        self.vertices.len() * self.instances.len()
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;
    use crate::solid::{Traversal, fill_holes};

    #[test]
    fn points_fall_where_the_pieces_are_and_mending_closes_the_holes() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let maps = corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, c * 0.5)).to_vec();
        let ifs = Ifs3::new(maps).unwrap();
        let camera = Camera::around(DVec3::splat(0.3), 3.0, 0.5, 0.4, 0.6).unwrap();
        let mut traversal = Traversal::new(std::slice::from_ref(&ifs), &camera, 120, 90);
        let range = traversal.range();
        assert!(traversal.run(10_000_000));
        let eye = Eye::new(&camera, 120, 90, range);
        let cloud = Cloud::new(&ifs, 3, 200_000, 1);
        assert!(cloud.points() > 100_000 && cloud.points() <= 200_000);
        let mut buffer = DepthBuffer::new(120, 90);
        for piece in &cloud.instances {
            for point in &cloud.vertices {
                eye.draw(&mut buffer, point, piece);
            }
        }
        let off = |buffer: &DepthBuffer| {
            let pairs = buffer.depth().iter().zip(traversal.depth_buffer().depth());
            pairs.filter(|(a, b)| a.is_finite() != b.is_finite()).count()
        };
        let lit = traversal.depth_buffer().lit();
        // Pixels of a piece that is smaller than one are lit by its middle: borders differ.
        assert!(off(&buffer) * 5 < lit, "{} of {lit}", off(&buffer));
        let same = buffer.depth().iter().zip(traversal.depth_buffer().depth());
        let near = same.filter(|(a, b)| (**a - **b).abs() < 0.02).count();
        assert!(near * 4 > lit * 3, "{near} of {lit}");
        let first = buffer.codes().iter().find(|&&code| code != 0).unwrap() - 1;
        assert_eq!(first >> OBJECT_BIT, 3);
        assert!(fill_holes(&buffer, eye.focal).lit() + 200 > buffer.lit());
    }
}
