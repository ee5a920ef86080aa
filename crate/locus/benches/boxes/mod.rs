//! Patches: whole boxes of parameters decided at once.

use frond_core::Morph;
use frond_locus::{
    Bounds, CertifyOptions, Family, LocusGrid, Polygons, Scratch, Slice, certify_path, find_path,
};
use frond_testing::least_time;

use crate::RUNS;

/// The states of a patch by their numbers, and the least time of some runs in seconds.
pub fn patch(family: &dyn Family, bounds: Bounds, size: usize, epsilon: f64) -> ([usize; 5], f64) {
    let grid = LocusGrid::new(bounds, size, size).expect("a small grid");
    let mut scratch = Scratch::default();
    let mut states = [0; 5];
    // Tiles as the page asks for them, each timed on its own.
    let edges = |k: usize| k * size / 4..(k + 1) * size / 4;
    let mut seconds = 0.0;
    for (x, y) in (0..16).map(|k| (edges(k % 4), edges(k / 4))) {
        let mut tile = Vec::new();
        seconds += least_time(RUNS, || {
            tile = grid.patch(family, epsilon, x.clone(), y.clone(), &mut scratch).state;
        });
        for state in tile {
            states[usize::from(state)] += 1;
        }
    }
    (states, seconds)
}

/// Prints how fast patches are, all or those whose name has a word; `buffer` is the time of an index buffer in seconds.
pub fn report(morph: &Morph, buffer: f64, only: Option<&str>) {
    let slice = Slice::new(morph, 0.0);
    let print = |name: &str, family: &dyn Family, bounds: Bounds, size: usize, epsilon: f64| {
        if only.is_some_and(|word| !name.contains(word)) {
            return;
        }
        let (states, seconds) = patch(family, bounds, size, epsilon);
        let each = seconds / (size * size) as f64;
        println!(
            "patches of {name}, {size} x {size}, epsilon {epsilon:.1e}: {:.0} samples/s, {:.1} ms, {:.0} times the \
             index buffer; connected, touching, disconnected, undecided, none: {states:?}",
            1.0 / each,
            seconds * 1e3,
            buffer / each,
        );
    };
    for epsilon in [1.0 / 600.0, 1e-4, 1e-5] {
        print("the locus", &slice, Bounds::default(), 256, epsilon);
    }
    for (u0, v0, side) in [(0.2, 0.45, 0.1), (0.9, 0.9, 0.1), (0.0, 0.3, 0.02), (-0.3, 0.7, 0.02)] {
        let near = Bounds { u0, v0, u1: u0 + side, v1: v0 + side };
        print(&format!("({u0}, {v0}) + {side}"), &slice, near, 256, 1e-5);
    }
    let all = Bounds { u0: -0.75, v0: 0.0, u1: 0.75, v1: 0.75 };
    for epsilon in [1.0 / 600.0, 1e-4, 1e-5] {
        print("the set M", &Polygons::new(2), all, 400, epsilon);
    }
    let near = Bounds { u0: 0.4785, v0: 0.456, u1: 0.4805, v1: 0.458 };
    print("the set M, magnified", &Polygons::new(2), near, 256, 1e-6);
    if only.is_some() {
        return;
    }
    if let Ok(plan) = find_path(morph, &frond_locus::PathOptions::default()) {
        for within in [1e-2, 1.0 / 600.0] {
            let options = CertifyOptions { within, ..CertifyOptions::default() };
            let mut proved = None;
            let seconds = least_time(1, || proved = Some(certify_path(morph, &plan.points, &options)));
            println!("a path proved within {within:.1e}: {:.0} ms, {proved:?}", seconds * 1e3);
        }
    }
}
