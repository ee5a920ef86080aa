//! The open question of the paper: is the intersection of two fractals one?
//!
//! Where all maps of two systems share one linear part there is an answer that can be worked out, by a product of the
//! two. With `x = M x' + a` in the first shape and `x - d = M y' + b` in the second, `x' - y' = M^-1 (d + b - a)`:
//! whether x lies in both, the second moved by d, depends on whether x' does, moved by d'. So the sets `X_d`, the first
//! shape intersected with the second moved by d, are unions of smaller copies of each other:
//!
//! ```text
//! X_d = union of  M X_d' + a   over all a, b with  d' = M^-1 (d + b - a)
//! ```
//!
//! Only shifts d by which the shapes still reach each other count. Where they are finitely many, the intersection `X_0`
//! is drawn by a walk on a finite graph. Where all ways lead from 0 back to 0, the maps on them are a system, and `X_0`
//! is its attractor. Otherwise it is a union of several kinds of pieces, which need not be an attractor.

use std::collections::HashMap;

use glam::DVec3;
use thiserror::Error;

use crate::bounds::bounds3::Bounds3;
use crate::error::IfsError;
use crate::hash;
use crate::ifs::system::Ifs3;
use crate::linear::affine::Affine3;

/// Why the product of two systems cannot be worked out.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum IntersectionError {
    /// Their maps do not share one linear part.
    #[error("The maps of both shapes must all share one matrix; map {} of the {which} shape has another.", .map + 1)]
    Linear {
        /// "first" or "second".
        which: &'static str,
        /// The map, from 0.
        map: usize,
    },
    /// That linear part cannot be undone.
    #[error("The matrix that the maps share must not flatten anything.")]
    Singular,
    /// The shapes reach each other by too many shifts.
    #[error(
        "The shapes meet in more than {most} ways: their shifts are not on a lattice that can be followed."
    )]
    TooMany {
        /// How many ways were followed.
        most: usize,
    },
    /// One of them is no system.
    #[error(transparent)]
    Ifs(#[from] IfsError),
}

impl IntersectionError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Linear { .. } => "meet-linear",
            Self::Singular => "meet-singular",
            Self::TooMany { .. } => "meet-too-many",
            Self::Ifs(error) => error.code(),
        }
    }
}

/// One way from a shift to the next, by a map of the first shape and one of the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrow {
    /// The shift it starts at, an index.
    pub from: usize,
    /// The map of the first shape.
    pub first: usize,
    /// The map of the second.
    pub second: usize,
    /// The shift it leads to.
    pub to: usize,
}

/// The product of two systems: the shifts by which the shapes reach each other, and the ways between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Intersection {
    maps: Vec<Affine3>,
    /// The shifts d, the first of them 0, of which there are ways that go on for ever. Empty where the shapes do not
    /// meet.
    pub shifts: Vec<DVec3>,
    /// All ways.
    pub arrows: Vec<Arrow>,
}

/// Shifts that are followed at most.
const MOST_SHIFTS: usize = 4000;
/// Letters of an address when points are drawn.
const ADDRESS_LETTERS: u32 = 64;

impl Intersection {
    /// Whether the shapes do not meet, as far as floating point tells.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.shifts.is_empty()
    }

    /// The maps whose attractor the intersection is, where all ways lead from no shift to no shift. `None` where they
    /// do not: then it may be an attractor or not.
    #[must_use]
    pub fn attractor(&self) -> Option<Vec<Affine3>> {
        let straight = !self.is_empty() && self.arrows.iter().filter(|a| a.from == 0).all(|a| a.to == 0);
        if !straight {
            return None;
        }
        let mut used: Vec<usize> = self.arrows.iter().filter(|a| a.from == 0).map(|a| a.first).collect();
        used.sort_unstable();
        used.dedup();
        Some(used.into_iter().map(|i| self.maps[i]).collect())
    }

    /// Points of the intersection, `x0, y0, z0, x1, ..`: ends of random walks from no shift. None where it is empty.
    #[must_use]
    pub fn points(&self, count: usize, seed: u32) -> Vec<f32> {
        if self.is_empty() {
            return Vec::new();
        }
        let mut from: Vec<Vec<Arrow>> = vec![Vec::new(); self.shifts.len()];
        for arrow in &self.arrows {
            from[arrow.from].push(*arrow);
        }
        let count = count.min(10_000_000);
        let mut positions = Vec::with_capacity(3 * count);
        for k in 0..count {
            let (mut at, mut map) = (0, Affine3::IDENTITY);
            for letter in 0..ADDRESS_LETTERS {
                let bits = hash::counter(seed ^ hash::pcg(k as u32), letter);
                let arrow = from[at][bits as usize % from[at].len()];
                map = map * self.maps[arrow.first];
                at = arrow.to;
                if map.norm() < 1e-9 {
                    break;
                }
            }
            // What is left is smaller than a point.
            positions.extend(map.translation.as_vec3().to_array());
        }
        positions
    }
}

/// The product of two systems whose maps share one linear part.
///
/// # Errors
/// [`IntersectionError`] where they do not, or where the shifts do not come to an end.
pub fn intersection(first: &[Affine3], second: &[Affine3]) -> Result<Intersection, IntersectionError> {
    let bounds = [first, second].map(|maps| Ifs3::new(maps.to_vec()).map(|ifs| Bounds3::of(&ifs)));
    let [a, b] = bounds;
    let (a, b) = (a?, b?);
    let shared = first[0].linear;
    for (which, maps) in [("first", first), ("second", second)] {
        if let Some(map) = maps.iter().position(|map| !map.linear.abs_diff_eq(shared, 1e-12)) {
            return Err(IntersectionError::Linear { which, map });
        }
    }
    let back = Affine3::new(shared, DVec3::ZERO).undo().map_err(|_| IntersectionError::Singular)?.linear;
    let size = a.radius.max(b.radius).max(f64::MIN_POSITIVE);
    // x - d lies in the second shape and x in the first, so that d lies between their boxes.
    let slack = DVec3::splat(2e-3 * size);
    let (low, high) = (a.min - b.max - slack, a.max - b.min + slack);
    let grid = 1e-7 * size;
    let key = |d: DVec3| (d / grid).round().to_array().map(|x| x as i64);
    let mut shifts = vec![DVec3::ZERO];
    let mut known = HashMap::from([(key(DVec3::ZERO), 0)]);
    let mut arrows = Vec::new();
    let mut next = 0;
    let reaches = |d: DVec3| d.cmpge(low).all() && d.cmple(high).all();
    if !reaches(DVec3::ZERO) {
        return Ok(Intersection { maps: first.to_vec(), shifts: Vec::new(), arrows });
    }
    while next < shifts.len() {
        for (i, x) in first.iter().enumerate() {
            for (j, y) in second.iter().enumerate() {
                let d = back * (shifts[next] + y.translation - x.translation);
                if !reaches(d) {
                    continue;
                }
                // Rounding may put a shift on the other side of a cell of the grid.
                let near = key(d);
                let around =
                    (0..27).map(|k| [near[0] + k % 3 - 1, near[1] + k / 3 % 3 - 1, near[2] + k / 9 - 1]);
                let found = around.filter_map(|cell| known.get(&cell).copied()).next();
                let to = match found {
                    Some(to) => to,
                    None if shifts.len() >= MOST_SHIFTS => {
                        return Err(IntersectionError::TooMany { most: MOST_SHIFTS });
                    }
                    None => {
                        shifts.push(d);
                        known.insert(near, shifts.len() - 1);
                        shifts.len() - 1
                    }
                };
                arrows.push(Arrow { from: next, first: i, second: j, to });
            }
        }
        next += 1;
    }
    Ok(pruned(first.to_vec(), &shifts, arrows))
}

/// Leaves out shifts from which no way goes on for ever, and those that are not reached any more.
fn pruned(maps: Vec<Affine3>, shifts: &[DVec3], mut arrows: Vec<Arrow>) -> Intersection {
    loop {
        let mut goes_on = vec![false; shifts.len()];
        arrows.iter().for_each(|arrow| goes_on[arrow.from] = true);
        let before = arrows.len();
        arrows.retain(|arrow| goes_on[arrow.to]);
        if arrows.len() == before {
            break;
        }
    }
    let mut name = vec![usize::MAX; shifts.len()];
    let mut kept: Vec<usize> = Vec::new();
    if arrows.iter().any(|arrow| arrow.from == 0) {
        kept.push(0);
        name[0] = 0;
    }
    let mut next = 0;
    while next < kept.len() {
        let at = kept[next];
        for arrow in arrows.iter().filter(|arrow| arrow.from == at) {
            if name[arrow.to] == usize::MAX {
                name[arrow.to] = kept.len();
                kept.push(arrow.to);
            }
        }
        next += 1;
    }
    arrows.retain(|arrow| name[arrow.from] != usize::MAX);
    for arrow in &mut arrows {
        (arrow.from, arrow.to) = (name[arrow.from], name[arrow.to]);
    }
    Intersection { maps, shifts: kept.iter().map(|&k| shifts[k]).collect(), arrows }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_that_do_not_meet_and_shapes_that_are_one() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let maps = corners.map(|c| Affine3::scaling(DVec3::splat(0.5)).about(c));
        let far = maps.map(|map| map.moved(Affine3::moving(DVec3::splat(5.0))).unwrap());
        assert!(intersection(&maps, &far).unwrap().is_empty());
        assert!(intersection(&maps, &far).unwrap().points(100, 1).is_empty());
        let same = intersection(&maps, &maps).unwrap();
        // All maps lead from no shift to none, beside the ways through corners.
        assert!(same.arrows.iter().filter(|a| a.from == 0 && a.to == 0).count() == 4);
        // Apart but for a corner.
        let beside = maps.map(|map| map.moved(Affine3::moving(DVec3::X)).unwrap());
        let touch = intersection(&maps, &beside).unwrap().points(50, 1);
        assert!(touch.as_chunks::<3>().0.iter().all(|p| (p[0] - 1.0).abs() < 1e-6 && p[1].abs() < 1e-6));
    }

    #[test]
    fn systems_that_share_no_linear_part_are_refused() {
        let half = |at: DVec3| Affine3::scaling(DVec3::splat(0.5)).about(at);
        let third = Affine3::scaling(DVec3::splat(1.0 / 3.0));
        let code =
            |a: &[Affine3], b: &[Affine3]| intersection(a, b).map_or_else(|error| error.code(), |_| "done");
        assert_eq!(code(&[half(DVec3::X), third], &[half(DVec3::Y)]), "meet-linear");
        assert_eq!(code(&[half(DVec3::X)], &[half(DVec3::Y), third]), "meet-linear");
        let flat = Affine3::scaling(DVec3::new(0.5, 0.5, 0.0));
        assert_eq!(code(&[flat], &[flat]), "meet-singular");
        assert_eq!(code(&[], &[flat]), "no-maps");
        // A shift that never comes back.
        let root = 2.0_f64.sqrt() / 7.0;
        let wide = |shift: f64| Affine3::new(glam::DMat3::from_diagonal(DVec3::splat(0.9)), DVec3::X * shift);
        assert_eq!(code(&[wide(0.0), wide(1.0), wide(root)], &[wide(0.3), wide(0.77)]), "meet-too-many");
    }
}
