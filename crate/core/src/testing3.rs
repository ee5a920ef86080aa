//! What the tests of the systems of space share.

use glam::{DMat3, DVec3};
use proptest::prelude::*;

use crate::hash;
use crate::ifs::system::Ifs3;
use crate::linear::affine::Affine3;

/// A map that mostly shrinks; some are flat, reflecting, sheared, or put every point in one place.
pub(crate) fn any_map3() -> impl Strategy<Value = Affine3> {
    let entry = prop_oneof![6 => -0.55..0.55_f64, 1 => Just(0.0), 1 => Just(0.5)];
    let shift = prop_oneof![6 => -1.0..1.0_f64, 1 => Just(0.0)];
    (proptest::array::uniform9(entry), proptest::array::uniform3(shift))
        .prop_map(|(linear, shift)| Affine3::new(DMat3::from_cols_array(&linear), DVec3::from_array(shift)))
}

/// A system of 1 to 5 maps that has an attractor.
pub(crate) fn any_ifs3() -> impl Strategy<Value = Ifs3> {
    proptest::collection::vec(any_map3(), 1..6).prop_filter_map("no attractor", |maps| Ifs3::new(maps).ok())
}

/// Points of the attractor, by a chaos game in f64.
pub(crate) fn orbit3(maps: &[Affine3], seed: u32, count: u32) -> Vec<DVec3> {
    let mut x = maps[0].fixed_point().unwrap_or(DVec3::ZERO);
    (0..count)
        .map(|i| {
            x = maps[hash::counter(seed, i) as usize % maps.len()].apply(x);
            x
        })
        .collect()
}

/// The maps in coordinates where they contract and the attractor lies in the unit ball, and the factor.
pub(crate) fn round(ifs: &Ifs3) -> (Vec<Affine3>, f64) {
    let c = ifs.contraction();
    let unit = if c.radius > 0.0 { c.radius } else { 1.0 };
    let by = Affine3::new(c.to_round * (1.0 / unit), c.to_round * c.centre * (-1.0 / unit));
    let back = Affine3::new(c.from_round * unit, c.centre);
    (ifs.maps().iter().map(|&map| by * map * back).collect(), c.factor)
}
