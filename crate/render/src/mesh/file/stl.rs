//! Binary STL: millimetres, by custom.

use glam::Vec3;

use super::super::Mesh;

/// It must not begin with "solid": text does.
const HEAD: &[u8; 80] = b"Frond, millimetres                                                              ";

/// The mesh as binary STL.
#[must_use]
pub fn stl(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(84 + 50 * mesh.triangles.len());
    bytes.extend(HEAD);
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    for triangle in &mesh.triangles {
        let corners = triangle.map(|v| Vec3::from_array(mesh.positions[v as usize]));
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or_zero();
        for point in [normal, a, b, c] {
            bytes.extend(point.to_array().iter().flat_map(|x| x.to_le_bytes()));
        }
        bytes.extend([0, 0]);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Reader, tetrahedron};
    use super::*;

    #[test]
    fn triangles_come_back_with_their_normals() {
        let mesh = tetrahedron();
        let bytes = stl(&mesh);
        assert_eq!(bytes.len(), 84 + 50 * 4);
        assert!(!bytes.starts_with(b"solid"));
        let mut file = Reader(&bytes[80..]);
        assert_eq!(file.u32(), 4);
        for triangle in &mesh.triangles {
            let [normal, a, b, c] = [(); 4].map(|()| Vec3::from_array([(); 3].map(|()| file.f32())));
            assert_eq!([a, b, c].map(|p| p.to_array()), triangle.map(|v| mesh.positions[v as usize]));
            // Outwards from the middle.
            assert!(normal.is_normalized() && normal.dot(a - Vec3::splat(0.75)) > 0.1);
            assert_eq!(file.take::<2>(), [0, 0]);
        }
        assert!(file.0.is_empty());
    }
}
