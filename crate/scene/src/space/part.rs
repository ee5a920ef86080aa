//! What a document says of space.

use serde::{Deserialize, Serialize};

/// Where space is seen from: the eye is `distance` away from `target`, `turn` to the side of -y and `tilt` above it.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SpaceView {
    /// What is looked at.
    pub target: [f64; 3],
    /// From there to the eye, in units of space: above 0.
    pub distance: f64,
    /// Radians, counter-clockwise seen from above.
    pub turn: f64,
    /// Radians upwards.
    pub tilt: f64,
    /// The height of the picture, in radians: above 0 and below pi.
    pub angle: f64,
    /// What stays when the view is turned: the target where absent, or the eye.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub holds: Option<Held>,
}

/// What stays when a view is turned.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Held {
    /// The eye.
    Eye,
}

impl SpaceView {
    /// Whether there is such a view.
    #[must_use]
    pub fn is_one(&self) -> bool {
        let Self { target, distance, turn, tilt, angle, .. } = self;
        let numbers = target.iter().chain([distance, turn, tilt]);
        numbers.copied().all(|x| x.is_finite() && x.abs() <= 1e100)
            && *distance > 0.0
            && *angle > 0.0
            && *angle < std::f64::consts::PI
    }

    /// The eye.
    #[must_use]
    pub fn eye(&self) -> [f64; 3] {
        let (sin, cos) = self.turn.sin_cos();
        let (rise, flat) = self.tilt.sin_cos();
        let away = [sin * flat, -cos * flat, rise];
        std::array::from_fn(|k| self.target[k] + self.distance * away[k])
    }
}

/// What a document says of space. What is there is a [`Space`](crate::Space) as [`pack`](crate::pack) writes it: only
/// who shows space has to understand it.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct SpacePart {
    /// What is there; what the tool begins with where empty.
    pub packed: String,
    /// Where it is seen from; from where all of it is seen where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub view: Option<SpaceView>,
    /// Whether somebody looks around: the view goes before that of the time line.
    #[serde(default, skip_serializing_if = "is_false")]
    pub own: bool,
    /// The moment of the time line, in seconds.
    #[serde(default)]
    pub at: f64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks so")]
fn is_false(own: &bool) -> bool {
    !own
}
