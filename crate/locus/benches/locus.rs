//! How fast a locus is decided, against the index buffer in the same run: `cargo bench -p frond-locus`; with a word
//! after `--`, only the patches whose name has it: `pair`, say, of twenty pairs of the gallery.
//!
//! The morph is that of Burch & Hart's Fig 7, reconstructed: Heighway's dragon as three maps
//! {w1, w2 w1, w2 w2} to the Sierpinski gasket, over [-1, 2] x [-1, 2], on one core.

mod boxes;
#[path = "../tests/common/mod.rs"]
mod common;
mod pairs;
mod set_m;

use frond_core::Ifs;
use frond_locus::{
    Bounds, IndexBuffer, IndexBufferOptions, LocusGrid, Options, Pass, Scratch, connectedness,
};
use frond_testing::least_time;

use crate::common::dragon_to_gasket;

/// Runs of which the fastest counts.
const RUNS: usize = 5;

fn main() {
    let morph = dragon_to_gasket();
    // Cargo adds options of its own.
    let only = std::env::args().skip(1).find(|arg| !arg.starts_with('-'));
    if only.is_some() {
        boxes::report(&morph, f64::NAN, only.as_deref());
        pairs::report(only.as_deref());
        return;
    }
    let mut scratch = Scratch::default();

    let ifs = Ifs::new(morph.at(0.3, 0.4)).expect("an attractor");
    let options = IndexBufferOptions { size: 600, points: 1_000_000, ..IndexBufferOptions::default() };
    let buffer = least_time(3 * RUNS, || drop(std::hint::black_box(IndexBuffer::run(&ifs, &options))));
    println!("index buffer, 600 x 600, 10^6 points: {:.3} ms a parameter", buffer * 1e3);

    for (size, epsilon) in [(64, 1.0 / 600.0), (256, 1.0 / 600.0), (256, 1e-4), (256, 1e-5)] {
        let grid = LocusGrid::new(Bounds::default(), size, size).expect("a small grid");
        let mut states = [0_usize; 5];
        // Row by row, so that other work on the machine disturbs no more than some of the runs of some rows.
        let row = |y| {
            let pass = Pass { rows: y..y + 1, stride: 1, first: true };
            least_time(RUNS, || {
                grid.run(&morph, epsilon, &pass, &mut scratch, |_, _, sample| {
                    states[sample.state as usize] += 1;
                });
            })
        };
        let seconds: f64 = (0..size).map(row).sum();
        let states = states.map(|n| n / RUNS);
        let each = seconds / (size * size) as f64;
        println!(
            "locus {size} x {size}, epsilon 1/{:.0}: {:.0} decisions/s, {seconds:.3} s, {:.0} times the index \
             buffer; connected, touching, disconnected, undecided, none: {states:?}",
            1.0 / epsilon,
            1.0 / each,
            buffer / each,
        );
    }

    set_m::report(&morph.at(0.3, 0.4));

    for (name, maps) in
        [("dragon", morph.at(0.0, 0.0)), ("gasket", morph.at(1.0, 1.0)), ("between", morph.at(0.6, 0.5))]
    {
        let ifs = Ifs::new(maps).expect("an attractor");
        let seconds = least_time(20, || drop(std::hint::black_box(connectedness(&ifs, &Options::default()))));
        println!("full answer, {name}: {:.1} us", seconds * 1e6);
    }
    boxes::report(&morph, buffer, None);
    pairs::report(None);
}
