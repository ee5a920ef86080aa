//! How many points of the chaos game a second, one thread.

use std::hint::black_box;
use std::time::Instant;

use frond_core::{Affine2, ChaosGame, Ifs};

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
    let mut best = 0.0_f64;
    for _ in 0..20 {
        let start = Instant::now();
        for _ in 0..64 {
            game.fill(&mut positions, &mut pieces);
            black_box((&positions, &pieces));
        }
        best = best.max(f64::from(64 << 16) / start.elapsed().as_secs_f64());
    }
    println!("chaos game, fern: {:.1} million points a second", best / 1e6);
}
