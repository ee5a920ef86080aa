//! Speed.
use frond_core::{Affine2, Morph, MorphOptions};
use frond_locus::{Scratch, decide};
use std::time::Instant;

fn main() {
    let row = Affine2::from_row;
    let (w1, w2) = (row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]), row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]));
    let dragon = [w1, w2 * w1, w2 * w2];
    let gasket =
        [[0.0, 0.0], [0.5, 0.0], [0.25, 0.75_f64.sqrt() / 2.0]].map(|[e, f]| row([0.5, 0.0, 0.0, 0.5, e, f]));
    let morph = Morph::new(&dragon, &gasket, &MorphOptions::default()).unwrap();
    let mut scratch = Scratch::default();
    let mut maps = Vec::new();
    for (size, eps) in [(64, 1.0 / 600.0), (256, 1.0 / 600.0), (256, 1e-4), (256, 1e-5)] {
        let start = Instant::now();
        let mut counts = [0; 5];
        let mut worst = 0.0_f64;
        for y in 0..size {
            for x in 0..size {
                let at = |k: i32| -1.0 + 3.0 * f64::from(k) / f64::from(size - 1);
                morph.fill(at(x), at(y), &mut maps);
                let t = Instant::now();
                let s = decide(&maps, eps, 20_000, &mut scratch);
                worst = worst.max(t.elapsed().as_secs_f64());
                counts[s.state as usize] += 1;
            }
        }
        let t = start.elapsed().as_secs_f64();
        println!(
            "{size} {eps:.2e}: {:.0}/s {t:.3}s {counts:?} worst {:.3} ms",
            f64::from(size * size) / t,
            worst * 1e3
        );
    }
}
