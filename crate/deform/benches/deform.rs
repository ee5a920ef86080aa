//! What moving the mesh costs, against the formula point by point: `cargo bench -p frond-deform`.
//!
//! The gasket at ke = 9 with a 4 x 4 mesh, as in Fujimoto et al., Fig 4.

use std::hint::black_box;
use std::time::Instant;

use frond_core::{Affine2, hash};
use frond_deform::{
    Attribute, Corners, Depths, Field, Lattice, Mesh, Place, Pull, Skin, Smooth, Spin, Turns,
};
use glam::{DMat2, DVec2};

/// The least time of some runs, in seconds: what the machine does when it is left alone.
fn least_time(runs: usize, mut run: impl FnMut()) -> f64 {
    let time = |()| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64()
    };
    std::iter::repeat_n((), runs).map(time).fold(f64::INFINITY, f64::min)
}

const KE: usize = 9;
const DELTA: f64 = 0.75;

fn main() {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
    let maps = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
    let list: Vec<DVec2> = (0..16).map(|i| DVec2::splat(0.02 * f64::from(i))).collect();
    let mesh = Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, list.clone()).expect("a mesh");

    let count = 1_000_000_usize;
    let codes: Vec<[u8; KE]> =
        (0..count as u32).map(|i| std::array::from_fn(|k| (hash::counter(i, k as u32) % 3) as u8)).collect();
    let tail = DVec2::splat(1.0 / 3.0);

    let field = Field::new(&maps, &mesh, Spin::None);
    let some = &codes[..count / 20];
    let formula = least_time(5, || {
        let place = |code| field.superposed(0, KE, DELTA, Place { code, tail });
        black_box(some.iter().map(|code| place(code)).sum::<DVec2>());
    }) * 20.0;

    let pull = Pull::new(&mesh, Turns::None);
    let mut skin = Skin::new(16, Turns::None);
    for code in &codes {
        let mut sum = [0.0; 16];
        let point = field.position(Place { code, tail });
        pull.add(point, DMat2::IDENTITY, 1.0, &mut sum);
        skin.push(point, &sum);
    }
    let mut out = vec![0.0; 2 * count];
    let follow = least_time(20, || skin.follow(black_box(&list), black_box(&mut out)));
    println!(
        "10^6 points, ke 9: formula {:.0} ms, skin {:.2} ms, {:.0} times as fast; {} bytes a point",
        formula * 1e3,
        follow * 1e3,
        formula / follow,
        skin.bytes(),
    );

    let depths = Depths { kb: 0, ke: KE, delta: DELTA, spin: Spin::None };
    let lattice = Lattice::new(&maps, Corners::find(&maps).expect("a triangle"), KE);
    let tree = least_time(10, || drop(black_box(Smooth::new(&lattice, &mesh, depths))));
    let cells: Vec<[u8; KE]> = (0..3_usize.pow(KE as u32))
        .map(|i| std::array::from_fn(|k| (i / 3_usize.pow((KE - 1 - k) as u32) % 3) as u8))
        .collect();
    let terms = least_time(5, || {
        let place = |code: &[u8]| -> DVec2 {
            corners.iter().map(|&tail| field.superposed(0, KE, DELTA, Place { code, tail })).sum()
        };
        black_box(cells.iter().map(|code| place(code)).sum::<DVec2>());
    });
    println!(
        "all cells of the gasket at ke 9, three corners each: term by term {:.1} ms, word tree {:.1} ms, {:.1} times",
        terms * 1e3,
        tree * 1e3,
        terms / tree,
    );
}
