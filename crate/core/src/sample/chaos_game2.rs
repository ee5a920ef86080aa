//! The chaos game in the plane.

use glam::DVec2;

use crate::hash;
use crate::ifs::system::Ifs;
use crate::sample::chaos_game::{LANES, SLOTS, STEPS_APART, chaos_game, table};

chaos_game! {
    /// Points of the attractor, by Barnsley's chaos game: from a fixed point on, apply a map chosen at random
    /// again and again.
    ///
    /// Probabilities are kept to 1/4096, and no map gets less. The points are `f32`, as a GPU wants them. The
    /// same system and seed give the same points on every machine, however the calls are cut: orbit k of 8
    /// gives the points k, k + 8, k + 16 ..
    ChaosGame, Ifs, 2
}

type Map = [f32; 6];
type Orbit = [f32; 2];

fn start(ifs: &Ifs) -> (Box<[Map; 64]>, Orbit) {
    let mut rows = Box::new([[0.0; 6]; 64]);
    for (row, map) in rows.iter_mut().zip(ifs.maps()) {
        *row = map.to_row().map(|x| x as f32);
    }
    (rows, ifs.maps()[0].fixed_point().unwrap_or(DVec2::ZERO).as_vec2().to_array())
}

#[inline(always)]
fn step([a, b, c, d, e, f]: Map, [x, y]: Orbit) -> Orbit {
    [a * x + (b * y + e), c * x + (d * y + f)]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::any_ifs;
    use crate::{Affine2, Hull};

    fn run(ifs: &Ifs, seed: u32, calls: &[usize]) -> (Vec<f32>, Vec<u8>) {
        let mut game = ChaosGame::new(ifs, seed);
        let (mut positions, mut pieces) = (Vec::new(), Vec::new());
        for &n in calls {
            let (mut p, mut i) = (vec![0.0; 2 * n], vec![0; n]);
            assert_eq!(game.fill(&mut p, &mut i), n);
            positions.append(&mut p);
            pieces.append(&mut i);
        }
        (positions, pieces)
    }

    proptest! {
        #[test]
        fn points_lie_in_the_hull_and_in_the_piece_they_name(ifs in any_ifs(), seed in any::<u32>()) {
            let hull = Hull::of(&ifs);
            let (positions, pieces) = run(&ifs, seed, &[500]);
            let slack = 1e-4 * (1.0 + hull.radius() + hull.centre().length());
            for (p, i) in positions.chunks_exact(2).zip(pieces) {
                let p = DVec2::new(p[0].into(), p[1].into());
                prop_assert!(p.distance(hull.centre()) <= hull.radius() + slack);
                prop_assert!(usize::from(i) < ifs.len());
                let map = ifs.maps()[usize::from(i)];
                prop_assert!(p.distance(map.apply(hull.centre())) <= map.norm() * hull.radius() + slack);
            }
        }

        #[test]
        fn the_cut_into_calls_does_not_matter(ifs in any_ifs(), calls in proptest::collection::vec(0_usize..20, 1..8)) {
            let total = calls.iter().sum();
            prop_assert_eq!(run(&ifs, 7, &calls), run(&ifs, 7, &[total]));
        }
    }

    #[test]
    fn maps_come_as_often_as_they_are_probable() {
        let maps = vec![Affine2::similitude(0.5, 0.0, DVec2::X); 3];
        let ifs = Ifs::new(maps).unwrap().with_probabilities(&[0.7, 0.3, 0.0]).unwrap();
        let (_, pieces) = run(&ifs, 5, &[100_000]);
        let share = |i| pieces.iter().filter(|&&p| p == i).count() as f64 / 100_000.0;
        assert!((share(0) - 0.7).abs() < 0.01 && (share(1) - 0.3).abs() < 0.01);
        assert!(share(2) > 0.0, "a map of probability 0 still shows");
    }
}
