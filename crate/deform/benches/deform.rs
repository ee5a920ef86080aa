//! What bending costs, against the formula point by point: `cargo bench -p frond-deform`.
//!
//! The gasket at ke = 9 with a 4 x 4 mesh, as in Fujimoto et al., Fig 4.

use std::hint::black_box;
use std::time::Instant;

use frond_core::{Affine2, hash};
use frond_deform::{
    Bend, Continuity, Corners, Cursor, Field, Mesh, Place, RingBend, Roughness, Settings, Spin,
};
use frond_testing::least_time;
use glam::DVec2;

const KE: usize = 9;
const DELTA: f64 = 0.75;

fn settings(ke: f64, continuity: Continuity) -> Settings {
    let roughness = Roughness::Constant(DELTA);
    Settings { kb: 0.0, ke, roughness, spin: Spin::None, continuity, superposed: true }
}

/// Where the corners of all cells of so many letters go, in sum.
fn walk(bend: &Bend, cursor: &Cursor, maps: usize, letters: usize) -> DVec2 {
    if letters == 0 {
        return bend.displaced(cursor).into_iter().sum();
    }
    (0..maps).map(|letter| walk(bend, &bend.child(cursor, letter), maps, letters - 1)).sum()
}

fn square(parts: u32) -> Vec<Affine2> {
    let s = 1.0 / f64::from(parts);
    let corner = |i| DVec2::new(f64::from(i % parts), f64::from(i / parts)) * s;
    (0..parts * parts).map(|i| Affine2::similitude(s, 0.0, corner(i))).collect()
}

fn main() {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
    let maps = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
    let list: Vec<DVec2> = (0..16).map(|i| DVec2::splat(0.02 * f64::from(i))).collect();
    let mesh = Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, list.clone()).expect("a mesh");
    let make = |maps: &[Affine2], ke, continuity| {
        Bend::new(maps, mesh.clone(), settings(ke, continuity), None).expect("a bend")
    };
    let field = Field::new(&maps, &mesh, Spin::None);

    let count = 1_000_000_usize;
    let code = |i: u32| -> [u8; KE] { std::array::from_fn(|k| (hash::counter(i, k as u32) % 3) as u8) };
    let tail = DVec2::splat(1.0 / 3.0);
    let some: Vec<[u8; KE]> = (0..count as u32 / 20).map(code).collect();
    let formula = 20.0
        * least_time(5, || {
            let place = |code| field.superposed(0, KE, DELTA, Place { code, tail });
            black_box(some.iter().map(|code| place(code)).sum::<DVec2>());
        });

    let mut bend = make(&maps, KE as f64, Continuity::Corners);
    let at = |i| code(i).iter().fold(bend.whole(), |at, &letter| bend.child(&at, usize::from(letter)));
    let places: Vec<(Cursor, DVec2)> = (0..count as u32 / 10).map(|i| (at(i), tail)).collect();
    let start = Instant::now();
    let first = bend.skin(&places);
    let first = (start.elapsed().as_secs_f64(), first.len());
    let skins: Vec<_> = (0..10).map(|_| bend.skin(&places)).collect();
    let mut out = vec![0.0; 2 * places.len()];
    let follow = least_time(20, || {
        skins.iter().for_each(|skin| skin.follow(black_box(&list), black_box(&mut out)));
    });
    println!(
        "10^6 points, ke 9: formula {:.0} ms, skin {:.2} ms, {:.0} times as fast; {} bytes a point; the first {} took {:.0} ms to skin",
        formula * 1e3,
        follow * 1e3,
        formula / follow,
        skins[0].bytes(),
        first.1,
        first.0 * 1e3,
    );
    let moved = least_time(20, || bend.set_mesh(black_box(&list)).expect("a mesh"));
    println!(
        "moving the mesh of a bend at ke 9, 29,526 corners: {:.2} ms, {:.0} times as fast as the formula for as many points",
        moved * 1e3,
        formula * 29_526.0 / 1e6 / moved,
    );

    let cells: Vec<[u8; KE]> = (0..3_usize.pow(KE as u32))
        .map(|i| std::array::from_fn(|k| (i / 3_usize.pow((KE - 1 - k) as u32) % 3) as u8))
        .collect();
    let tree = |maps: &[Affine2], ke: usize, continuity| {
        least_time(5, || {
            let bend = make(maps, ke as f64, continuity);
            black_box(walk(&bend, &bend.whole(), maps.len(), ke));
        })
    };
    let terms = least_time(5, || {
        let place = |code: &[u8]| -> DVec2 {
            corners.iter().map(|&tail| field.superposed(0, KE, DELTA, Place { code, tail })).sum()
        };
        black_box(cells.iter().map(|code| place(code)).sum::<DVec2>());
    });
    let whole = tree(&maps, KE, Continuity::Corners);
    println!(
        "all cells of the gasket at ke 9, three corners each: term by term {:.1} ms, word tree and all {:.2} ms, {:.1} times",
        terms * 1e3,
        whole * 1e3,
        terms / whole,
    );
    println!("the same at ke 12, 531,441 cells: {:.0} ms", 1e3 * tree(&maps, 12, Continuity::Corners));

    let dragon =
        [[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]].map(Affine2::from_row);
    let fern = [
        [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
        [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
    ]
    .map(Affine2::from_row);
    for (name, maps, ke, letters, continuity) in [
        ("gasket", &maps[..], 9, 10, Continuity::Corners),
        ("square", &square(2), 9, 8, Continuity::Corners),
        ("square of nine", &square(3), 6, 5, Continuity::Corners),
        ("twin-dragon", &dragon, 9, 16, Continuity::Splat),
        ("twin-dragon, averages", &dragon, 9, 16, Continuity::Average),
        ("fern", &fern, 9, 9, Continuity::Raw),
        ("fern, splat", &fern, 6, 8, Continuity::Splat),
    ] {
        let new = least_time(5, || drop(black_box(make(maps, f64::from(ke), continuity))));
        let bend = make(maps, f64::from(ke), continuity);
        let down = least_time(5, || {
            black_box(walk(&bend, &bend.whole(), maps.len(), letters));
        });
        let count = maps.len().pow(letters as u32) as f64;
        println!(
            "{name}, ke {ke}: made in {:.2} ms, 100,000 pieces of {letters} letters placed in {:.1} ms",
            new * 1e3,
            down * 1e3 * 1e5 / count,
        );
    }
    let shapes = [
        ("gasket", &maps[..]),
        ("square of nine", &square(3)),
        ("fern", &fern),
        ("square of 64", &square(8)),
    ];
    for (name, maps) in shapes {
        let find = least_time(20, || drop(black_box(Corners::find(black_box(maps)))));
        println!("looking for corners, {name}: {:.1} us", find * 1e6);
    }
    for ke in [7.0, 9.0] {
        rings(ke, &mesh, &list);
    }
}

/// A closed curve: the bend made, its mesh moved, and points placed.
fn rings(ke: f64, mesh: &Mesh, list: &[DVec2]) {
    let settings = settings(ke, Continuity::Auto);
    let count = RingBend::points(&settings).expect("settings");
    let place = |t: f64| DVec2::splat(0.5) + 0.4 * DVec2::from_angle(std::f64::consts::TAU * t);
    let grid: Vec<_> = (0..count).map(|i| place(i as f64 / count as f64)).collect();
    let make = || RingBend::new(mesh.clone(), settings, &grid).expect("a bend");
    let new = least_time(5, || drop(black_box(make())));
    let mut bend = make();
    let moved = least_time(20, || bend.set_mesh(black_box(list)).expect("a mesh"));
    let points: Vec<_> = (0..10_000).map(|i| f64::from(i) / 1e4).map(|t| (t, place(t))).collect();
    let down = least_time(20, || {
        black_box(points.iter().map(|&(t, z)| bend.displaced(t, z)).sum::<DVec2>());
    });
    let drawn = least_time(5, || drop(black_box(bend.polyline(&points, 1e-3, None, 1 << 20))));
    println!(
        "closed curve, ke {ke}: made in {:.2} ms, mesh moved in {:.2} ms, 10,000 points placed in {:.2} ms, drawn in {:.2} ms",
        new * 1e3,
        moved * 1e3,
        down * 1e3,
        drawn * 1e3,
    );
}
