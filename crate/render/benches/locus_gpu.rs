//! How long a graphics card takes for a locus, against one core of the processor in the same run:
//! `cargo xtask bench locus_gpu`.
//!
//! The morph is that of Burch & Hart's Fig 7, as in the bench of crate/locus.

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
#[path = "../../locus/tests/common/mod.rs"]
mod common;

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
mod measure {
    use std::hint::black_box;
    use std::time::Instant;

    use crate::common::dragon_to_gasket;
    use frond_core::Morph;
    use frond_locus::{Bounds, LocusGrid, Sample, Scratch, SingleLocus, State, decide, unpack_single};
    use frond_render::gpu::{LocusGpu, LocusJob};

    /// Milliseconds of a run: to prepare the job, to hand it over, for the card to do it, and to bring it back.
    #[derive(Clone, Copy)]
    struct Times([f64; 4]);

    impl Times {
        fn whole(self) -> f64 {
            self.0.iter().sum()
        }
    }

    pub fn main() {
        let gpu = match pollster::block_on(LocusGpu::open()) {
            Ok(gpu) => gpu,
            Err(problem) => return println!("not measured, {}: {problem}", problem.code()),
        };
        let software = if gpu.software { " (no graphics card: this says nothing of speed)" } else { "" };
        println!("adapter: {}{software}", gpu.description);
        let morph = dragon_to_gasket();
        let first = gpu.at_once.get();
        let (sizes, runs) = if gpu.software { (vec![128], 1) } else { (vec![128, 256, 1024], 10) };
        for size in sizes {
            for epsilon in [1.0 / 600.0, 1e-4, 1e-5] {
                let grid = LocusGrid::new(Bounds::default(), size, size).expect("a grid");
                let mut answers = Vec::new();
                // As the page begins, then in fewer and larger commands, as it goes on where they are soon done.
                for at_once in
                    [first, 1 << 17, 1 << 20].into_iter().filter(|n| *n <= first.max((size * size) as u32))
                {
                    gpu.at_once.set(at_once);
                    let best = (0..runs)
                        .map(|_| run(&gpu, &morph, &grid, epsilon, &mut answers))
                        .min_by(|a, b| a.whole().total_cmp(&b.whole()))
                        .expect("a run");
                    let [prepare, begin, card, back] = best.0;
                    println!(
                        "{size} x {size}, epsilon {epsilon:.0e}, {at_once} at once: {:.2} ms ({prepare:.2} to prepare, \
                         {begin:.2} to hand over, {card:.2} on the card, {back:.2} to bring back)",
                        best.whole()
                    );
                }
                println!("    as the page goes on: {}", adapted(&gpu, first, &morph, &grid, epsilon, runs));
                let samples: Vec<Sample> = answers.iter().copied().map(unpack_single).collect();
                let left = samples.iter().filter(|sample| sample.state == State::Undecided).count();
                let settle = milliseconds(|| settle(&morph, &grid, epsilon, &samples));
                // A part of the rows stands for all.
                let part = 16.min(size);
                let cpu = milliseconds(|| rows(&morph, &grid, epsilon, part)) * size as f64 / part as f64;
                println!("    it leaves {left}: {settle:.1} ms on one core, which takes {cpu:.0} ms for all");
            }
        }
    }

    fn milliseconds(run: impl FnOnce()) -> f64 {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64() * 1e3
    }

    fn run(gpu: &LocusGpu, morph: &Morph, grid: &LocusGrid, epsilon: f64, answers: &mut Vec<u32>) -> Times {
        let (mut single, mut begun) = (None, None);
        let prepare = milliseconds(|| {
            single = Some(SingleLocus::of_morph(morph, 0.0, grid, epsilon).expect("three maps"));
        });
        let single = single.expect("a job");
        let job = LocusJob {
            maps: single.maps(),
            epsilon: single.epsilon(),
            columns: single.columns(),
            rows: single.rows(),
        };
        let begin = milliseconds(|| begun = Some(gpu.begin(job).expect("a job that fits")));
        let card = milliseconds(|| gpu.finish());
        let begun = begun.expect("it was begun");
        let back = milliseconds(|| *answers = pollster::block_on(begun.answers()).expect("an answer"));
        Times([prepare, begin, card, back])
    }

    /// Jobs one after the other, in commands that grow as the card turns out to be quick: milliseconds, and how many
    /// samples a command had.
    fn adapted(
        gpu: &LocusGpu,
        first: u32,
        morph: &Morph,
        grid: &LocusGrid,
        epsilon: f64,
        runs: usize,
    ) -> String {
        gpu.at_once.set(first);
        let mut told = Vec::new();
        for _ in 0..runs {
            let at_once = gpu.at_once.get();
            let times = run(gpu, morph, grid, epsilon, &mut Vec::new());
            gpu.took(grid.width() * grid.height(), times.whole());
            told.push(format!("{:.1} ms ({at_once})", times.whole()));
        }
        told.join(", ")
    }

    fn settle(morph: &Morph, grid: &LocusGrid, epsilon: f64, samples: &[Sample]) {
        let (mut maps, mut scratch) = (Vec::new(), Scratch::default());
        for (k, _) in samples.iter().enumerate().filter(|(_, sample)| sample.state == State::Undecided) {
            morph.fill(grid.u(k % grid.width()), grid.v(k / grid.width()), &mut maps);
            black_box(decide(&maps, epsilon, LocusGrid::BUDGET, &mut scratch));
        }
    }

    /// Rows spread over the grid, by the processor.
    fn rows(morph: &Morph, grid: &LocusGrid, epsilon: f64, part: usize) {
        let (mut maps, mut scratch) = (Vec::new(), Scratch::default());
        for k in 0..part {
            let v = grid.v((2 * k + 1) * grid.height() / (2 * part));
            for x in 0..grid.width() {
                morph.fill(grid.u(x), v, &mut maps);
                black_box(decide(&maps, epsilon, LocusGrid::BUDGET, &mut scratch));
            }
        }
    }
}

fn main() {
    #[cfg(all(frond_card, not(target_arch = "wasm32")))]
    measure::main();
}
