//! Pieces that must meet, since their areas leave no room between them.

use frond_core::{Affine2, hash};
use frond_locus::{Scratch, State, decide, decide_bounds};
use glam::{DMat2, DVec2};

fn number(seed: u32, index: u32) -> f64 {
    f64::from(hash::counter(seed, index)) / f64::from(u32::MAX) * 2.0 - 1.0
}

#[test]
fn a_large_piece_meets_all_that_are_not_too_small() {
    let mut scratch = Scratch::default();
    for seed in 0..200 {
        let map = |k: u32, scale: f64| {
            let shift = DVec2::new(number(seed, 3 * k), number(seed, 3 * k + 1));
            Affine2::similitude(scale, 3.0 * number(seed, 3 * k + 2), shift)
        };
        // 0.96^2 + 0.29^2 is more than 1, 0.96^2 + 0.26^2 is less.
        let large = [map(0, 0.96), map(1, 0.29), map(2, 0.3), map(3, 0.31)];
        let known = decide_bounds(&large, 1e-6, 20_000, &mut scratch);
        assert_eq!((known.sample.state, known.upper), (State::Connected, 0.0), "{seed}");
        let less = [map(0, 0.96), map(1, 0.26), map(2, 0.26)];
        let sample = decide(&less, 1e-6, 2_000, &mut scratch);
        assert_ne!(sample.state, State::Connected, "{seed} {sample:?}");
    }
    // Areas of 1 in all are not enough without those of two: three pieces apart, and a reflection counts as much.
    let corner = |k: u32| DVec2::from_angle(2.1 * f64::from(k));
    let flip = DMat2::from_diagonal(DVec2::new(0.49, -0.49));
    let apart = [0, 1, 2].map(|k| Affine2::new(flip, corner(k)));
    assert_eq!(decide(&apart, 1e-6, 20_000, &mut scratch).state, State::Disconnected);
    let pair = [DVec2::ZERO, DVec2::X].map(|t| Affine2::new(flip * (0.71 / 0.49), t));
    assert_eq!(decide(&pair, 1e-6, 20_000, &mut scratch).state, State::Connected);
}
