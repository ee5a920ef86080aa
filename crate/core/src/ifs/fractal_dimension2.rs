//! Dimensions read off the maps.

use crate::ifs::ifs2::Ifs;

/// The similarity dimension: the `s` with `r_1^s + .. + r_N^s = 1`, where `r_i` are the ratios of maps
/// that are all similitudes (Hutchinson 1981). It is the Hausdorff dimension where the pieces do not
/// overlap, and never below it. `None` where some map is not a similitude.
#[must_use]
pub fn similarity_dimension(ifs: &Ifs) -> Option<f64> {
    let all = ifs.maps().iter().all(|map| map.is_similitude(1e-9));
    all.then(|| affinity_dimension(ifs))
}

/// An upper bound of the dimension of any attractor of affine maps: the `s` where the singular value
/// functions of the maps sum to 1 (Falconer 1988, first level).
#[must_use]
pub fn affinity_dimension(ifs: &Ifs) -> f64 {
    let values: Vec<_> = ifs.maps().iter().map(|map| map.singular_values()).collect();
    let sum = |s: f64| -> f64 { values.iter().map(|&(large, small)| falconer(large, small, s)).sum() };
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

/// The singular value function of one map of the plane.
fn falconer(large: f64, small: f64, s: f64) -> f64 {
    if large == 0.0 {
        // A map to one point: it counts as a piece only where points are counted.
        return if s == 0.0 { 1.0 } else { 0.0 };
    }
    if s <= 1.0 {
        large.powf(s)
    } else if s <= 2.0 {
        large * small.powf(s - 1.0)
    } else {
        (large * small).powf(s / 2.0)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::linear::affine2::Affine2;

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
}
