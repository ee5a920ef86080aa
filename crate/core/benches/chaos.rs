//! How many points of the chaos game a second, one thread.

use std::hint::black_box;
use std::time::Instant;

use frond_core::{Affine2, Affine3, ChaosGame, ChaosGame3, Ifs, Ifs3};
use frond_testing::least_time;
use glam::DVec3;

/// Of a call that makes 2^16 points.
fn million_points_a_second(mut fill: impl FnMut()) -> f64 {
    f64::from(64 << 16) / least_time(20, || (0..64).for_each(|_| fill())) / 1e6
}

fn main() {
    let fern = [
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
        [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
        [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
    ];
    let ifs = Ifs::new(fern.map(Affine2::from_row).to_vec()).expect("the fern");
    let mut game = ChaosGame::new(&ifs, 1);
    let (mut positions, mut pieces) = (vec![0.0; 1 << 17], vec![0; 1 << 16]);
    let plane = million_points_a_second(|| {
        game.fill(&mut positions, &mut pieces);
        black_box((&positions, &pieces));
    });
    println!("chaos game, fern: {plane:.1} million points a second");

    // Four maps as well, turned about any axis.
    let turned = |k: u32| {
        let axis = DVec3::new(1.0, f64::from(k), 0.5);
        let turn = Affine3::rotation(axis, f64::from(k)).expect("an axis");
        Affine3::moving(axis) * turn * Affine3::scaling(DVec3::new(0.5, 0.6, 0.4))
    };
    let ifs = Ifs3::new((0..4).map(turned).collect()).expect("four maps");
    let mut game = ChaosGame3::new(&ifs, 1);
    let mut positions = vec![0.0; 3 << 16];
    let space = million_points_a_second(|| {
        game.fill(&mut positions, &mut pieces);
        black_box((&positions, &pieces));
    });
    println!("chaos game in space: {space:.1} million points a second, {:.2} of the plane's", space / plane);
    let by = Affine3::rotation(DVec3::ONE, 0.3).expect("an axis");
    let many = Ifs3::new((0..64).map(|k| turned(k % 4)).collect()).expect("64 maps");
    let start = Instant::now();
    for _ in 0..100 {
        black_box(many.maps().iter().map(|map| map.moved(by)).collect::<Vec<_>>());
    }
    println!("conjugation of 64 maps: {:.1} us", start.elapsed().as_secs_f64() * 1e4);
    let start = Instant::now();
    for _ in 0..10 {
        black_box(many.conjugate(by)).expect("a turn");
    }
    println!(
        "conjugation of 64 maps, checked again for an attractor: {:.1} us",
        start.elapsed().as_secs_f64() * 1e5
    );
}
