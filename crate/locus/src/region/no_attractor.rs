//! Boxes of parameters without attractors.

use frond_core::Affine2;

use crate::family::{Drift, Family};
use crate::region::extent::Extent;
use crate::support::extremes::larger;

/// Whether some map of a family has no attractor anywhere in a box: its spectral radius stays above 1, as the root of
/// its determinant or half its trace does.
pub(crate) fn never_contracts<F: Family + ?Sized>(family: &F, extent: Extent) -> bool {
    let mut lanes: [Vec<Affine2>; 6] = std::array::from_fn(|_| Vec::with_capacity(family.len()));
    for (l, maps) in lanes.iter_mut().enumerate() {
        let place = extent.place::<6>(l);
        family.fill(place.x, place.y, maps);
    }
    let mut drifts = [Vec::new(), Vec::new()];
    for (axis, drifts) in drifts.iter_mut().enumerate() {
        family.drift(axis, extent.middle, extent.half[axis], drifts);
    }
    extent.is_usual()
        && (0..family.len()).any(|i| {
            let most = lanes.iter().map(|maps| maps[i].norm()).fold(0.0, larger);
            let (mut bent_trace, mut bent_area) = (0.0, 0.0);
            for (axis, drifts) in drifts.iter().enumerate() {
                let Drift { speed, bend, .. } = drifts[i];
                let square = 0.5 * extent.half[axis] * extent.half[axis];
                let first = speed.norm() + extent.half[axis] * bend;
                bent_trace += 2.0 * bend * square;
                bent_area += 2.0 * (first * first + (most + bend * square) * bend) * square;
            }
            let beyond = |of: &dyn Fn(&Affine2) -> f64, bent: f64, limit: f64| {
                let each = lanes.iter().map(|maps| of(&maps[i]));
                let (low, high) =
                    each.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
                low.max(-high) - bent > limit * (1.0 + 1e-9)
            };
            beyond(&|map| map.determinant(), bent_area, 1.0)
                || beyond(&|map| map.linear.x_axis.x + map.linear.y_axis.y, bent_trace, 2.0)
        })
}

#[cfg(test)]
mod tests {
    use frond_core::{Morph, MorphOptions, hash};
    use glam::DVec2;

    use super::*;
    use crate::family::Slice;

    fn unit(seed: u32, k: u32) -> f64 {
        f64::from(hash::unit(hash::counter(seed, k)))
    }

    /// A morph of three maps, of which some reflect.
    fn any_morph(seed: u32) -> Morph {
        let end = |seed: u32| -> Vec<Affine2> {
            let size = |k: u32| if k < 4 { 1.0 } else { 4.0 };
            let row = |i: u32| std::array::from_fn(|k| (unit(seed, 6 * i + k as u32) - 0.5) * size(k as u32));
            (0..3).map(|i| Affine2::from_row(row(i))).collect()
        };
        Morph::new(&end(2 * seed), &end(2 * seed + 1), &MorphOptions::default()).unwrap()
    }

    #[test]
    fn what_never_contracts_does_so_nowhere() {
        let (mut maps, mut proved) = (Vec::new(), 0);
        for seed in 0..300 {
            let morph = any_morph(seed);
            let slice = Slice::new(&morph, 0.0);
            let middle = DVec2::new(unit(seed, 500), unit(seed, 501)) * 6.0 - 3.0;
            let extent = Extent { middle, half: DVec2::splat(0.2) };
            if never_contracts(&slice, extent) {
                proved += 1;
                for k in 0..100 {
                    let at = middle + DVec2::new(unit(seed, 2 * k), unit(seed, 2 * k + 1)) * 0.4 - 0.2;
                    slice.fill(at.x, at.y, &mut maps);
                    assert!(maps.iter().any(|map| map.spectral_radius() >= 1.0));
                }
            }
        }
        assert!(proved > 10, "{proved}");
    }
}
