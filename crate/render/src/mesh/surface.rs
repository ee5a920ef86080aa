//! The surface of a field, and what can be said of one.

use fast_surface_nets::ndshape::RuntimeShape;
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use glam::{DVec3, Vec3};

use super::field::Field;

/// A closed surface of triangles: every edge has two, which go along it in opposite directions, counter-clockwise seen
/// from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// In millimetres; z points up, and the least coordinates are about 0.
    pub positions: Vec<[f32; 3]>,
    /// Outwards, of length 1.
    pub normals: Vec<[f32; 3]>,
    /// Which map of which object each vertex belongs to, as a number of the list that it was made with.
    pub codes: Vec<u16>,
    /// Numbers of vertices.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The surface of a well-composed field whose two outermost layers are outside, in units of samples.
    pub(super) fn of(field: &Field) -> Self {
        let size = field.size.map(|side| side as u32);
        let mut made = SurfaceNetsBuffer::default();
        let shape = RuntimeShape::<u32, 3>::new(size);
        surface_nets(&field.value, &shape, [0; 3], size.map(|side| side - 1), &mut made);
        let [nx, ny, _] = field.size;
        let corners = [0, 1, nx, nx + 1, nx * ny, nx * ny + 1, nx * ny + nx, nx * ny + nx + 1];
        let nearest = |&first: &u32| {
            let samples = corners.map(|step| first as usize + step);
            let least = samples.into_iter().min_by(|&a, &b| field.value[a].total_cmp(&field.value[b]));
            field.code[least.unwrap_or(first as usize)]
        };
        let normal = |&n: &[f32; 3]| Vec3::from_array(n).normalize_or(Vec3::Z).to_array();
        Self {
            codes: made.surface_strides.iter().map(nearest).collect(),
            normals: made.normals.iter().map(normal).collect(),
            triangles: made.indices.as_chunks().0.to_vec(),
            positions: made.positions,
        }
    }

    /// The least and the largest coordinates.
    #[must_use]
    pub fn bounds(&self) -> [Vec3; 2] {
        let points = || self.positions.iter().map(|&p| Vec3::from_array(p));
        [points().reduce(Vec3::min), points().reduce(Vec3::max)].map(Option::unwrap_or_default)
    }

    /// What it encloses; negative where the triangles are the wrong way round.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let corner = |v: u32| Vec3::from_array(self.positions[v as usize]).as_dvec3();
        let about = self.bounds()[0].as_dvec3();
        let under = |triangle: &[u32; 3]| {
            let [a, b, c]: [DVec3; 3] = triangle.map(|v| corner(v) - about);
            a.dot(b.cross(c)) / 6.0
        };
        self.triangles.iter().map(under).sum()
    }

    /// In how many pieces the surface is: in as many as the body, since that has no hollows.
    #[must_use]
    pub fn parts(&self) -> usize {
        let mut parent: Vec<u32> = (0..self.positions.len() as u32).collect();
        fn root(parent: &mut [u32], mut v: u32) -> u32 {
            while parent[v as usize] != v {
                let above = parent[parent[v as usize] as usize];
                parent[v as usize] = above;
                v = above;
            }
            v
        }
        let mut parts = parent.len();
        for &[a, b, c] in &self.triangles {
            for (v, w) in [(a, b), (b, c)] {
                let (v, w) = (root(&mut parent, v), root(&mut parent, w));
                if v != w {
                    parent[v as usize] = w;
                    parts -= 1;
                }
            }
        }
        parts
    }

    /// Moves it to where its least coordinates are 0, `scale` times as large.
    pub(super) fn place(&mut self, scale: f32) {
        let [least, _] = self.bounds();
        for point in &mut self.positions {
            *point = ((Vec3::from_array(*point) - least) * scale).to_array();
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use std::collections::HashMap;

    use super::super::well_composed::make_well_composed;
    use super::*;

    /// Every edge has two triangles that go along it in opposite directions, and the triangles around a vertex are one
    /// fan.
    pub fn assert_manifold(mesh: &Mesh) {
        let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
        for &[a, b, c] in &mesh.triangles {
            for (from, to, apex) in [(a, b, c), (b, c, a), (c, a, b)] {
                assert_ne!(from, to);
                assert_eq!(edges.insert((from, to), apex), None, "two triangles go from {from} to {to}");
            }
        }
        let mut fans: HashMap<u32, usize> = HashMap::new();
        for &(from, to) in edges.keys() {
            assert!(edges.contains_key(&(to, from)), "nothing goes back from {to} to {from}");
            *fans.entry(from).or_default() += 1;
        }
        for &(from, to) in edges.keys() {
            let Some(count) = fans.remove(&from) else { continue };
            let (mut at, mut steps) = (to, 0);
            loop {
                at = edges[&(from, at)];
                steps += 1;
                if at == to {
                    break;
                }
            }
            assert_eq!(steps, count, "vertex {from} has more than one fan");
        }
        assert!(fans.is_empty());
        let used = mesh.triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
        assert_eq!([mesh.normals.len(), mesh.codes.len(), used], [mesh.positions.len(); 3]);
    }

    #[test]
    fn any_field_has_a_manifold_surface_with_its_inside_within() {
        let mut state = 1_u64;
        let mut chance = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f32 / (1_u64 << 24) as f32
        };
        for round in 0..60 {
            let size = [9, 7, 8];
            let mut field = Field::new(size, 1.0);
            let share = [0.1, 0.3, 0.5, 0.8][round % 4];
            for z in 1..size[2] - 2 {
                for y in 1..size[1] - 2 {
                    for x in 1..size[0] - 2 {
                        let index = field.index([x, y, z]);
                        let inside = chance() < share;
                        field.value[index] = if inside { chance() } else { 1.0 + 5.0 * chance() };
                    }
                }
            }
            field.signed();
            make_well_composed(&mut field);
            if round % 2 == 0 {
                field.fill_hollows();
            }
            let mesh = Mesh::of(&field);
            assert_manifold(&mesh);
            assert!(mesh.volume() > 0.0);
            assert_eq!(mesh.triangles.len(), 2 * field.crossings());
        }
    }
}
