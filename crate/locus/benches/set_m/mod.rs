//! How fast the set M is decided, in steps of the chaos game.

use std::hint::black_box;

use frond_core::{Affine2, hash};
use frond_locus::{Scratch, decide_polygon};
use frond_testing::least_time;
use glam::DVec2;

use crate::RUNS;

const SIZE: usize = 400;
const STEPS: u32 = 2_000_000;

/// Seconds that one step of one orbit takes: each begins where the last one ended.
fn chaos_step(maps: &[Affine2]) -> f64 {
    let game = || {
        let mut x = DVec2::ZERO;
        for i in 0..STEPS {
            x = maps[hash::counter(1, i) as usize % maps.len()].apply(x);
        }
        black_box(x);
    };
    least_time(RUNS, game) / f64::from(STEPS)
}

/// 400 x 400 parameters over [-0.75, 0.75] x [0, 0.75].
pub fn report(maps: &[Affine2]) {
    let step = chaos_step(maps);
    println!("chaos game, one orbit: {:.0} million steps/s", 1e-6 / step);
    let mut scratch = Scratch::default();
    for epsilon in [1e-3, 1e-4] {
        let mut states = [0_usize; 5];
        let row = |y: usize| {
            let im = 0.75 * y as f64 / (SIZE - 1) as f64;
            least_time(RUNS, || {
                for x in 0..SIZE {
                    let re = 1.5 * x as f64 / (SIZE - 1) as f64 - 0.75;
                    let sample = decide_polygon(2, [re, im], epsilon, 20_000, &mut scratch);
                    states[black_box(sample).state as usize] += 1;
                }
            })
        };
        let seconds: f64 = (0..SIZE).map(row).sum();
        let each = seconds / (SIZE * SIZE) as f64;
        println!(
            "set M {SIZE} x {SIZE}, epsilon {epsilon}: {:.2} million decisions/s, {:.0} steps of the chaos game \
             each; connected, touching, disconnected, undecided, none: {:?}",
            1e-6 / each,
            each / step,
            states.map(|n| n / RUNS),
        );
    }
}
