//! The locus by the graphics card of the machine, if it has one, against its twin: `cargo xtask test card`.
#![cfg(all(frond_card, not(target_arch = "wasm32")))]

use frond_locus::{Bounds, LocusGrid, SingleLocus, State, unpack_single};

use crate::common::dragon_to_gasket;
use crate::gpu::{LocusError, LocusGpu, LocusJob};
use crate::wait::wait;

#[path = "../src/gpu/mod.rs"]
mod gpu;

#[path = "../../locus/tests/common/mod.rs"]
mod common;
mod wait;

fn open() -> Option<LocusGpu> {
    match wait(LocusGpu::open()) {
        Ok(gpu) => {
            println!("{}, software: {}", gpu.description, gpu.software);
            Some(gpu)
        }
        Err(problem) => {
            assert_eq!(problem.code(), "no-gpu");
            println!("not tested: {problem}");
            None
        }
    }
}

/// Samples that the card and the twin see differently: of those that both decide, and of which one does.
fn differences(gpu: &LocusGpu, single: &SingleLocus, grid: &LocusGrid) -> (usize, usize) {
    let job = LocusJob {
        maps: single.maps(),
        epsilon: single.epsilon(),
        columns: single.columns(),
        rows: single.rows(),
    };
    let answers = wait(gpu.run(job)).unwrap();
    assert_eq!(answers.len(), grid.width() * grid.height());
    let (mut differ, mut one) = (0, 0);
    let mut states = [0; 4];
    for (k, &bits) in answers.iter().enumerate() {
        let (x, y) = (k % grid.width(), k / grid.width());
        let (seen, twin) = (unpack_single(bits), single.decide(x, y));
        states[twin.state as usize] += 1;
        let at = format!("({x}, {y}): {seen:?}, by the twin {twin:?}");
        let undecided = [seen, twin].map(|sample| sample.state == State::Undecided);
        if undecided[0] != undecided[1] {
            one += 1;
        } else if seen.state != twin.state {
            // Both proved what they say: the gap is between 0 and epsilon.
            assert!(seen.gap.max(twin.gap) <= single.epsilon(), "{at}");
            differ += 1;
        } else if seen.state == State::Disconnected {
            // A descent that takes another turn still bounds the same gap.
            assert!(seen.gap > 0.4 * twin.gap && twin.gap > 0.4 * seen.gap, "{at}");
        }
    }
    println!("{states:?} by the twin; {differ} decided differently, {one} by one of the two");
    (differ, one)
}

#[test]
fn the_card_answers_as_its_twin() {
    let Some(gpu) = open() else { return };
    let morph = dragon_to_gasket();
    let grid = LocusGrid::new(Bounds::default(), 91, 67).unwrap();
    let samples = grid.width() * grid.height();
    for epsilon in [1.0 / 600.0, 1e-4, 1e-5] {
        let single = SingleLocus::of_morph(&morph, 0.0, &grid, epsilon).unwrap();
        let (differ, one) = differences(&gpu, &single, &grid);
        assert!(differ * 500 <= samples && one * 100 <= samples, "{differ} {one}");
    }
    let bounds = Bounds { u0: -0.75, v0: 0.0, u1: 0.75, v1: 0.75 };
    let grid = LocusGrid::new(bounds, 61, 40).unwrap();
    let samples = grid.width() * grid.height();
    for sides in [1, 2, 3, 5, 8] {
        let single = SingleLocus::of_polygons(sides, &grid, 1e-4).unwrap();
        let (differ, one) = differences(&gpu, &single, &grid);
        assert!(differ * 500 <= samples && one * 50 <= samples, "{differ} {one}");
    }
}

#[test]
fn jobs_that_are_none_are_refused() {
    let Some(gpu) = open() else { return };
    let run = |maps, columns: &[[f32; 8]], rows: &[[f32; 8]]| {
        wait(gpu.run(LocusJob { maps, epsilon: 1e-3, columns, rows }))
    };
    let some = [[0.1; 8]; 9];
    assert_eq!(run(0, &some, &some), Err(LocusError::Size));
    assert_eq!(run(9, &some, &some), Err(LocusError::Size));
    assert_eq!(run(2, &some, &some), Err(LocusError::Size));
    assert_eq!(run(3, &[], &some), Ok(Vec::new()));
    assert_eq!(run(3, &some, &some).map(|answers| answers.len()), Ok(9));
    let many = vec![[0.0; 8]; 5000];
    assert_eq!(run(1, &many, &many), Err(LocusError::Size));
}
