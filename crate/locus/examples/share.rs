//! How much of what holds is proved, over the loci of the gallery's pairs; and what is left, by cause.
//!
//!     cargo run --release -p frond-locus --example share              a third of the pairs
//!     cargo run --release -p frond-locus --example share -- all       all of them
//!     cargo run --release -p frond-locus --example share -- carpet vicsek

use std::collections::BTreeMap;
use std::time::Instant;

use frond_core::{Affine2, Ifs, Morph, MorphOptions, hash, pair};
use frond_locus::{Bounds, Family, LocusGrid, Scratch, Slice, State, decide};
use frond_scene::{Preset, presets};

/// Samples a side, and of a rectangle that is proved at once, as the page has it.
const SIZE: usize = 85;
const PATCH: usize = 17;
const EPSILON: f64 = 1.0 / 600.0;
/// Shapes of more maps are left out.
const MOST_MAPS: usize = 12;
/// So much closer what is left is looked at, one sample in so many.
const CLOSER: f64 = 1e-3;
const EVERY: usize = 7;

fn ifs(preset: &Preset) -> Option<Ifs> {
    Ifs::new(preset.maps.iter().map(|&row| Affine2::from_row(row)).collect()).ok()
}

/// What the maps of a sample are like, as far as it bears on proofs.
fn likeness(maps: &[Affine2]) -> &'static str {
    let first = maps[0].linear;
    let same = |map: &Affine2| (map.linear - first).abs().to_cols_array().iter().all(|&x| x < 1e-12);
    let along = |map: &Affine2| {
        let [a, b] = [first, map.linear].map(|m| m.to_cols_array());
        let size = |m: [f64; 4]| m.iter().map(|x| x * x).sum::<f64>().sqrt();
        let dot: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        (dot.abs() / (size(a) * size(b)) - 1.0).abs() < 1e-9
    };
    if maps.iter().all(same) {
        "one linear part"
    } else if maps.iter().all(along) {
        "one direction, several sizes"
    } else if maps.iter().any(|map| map.determinant().abs() < 1e-4) {
        "flat maps"
    } else if maps.iter().skip(1).any(same) {
        "some of one linear part"
    } else {
        "others"
    }
}

/// Counts of samples: those that hold, those proved; and what is left by cause.
#[derive(Default)]
struct Share {
    holds: usize,
    proved: usize,
    left: BTreeMap<String, usize>,
}

fn share(morph: &Morph, scratch: &mut Scratch) -> Share {
    let slice = Slice::new(morph, 0.0);
    let Ok(grid) = LocusGrid::new(Bounds::default(), SIZE, SIZE) else { return Share::default() };
    let mut states = vec![0; SIZE * SIZE];
    for (x, y) in (0..SIZE / PATCH).flat_map(|i| (0..SIZE / PATCH).map(move |j| (i * PATCH, j * PATCH))) {
        let (xs, ys) = (x..x + PATCH, y..y + PATCH);
        let mut tile = grid.patch(&slice, EPSILON, xs.clone(), ys.clone(), scratch).state;
        grid.prove(&slice, EPSILON, xs, ys, &mut tile, scratch);
        for (k, state) in tile.into_iter().enumerate() {
            states[(y + k / PATCH) * SIZE + x + k % PATCH] = state;
        }
    }
    let mut found = Share::default();
    let mut maps = Vec::new();
    for (k, &state) in states.iter().enumerate() {
        found.proved += usize::from(state == State::Connected as u8);
        found.holds += usize::from(state <= State::Touching as u8);
        if state != State::Touching as u8 || !k.is_multiple_of(EVERY) {
            continue;
        }
        slice.fill(grid.u(k % SIZE), grid.v(k / SIZE), &mut maps);
        let closer = decide(&maps, EPSILON * CLOSER, LocusGrid::budget(maps.len()), scratch);
        let what = match closer.state {
            State::Disconnected => "apart by less than epsilon",
            State::Undecided => "not known whether apart by less than epsilon",
            _ => "touches a thousand times closer",
        };
        *found.left.entry(format!("{what}: {}", likeness(&maps))).or_default() += EVERY;
    }
    found
}

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let few: Vec<Preset> = presets().into_iter().filter(|preset| preset.maps.len() <= MOST_MAPS).collect();
    let mut scratch = Scratch::default();
    let mut all = Share::default();
    let start = Instant::now();
    let mut pairs = 0;
    for (k, (i, j)) in (0..few.len()).flat_map(|j| (0..j).map(move |i| (i, j))).enumerate() {
        let ids = [few[i].id, few[j].id];
        let wanted = match &asked[..] {
            [] => hash::counter(1, k as u32).is_multiple_of(3),
            [word] if word == "all" => true,
            names => ids.iter().all(|id| names.iter().any(|name| name == id)),
        };
        let (true, Some(a), Some(b)) = (wanted, ifs(&few[i]), ifs(&few[j])) else { continue };
        let paired = pair(&a, &b);
        let Ok(morph) = Morph::new(&paired.from, &paired.to, &MorphOptions::default()) else { continue };
        let before = Instant::now();
        let found = share(&morph, &mut scratch);
        pairs += 1;
        let seconds = before.elapsed().as_secs_f64();
        let percent = 100.0 * found.proved as f64 / found.holds.max(1) as f64;
        let Share { holds, left, .. } = &found;
        println!("{} - {}: {percent:.1}% of {holds}, {seconds:.2} s; left {left:?}", ids[0], ids[1]);
        all.holds += found.holds;
        all.proved += found.proved;
        for (cause, count) in found.left {
            *all.left.entry(cause).or_default() += count;
        }
    }
    println!(
        "{pairs} pairs, {:.1} s: {:.2}% of {} samples that hold are proved; of these are left, by cause:",
        start.elapsed().as_secs_f64(),
        100.0 * all.proved as f64 / all.holds.max(1) as f64,
        all.holds
    );
    let mut causes: Vec<_> = all.left.into_iter().collect();
    causes.sort_by_key(|cause| std::cmp::Reverse(cause.1));
    for (cause, count) in causes {
        println!("  {:.2}%  {cause}", 100.0 * count as f64 / all.holds.max(1) as f64);
    }
}
