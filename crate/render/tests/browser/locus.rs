//! The locus by the graphics card, against its twin.

use frond_core::{Affine2, Morph, MorphOptions};
use frond_locus::{Bounds, LocusGrid, SingleLocus, State, unpack_single};
use frond_render::gpu::{LocusError, LocusGpu, LocusJob};
use glam::DVec2;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::card::print;

async fn open() -> LocusGpu {
    let gpu = LocusGpu::open().await.unwrap();
    print(&gpu.description);
    gpu
}

fn dragon() -> [Affine2; 3] {
    let a = Affine2::from_row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]);
    let b = Affine2::from_row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]);
    [a, b * a, b * b]
}

fn gasket() -> [Affine2; 3] {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
    corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5))
}

fn job(single: &SingleLocus) -> LocusJob<'_> {
    LocusJob {
        maps: single.maps(),
        epsilon: single.epsilon(),
        columns: single.columns(),
        rows: single.rows(),
    }
}

/// Compares all samples with the twin.
async fn compare(gpu: &LocusGpu, single: &SingleLocus, grid: &LocusGrid) {
    let answers = gpu.run(job(single)).await.unwrap();
    let samples = grid.width() * grid.height();
    assert_eq!(answers.len(), samples);
    let (mut differ, mut one, mut states) = (0, 0, [0; 4]);
    for (k, &bits) in answers.iter().enumerate() {
        let (x, y) = (k % grid.width(), k / grid.width());
        let (seen, twin) = (unpack_single(bits), single.decide(x, y));
        states[twin.state as usize] += 1;
        let at = format!("({x}, {y}): {seen:?}, by the twin {twin:?}");
        if (seen.state == State::Undecided) != (twin.state == State::Undecided) {
            one += 1;
        } else if seen.state != twin.state {
            // Both are right: the gap is between zero and epsilon.
            assert!(seen.gap.max(twin.gap) <= 2.0 * single.epsilon(), "{at}");
            differ += 1;
        } else if seen.state == State::Disconnected {
            // A descent that takes another turn still bounds the same gap.
            assert!(seen.gap > 0.4 * twin.gap && twin.gap > 0.4 * seen.gap, "{at}");
        }
    }
    print(&format!("{states:?} by the twin; {differ} decided differently, {one} by one of the two"));
    assert!(differ * 500 <= samples && one * 50 <= samples, "{differ} {one}");
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn the_card_answers_as_its_twin() {
    let gpu = open().await;
    let morph = Morph::new(&dragon(), &gasket(), &MorphOptions::default()).unwrap();
    let grid = LocusGrid::new(Bounds::default(), 61, 43).unwrap();
    for epsilon in [1.0 / 600.0, 1e-5] {
        compare(&gpu, &SingleLocus::of_morph(&morph, 0.1, &grid, epsilon).unwrap(), &grid).await;
    }
    let bounds = Bounds { u0: -0.75, v0: 0.0, u1: 0.75, v1: 0.75 };
    let grid = LocusGrid::new(bounds, 41, 27).unwrap();
    for sides in [2, 4, 8] {
        compare(&gpu, &SingleLocus::of_polygons(sides, &grid, 1e-3).unwrap(), &grid).await;
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn commands_grow_where_they_are_soon_done() {
    let gpu = open().await;
    let morph = Morph::new(&dragon(), &gasket(), &MorphOptions::default()).unwrap();
    let first = gpu.at_once.get();
    let samples = 2 * first as usize;
    gpu.took(samples, 40.0);
    assert_eq!(gpu.at_once.get(), first, "neither soon nor late");
    gpu.took(samples, 20.0);
    assert_eq!(gpu.at_once.get(), 2 * first);
    gpu.took(samples, 2.0);
    assert_eq!(gpu.at_once.get(), 2 * first, "one command is enough");
    gpu.took(samples, 200.0);
    gpu.took(samples, 200.0);
    assert_eq!(gpu.at_once.get(), first, "not smaller than at first");
    // A band of eight rows, and the row that is left: as all at once.
    gpu.at_once.set(1);
    let grid = LocusGrid::new(Bounds::default(), 9, 9).unwrap();
    let single = SingleLocus::of_morph(&morph, 0.0, &grid, 1e-3).unwrap();
    let parts = gpu.run(job(&single)).await.unwrap();
    gpu.at_once.set(1 << 20);
    assert_eq!(gpu.run(job(&single)).await.unwrap(), parts);
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn jobs_that_are_none_are_refused() {
    let gpu = open().await;
    let run = async |maps, columns: &[[f32; 8]], rows: &[[f32; 8]]| {
        gpu.run(LocusJob { maps, epsilon: 1e-3, columns, rows }).await
    };
    let some = [[0.1; 8]; 9];
    assert_eq!(run(0, &some, &some).await, Err(LocusError::Size));
    assert_eq!(run(9, &some, &some).await, Err(LocusError::Size));
    assert_eq!(run(2, &some, &some).await, Err(LocusError::Size));
    assert_eq!(run(3, &[], &some).await, Ok(Vec::new()));
    assert_eq!(run(3, &some, &some).await.map(|answers| answers.len()), Ok(9));
    let many = vec![[0.0; 8]; 5000];
    assert_eq!(run(1, &many, &many).await, Err(LocusError::Size));
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn two_devices_live_and_die_apart() {
    let (first, second) = (open().await, open().await);
    // s z - 1 and s z + 1 over real s: two points at 0, a segment from 1/2 on, certain from the root of 1/2 on.
    let bounds = Bounds { u0: 0.0, v0: 0.0, u1: 0.8, v1: 0.0 };
    let grid = LocusGrid::new(bounds, 9, 1).unwrap();
    let single = SingleLocus::of_polygons(2, &grid, 1.0 / 600.0).unwrap();
    let states = async |gpu: &LocusGpu| {
        let answers = gpu.run(job(&single)).await.unwrap();
        answers.into_iter().map(|bits| unpack_single(bits).state as u8).collect::<Vec<_>>()
    };
    let expected = [2, 2, 2, 2, 2, 1, 1, 1, 0];
    assert_eq!(states(&first).await, expected);
    drop(first);
    assert_eq!(states(&second).await, expected, "the other device lives on");
}
