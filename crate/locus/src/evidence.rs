//! What shows a verdict: reasons to be connected, and certificates of being disconnected.

pub(crate) mod axis_scales;
pub(crate) mod certificate;
pub(crate) mod collinear;
pub(crate) mod connected_certificate;
pub(crate) mod far_parts;
pub(crate) mod meant;
pub(crate) mod neighbour_graph;
pub(crate) mod plain;
pub(crate) mod reason;
pub(crate) mod separate;
pub(crate) mod shared_points;
