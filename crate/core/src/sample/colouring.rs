//! What the colours of an attractor's points tell.

use serde::{Deserialize, Serialize};

/// What colours mean.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Colouring {
    /// The first letter of a point's address: each map has a colour.
    #[default]
    Map,
    /// More letters: the pieces within pieces are lighter and darker.
    Address,
    /// The measure: points are the brighter the more often the chaos game comes by.
    Density,
    /// The colours that a deformation carries to each piece. By map where there is none.
    Grid,
}
