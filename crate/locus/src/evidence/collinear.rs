//! Attractors that lie on a line.
//!
//! **Theorem.** Let all maps contract, and let the attractor A lie on a line. If the graph of the pairs (i, j) of
//! which one piece has a point between two points of the other, or at one of them, is connected, then A is connected.
//!
//! **Proof.** The hulls of the pieces are segments, and those of such a pair have a common point: so all of them
//! together are the hull of A. Suppose that the widest hole of A in it is g wide, and g > 0. A point of this hole lies
//! in the hull of a piece `A_i`, and so in a hole of `A_i`. This is at most `|w_i| g < g` wide; but no point of A is in
//! the widest hole, so that the ends of the other, which are points of A, lie beyond: a contradiction.

use frond_core::Affine2;
use glam::DVec2;

use crate::exact::address::Address;
use crate::overlap_graph::Components;

/// What rounding may take from a point, relative to the line's extent, where the maps contract well.
const POINT_ROUNDING: f64 = 1e-13;
/// Rounds for the ends of the attractor, which need not be found to the last digit.
const MOST_ROUNDS_FOR_ENDS: usize = 2000;

/// Two pieces that overlap on a line.
#[derive(Clone, Debug)]
pub(crate) struct Overlap {
    /// Two maps, the smaller index first.
    pub pair: [usize; 2],
    /// Two points of one of the pieces, and one of the other between them.
    pub addresses: [Address; 3],
    /// The ends of both pieces.
    pub corners: [DVec2; 4],
}

/// Pieces on one of the axes that overlap, beside those that are known to meet: enough to reach every piece.
pub(crate) fn overlaps_on_a_line(met: &[(usize, usize)], maps: &[Affine2]) -> Option<Vec<Overlap>> {
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
    let [lowest, highest] = addresses_of_ends(&line, [low, high])?;
    // The ends of a piece with their addresses, the lower one first.
    let reach = |i: usize| {
        let (scale, shift) = line[i];
        let of = |x: f64, end: &Address| {
            let head = [&[i as u8], &end.head[..]].concat();
            Address::new(head, end.repeat.clone()).map(|address| (scale * x + shift, address))
        };
        let [p, q] = [of(low, &lowest)?, of(high, &highest)?];
        Some(if p.0 <= q.0 { [p, q] } else { [q, p] })
    };
    let mut components = Components::new(maps.len());
    for &(i, j) in met {
        components.join(i, j);
    }
    let mut found = Vec::new();
    for i in 0..maps.len() {
        for j in i + 1..maps.len() {
            let ([a, b], [c, d]) = (reach(i)?, reach(j)?);
            if b.0.min(d.0) - a.0.max(c.0) > rounding && components.join(i, j) {
                let place = |x: f64| if axis == 0 { DVec2::new(x, 0.0) } else { DVec2::new(0.0, x) };
                let corners = [a.0, b.0, c.0, d.0].map(place);
                // Of two segments that overlap one begins in the other.
                let three = if a.0 <= c.0 { [a, b, c] } else { [c, d, a] };
                found.push(Overlap { pair: [i, j], addresses: three.map(|(_, address)| address), corners });
            }
        }
    }
    (components.count() == 1).then_some(found)
}

/// The addresses of the ends of an attractor on a line: each is the image of one of the two.
fn addresses_of_ends(line: &[(f64, f64)], ends: [f64; 2]) -> Option<[Address; 2]> {
    let images =
        || (0..line.len()).flat_map(|k| [0, 1].map(|end| (line[k].0 * ends[end] + line[k].1, k as u8, end)));
    let (_, first, of_first) = images().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let (_, last, of_last) = images().max_by(|a, b| a.0.total_cmp(&b.0))?;
    let address = |own: usize, letter: u8, of: usize, other: u8, of_other: usize| {
        if of == own {
            Address::new(Vec::new(), vec![letter])
        } else if of_other == of {
            Address::new(vec![letter], vec![other])
        } else {
            Address::new(Vec::new(), vec![letter, other])
        }
    };
    Some([address(0, first, of_first, last, of_last)?, address(1, last, of_last, first, of_first)?])
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
