//! Bringing two systems to the same number of maps.

use crate::bounds::hull2::Hull;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::sort::sort_indices;

/// Both systems with the same number of maps, in an order in which the i-th of one becomes the i-th of
/// the other. The attractors are those of the systems that were given.
#[derive(Clone, Debug, PartialEq)]
pub struct Pairing {
    /// The maps of the first system.
    pub from: Vec<Affine2>,
    /// The maps of the last system.
    pub to: Vec<Affine2>,
    /// How probable each map of the first system is: its measure (Hutchinson 1981, section 4) stays what it was.
    pub from_probabilities: Vec<f64>,
    /// The same of the last system.
    pub to_probabilities: Vec<f64>,
    /// A sentence for each step taken; none when the numbers were equal.
    pub steps: Vec<String>,
}

/// Brings two systems to the same number of maps.
///
/// The one with fewer has its largest maps replaced by their refinement, `w_i o w_1 .. w_i o w_N`, while that
/// does not overshoot; then maps are doubled. Neither changes the shape. The new maps are matched to
/// those of the other system so that pieces travel least. Systems of equal numbers are left as they are:
/// their order is the user's.
#[must_use]
pub fn pair(from: &Ifs, to: &Ifs) -> Pairing {
    let (mut a, mut b, mut steps) = (weighted(from), weighted(to), Vec::new());
    if a.len() < b.len() {
        a = matched(&extend(&a, b.len(), "A", &mut steps), &b, from, to);
    } else if b.len() < a.len() {
        b = matched(&extend(&b, a.len(), "B", &mut steps), &a, to, from);
    }
    let ((from, from_probabilities), (to, to_probabilities)) = (a.into_iter().unzip(), b.into_iter().unzip());
    Pairing { from, to, from_probabilities, to_probabilities, steps }
}

impl Pairing {
    /// How probable the maps are on the way: those of the first system where `u` is 0, those of the last where it is 1,
    /// and in between in proportion. `correspondence` says which map becomes which, as in
    /// [`MorphOptions`](crate::MorphOptions); a list of another length counts as none.
    #[must_use]
    pub fn probabilities(&self, correspondence: &[usize], u: f64) -> Vec<f64> {
        probabilities_between(&self.from_probabilities, &self.to_probabilities, correspondence, u)
    }
}

/// [`Pairing::probabilities`] of lists that are at hand.
#[must_use]
pub fn probabilities_between(from: &[f64], to: &[f64], correspondence: &[usize], u: f64) -> Vec<f64> {
    // Beyond the ends a share would fall below 0.
    let u = u.clamp(0.0, 1.0);
    let partner = |i: usize| if correspondence.len() == from.len() { correspondence[i] } else { i };
    let at = |(i, p): (usize, &f64)| p * (1.0 - u) + to.get(partner(i)).copied().unwrap_or(0.0) * u;
    from.iter().enumerate().map(at).collect()
}

/// A map and its probability.
pub(crate) type Weighted = (Affine2, f64);

pub(crate) fn weighted(ifs: &Ifs) -> Vec<Weighted> {
    ifs.maps().iter().copied().zip(ifs.probabilities().iter().copied()).collect()
}

fn extend(original: &[Weighted], target: usize, which: &str, steps: &mut Vec<String>) -> Vec<Weighted> {
    let gain = original.len() - 1;
    let mut maps = original.to_vec();
    let largest = |maps: &[Weighted]| {
        let size = |(map, _): &Weighted| map.determinant().abs().max(1e-9 * map.norm());
        // The first of the largest, so that the order is stable.
        (0..maps.len()).rev().max_by(|&i, &j| size(&maps[i]).total_cmp(&size(&maps[j]))).unwrap_or(0)
    };
    let mut splits = 0;
    while gain > 0 && maps.len() + gain <= target {
        let i = largest(&maps);
        maps = refined(&maps, original, i);
        splits += 1;
    }
    if splits > 0 {
        let often = if splits == 1 { String::new() } else { format!(" {splits} times") };
        steps.push(format!(
            "In shape {which}, a map is replaced by its {} parts{often}, so that it has {} maps.",
            original.len(),
            maps.len()
        ));
    }
    let had = maps.len();
    let missing = target - had;
    if missing > 0 {
        // Each map at most once more than any other, the largest first.
        let mut order: Vec<usize> = (0..maps.len()).collect();
        let area = |i: usize| maps[i].0.determinant().abs();
        sort_indices(&mut order, &|i, j| area(j).total_cmp(&area(i)));
        let doubled: Vec<usize> = order.into_iter().cycle().take(missing).collect();
        let copies: Vec<usize> =
            (0..maps.len()).map(|i| doubled.iter().filter(|&&j| j == i).count()).collect();
        for (one, copies) in maps.iter_mut().zip(copies) {
            one.1 /= (1 + copies) as f64;
        }
        let doubles: Vec<Weighted> = doubled.iter().map(|&i| maps[i]).collect();
        maps.extend(doubles);
        let used = match missing {
            1 => "one map is used twice".to_owned(),
            _ if missing <= had => format!("{missing} maps are used twice"),
            _ => "maps are used more than once".to_owned(),
        };
        steps.push(format!("Shape {which} has {had} maps and needs {target}, so {used}."));
    }
    maps
}

/// The maps with the one of index `k` replaced by its refinement, `w_k o w_1 .. w_k o w_N`, which shares out its
/// probability.
pub(crate) fn refined(maps: &[Weighted], original: &[Weighted], k: usize) -> Vec<Weighted> {
    let mut refined = maps.to_vec();
    let (map, share) = maps[k];
    refined.splice(k..=k, original.iter().map(|&(part, p)| (map * part, share * p)));
    refined
}

/// The maps of `own`, reordered so that the sum of the distances to the maps of `other` is least.
fn matched(own: &[Weighted], other: &[Weighted], own_ifs: &Ifs, other_ifs: &Ifs) -> Vec<Weighted> {
    let (h, k) = (Hull::of(own_ifs), Hull::of(other_ifs));
    let place = |map: &Affine2, hull: &Hull| {
        (map.apply(hull.centre()) - hull.centre()) / hull.diameter().max(f64::MIN_POSITIVE)
    };
    let cost: Vec<Vec<f64>> = other
        .iter()
        .map(|(b, _)| {
            own.iter()
                .map(|(a, _)| {
                    let moved = place(a, &h).distance_squared(place(b, &k));
                    let d = a.linear - b.linear;
                    let bent = d.x_axis.length_squared() + d.y_axis.length_squared();
                    let cost = moved + 0.1 * bent;
                    if cost.is_finite() { cost } else { 1e12 }
                })
                .collect()
        })
        .collect();
    assignment(&cost).into_iter().map(|j| own[j]).collect()
}

/// The assignment of columns to rows of a square matrix with the least sum (the Hungarian method with
/// potentials, O(n^3)): for each row its column.
pub(crate) fn assignment(cost: &[Vec<f64>]) -> Vec<usize> {
    let n = cost.len();
    // Rows and columns count from 1 here; 0 is the row that looks for a column.
    let (mut of_row, mut of_column) = (vec![0.0; n + 1], vec![0.0; n + 1]);
    let mut row_of = vec![0_usize; n + 1];
    for row in 1..=n {
        row_of[0] = row;
        let mut least = vec![f64::INFINITY; n + 1];
        let mut before = vec![0_usize; n + 1];
        let mut used = vec![false; n + 1];
        let mut column = 0;
        while row_of[column] != 0 {
            used[column] = true;
            let i = row_of[column];
            let (mut delta, mut next) = (f64::INFINITY, 0);
            for j in (1..=n).filter(|&j| !used[j]).collect::<Vec<_>>() {
                let reduced = cost[i - 1][j - 1] - of_row[i] - of_column[j];
                if reduced < least[j] {
                    least[j] = reduced;
                    before[j] = column;
                }
                if least[j] < delta {
                    delta = least[j];
                    next = j;
                }
            }
            for j in 0..=n {
                if used[j] {
                    of_row[row_of[j]] += delta;
                    of_column[j] -= delta;
                } else {
                    least[j] -= delta;
                }
            }
            column = next;
        }
        while column != 0 {
            row_of[column] = row_of[before[column]];
            column = before[column];
        }
    }
    let mut columns = vec![0; n];
    for column in 1..=n {
        columns[row_of[column] - 1] = column - 1;
    }
    columns
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_ifs, orbit};

    #[test]
    fn the_dragon_of_two_maps_is_refined_to_three() {
        let dragon = [[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]];
        let dragon = Ifs::new(dragon.map(Affine2::from_row).to_vec()).unwrap();
        let gasket =
            [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]));
        let gasket = Ifs::new(gasket.to_vec()).unwrap();
        let paired = pair(&dragon, &gasket);
        assert_eq!((paired.from.len(), paired.to.len(), paired.steps.len()), (3, 3, 1));
        assert_eq!(paired.to, gasket.maps());
        let mut areas: Vec<_> = paired.from.iter().map(|map| map.determinant()).collect();
        areas.sort_by(f64::total_cmp);
        assert_eq!(areas, [0.25, 0.25, 0.5]);
    }

    #[test]
    fn refining_and_doubling_keep_the_measure() {
        // The mean of the measure: m = sum p_i w_i(m).
        fn mean(maps: &[Affine2], p: &[f64]) -> DVec2 {
            let each = |m: DVec2| -> DVec2 { maps.iter().zip(p).map(|(map, p)| map.apply(m) * *p).sum() };
            (0..200).fold(DVec2::ZERO, |m, _| each(m))
        }
        let halves = |corners: &[[f64; 2]]| {
            Ifs::new(corners.iter().map(|&[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f])).collect())
                .unwrap()
        };
        let corners = [[0.0, 0.0], [0.5, 0.1], [0.2, 0.6]];
        // Two are refined alone; of three, which refining makes five, some are doubled.
        for (own, weights) in [(2, &[1.0, 4.0][..]), (3, &[1.0, 4.0, 2.0])] {
            let system = halves(&corners[..own]).with_probabilities(weights).unwrap();
            for count in own..9 {
                let other = halves(&vec![[0.1, 0.2]; count]);
                for paired in [pair(&system, &other), pair(&other, &system)] {
                    let first = paired.from.len() == count && paired.to == other.maps();
                    let (maps, p) = if first {
                        (&paired.from, &paired.from_probabilities)
                    } else {
                        (&paired.to, &paired.to_probabilities)
                    };
                    assert!((p.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{p:?}");
                    let apart = mean(maps, p) - mean(system.maps(), system.probabilities());
                    assert!(apart.length() < 1e-12, "{own} to {count} maps: {apart}");
                }
            }
        }
    }

    #[test]
    fn probabilities_go_from_one_end_to_the_other() {
        let (p, q) = ([0.75, 0.25], [0.5, 0.5]);
        assert_eq!(probabilities_between(&p, &q, &[], 0.0), p);
        assert_eq!(probabilities_between(&p, &[0.9, 0.1], &[1, 0], 1.0), [0.1, 0.9]);
        assert_eq!(probabilities_between(&p, &q, &[], 0.5), [0.625, 0.375]);
        for u in [-3.0, 7.0, f64::NEG_INFINITY] {
            assert!(probabilities_between(&p, &q, &[], u).iter().all(|p| (0.0..=1.0).contains(p)));
        }
    }

    #[test]
    fn many_splits_make_one_sentence() {
        let two = [0.0, 0.5].map(|e| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, 0.0]));
        let eight = [0.1; 8].map(|r| Affine2::from_row([r, 0.0, 0.0, r, 0.0, 0.0]));
        let ifs = |maps: &[Affine2]| Ifs::new(maps.to_vec()).unwrap();
        let steps = pair(&ifs(&two), &ifs(&eight)).steps;
        let wanted = "In shape A, a map is replaced by its 2 parts 6 times, so that it has 8 maps.";
        assert_eq!(steps, [wanted]);
        let doubled = |count: usize| pair(&ifs(&eight[..8 - count]), &ifs(&eight)).steps;
        assert_eq!(doubled(1), ["Shape A has 7 maps and needs 8, so one map is used twice."]);
        assert_eq!(doubled(2), ["Shape A has 6 maps and needs 8, so 2 maps are used twice."]);
    }

    #[test]
    fn the_least_assignment_is_found() {
        let cost = vec![vec![4.0, 1.0, 3.0], vec![2.0, 0.0, 5.0], vec![3.0, 2.0, 2.0]];
        assert_eq!(assignment(&cost), [1, 0, 2]);
        assert_eq!(assignment(&[]), [0; 0]);
    }

    proptest! {
        #[test]
        fn the_shapes_stay_what_they_were(a in any_ifs(), b in any_ifs()) {
            let paired = pair(&a, &b);
            let count = a.len().max(b.len());
            prop_assert_eq!((paired.from.len(), paired.to.len()), (count, count));
            for (maps, ifs) in [(&paired.from, &a), (&paired.to, &b)] {
                let again = Ifs::new(maps.clone()).unwrap();
                for (points, hull) in [(ifs, Hull::of(&again)), (&again, Hull::of(ifs))] {
                    let slack = 1e-9 * (1.0 + hull.radius() + hull.centre().length());
                    for p in orbit(points, 1, 200) {
                        for k in 0..16 {
                            let d = DVec2::from_angle(f64::from(k));
                            prop_assert!(p.dot(d) <= hull.support(d) + slack);
                        }
                    }
                }
            }
            prop_assert_eq!(paired.steps.is_empty(), a.len() == b.len());
        }
    }
}
