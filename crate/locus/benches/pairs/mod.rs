//! Patches of pairs of the gallery, drawn at random.

use frond_core::{Affine2, Ifs, Morph, MorphOptions, hash, pair};
use frond_locus::{Bounds, Slice};
use frond_scene::{Preset, presets};

use crate::boxes::patch;

const COUNT: usize = 20;
const SEED: u32 = 20;
const SIZE: usize = 256;
const EPSILON: f64 = 1e-4;

/// The morph of two shapes as the page pairs them.
fn morph(a: &Preset, b: &Preset) -> Morph {
    let ifs = |preset: &Preset| {
        Ifs::new(preset.maps.iter().map(|&row| Affine2::from_row(row)).collect()).expect("an attractor")
    };
    let paired = pair(&ifs(a), &ifs(b));
    Morph::new(&paired.from, &paired.to, &MorphOptions::default()).expect("as many maps each")
}

/// Numbers of two shapes that differ, no pair twice.
fn draw(shapes: usize) -> Vec<[usize; 2]> {
    let mut pairs: Vec<[usize; 2]> = Vec::new();
    for k in 0.. {
        let [i, j] = [2 * k, 2 * k + 1].map(|k| hash::counter(SEED, k) as usize % shapes);
        if i != j && !pairs.iter().any(|&pair| pair == [i, j] || pair == [j, i]) {
            pairs.push([i, j]);
        }
        if pairs.len() == COUNT {
            break;
        }
    }
    pairs
}

/// Prints how fast the map of each pair is decided, or of those whose name has a word, and the slowest.
pub fn report(only: Option<&str>) {
    let shapes = presets();
    let mut slowest = (f64::INFINITY, String::new());
    for [i, j] in draw(shapes.len()) {
        let (a, b) = (&shapes[i], &shapes[j]);
        let name = format!("the pair {} to {}", a.id, b.id);
        if only.is_some_and(|word| !name.contains(word)) {
            continue;
        }
        let morph = morph(a, b);
        let (states, seconds) = patch(&Slice::new(&morph, 0.0), Bounds::default(), SIZE, EPSILON);
        let rate = (SIZE * SIZE) as f64 / seconds;
        println!(
            "patches of {name}, {} maps, {SIZE} x {SIZE}, epsilon {EPSILON:.1e}: {rate:.0} samples/s; connected, \
             touching, disconnected, undecided, none: {states:?}",
            morph.len(),
        );
        if rate < slowest.0 {
            slowest = (rate, name);
        }
    }
    if slowest.0.is_finite() {
        println!("slowest of the pairs: {}, {:.0} samples/s", slowest.1, slowest.0);
    }
}
