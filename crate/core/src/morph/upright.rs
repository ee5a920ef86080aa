//! Where the last shape of a morph between chains of pieces is laid: as little turned as can be.
//!
//! A similarity `P` takes the ends of one zipper to those of another. For a symmetry `sigma` of the first shape `A`
//! and one `tau` of the last, `B`, the same morph seen through `sigma` is as good: it begins with `sigma(A) = A`,
//! keeps its joints, moves its maps as far, and ends with `sigma P(B) = sigma P tau(B)`. So each `sigma P tau` is a
//! place for `B`, and one that neither turns nor mirrors it leaves it upright. A reflection `P` may serve as well,
//! where a symmetry makes up for it.

use glam::{DMat2, DVec2};

use crate::linear::affine::Affine2;
use crate::morph::pairing::Weighted;

/// Turns that count as one, in radians.
const SAME_TURN: f64 = 1e-6;
/// What rounding leaves of a map that should be another, in proportion to the shape.
const SAME_MAP: f64 = 1e-12;

/// A way to lay one chain over another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Laying {
    /// The ends of both chains.
    pub ends: [[DVec2; 2]; 2],
    /// The similarity, maybe a reflection, that takes the ends of the last to those of the first.
    pub over: Affine2,
    /// The symmetry of the first shape through which the morph is seen.
    sigma: Affine2,
    /// The symmetry of the last shape that is nothing but another way to see it.
    tau: Affine2,
    /// By how much the last shape is turned, either way, in radians.
    turn: f64,
}

/// All ways to lay chains with the ends `last` over those with the ends `first`, in groups of one turn, the least
/// first. `groups` are the symmetries of the two shapes.
pub(crate) fn layings(
    first: &[[DVec2; 2]],
    last: &[[DVec2; 2]],
    groups: &[Vec<Affine2>; 2],
) -> Vec<Vec<Laying>> {
    let mirrors = groups.iter().flatten().any(|symmetry| symmetry.determinant() < 0.0);
    let mut all: Vec<Laying> = Vec::new();
    for &p in first {
        for &q in last {
            let both = [Some(false), mirrors.then_some(true)].into_iter().flatten();
            all.extend(both.filter_map(|mirrored| least_turned([p, q], mirrored, groups)));
        }
    }
    all.sort_by(|a, b| a.turn.total_cmp(&b.turn));
    all.chunk_by(|a, b| b.turn - a.turn <= SAME_TURN).map(<[Laying]>::to_vec).collect()
}

fn least_turned(ends: [[DVec2; 2]; 2], mirrored: bool, groups: &[Vec<Affine2>; 2]) -> Option<Laying> {
    let over = similarity(ends[1], ends[0], mirrored)?;
    let mut least: Option<Laying> = None;
    for &sigma in &groups[0] {
        for &tau in &groups[1] {
            if (sigma.determinant() * tau.determinant() < 0.0) != mirrored {
                continue;
            }
            let turn = (sigma.linear * (over.linear * tau.linear).x_axis).to_angle().abs();
            // The first of the least, and the identities come first.
            if least.is_none_or(|before| turn < before.turn - SAME_TURN) {
                least = Some(Laying { ends, over, sigma, tau, turn });
            }
        }
    }
    least
}

impl Laying {
    /// Where the last shape lies then; `None` where it stays.
    pub fn place(&self) -> Option<Affine2> {
        let place = self.sigma * self.over * self.tau;
        (!is_same(place, Affine2::IDENTITY, self.ends[1])).then_some(place)
    }

    /// Maps of the first shape, seen through the symmetry; `variants` are all maps that make the same pieces.
    pub fn first(&self, maps: &mut [Weighted], variants: &[Affine2]) -> Option<()> {
        seen(maps, self.sigma, variants, self.ends[0])
    }

    /// Maps of the last shape, as they are before they are laid.
    pub fn last(&self, maps: &mut [Weighted], variants: &[Affine2]) -> Option<()> {
        seen(maps, self.tau.inverse()?, variants, self.ends[1])
    }
}

/// Maps conjugated by a symmetry of their shape, which takes them to others of its maps, to the last bit.
fn seen(maps: &mut [Weighted], by: Affine2, variants: &[Affine2], ends: [DVec2; 2]) -> Option<()> {
    if by != Affine2::IDENTITY {
        for (map, _) in maps {
            let moved = map.conjugate(by)?;
            *map = variants.iter().copied().find(|&known| is_same(known, moved, ends)).unwrap_or(moved);
        }
    }
    Some(())
}

/// Whether two maps take the ends, and a third point as far from them, to the same points.
fn is_same(f: Affine2, g: Affine2, [s, e]: [DVec2; 2]) -> bool {
    [s, e, s + (e - s).perp()].iter().all(|&p| f.apply(p).distance(g.apply(p)) <= SAME_MAP * s.distance(e))
}

/// The similarity, with a reflection or without, that takes two points to two others; the identity to the last bit
/// where they are the same.
fn similarity(from: [DVec2; 2], to: [DVec2; 2], mirrored: bool) -> Option<Affine2> {
    if from == to && !mirrored {
        return Some(Affine2::IDENTITY);
    }
    let (a, b) = (from[1] - from[0], to[1] - to[0]);
    // Complex numbers: b / a, or b over the conjugate of a.
    let a = if mirrored { DVec2::new(a.x, -a.y) } else { a };
    let factor = DVec2::new(a.dot(b), a.perp_dot(b)) / a.length_squared();
    let linear = DMat2::from_cols(factor, if mirrored { -factor.perp() } else { factor.perp() });
    let map = Affine2::new(linear, to[0] - linear * from[0]);
    map.is_finite().then_some(map)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_similarity_takes_ends_to_ends_with_a_reflection_or_without() {
        let from = [DVec2::new(0.3, -1.0), DVec2::new(2.0, 0.5)];
        let to = [DVec2::new(-1.0, 4.0), DVec2::new(-3.0, 1.0)];
        for mirrored in [false, true] {
            let map = similarity(from, to, mirrored).unwrap();
            assert_eq!(map.determinant() < 0.0, mirrored);
            for k in 0..2 {
                assert!(map.apply(from[k]).distance(to[k]) < 1e-12, "{mirrored} {k}");
            }
        }
        assert_eq!(similarity(from, from, false), Some(Affine2::IDENTITY));
    }

    #[test]
    fn a_symmetry_makes_up_for_a_turn_and_for_a_reflection() {
        let ends = [DVec2::ZERO, DVec2::X];
        let back = [DVec2::X, DVec2::ZERO];
        let mirror = Affine2::from_row([-1.0, 0.0, 0.0, 1.0, 1.0, 0.0]);
        let half = Affine2::from_row([-1.0, 0.0, 0.0, -1.0, 1.0, 0.0]);
        let none = || vec![Affine2::IDENTITY];
        let least = |groups: [Vec<Affine2>; 2]| layings(&[ends], &[back], &groups).remove(0);
        assert!((least([none(), none()])[0].turn - std::f64::consts::PI).abs() < 1e-9);
        for group in [half, mirror] {
            for groups in [[vec![Affine2::IDENTITY, group], none()], [none(), vec![Affine2::IDENTITY, group]]]
            {
                let found = least(groups);
                assert_eq!((found.len(), found[0].turn < 1e-9), (1, true), "{group:?}");
                assert_eq!(found[0].place(), None, "{group:?}");
            }
        }
    }
}
