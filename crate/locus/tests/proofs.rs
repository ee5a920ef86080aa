//! Proofs for the samples of a locus, against each sample on its own.

mod common;

use frond_core::{Affine2, Ifs, Morph, MorphOptions, hash};
use frond_locus::{Bounds, LocusGrid, Options, Scratch, State, Verdict, connectedness};
use glam::{DMat2, DVec2};

use crate::common::dragon_to_gasket;

const CONNECTED: u8 = State::Connected as u8;
const TOUCHING: u8 = State::Touching as u8;

/// What is decided of all samples of a grid, before and after its proofs.
fn proved(grid: &LocusGrid, morph: &Morph, epsilon: f64) -> [Vec<u8>; 2] {
    let (width, height) = (grid.width(), grid.height());
    let mut scratch = Scratch::default();
    let before = grid.patch(morph, epsilon, 0..width, 0..height, &mut scratch).state;
    let mut after = before.clone();
    let count = grid.prove(morph, epsilon, 0..width, 0..height, &mut after, &mut scratch);
    let new = before.iter().zip(&after).filter(|(before, after)| before != after);
    assert!(new.clone().all(|(&before, &after)| before == TOUCHING && after == CONNECTED));
    assert_eq!(count, new.count());
    [before, after]
}

#[test]
fn most_of_what_holds_between_dragon_and_gasket_is_proved() {
    let grid = LocusGrid::new(Bounds::default(), 128, 128).unwrap();
    for (epsilon, percent) in [(1.0 / 600.0, 97), (1e-4, 98)] {
        let [before, after] = proved(&grid, &dragon_to_gasket(), epsilon);
        let holds = after.iter().filter(|&&state| state == CONNECTED || state == TOUCHING).count();
        let [few, most] = [before, after].map(|all| all.iter().filter(|&&state| state == CONNECTED).count());
        assert!(holds > 5000 && few * 4 < holds, "{few} of {holds}");
        assert!(most * 100 >= holds * percent, "{most} of {holds} at {epsilon}");
    }
}

fn unit(seed: u32, k: u32) -> f64 {
    f64::from(hash::unit(hash::counter(seed, k)))
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// One linear part for all maps.
    Equal,
    Round,
    /// Bars, the gaps of which others may pass.
    Thin,
}

/// A random system, near the edge of falling apart.
fn any_maps(seed: u32, count: u32, kind: Kind) -> Vec<Affine2> {
    let linear = |i: u32| {
        let at = |k: u32| unit(seed, 20 * i + k);
        let size = (f64::from(count).sqrt().recip() * (0.8 + 0.4 * at(0))).min(0.9);
        let flat = match kind {
            Kind::Thin => DVec2::new(0.5 + 0.4 * at(0), 0.02 + 0.2 * at(1)),
            _ => DVec2::new(size, size * (0.6 + 0.4 * at(1))),
        };
        DMat2::from_angle(6.3 * at(2)) * DMat2::from_diagonal(flat) * DMat2::from_angle(6.3 * at(3))
    };
    let map = |i: u32| {
        let shift = DVec2::new(unit(seed, 20 * i + 4), unit(seed, 20 * i + 5)) * 2.0 - 1.0;
        Affine2::new(linear(if kind == Kind::Equal { 0 } else { i }), shift)
    };
    (0..count).map(map).collect()
}

#[test]
fn no_proof_contradicts_what_a_sample_is_on_its_own() {
    let side = 10;
    let grid = LocusGrid::new(Bounds { u0: -0.2, v0: -0.2, u1: 1.2, v1: 1.2 }, side, side).unwrap();
    // So wide that what is apart by less passes for touching: those are not to be proved.
    let epsilon = 0.05;
    let mut new = [0; 3];
    let mut refused = [0; 3];
    for seed in 0..frond_testing::cases(60) {
        let which = seed as usize % 3;
        let kind = [Kind::Equal, Kind::Round, Kind::Thin][which];
        let count = 2 + seed / 3 % 4;
        let [from, to] = [0, 1].map(|k| any_maps(2 * seed + k, count, kind));
        // Between two linear parts all the maps go the same way.
        let morph = Morph::new(&from, &to, &MorphOptions::default()).unwrap();
        let [before, after] = proved(&grid, &morph, epsilon);
        for k in (0..side * side).filter(|&k| before[k] == TOUCHING) {
            let Ok(ifs) = Ifs::new(morph.at(grid.u(k % side), grid.v(k / side))) else { continue };
            let finer = connectedness(&ifs, &Options { epsilon: 1e-6, ..Options::default() });
            if after[k] == CONNECTED {
                assert_ne!(finer.verdict, Verdict::Disconnected, "seed {seed}, sample {k}");
                new[which] += 1;
            } else if finer.verdict == Verdict::Disconnected {
                refused[which] += 1;
            }
        }
    }
    assert!(new.into_iter().chain(refused).all(|count| count > 20), "{new:?} proved, {refused:?} refused");
}

/// Three halves touch in the middles of a triangle's sides, wherever its corners are; what is less by the last digit
/// does not.
#[test]
fn points_that_pieces_share_are_told_from_points_that_nearly_coincide() {
    let grid = LocusGrid::new(Bounds::default(), 31, 31).unwrap();
    let still = |k: usize| (grid.u(k % 31) == 0.0).then_some(k);
    for (scale, is_shared) in [(0.5, true), (0.5_f64.next_down(), false)] {
        let corner = |k: u32, turn: f64, scale: f64| {
            let place = DVec2::new(unit(8, 2 * k), unit(8, 2 * k + 1)) * 2.0 - turn;
            Affine2::new(DMat2::from_angle(turn) * scale, place)
        };
        let [from, to] =
            [(0.0, scale), (1.2, 0.6)].map(|(turn, scale)| [0, 1, 2].map(|k| corner(k, turn, scale)));
        let morph = Morph::new(&from, &to, &MorphOptions::default()).unwrap();
        let [before, after] = proved(&grid, &morph, 1.0 / 600.0);
        let column: Vec<usize> =
            (0..after.len()).filter_map(still).filter(|&k| before[k] == TOUCHING).collect();
        let count = column.iter().filter(|&&k| after[k] == CONNECTED).count();
        assert!(column.len() > 20, "{}", column.len());
        assert_eq!(count, if is_shared { column.len() } else { 0 }, "of {} at {scale}", column.len());
    }
}

#[test]
fn states_that_say_too_much_are_not_believed() {
    let grid = LocusGrid::new(Bounds::default(), 24, 24).unwrap();
    let morph = dragon_to_gasket();
    let mut scratch = Scratch::default();
    let truth = grid.patch(&morph, 1e-4, 0..24, 0..24, &mut scratch).state;
    let mut all = vec![TOUCHING; 24 * 24];
    grid.prove(&morph, 1e-4, 0..24, 0..24, &mut all, &mut scratch);
    for (truth, told) in truth.iter().zip(&all) {
        assert!(*told == TOUCHING || *truth == CONNECTED || *truth == TOUCHING);
    }
}

#[test]
fn rectangles_past_the_edge_and_empty_ones_are_no_trouble() {
    let grid = LocusGrid::new(Bounds::default(), 5, 4).unwrap();
    let morph = dragon_to_gasket();
    let mut scratch = Scratch::default();
    assert_eq!(grid.prove(&morph, 1e-4, 5..9, 0..4, &mut [], &mut scratch), 0);
    assert_eq!(grid.prove(&morph, 1e-4, 0..5, 4..9, &mut [], &mut scratch), 0);
    let mut corner = [TOUCHING; 2];
    grid.prove(&morph, 1e-4, 3..9, 3..9, &mut corner, &mut scratch);
    for epsilon in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e300] {
        let mut all = [TOUCHING; 20];
        grid.prove(&morph, epsilon, 0..5, 0..4, &mut all, &mut scratch);
    }
    // Where parameters are no numbers, or far off, there is nothing to prove.
    let far = LocusGrid::new(Bounds { u0: -1e9, v0: -1e9, u1: 1e9, v1: 1e9 }, 4, 4).unwrap();
    assert_eq!(far.prove(&morph, 1e-4, 0..4, 0..4, &mut [TOUCHING; 16], &mut scratch), 0);
}

#[test]
#[should_panic(expected = "one state for each sample")]
fn too_few_states_are_refused() {
    let grid = LocusGrid::new(Bounds::default(), 5, 4).unwrap();
    grid.prove(&dragon_to_gasket(), 1e-4, 0..5, 0..4, &mut [TOUCHING; 7], &mut Scratch::default());
}
