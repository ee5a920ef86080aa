//! Reasons to be connected that cost next to nothing to see: equal maps, a common fixed point, areas that fill.

use frond_core::Affine2;
use glam::DVec2;

use crate::exact::expansion::{sign_of_sum, two_product};
use crate::verdict::ReasonKind;

/// The proofs that cost next to nothing: there is one map, or all maps are the same, or all of them fix the
/// origin (so that it is the attractor), or the areas of two maps leave no room between the pieces.
///
/// The last: were the pieces of two maps apart, a small enough neighbourhood of the attractor would hold
/// its two disjoint images and more, so that `|det w_1| + |det w_2| < 1`.
pub(crate) fn kind(maps: &[Affine2]) -> Option<ReasonKind> {
    match maps {
        [] => None,
        [_] => Some(ReasonKind::OneMap),
        [first, rest @ ..] if rest.iter().all(|map| map == first) => Some(ReasonKind::EqualMaps),
        _ if maps.iter().all(|map| map.translation == DVec2::ZERO) => Some(ReasonKind::CommonPoint),
        [a, b] if areas_fill(a, b) => Some(ReasonKind::Area),
        _ => None,
    }
}

/// Whether there is such a proof.
pub(crate) fn at_once(maps: &[Affine2]) -> bool {
    kind(maps).is_some()
}

/// Whether `|det a| + |det b| >= 1`, decided exactly for the numbers as they are given.
pub(crate) fn areas_fill(a: &Affine2, b: &Affine2) -> bool {
    let products = |map: &Affine2| {
        let [p, q, r, s, ..] = map.to_row();
        [(p, s), (-q, r)]
    };
    let areas = [products(a), products(b)];
    let rough: f64 = areas.iter().map(|[p, q]| (p.0 * p.1 + q.0 * q.1).abs()).sum();
    if rough.is_nan() || rough < 1.0 - 1e-9 {
        return false;
    }
    let factors = areas.iter().flatten().flat_map(|&(p, q)| [p, q]);
    if factors.clone().any(|x| x != 0.0 && !(1e-100..1e100).contains(&x.abs())) {
        return false;
    }
    let mut terms = vec![-1.0];
    for area in areas {
        let parts = area.map(|(p, q)| two_product(p, q));
        let det = [parts[0].0, parts[0].1, parts[1].0, parts[1].1];
        let sign = f64::from(sign_of_sum(&det));
        terms.extend(det.map(|part| sign * part));
    }
    sign_of_sum(&terms) >= 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_maps_that_fill_the_plane_meet() {
        let dragon =
            [[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]].map(Affine2::from_row);
        assert!(at_once(&dragon));
        let mut smaller = dragon;
        smaller[1].linear.x_axis.x += f64::EPSILON / 4.0;
        assert!(!at_once(&smaller), "one digit less is no proof");
        let mirrored = [dragon[0], Affine2::from_row([0.5, 0.5, 0.5, -0.5, 1.0, 0.0])];
        assert!(at_once(&mirrored), "a reflection keeps areas");
    }

    #[test]
    fn three_maps_need_more_than_area() {
        let map = Affine2::from_row([0.7, 0.0, 0.0, 0.7, 0.0, 0.0]);
        let moved = |e| Affine2::new(map.linear, DVec2::new(e, 0.0));
        assert!(!at_once(&[map, moved(1.0), moved(100.0)]));
        assert!(at_once(&[moved(1.0); 3]) && at_once(&[map]) && at_once(&[map; 2]) && !at_once(&[]));
    }
}
