//! How long a graphics card takes for a locus, against one core of the processor in the same run:
//! `cargo xtask bench locus_gpu`.
//!
//! The morph is that of Burch & Hart's Fig 7, as in the bench of crate/locus.

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
#[path = "../src/gpu/mod.rs"]
mod gpu;

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
#[path = "../../locus/tests/common/mod.rs"]
mod common;

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
#[path = "../tests/wait/mod.rs"]
mod wait;

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
mod measure {
    use crate::common::dragon_to_gasket;
    use crate::gpu::{LocusError, LocusGpu, LocusJob};
    use crate::wait::wait;
    use frond_core::Morph;
    use frond_locus::{Bounds, LocusGrid, Sample, Scratch, SingleLocus, State, decide, unpack_single};
    use frond_testing::least_time;

    pub fn main() {
        let gpu = match wait(LocusGpu::open()) {
            Ok(gpu) => gpu,
            Err(problem) => return println!("not measured, {}: {problem}", problem.code()),
        };
        let software = if gpu.software { " (no graphics card: this says nothing of speed)" } else { "" };
        println!("adapter: {}{software}", gpu.description);
        let morph = dragon_to_gasket();
        let sizes = if gpu.software { vec![128, 256] } else { vec![128, 256, 1024] };
        for size in sizes {
            for epsilon in [1.0 / 600.0, 1e-4, 1e-5] {
                let grid = LocusGrid::new(Bounds::default(), size, size).expect("a grid");
                let runs = if gpu.software { 1 } else { 10 };
                let mut answers = Vec::new();
                let card =
                    least_time(runs, || answers = run(&gpu, &morph, &grid, epsilon).expect("an answer"));
                let samples: Vec<Sample> = answers.iter().copied().map(unpack_single).collect();
                let left = samples.iter().filter(|sample| sample.state == State::Undecided).count();
                let settle = least_time(1, || settle(&morph, &grid, epsilon, &samples));
                // A part of the rows stands for all.
                let part = 16.min(size);
                let cpu = least_time(3, || rows(&morph, &grid, epsilon, part)) * size as f64 / part as f64;
                println!(
                    "{size} x {size}, epsilon {epsilon:.0e}: card {card:.1} ms and {settle:.1} ms for the {left} it leaves, \
                     one core {cpu:.0} ms: {:.1} times as fast",
                    cpu / (card + settle)
                );
            }
        }
    }

    fn run(gpu: &LocusGpu, morph: &Morph, grid: &LocusGrid, epsilon: f64) -> Result<Vec<u32>, LocusError> {
        let single = SingleLocus::of_morph(morph, 0.0, grid, epsilon).expect("three maps");
        wait(gpu.run(LocusJob {
            maps: single.maps(),
            epsilon: single.epsilon(),
            columns: single.columns(),
            rows: single.rows(),
        }))
    }

    fn settle(morph: &Morph, grid: &LocusGrid, epsilon: f64, samples: &[Sample]) {
        let (mut maps, mut scratch) = (Vec::new(), Scratch::default());
        for (k, _) in samples.iter().enumerate().filter(|(_, sample)| sample.state == State::Undecided) {
            morph.fill(grid.u(k % grid.width()), grid.v(k / grid.width()), &mut maps);
            std::hint::black_box(decide(&maps, epsilon, LocusGrid::BUDGET, &mut scratch));
        }
    }

    /// Rows spread over the grid, by the processor.
    fn rows(morph: &Morph, grid: &LocusGrid, epsilon: f64, part: usize) {
        let (mut maps, mut scratch) = (Vec::new(), Scratch::default());
        for k in 0..part {
            let v = grid.v((2 * k + 1) * grid.height() / (2 * part));
            for x in 0..grid.width() {
                morph.fill(grid.u(x), v, &mut maps);
                std::hint::black_box(decide(&maps, epsilon, LocusGrid::BUDGET, &mut scratch));
            }
        }
    }
}

fn main() {
    #[cfg(all(frond_card, not(target_arch = "wasm32")))]
    measure::main();
}
