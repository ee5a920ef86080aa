//! The box dimension of a shape of space, from points of it.

use std::collections::HashSet;

/// How many boxes a shape meets, by their side.
#[derive(Clone, Debug, PartialEq)]
pub struct BoxCount {
    /// The slope of the logarithms of the counts: an estimate of the box dimension. 0 where there are too few points.
    pub dimension: f64,
    /// The side of the boxes, in units of space, and how many were met; the largest side first.
    pub counts: Vec<(f64, usize)>,
}

/// Most points that are counted.
const MOST_COUNTED: usize = 4_000_000;
/// As long as there are so many points to a box on the average, few boxes are missed.
const POINTS_A_BOX: usize = 12;

/// Estimates the box dimension from points `x0, y0, z0, x1, ..` of a shape: how fast the boxes that it meets become
/// more as they become smaller. Points that are not finite are left out, and so are those beyond the first four
/// million.
///
/// It is off by 0.05 or so with a million points of a shape whose points are spread evenly.
#[must_use]
pub fn box_dimension(positions: &[f32]) -> BoxCount {
    let points: Vec<[f32; 3]> = positions
        .as_chunks::<3>()
        .0
        .iter()
        .take(MOST_COUNTED)
        .filter(|p| p.iter().all(|x| x.is_finite()))
        .copied()
        .collect();
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for point in &points {
        for k in 0..3 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    let size = (0..3).map(|k| f64::from(high[k]) - f64::from(low[k])).fold(0.0, f64::max);
    let mut counts = Vec::new();
    if points.is_empty() || size == 0.0 {
        return BoxCount { dimension: 0.0, counts };
    }
    // A little larger, so that the last point does not open a box of its own.
    let size = size * (1.0 + 1e-6);
    for level in 1..=12 {
        let side = size / f64::from(1_u32 << level);
        let cell = |x: f32, low: f32| ((f64::from(x) - f64::from(low)) / side) as u16;
        let boxes: HashSet<[u16; 3]> =
            points.iter().map(|p| std::array::from_fn(|k| cell(p[k], low[k]))).collect();
        if level > 2 && boxes.len() * POINTS_A_BOX > points.len() {
            break;
        }
        counts.push((side, boxes.len()));
    }
    // Large boxes say little of the shape.
    let used = &counts[counts.len().saturating_sub(4).max(1).min(counts.len())..];
    let logs: Vec<(f64, f64)> = used.iter().map(|&(side, n)| (-side.ln(), (n as f64).ln())).collect();
    BoxCount { dimension: slope(&logs), counts }
}

/// The slope of a line through points, by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / count, sum.1 + p.1 / count));
    let (xx, xy) =
        points.iter().fold((0.0, 0.0), |s, p| (s.0 + (p.0 - x).powi(2), s.1 + (p.0 - x) * (p.1 - y)));
    if xx > 0.0 { xy / xx } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;
    use crate::{Affine3, ChaosGame3, Ifs3};

    fn shrunk(ratio: f64, corners: &[DVec3]) -> Ifs3 {
        let map = |&c: &DVec3| Affine3::similitude(ratio, DQuat::IDENTITY, c * (1.0 - ratio));
        Ifs3::new(corners.iter().map(map).collect()).unwrap()
    }

    fn sponge() -> Ifs3 {
        let cells = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9]);
        let kept = cells.filter(|cell| cell.iter().filter(|&&c| c == 1).count() < 2);
        let corners: Vec<DVec3> = kept.map(|c| DVec3::from_array(c.map(|x| f64::from(x) / 2.0))).collect();
        shrunk(1.0 / 3.0, &corners)
    }

    #[test]
    fn counted_boxes_come_near() {
        let tetrahedron = shrunk(0.5, &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
        for (ifs, wanted, off) in [(tetrahedron, 2.0, 0.1), (sponge(), 2.727, 0.15)] {
            let mut positions = vec![0.0; 3_000_000];
            ChaosGame3::new(&ifs, 1).fill(&mut positions, &mut vec![0; 1_000_000]);
            let found = box_dimension(&positions);
            assert!((found.dimension - wanted).abs() < off, "{wanted}: {found:?}");
        }
    }

    #[test]
    fn few_points_and_bad_ones_do_no_harm() {
        for points in [
            &[][..],
            &[1.0, 2.0],
            &[1.0, 2.0, 3.0],
            &[f32::NAN; 9],
            &[f32::MAX, 0.0, 0.0, f32::MIN, 0.0, 0.0],
        ] {
            assert!(box_dimension(points).dimension.is_finite());
        }
    }
}
