//! Binary PLY, with normals and colours.

use super::super::Mesh;

/// The mesh as binary PLY. `colours` has one for each code, as on the screen.
#[must_use]
pub fn ply(mesh: &Mesh, colours: &[[u8; 3]]) -> Vec<u8> {
    let head = format!(
        "ply\nformat binary_little_endian 1.0\ncomment Frond, millimetres\nelement vertex {}\n\
         property float x\nproperty float y\nproperty float z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        mesh.positions.len(),
        mesh.triangles.len()
    );
    let mut bytes = Vec::with_capacity(head.len() + 27 * mesh.positions.len() + 13 * mesh.triangles.len());
    bytes.extend(head.as_bytes());
    for ((point, normal), &code) in mesh.positions.iter().zip(&mesh.normals).zip(&mesh.codes) {
        bytes.extend(point.iter().chain(normal).flat_map(|x| x.to_le_bytes()));
        bytes.extend(colours.get(usize::from(code)).unwrap_or(&[255; 3]));
    }
    for triangle in &mesh.triangles {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|v| v.to_le_bytes()));
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Reader, tetrahedron};
    use super::*;

    #[test]
    fn vertices_colours_and_faces_come_back() {
        let mesh = tetrahedron();
        let colours = [[255, 0, 0], [0, 255, 0], [0, 0, 255]];
        let bytes = ply(&mesh, &colours);
        let end = bytes.windows(11).position(|part| part == b"end_header\n").unwrap() + 11;
        let head = str::from_utf8(&bytes[..end]).unwrap();
        assert!(head.contains("element vertex 4\n") && head.contains("element face 4\n"), "{head}");
        let mut file = Reader(&bytes[end..]);
        for v in 0..4 {
            assert_eq!([(); 3].map(|()| file.f32()), mesh.positions[v]);
            assert_eq!([(); 3].map(|()| file.f32()), mesh.normals[v]);
            assert_eq!(file.take::<3>(), colours[usize::from(mesh.codes[v])]);
        }
        for &triangle in &mesh.triangles {
            assert_eq!((file.take(), [(); 3].map(|()| file.u32())), ([3], triangle));
        }
        assert!(file.0.is_empty());
    }
}
