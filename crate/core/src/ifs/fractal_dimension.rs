//! Dimensions read off the maps.

use crate::dimension::Dimension;
use crate::ifs::system::Ifs;

/// The similarity dimension: the `s` with `r_1^s + .. + r_N^s = 1`, where `r_i` are the ratios of maps
/// that are all similitudes (Hutchinson 1981). It is the Hausdorff dimension where the pieces do not
/// overlap, and never below it. `None` where some map is not a similitude.
#[must_use]
pub fn similarity_dimension<D: Dimension>(ifs: &Ifs<D>) -> Option<f64> {
    let all = ifs.maps().iter().all(|map| map.is_similitude(1e-9));
    all.then(|| affinity_dimension(ifs))
}

/// An upper bound of the dimension of any attractor of affine maps: the `s` where the singular value
/// functions of the maps sum to 1 (Falconer 1988, first level).
#[must_use]
pub fn affinity_dimension<D: Dimension>(ifs: &Ifs<D>) -> f64 {
    let values: Vec<_> = ifs.maps().iter().map(|map| D::singular_values(map.linear)).collect();
    let sum = |s: f64| -> f64 { values.iter().map(|v| falconer(v.as_ref(), s)).sum() };
    // Maps that stretch at first may need any s; beyond 64 nobody asks.
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

/// The singular value function of one map: the product of the largest values, the last to the power that is left of s.
pub(crate) fn falconer(values: &[f64], s: f64) -> f64 {
    if values[0] == 0.0 {
        // A map to one point: it counts as a piece only where points are counted.
        return if s == 0.0 { 1.0 } else { 0.0 };
    }
    if s > values.len() as f64 {
        return values.iter().product::<f64>().powf(s / values.len() as f64);
    }
    let whole = (s.ceil() as usize).saturating_sub(1);
    values[..whole].iter().product::<f64>() * values[whole].powf(s - whole as f64)
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec2, DVec3};

    use super::*;
    use crate::{Affine2, Affine3, Ifs3};

    fn similitudes(ratios: &[f64]) -> Ifs {
        let maps = ratios.iter().map(|&r| Affine2::similitude(r, r, DVec2::new(r, 1.0))).collect();
        Ifs::new(maps).unwrap()
    }

    #[test]
    fn known_dimensions() {
        let close = |ifs: &Ifs, s: f64| (similarity_dimension(ifs).unwrap() - s).abs() < 1e-12;
        assert!(close(&similitudes(&[0.5; 3]), 3.0_f64.log2()));
        assert!(close(&similitudes(&[1.0 / 3.0; 4]), 4.0_f64.ln() / 3.0_f64.ln()));
        assert!(close(&similitudes(&[0.5_f64.sqrt(); 2]), 2.0));
        assert!(close(&similitudes(&[0.5]), 0.0));
        assert!(close(&similitudes(&[0.0, 0.0]), 0.0));
    }

    #[test]
    fn other_maps_have_a_bound_only() {
        let carpet =
            [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.4, e, f]));
        let ifs = Ifs::new(carpet.to_vec()).unwrap();
        assert_eq!(similarity_dimension(&ifs), None);
        let bound = affinity_dimension(&ifs);
        assert!((3.0 * 0.5 * 0.4_f64.powf(bound - 1.0) - 1.0).abs() < 1e-9);
    }

    fn shrunk(ratio: f64, corners: &[DVec3]) -> Ifs3 {
        let map = |&c: &DVec3| Affine3::similitude(ratio, DQuat::IDENTITY, c * (1.0 - ratio));
        Ifs3::new(corners.iter().map(map).collect()).unwrap()
    }

    #[test]
    fn known_dimensions_in_space() {
        let tetrahedron = shrunk(0.5, &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
        assert!((similarity_dimension(&tetrahedron).unwrap() - 2.0).abs() < 1e-12);
        let cells = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9]);
        let kept = cells.filter(|cell| cell.iter().filter(|&&c| c == 1).count() < 2);
        let corners: Vec<DVec3> = kept.map(|c| DVec3::from_array(c.map(|x| f64::from(x) / 2.0))).collect();
        let sponge = shrunk(1.0 / 3.0, &corners);
        let wanted = 20.0_f64.ln() / 3.0_f64.ln();
        assert!((similarity_dimension(&sponge).unwrap() - wanted).abs() < 1e-9);
        let slab = Ifs3::new(vec![Affine3::scaling(DVec3::new(0.5, 0.5, 0.25)); 8]).unwrap();
        assert_eq!(similarity_dimension(&slab), None);
        // 8 * 1/2 * 1/2 * (1/4)^(s - 2) = 1 at s = 2.5.
        assert!((affinity_dimension(&slab) - 2.5).abs() < 1e-9);
    }
}
