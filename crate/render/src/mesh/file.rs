//! Meshes as files.

mod glb;
mod ply;
mod stl;

pub use glb::glb;
pub use ply::ply;
pub use stl::stl;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Binary STL: triangles and nothing else.
    Stl,
    /// Binary PLY, with normals and colours.
    Ply,
    /// Binary glTF 2.0, with normals, colours and a material.
    Glb,
}

impl MeshFormat {
    /// By its extension.
    #[must_use]
    pub fn by_id(id: &str) -> Option<Self> {
        match id {
            "stl" => Some(Self::Stl),
            "ply" => Some(Self::Ply),
            "glb" => Some(Self::Glb),
            _ => None,
        }
    }

    /// How many bytes it has for so many triangles; a closed surface has half as many vertices.
    #[must_use]
    pub fn bytes(self, triangles: f64) -> f64 {
        match self {
            Self::Stl => 84.0 + 50.0 * triangles,
            Self::Ply => 300.0 + (13.0 + 27.0 / 2.0) * triangles,
            Self::Glb => 1200.0 + (12.0 + 28.0 / 2.0) * triangles,
        }
    }
}

#[cfg(test)]
pub(crate) mod testing {
    use super::super::Mesh;

    /// A tetrahedron in the corner of the axes, 3 mm large.
    pub fn tetrahedron() -> Mesh {
        Mesh {
            positions: vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]],
            normals: vec![[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            codes: vec![0, 1, 2, 0],
            triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
        }
    }

    /// The numbers of a file, little end first.
    pub struct Reader<'a>(pub &'a [u8]);

    impl Reader<'_> {
        pub fn take<const N: usize>(&mut self) -> [u8; N] {
            let (head, rest) = self.0.split_first_chunk().expect("the file goes on");
            self.0 = rest;
            *head
        }

        pub fn f32(&mut self) -> f32 {
            f32::from_le_bytes(self.take())
        }

        pub fn u32(&mut self) -> u32 {
            u32::from_le_bytes(self.take())
        }
    }
}
