//! Attractors that lie on a line.
//!
//! **Theorem.** Let all maps contract, and let the attractor A lie on a line. If the graph of the pairs (i, j) of
//! which one piece has a point between two points of the other is connected, then A is connected.
//!
//! **Proof.** Suppose that the widest gap g of A (the widest edge of the minimum spanning tree of the distances
//! between the pieces) is positive. A is connected in steps of g, as in [`trap`](crate::region::trap), and so is the
//! piece `A_i` in steps of `|w_i| g`. On a line, a point between two points of `A_i` is then within `|w_i| g / 2 < g`
//! of it. So the pairs of the graph are nearer than g, and as the graph is connected, no gap is as wide as g: a
//! contradiction.

use frond_core::Affine2;
use glam::DVec2;

use crate::overlap_graph::Components;
use crate::region::trap::Crossing;

/// What rounding may take from a point, relative to the line's extent, where the maps contract well.
const POINT_ROUNDING: f64 = 1e-13;
/// Rounds for the ends of the attractor, which need not be found to the last digit.
const MOST_ROUNDS_FOR_ENDS: usize = 2000;

/// Pieces on one of the axes that reach past each other, beside those that are known to meet: enough to reach every
/// piece.
pub(crate) fn overlaps_on_a_line(met: &[(usize, usize)], maps: &[Affine2]) -> Option<Vec<Crossing>> {
    // Exactly: a number more that is not 0, and the line is left.
    let stays = |axis: usize| {
        maps.iter().all(|map| {
            let row = map.to_row();
            row[2 - axis] == 0.0 && row[5 - axis] == 0.0
        })
    };
    let axis = (0..2).find(|&axis| stays(axis))?;
    let line: Vec<(f64, f64)> =
        maps.iter().map(|map| map.to_row()).map(|row| (row[3 * axis], row[4 + axis])).collect();
    let factor = line.iter().map(|(scale, _)| scale.abs()).fold(0.0, f64::max);
    // The other direction does not matter to the shape, but to there being one.
    if factor.is_nan() || factor > 1.0 - 1e-6 || maps.len() < 2 {
        return None;
    }
    // Two points of the attractor, pushed outward.
    let first = line[0].1 / (1.0 - line[0].0);
    let (mut low, mut high) = (first, first);
    for _ in 0..MOST_ROUNDS_FOR_ENDS {
        let ends = line.iter().flat_map(|(scale, shift)| [low, high].map(|x| scale * x + shift));
        let (least, most) = ends.fold((low, high), |(a, b), x| (a.min(x), b.max(x)));
        if least == low && most == high {
            break;
        }
        (low, high) = (least, most);
    }
    let rounding = POINT_ROUNDING * (low.abs() + high.abs()) / (1.0 - factor);
    let reach = |i: usize| {
        let (scale, shift) = line[i];
        let ends = [scale * low + shift, scale * high + shift];
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    };
    let mut components = Components::new(maps.len());
    for &(i, j) in met {
        components.join(i, j);
    }
    let mut found = Vec::new();
    for i in 0..maps.len() {
        for j in i + 1..maps.len() {
            let ([a, b], [c, d]) = (reach(i), reach(j));
            if b.min(d) - a.max(c) > rounding && components.join(i, j) {
                let place = |x: f64| if axis == 0 { DVec2::new(x, 0.0) } else { DVec2::new(0.0, x) };
                let corners = [a, b, c, d].map(place);
                found.push(Crossing { i, j, u: vec![i as u8], v: vec![j as u8], corners });
            }
        }
    }
    (components.count() == 1).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(scale: f64, axis: usize) -> Vec<Affine2> {
        let row = |e: f64| match axis {
            0 => [scale, 0.3, 0.0, 0.2, e, 0.0],
            _ => [0.2, 0.0, 0.3, scale, 0.0, e],
        };
        [-1.0, 1.0].map(row).map(Affine2::from_row).to_vec()
    }

    #[test]
    fn overlapping_segments_are_one() {
        for axis in 0..2 {
            assert_eq!(overlaps_on_a_line(&[], &segment(0.51, axis)).unwrap().len(), 1);
            assert!(overlaps_on_a_line(&[], &segment(-0.7, axis)).is_some());
            assert!(overlaps_on_a_line(&[], &segment(0.49, axis)).is_none());
            // They meet in one point: that is for exact arithmetic to say.
            assert!(overlaps_on_a_line(&[], &segment(0.5, axis)).is_none());
            assert!(overlaps_on_a_line(&[(0, 1)], &segment(0.5, axis)).is_some());
        }
    }

    #[test]
    fn what_leaves_the_line_is_not_its_business() {
        let mut maps = segment(0.6, 0);
        maps[1].translation.y = 1e-300;
        assert!(overlaps_on_a_line(&[], &maps).is_none());
        assert!(overlaps_on_a_line(&[], &[]).is_none());
    }
}
