//! The chaos game in space.

use glam::DVec3;

use crate::hash;
use crate::ifs::system::Ifs3;
use crate::sample::chaos_game::{LANES, SLOTS, STEPS_APART, chaos_game, table};

chaos_game! {
    /// Points of an attractor of space, by Barnsley's chaos game: the twin of [`ChaosGame`](crate::ChaosGame).
    ///
    /// Probabilities are kept to 1/4096, and no map gets less. The same system and seed give the same points on every
    /// machine, however the calls are cut.
    ChaosGame3, Ifs3, 3
}

/// The columns of a map, then its translation, each filled up to four numbers, so that one step is a few operations on
/// four lanes.
type Map = [[f32; 4]; 4];
type Orbit = [f32; 4];

fn start(ifs: &Ifs3) -> (Box<[Map; 64]>, Orbit) {
    let mut columns = Box::new([[[0.0; 4]; 4]; 64]);
    for (columns, map) in columns.iter_mut().zip(ifs.maps()) {
        let m = map.linear;
        *columns = [m.x_axis, m.y_axis, m.z_axis, map.translation]
            .map(|v| [v.x as f32, v.y as f32, v.z as f32, 0.0]);
    }
    let start = ifs.maps()[0].fixed_point().unwrap_or(DVec3::ZERO).as_vec3();
    (columns, [start.x, start.y, start.z, 0.0])
}

#[inline(always)]
fn step([a, b, c, t]: Map, [x, y, z, _]: Orbit) -> Orbit {
    std::array::from_fn(|k| (a[k] * x + b[k] * y) + (c[k] * z + t[k]))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing3::any_ifs3;
    use crate::{Affine3, Bounds3};

    fn run(ifs: &Ifs3, seed: u32, calls: &[usize]) -> (Vec<f32>, Vec<u8>) {
        let mut game = ChaosGame3::new(ifs, seed);
        let (mut positions, mut pieces) = (Vec::new(), Vec::new());
        for &n in calls {
            let (mut p, mut i) = (vec![0.0; 3 * n], vec![0; n]);
            assert_eq!(game.fill(&mut p, &mut i), n);
            positions.append(&mut p);
            pieces.append(&mut i);
        }
        (positions, pieces)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(64)))]
        #[test]
        fn points_lie_in_the_ball_and_in_the_piece_they_name(ifs in any_ifs3(), seed in any::<u32>()) {
            let bounds = Bounds3::of(&ifs);
            let (positions, pieces) = run(&ifs, seed, &[500]);
            let slack = 1e-4 * (1.0 + bounds.radius + bounds.centre.length());
            for (p, i) in positions.chunks_exact(3).zip(pieces) {
                let p = DVec3::new(p[0].into(), p[1].into(), p[2].into());
                prop_assert!(p.distance(bounds.centre) <= bounds.radius + slack);
                prop_assert!(usize::from(i) < ifs.len());
                let map = ifs.maps()[usize::from(i)];
                prop_assert!(p.distance(map.apply(bounds.centre)) <= map.norm() * bounds.radius + slack);
            }
        }

        #[test]
        fn the_cut_into_calls_does_not_matter(ifs in any_ifs3(), calls in proptest::collection::vec(0_usize..20, 1..8)) {
            let total = calls.iter().sum();
            prop_assert_eq!(run(&ifs, 7, &calls), run(&ifs, 7, &[total]));
        }
    }

    #[test]
    fn maps_come_as_often_as_they_are_probable() {
        let maps = vec![Affine3::scaling(DVec3::splat(0.5)); 3];
        let ifs = Ifs3::new(maps).unwrap().with_probabilities(&[0.7, 0.3, 0.0]).unwrap();
        let (_, pieces) = run(&ifs, 5, &[100_000]);
        let share = |i| pieces.iter().filter(|&&p| p == i).count() as f64 / 100_000.0;
        assert!((share(0) - 0.7).abs() < 0.01 && (share(1) - 0.3).abs() < 0.01);
        assert!(share(2) > 0.0, "a map of probability 0 still shows");
    }
}
