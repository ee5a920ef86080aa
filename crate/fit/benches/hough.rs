//! What counting costs a vote, against a plain loop that solves each 3 x 3 system: `cargo bench -p frond-fit --bench
//! hough`.

#[path = "../tests/plain/mod.rs"]
mod plain;

use frond_fit::{Features, FirstPass, FractalFunction, HoughOptions, SecondPass};
use frond_testing::processor_seconds;
use glam::DVec2;

fn main() {
    let maps = [[0.5, 0.746, 0.5, -0.5, 0.246], [0.5, -0.199, -0.6, 0.5, 0.189]];
    let function = FractalFunction::pfif(&maps.map(|map| (map, [-1.0, 1.0]))).expect("Table 1");
    let [low, high] = Features::sample(&function, 129).expect("features").heights();
    let framed = |p: &DVec2| DVec2::new(p.x, (p.y - f64::midpoint(low, high)) / (0.5 * (high - low)));
    let [coarse, fine] = [65, 129].map(|count| {
        let features = Features::sample(&function, count).expect("features");
        features.points().iter().map(framed).collect::<Vec<_>>()
    });
    // All candidates, clutter with them: that is what the paper counts.
    let options = HoughOptions { reflected: false, least_a: 0.0, ..HoughOptions::default() };
    let start = processor_seconds();
    // One width in the middle; all of them take minutes.
    let votes = plain::count(&coarse, &fine, options, 20..21).votes;
    let plain = (processor_seconds() - start) / votes as f64;
    println!("plain loop   {:.2} ns a vote, {votes} votes", 1e9 * plain);

    let [coarse, fine] = [coarse, fine].map(|points| Features::new(&points).expect("features"));
    for reflected in [false, true] {
        let options = HoughOptions { reflected, ..options };
        let start = processor_seconds();
        let mut first = FirstPass::new(&coarse, &fine, options, (0, 1));
        let mut votes = 0;
        while !first.is_done() {
            votes = first.step().votes;
        }
        let time = processor_seconds() - start;
        let fast = time / votes as f64;
        println!(
            "first pass   {:.2} ns a vote, {votes} votes, {time:.2} s on one core: {:.1} times as fast",
            1e9 * fast,
            plain / fast
        );
        let start = processor_seconds();
        let mut second = SecondPass::new(&coarse, &fine, options, &first.promising(), (0, 1));
        while !second.is_done() {
            second.step();
        }
        let clusters = second.clusters();
        println!("second pass  {:.2} s; best: {:?}", processor_seconds() - start, clusters.first());
    }
}
