//! What the tests of this crate share: random systems that lean to degenerate cases, and orbits.

use glam::DVec2;
use proptest::prelude::*;

use crate::hash;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;

/// A map that mostly shrinks; some are singular, reflecting, sheared, or put every point in one place.
pub(crate) fn any_map() -> impl Strategy<Value = Affine2> {
    let entry = prop_oneof![6 => -0.7..0.7_f64, 1 => Just(0.0), 1 => Just(0.5)];
    let shift = prop_oneof![6 => -1.0..1.0_f64, 1 => Just(0.0)];
    (entry.clone(), entry.clone(), entry.clone(), entry, shift.clone(), shift)
        .prop_map(|(a, b, c, d, e, f)| Affine2::from_row([a, b, c, d, e, f]))
}

/// A system of 1 to 5 maps that has an attractor.
pub(crate) fn any_ifs() -> impl Strategy<Value = Ifs> {
    proptest::collection::vec(any_map(), 1..6).prop_filter_map("no attractor", |maps| Ifs::new(maps).ok())
}

/// Points of the attractor, by a chaos game in f64.
pub(crate) fn orbit(ifs: &Ifs, seed: u32, count: u32) -> Vec<DVec2> {
    let mut x = ifs.maps()[0].fixed_point().unwrap_or(DVec2::ZERO);
    (0..count)
        .map(|i| {
            x = ifs.maps()[hash::counter(seed, i) as usize % ifs.len()].apply(x);
            x
        })
        .collect()
}
