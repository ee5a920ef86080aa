//! Whole boxes of parameters, against each sample on its own and against truth known by theorem.

mod common;

use frond_core::{Affine2, Ifs, Mode, Morph, MorphOptions, hash};
use frond_locus::{
    Bounds, Crossing, Family, LocusGrid, Options, Polygons, Scratch, Slice, State, Verdict, connectedness,
    crossings, decide, decide_bounds,
};
use glam::{DMat2, DVec2};

use crate::common::dragon_to_gasket;

fn unit(seed: u32, k: u32) -> f64 {
    f64::from(hash::unit(hash::counter(seed, k)))
}

/// Two thin bars, each of two halves that reach a little beyond the middle: one along x, the other turned.
fn bars(turn: f64, up: f64) -> Vec<Affine2> {
    let half = |angle: f64, side: f64, up: f64| {
        let flat = DMat2::from_diagonal(DVec2::new(0.6, 0.05));
        let turned = DMat2::from_angle(angle);
        Affine2::new(turned * flat, turned * DVec2::new(0.4 * side, 0.0) + DVec2::new(0.0, up))
    };
    vec![half(0.0, -1.0, 0.0), half(0.0, 1.0, 0.0), half(turn, -1.0, up), half(turn, 1.0, up)]
}

#[test]
fn two_bars_laid_across_each_other_cross() {
    let found = crossings(&bars(1.5, 0.03), f64::INFINITY, 0.0).expect("a plus");
    assert_eq!(found.len(), 3);
    for Crossing { i, j, u, v, corners } in &found {
        assert_eq!((usize::from(u[0]), usize::from(v[0])), (*i, *j));
        // The corners take turns about their middle.
        let middle = corners.iter().sum::<DVec2>() / 4.0;
        let mut around: Vec<_> = (0..4).map(|k| ((corners[k] - middle).to_angle(), k / 2)).collect();
        around.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert!((0..4).all(|k| around[k].1 != around[(k + 1) % 4].1), "{around:?}");
    }
    // Laid beside each other they do not, however near; nor if they may be off by as much as they are long.
    for up in [0.5, 0.12] {
        assert_eq!(crossings(&bars(0.0, up), f64::INFINITY, 0.0), None);
    }
    let plus = bars(1.5, 0.03);
    assert_eq!(crossings(&plus, f64::INFINITY, 1.0), None);
    assert_eq!(crossings(&plus, f64::INFINITY, f64::NAN), None);
    assert!(crossings(&plus, f64::INFINITY, 1e-4).is_some());
    // A shape bent by an affine map crosses as well.
    let by = Affine2::from_row([3.0, 1.5, 0.2, 0.8, 40.0, -7.0]);
    let bent: Vec<_> = plus.iter().map(|map| map.conjugate(by).unwrap()).collect();
    assert!(crossings(&bent, f64::INFINITY, 0.0).is_some());
}

#[test]
fn bad_systems_have_no_crossings() {
    let shrink = |s: f64| Affine2::similitude(s, 0.3, DVec2::X);
    for maps in
        [vec![], vec![shrink(0.5)], vec![shrink(0.5); 2], vec![shrink(1.5); 2], vec![shrink(f64::NAN); 2]]
    {
        assert_eq!(crossings(&maps, f64::INFINITY, 0.0), None);
    }
    assert_eq!(crossings(&vec![shrink(0.1); 100], f64::INFINITY, 0.0), None);
}

/// Maps of a random system, mostly near the edge of falling apart.
fn any_maps(seed: u32) -> Vec<Affine2> {
    let count = 2 + (unit(seed, 0) * 4.0) as u32;
    let map = |i: u32| {
        let at = |k: u32| unit(seed, 10 * i + k + 1);
        let size = (1.2 / f64::from(count).sqrt() * (0.75 + 0.5 * at(0))).min(0.94);
        let flat = DVec2::new(size, size * (0.4 + 0.6 * at(1)) * if at(2) < 0.2 { -1.0 } else { 1.0 });
        let linear = DMat2::from_angle(6.3 * at(3))
            * DMat2::from_diagonal(flat)
            * DMat2::from_angle(if at(4) < 0.5 { 0.0 } else { 6.3 * at(4) });
        Affine2::new(linear, DVec2::new(at(5), at(6)) * 2.0 - 1.0)
    };
    (0..count).map(map).collect()
}

#[test]
fn what_is_disconnected_never_crosses() {
    let mut scratch = Scratch::default();
    let (mut apart, mut crossed, count) = (0, 0, frond_testing::cases(2000));
    for seed in 0..count {
        let maps = any_maps(seed);
        let state = decide(&maps, 1e-4, 20_000, &mut scratch).state;
        if crossings(&maps, f64::INFINITY, 0.0).is_some() {
            crossed += 1;
            assert!(state != State::Disconnected, "seed {seed}");
        }
        apart += u32::from(state == State::Disconnected);
    }
    assert!(20 * apart > 3 * count && 20 * crossed > 3 * count, "{apart} disconnected, {crossed} crossed");
}

#[test]
fn polygons_just_below_their_scale_never_cross() {
    let mut maps = Vec::new();
    for sides in [2, 3, 4, 5, 6, 7, 8, 9, 12, 16] {
        let family = Polygons::new(sides);
        for off in [1e-3, 1e-6] {
            for turn in [0.0, 1.0] {
                let angle = turn * std::f64::consts::TAU / sides as f64;
                let s = DVec2::from_angle(angle) * family.critical_scale() * (1.0 - off);
                family.fill(s.x, s.y, &mut maps);
                assert_eq!(crossings(&maps, f64::INFINITY, 0.0), None, "{sides} sides, {off} below");
                let ifs = Ifs::new(maps.clone()).unwrap();
                let options = Options { epsilon: 1e-8, ..Options::default() };
                assert_eq!(connectedness(&ifs, &options).verdict, Verdict::Disconnected, "{sides} sides");
            }
        }
    }
}

/// What a patch says, against its samples one by one.
#[derive(Default)]
struct Compared {
    /// How many samples have each state.
    states: [usize; 5],
    /// How many samples the patch knows better.
    better: usize,
    /// How many gaps are interpolated, and how many of them are off by more than 1 in 10 and more than 1 in 5, or by as
    /// much as that is of a gap of 1 in 25 of the diameter.
    shaded: usize,
    off: [usize; 2],
    /// The most that one is off, in proportion to the same.
    worst: f64,
}

/// Compares a patch with its samples one by one.
///
/// No answer may contradict another: with `g` the widest gap over the diameter, `Connected` says that g is 0,
/// `Touching` that it is no more than epsilon, `Disconnected` that it is more than 0, and of a whole box that it is
/// more than epsilon. So what `decide_bounds` proves of g is held against what the patch says. `Undecided` says
/// nothing.
fn compare<F: Family>(family: &F, grid: &LocusGrid, epsilon: f64, name: &str) -> Compared {
    let mut scratch = Scratch::default();
    let (width, height) = (grid.width(), grid.height());
    let patch = grid.patch(family, epsilon, 0..width, 0..height, &mut scratch);
    let mut found = Compared::default();
    let mut maps = Vec::new();
    for y in 0..height {
        for x in 0..width {
            family.fill(grid.u(x), grid.v(y), &mut maps);
            let budget = LocusGrid::BUDGET.max(2000 * maps.len());
            let alone = decide(&maps, epsilon, budget, &mut scratch);
            let i = y * width + x;
            let state = State::from_code(patch.state[i]).expect("a state");
            let case = format!("{name}, ({}, {}): {alone:?}, {state:?}", grid.u(x), grid.v(y));
            found.states[state as usize] += 1;
            match (alone.state, state) {
                (a, b) if a == b => {}
                (State::Touching | State::Undecided, State::Connected) => found.better += 1,
                (State::Undecided, State::Disconnected | State::NoAttractor) => {
                    found.better += 1;
                }
                (State::Undecided | State::Disconnected, State::Touching) => {
                    // Looked at much more closely, to see whether the claim is wrong.
                    let known = decide_bounds(&maps, 1e-3 * epsilon, 5 * budget, &mut scratch);
                    assert!(known.lower <= epsilon, "{case}: {known:?}");
                    found.better += usize::from(alone.state == State::Undecided);
                }
                _ => panic!("{case}"),
            }
            let gap = patch.gap[i];
            match state {
                State::Connected | State::Touching => assert_eq!(gap, 0.0, "{case}"),
                State::Disconnected => {
                    assert!(gap > 0.0, "{case}");
                    if alone.state == State::Disconnected && gap.to_bits() != alone.gap.to_bits() {
                        let off =
                            (f64::from(gap) - f64::from(alone.gap)).abs() / f64::from(alone.gap).max(0.04);
                        found.shaded += 1;
                        found.off[0] += usize::from(off > 0.1);
                        found.off[1] += usize::from(off > 0.2);
                        found.worst = found.worst.max(off);
                    }
                }
                _ => {}
            }
        }
    }
    found
}

#[test]
fn patches_agree_with_their_samples_on_a_morph() {
    let morph = dragon_to_gasket();
    for w in [0.0, 0.15] {
        let slice = Slice::new(&morph, w);
        let grid = LocusGrid::new(Bounds::default(), 61, 61).unwrap();
        let Compared { states, worst, .. } = compare(&slice, &grid, 1.0 / 600.0, "all of it");
        assert!(states[2] > 1000 && worst < 0.35, "{states:?}, {worst}");
        // Magnified, whole boxes are proved both ways.
        for (u, v) in [(0.2, 0.48), (-0.3, 0.7), (0.05, 0.3)] {
            let near = Bounds { u0: u, v0: v, u1: u + 0.02, v1: v + 0.02 };
            let grid = LocusGrid::new(near, 65, 65).unwrap();
            let Compared { states, better, worst, .. } = compare(&slice, &grid, 1e-5, "magnified");
            assert!((states[2] > 4000 || better > 100) && worst < 0.35, "{states:?}, {better}, {worst}");
        }
    }
}

/// A window of a random morph, mostly across the boundary of its locus, and a plane.
fn any_window(seed: u32) -> (Morph, LocusGrid, f64) {
    let (from, mut to) = (any_maps(2 * seed), any_maps(2 * seed + 1));
    to.resize(from.len(), Affine2::similitude(0.4, 1.0, DVec2::X));
    let mode = if seed.is_multiple_of(4) { Mode::Linear } else { Mode::Polar };
    let morph = Morph::new(&from, &to, &MorphOptions { mode, ..MorphOptions::default() }).unwrap();
    let size = [3.0, 0.3, 0.02][seed as usize % 3];
    let (u, v) = (unit(seed, 800) * 3.0 - 1.0, unit(seed, 801) * 3.0 - 1.0);
    let bounds = Bounds { u0: u, v0: v, u1: u + size, v1: v + size };
    (morph, LocusGrid::new(bounds, 24, 19).unwrap(), 0.1 * unit(seed, 802))
}

#[test]
fn patches_agree_with_their_samples_on_random_morphs() {
    let (mut all, mut better) = ([0; 5], 0);
    let (mut shaded, mut off) = (0, [0; 2]);
    for seed in 0..frond_testing::cases(100) {
        let (morph, grid, w) = any_window(seed);
        let found = compare(&Slice::new(&morph, w), &grid, 1e-3, &format!("seed {seed}"));
        all.iter_mut().zip(found.states).for_each(|(sum, n)| *sum += n);
        better += found.better;
        shaded += found.shaded;
        off.iter_mut().zip(found.off).for_each(|(sum, n)| *sum += n);
    }
    // What `LocusGrid::patch` says of them, and room for what was drawn.
    assert!(shaded > 2500 && 40 * off[0] < shaded && 400 * off[1] < shaded, "{off:?} of {shaded}");
    assert!(all[0] + all[1] > 2500 && all[2] > 2500 && all[4] > 1000 && better > 100, "{all:?}, {better}");
}

/// The samples of a grid, from patches of these sides, forwards or back, and by so many workers in turn.
fn by_patches<F: Family>(
    family: &F,
    grid: &LocusGrid,
    sides: [usize; 2],
    back: bool,
    workers: usize,
) -> Vec<(u8, u32)> {
    let (width, height) = (grid.width(), grid.height());
    let cut = |size: usize, side: usize| (0..size).step_by(side).map(move |a| a..(a + side).min(size));
    let mut tiles: Vec<_> =
        cut(height, sides[1]).flat_map(|y| cut(width, sides[0]).map(move |x| (x, y.clone()))).collect();
    if back {
        tiles.reverse();
    }
    let mut scratches = vec![Scratch::default(); workers];
    let mut samples = vec![(LocusGrid::UNTOUCHED, 0); width * height];
    for (k, (xs, ys)) in tiles.into_iter().enumerate() {
        let tile = grid.patch(family, 1e-3, xs.clone(), ys.clone(), &mut scratches[k % workers]);
        let mut found = tile.state.into_iter().zip(tile.gap);
        for (y, x) in ys.flat_map(|y| xs.clone().map(move |x| (y, x))) {
            let (state, gap) = found.next().expect("a sample");
            samples[y * width + x] = (state, gap.to_bits());
        }
    }
    samples
}

#[test]
fn neither_workers_nor_their_order_nor_the_rectangles_change_the_picture() {
    let mut differ = 0;
    for seed in 0..frond_testing::cases(100) {
        let (morph, grid, w) = any_window(seed);
        let slice = Slice::new(&morph, w);
        let one = by_patches(&slice, &grid, [7, 9], false, 1);
        for (back, workers) in [(true, 1), (false, 3), (true, 2)] {
            assert!(
                one == by_patches(&slice, &grid, [7, 9], back, workers),
                "seed {seed}, {workers} workers"
            );
        }
        // Other rectangles: what is proved of a whole box may be told of more or fewer samples.
        for sides in [[24, 19], [5, 5], [1, 1]] {
            let other = by_patches(&slice, &grid, sides, false, 1);
            for (i, (a, b)) in one.iter().zip(&other).enumerate() {
                let [a, b] =
                    [a.0.min(b.0), a.0.max(b.0)].map(|code| State::from_code(code).expect("a state"));
                let proved = match (a, b) {
                    (State::Connected, State::Touching | State::Undecided) => true,
                    (State::Disconnected, State::Undecided) | (State::Undecided, State::NoAttractor) => true,
                    (a, b) => a == b,
                };
                assert!(proved, "seed {seed}, sample {i} of {sides:?}: {a:?}, {b:?}");
                differ += usize::from(a != b);
            }
        }
    }
    assert!(differ > 100, "{differ}");
}

#[test]
fn patches_agree_with_their_samples_on_polygons() {
    for sides in 2..=12 {
        let family = Polygons::new(sides);
        let size = if sides > 8 { 12 } else { 25 };
        for bounds in [
            Bounds { u0: -1.1, v0: -0.2, u1: 0.8, v1: 1.1 },
            Bounds { u0: 0.02, v0: 0.68, u1: 0.04, v1: 0.7 },
        ] {
            let grid = LocusGrid::new(bounds, size, size).unwrap();
            let Compared { worst, .. } = compare(&family, &grid, 1e-3, &format!("{sides} sides"));
            assert!(worst < 0.35, "{sides} sides: {worst}");
        }
    }
}

#[test]
fn a_tile_of_a_patch_has_its_rows_and_columns() {
    let morph = dragon_to_gasket();
    let slice = Slice::new(&morph, 0.0);
    let mut scratch = Scratch::default();
    let grid = LocusGrid::new(Bounds::default(), 30, 20).unwrap();
    let tile = grid.patch(&slice, 1e-3, 7..19, 3..99, &mut scratch);
    assert_eq!((tile.state.len(), tile.gap.len()), (12 * 17, 12 * 17));
    let whole = grid.locus(&morph, 1e-3);
    let same = |state: u8, other: State| (state < 2) == other.holds();
    assert!((0..12 * 17).all(|i| same(tile.state[i], whole.sample(7 + i % 12, 3 + i / 12).state)));
    let one = grid.patch(&slice, 1e-3, 5..6, 5..6, &mut scratch);
    assert_eq!(one.state.len(), 1);
    for (x, y) in [(5..5, 0..9), (40..50, 0..9), (0..9, 20..30)] {
        assert!(grid.patch(&slice, 1e-3, x, y, &mut scratch).state.is_empty());
    }
    // A window of no size, and one far away.
    for bounds in [
        Bounds { u0: 0.3, v0: 0.3, u1: 0.3, v1: 0.3 },
        Bounds { u0: 1e12, v0: -1e12, u1: 2e12, v1: 1e12 },
        Bounds { u0: 0.5, v0: 0.5, u1: -0.5, v1: -0.5 },
    ] {
        let grid = LocusGrid::new(bounds, 9, 9).unwrap();
        compare(&slice, &grid, 1e-3, "an odd window");
    }
}
