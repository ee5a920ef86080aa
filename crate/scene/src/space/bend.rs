//! A bend of a shape of space.

use frond_core::Ifs3;
use frond_deform::{Bend3, BendError, Mesh3, Room3, Settings3, Spin};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// The most letters that a document asks for.
pub const MOST_DETAIL3: f64 = 16.0;
/// The largest roughness.
pub const MOST_ROUGHNESS3: f64 = 1.5;
/// The farthest that a control point is moved, in longest sides of the box.
pub const FARTHEST_MOVE3: f64 = 10.0;

/// A fractal deformation of a shape of space by a lattice of control points (after Fujimoto et al., in space as they do
/// it in the plane). The lattice lies over a box around the shape as it was made; what is done to the object is done to
/// the bent shape.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SpaceBend {
    /// Control points along x, y and z: 2 to 6.
    pub sizes: [usize; 3],
    /// How far each is moved, in longest sides of the box; x fastest, then y.
    pub moves: Vec<[f64; 3]>,
    /// Locality.
    pub kb: f64,
    /// Detail.
    pub ke: f64,
    /// Roughness.
    pub delta: f64,
    /// How displacements turn with the pieces.
    #[serde(default)]
    pub spin: Spin,
}

impl SpaceBend {
    /// The bend of a shape. `before` is another one, from which is taken what is the same.
    ///
    /// # Errors
    /// [`BendError`].
    pub fn bend(&self, ifs: &Ifs3, before: Option<&Bend3>) -> Result<Bend3, BendError> {
        let room = Room3::of(ifs);
        let size = room.size();
        let moves = self.moves.iter().map(|&by| DVec3::from_array(by) * size).collect();
        let mesh = Mesh3::new(room.min, room.max, self.sizes, moves)?;
        let &Self { kb, ke, delta, spin, .. } = self;
        let settings = Settings3 { kb, ke, roughness: delta, spin, raw: false };
        Bend3::new(ifs.maps(), mesh, settings, before)
    }

    /// What is out of its range, and what is allowed; `None` where all is well.
    #[must_use]
    pub fn problem(&self) -> Option<&'static str> {
        let within = |x: f64, most: f64| x.is_finite() && (0.0..=most).contains(&x);
        let count: usize = self.sizes.iter().map(|&size| size.min(1 << 16)).product();
        if !self.sizes.iter().all(|size| (2..=Mesh3::LARGEST).contains(size)) || count != self.moves.len() {
            return Some("2 to 6 control points along each side, each with its move, are allowed");
        }
        if !(within(self.ke, MOST_DETAIL3) && within(self.kb, self.ke)) {
            return Some("a detail of 0 to 16 and a locality from 0 up to that are allowed");
        }
        if !within(self.delta, MOST_ROUGHNESS3) {
            return Some("a roughness of 0 to 1.5 is allowed");
        }
        moves_problem(&self.moves)
    }
}

/// What is out of range of moves of control points.
pub(super) fn moves_problem(moves: &[[f64; 3]]) -> Option<&'static str> {
    if moves.len() > Mesh3::LARGEST.pow(3) {
        return Some("up to 216 control points are allowed");
    }
    let far = |x: &f64| x.is_finite() && x.abs() <= FARTHEST_MOVE3;
    (!moves.iter().flatten().all(far))
        .then_some("moves of up to 10 times the longest side of the shape are allowed")
}
