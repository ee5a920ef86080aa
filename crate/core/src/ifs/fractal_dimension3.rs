//! Dimensions of shapes of space.

use std::collections::HashSet;

use crate::ifs::ifs3::Ifs3;

/// The similarity dimension: the `s` with `r_1^s + .. + r_N^s = 1`, where `r_i` are the ratios of maps that are all
/// similitudes (Hutchinson 1981). `None` where some map is not. See [`similarity_dimension`](crate::similarity_dimension).
#[must_use]
pub fn similarity_dimension3(ifs: &Ifs3) -> Option<f64> {
    let all = ifs.maps().iter().all(|map| map.is_similitude(1e-9));
    all.then(|| affinity_dimension3(ifs))
}

/// An upper bound of the dimension of any attractor of affine maps of space: the `s` where the singular value functions
/// of the maps sum to 1 (Falconer 1988, first level).
#[must_use]
pub fn affinity_dimension3(ifs: &Ifs3) -> f64 {
    let values: Vec<[f64; 3]> = ifs.maps().iter().map(|map| map.singular_values()).collect();
    let sum = |s: f64| -> f64 { values.iter().map(|v| falconer(*v, s)).sum() };
    let (mut low, mut high) = (0.0, 64.0);
    if sum(high) > 1.0 {
        return f64::INFINITY;
    }
    for _ in 0..100 {
        let middle = f64::midpoint(low, high);
        if sum(middle) > 1.0 { low = middle } else { high = middle }
    }
    f64::midpoint(low, high)
}

/// The singular value function of one map of space.
fn falconer([a, b, c]: [f64; 3], s: f64) -> f64 {
    if a == 0.0 {
        // A map to one point: it counts as a piece only where points are counted.
        return if s == 0.0 { 1.0 } else { 0.0 };
    }
    if s <= 1.0 {
        a.powf(s)
    } else if s <= 2.0 {
        a * b.powf(s - 1.0)
    } else if s <= 3.0 {
        a * b * c.powf(s - 2.0)
    } else {
        (a * b * c).powf(s / 3.0)
    }
}

/// How many boxes a shape meets, by their side.
#[derive(Clone, Debug, PartialEq)]
pub struct BoxCount {
    /// The slope of the logarithms of the counts: an estimate of the box dimension. 0 where there are too few points.
    pub dimension: f64,
    /// The side of the boxes, in units of space, and how many were met; the largest side first.
    pub counts: Vec<(f64, usize)>,
}

/// Most points that are counted.
const MOST: usize = 4_000_000;
/// As long as there are so many points to a box on the average, few boxes are missed.
const ENOUGH: usize = 12;

/// Estimates the box dimension from points `x0, y0, z0, x1, ..` of a shape: how fast the boxes that it meets become
/// more as they become smaller. Points that are not finite are left out, and so are those beyond the first four million.
///
/// It is off by 0.05 or so with a million points of a shape whose points are spread evenly.
#[must_use]
pub fn box_dimension(positions: &[f32]) -> BoxCount {
    let points: Vec<[f32; 3]> = positions
        .as_chunks::<3>()
        .0
        .iter()
        .take(MOST)
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
        if level > 2 && boxes.len() * ENOUGH > points.len() {
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
    use crate::linear::affine3::Affine3;
    use crate::sample::chaos_game3::ChaosGame3;

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
    fn known_dimensions() {
        let tetrahedron = shrunk(0.5, &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
        assert!((similarity_dimension3(&tetrahedron).unwrap() - 2.0).abs() < 1e-12);
        let wanted = 20.0_f64.ln() / 3.0_f64.ln();
        assert!((similarity_dimension3(&sponge()).unwrap() - wanted).abs() < 1e-9);
        let slab = Ifs3::new(vec![Affine3::scaling(DVec3::new(0.5, 0.5, 0.25)); 8]).unwrap();
        assert_eq!(similarity_dimension3(&slab), None);
        // 8 * 1/2 * 1/2 * (1/4)^(s - 2) = 1 at s = 2.5.
        assert!((affinity_dimension3(&slab) - 2.5).abs() < 1e-9);
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
