//! How a shape is bent.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::error::BendError;
use crate::mesh::Mesh;
use crate::shuffle::spin::Spin;

/// How much the small parts answer: delta of Fujimoto et al., eq 13. 0 or more, in no unit.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Roughness {
    /// The same all over.
    Constant(f64),
    /// At the corners of the mesh's box at rest: lower left, lower right, upper left, upper right. Bilinear in
    /// between and constant outward, so that nothing tears where it changes.
    Corners([f64; 4]),
}

impl Roughness {
    /// The roughness at a point of the plane at rest.
    #[must_use]
    pub fn at(&self, mesh: &Mesh, point: DVec2) -> f64 {
        match *self {
            Self::Constant(delta) => delta,
            Self::Corners([a, b, c, d]) => {
                let (low, high) = mesh.bounds();
                let place = ((point - low) / (high - low)).clamp(DVec2::ZERO, DVec2::ONE);
                let mix = |a: f64, b: f64, t: f64| a * (1.0 - t) + b * t;
                mix(mix(a, b, place.x), mix(c, d, place.x), place.y)
            }
        }
    }

    /// The same number all over, if it is.
    pub(crate) fn constant(&self) -> Option<f64> {
        match *self {
            Self::Constant(delta) => Some(delta),
            Self::Corners([a, b, c, d]) => (a == b && a == c && a == d).then_some(a),
        }
    }

    fn is_valid(&self) -> bool {
        let valid = |delta: &f64| delta.is_finite() && *delta >= 0.0;
        match self {
            Self::Constant(delta) => valid(delta),
            Self::Corners(list) => list.iter().all(valid),
        }
    }
}

/// What keeps neighbouring pieces together.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Continuity {
    /// What suits the shape: corners where there are any, nothing for trees, else the splat.
    #[default]
    Auto,
    /// Terms are sampled at corners that pieces share and interpolated inside: nothing tears, and all else is exact.
    Corners,
    /// Terms are spread over grids and read off smoothly between their nodes, for tilings: nothing tears.
    Splat,
    /// Nothing: the formula as it stands. Trees, whose pieces hardly touch, are bent best so; where the shuffle tears
    /// them, they fray, the rougher the more.
    Raw,
    /// As [`Continuity::Published`], but the terms that shuffle nothing are left exact: k = kb and, where displacements
    /// do not turn, k = kb + 1. So the bend becomes the plain deformation without a jump as kb goes to ke.
    Average,
    /// The mean of all terms over each piece of ke letters, interpolated over a Delaunay triangulation of their middles
    /// (Fujimoto et al., section 5.3). Where no term shuffles, the bend is the plain deformation. Nothing tears, but
    /// thin parts lean on their neighbours.
    Published,
}

/// How displacements are shuffled and kept together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Locality: letters that stay. 0 to `ke`, whole or not (Fujimoto et al., eq 19).
    pub kb: f64,
    /// Detail: the last letter that is shuffled. It is taken down to what memory allows.
    pub ke: f64,
    /// How much the small parts answer.
    pub roughness: Roughness,
    /// How displacements turn with the pieces.
    pub spin: Spin,
    /// What keeps pieces together.
    pub continuity: Continuity,
    /// Whether all terms kb to ke are summed (eq 12), or the last stands alone (eq 11).
    pub superposed: bool,
}

impl Settings {
    pub(crate) fn check(&self) -> Result<(), BendError> {
        check_bend(self.kb, self.ke, self.roughness)
    }
}

/// Whether there is such a bend, of the plane or of space.
pub(crate) fn check_bend(kb: f64, ke: f64, roughness: Roughness) -> Result<(), BendError> {
    check_depths(kb, ke)?;
    if roughness.is_valid() { Ok(()) } else { Err(BendError::Roughness) }
}

/// A colour function carried along: colours of the control points, blended like displacements and shuffled on their
/// own (Fujimoto et al., Figs 3 and 6). It is never smoothed: its jumps show how the code is shuffled.
#[derive(Clone, Debug, PartialEq)]
pub struct Tint {
    /// sRGB, 0 to 1, one a control point, row by row from the lower left.
    pub colours: Vec<[f64; 3]>,
    /// Locality, as in [`Settings`].
    pub kb: f64,
    /// Detail, as in [`Settings`].
    pub ke: f64,
    /// Roughness, 0 or more.
    pub roughness: f64,
    /// Sum of the terms, or the last alone.
    pub superposed: bool,
}

impl Tint {
    pub(crate) fn check(&self, wanted: usize) -> Result<(), BendError> {
        check_depths(self.kb, self.ke)?;
        if !Roughness::Constant(self.roughness).is_valid() {
            return Err(BendError::Roughness);
        }
        let fits = self.colours.iter().flatten().all(|x| (0.0..=1.0).contains(x));
        if fits && self.colours.len() == wanted { Ok(()) } else { Err(BendError::Tint { wanted }) }
    }
}

fn check_depths(kb: f64, ke: f64) -> Result<(), BendError> {
    if !(kb.is_finite() && ke.is_finite() && kb >= 0.0 && ke >= 0.0) {
        return Err(BendError::Depth);
    }
    if kb > ke { Err(BendError::Locality { kb, ke }) } else { Ok(()) }
}
