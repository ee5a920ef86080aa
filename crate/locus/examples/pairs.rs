//! How many pairs of the gallery have a way that holds: as they are, and with all ways that are worth trying.
//!
//!     cargo run --release -p frond-locus --example pairs              natural pairs
//!     cargo run --release -p frond-locus --example pairs -- all       all pairs, and the gallery's table of them
//!     cargo run --release -p frond-locus --example pairs -- fern koch

use std::time::Instant;

use frond_core::{Affine2, Ifs, Mode, Morph, MorphOptions, Route, RouteKind, pair, ways};
use frond_locus::{PathOptions, RateOptions, check_path, find_path, rate};
use frond_scene::{Preset, preset, presets};
use glam::DVec3;

/// Shapes that people bring together: curves, plants, and the gasket with either.
const NATURAL: [[&str; 2]; 14] = [
    ["fern", "koch"],
    ["fern", "tree"],
    ["fern", "dragon"],
    ["gasket", "fern"],
    ["spiral", "fern"],
    ["koch", "dragon"],
    ["gasket", "dragon"],
    ["gasket", "koch"],
    ["gasket", "terdragon"],
    ["dragon", "levy"],
    ["levy", "koch"],
    ["fern", "maple"],
    ["maple", "tree"],
    ["carpet", "vicsek"],
];

/// What is done for a pair at most: ways tried, and seconds.
const MOST_WAYS: usize = 240;
const MOST_SECONDS: f64 = 8.0;
/// After so many coarse looks comes a close one; and so many come last.
const BETWEEN: usize = 12;
const MOST_CLOSE: usize = 12;
const STRAIGHT: [DVec3; 2] = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];

/// What was found of a pair.
struct Found {
    /// The widest gap of the best path as they are, and of the best way.
    gaps: [f64; 2],
    how: String,
}

fn ifs(preset: &Preset) -> Option<Ifs> {
    Ifs::new(preset.maps.iter().map(|&row| Affine2::from_row(row)).collect()).ok()
}

fn morph(route: &Route) -> Option<Morph> {
    let (correspondence, turns) = (route.correspondence.clone(), route.turns.clone());
    let mode = route.mode.unwrap_or(Mode::Polar);
    Morph::new(&route.from, &route.to, &MorphOptions { mode, correspondence, turns }).ok()
}

/// The widest gap on the path of a way, as far as a coarse map tells, and whether that is the last word.
fn coarsely(route: &Route) -> Option<(f64, bool)> {
    let morph = morph(route)?;
    if route.kind == RouteKind::Joints {
        return Some((check_path(&morph, &STRAIGHT, 1.0 / 600.0, 1001).gap, true));
    }
    let coarse = rate(&morph, &RateOptions { size: 25, ..RateOptions::default() }).ok()?;
    Some((coarse.plan.gap, false))
}

fn closely(route: &Route) -> Option<f64> {
    Some(find_path(&morph(route)?, &PathOptions::default()).ok()?.gap)
}

fn look(a: &Ifs, b: &Ifs) -> Option<Found> {
    let paired = pair(a, b);
    let plain = Morph::new(&paired.from, &paired.to, &MorphOptions::default()).ok()?;
    let before = find_path(&plain, &PathOptions::default()).ok()?.gap;
    if before == 0.0 {
        return Some(Found { gaps: [0.0; 2], how: "as they are".to_owned() });
    }
    if STRAIGHT.iter().any(|&end| !check_path(&plain, &[end], 1.0 / 600.0, 2).holds) {
        return Some(Found { gaps: [before; 2], how: "a shape is in pieces itself".to_owned() });
    }
    let start = Instant::now();
    let (mut best, mut how) = (before, "nothing better".to_owned());
    let all = ways(a, b, MOST_WAYS);
    let count = all.len();
    let mut tried = 0;
    let mut open: Vec<(f64, usize)> = Vec::new();
    let mut take = |gap: f64, k: usize| {
        if gap < best {
            best = gap;
            how = format!("way {}: {:?}, {} maps", k + 1, all[k].kind, all[k].from.len());
        }
        best == 0.0 || start.elapsed().as_secs_f64() > MOST_SECONDS
    };
    for (k, route) in all.iter().enumerate() {
        tried += 1;
        let Some((gap, sure)) = coarsely(route) else { continue };
        let gap = if gap == 0.0 && !sure { closely(route).unwrap_or(f64::INFINITY) } else { gap };
        if take(gap, k) {
            open.clear();
            break;
        }
        if !sure {
            open.push((gap, k));
        }
        // What seems near to holding need not wait until all are seen: finer maps find ways through what is narrow.
        if tried % BETWEEN == 0 || tried == count {
            open.sort_by(|p, q| q.0.total_cmp(&p.0));
            let last = if tried == count { MOST_CLOSE } else { 1 };
            let near: Vec<usize> = (0..last).filter_map(|_| open.pop()).map(|(_, k)| k).collect();
            if near.into_iter().any(|k| take(closely(&all[k]).unwrap_or(f64::INFINITY), k)) {
                break;
            }
        }
    }
    let how = format!("{how}; {tried} of {count} ways in {:.1} s", start.elapsed().as_secs_f64());
    Some(Found { gaps: [before, best], how })
}

fn main() {
    let told: Vec<String> = std::env::args().skip(1).collect();
    let shapes = presets();
    let all = told.first().is_some_and(|word| word == "all");
    let named = |a: &str, b: &str| preset(a).zip(preset(b)).map(|(a, b)| [a, b]);
    let pairs: Vec<[Preset; 2]> = match &told[..] {
        _ if all => (0..shapes.len())
            .flat_map(|j| (0..j).map(move |i| [i, j]))
            .map(|pair| pair.map(|i| shapes[i].clone()))
            .collect(),
        [a, b] => named(a, b).into_iter().collect(),
        _ => NATURAL.iter().filter_map(|[a, b]| named(a, b)).collect(),
    };
    let mut marks = vec![vec!['='; shapes.len()]; shapes.len()];
    let (mut before, mut after) = (0, 0);
    for [a, b] in &pairs {
        let Some(Found { gaps: [first, last], how }) = ifs(a).zip(ifs(b)).and_then(|(a, b)| look(&a, &b))
        else {
            continue;
        };
        before += usize::from(first == 0.0);
        after += usize::from(last == 0.0);
        println!("{:>18} {:<18} {first:.4} {last:.4}  {how}", a.id, b.id);
        let place = |id: &str| shapes.iter().position(|shape| shape.id == id).unwrap_or(0);
        let mark = if first == 0.0 {
            '='
        } else if last == 0.0 {
            '+'
        } else {
            '.'
        };
        let (i, j) = (place(a.id), place(b.id));
        (marks[i][j], marks[j][i]) = (mark, mark);
    }
    println!("{} pairs: {before} hold as they are, {after} some way", pairs.len());
    if all {
        for (shape, row) in shapes.iter().zip(marks) {
            println!("{:<18} {}", shape.id, row.into_iter().collect::<String>());
        }
    }
}
