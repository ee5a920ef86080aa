//! One piece of work for the bench of the chaos game.

use frond_core::{Affine2, ChaosGame, Ifs};

const FERN: [[f64; 6]; 4] = [
    [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
    [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
    [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
    [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
];

/// Plays `rounds` times 65536 points of the fern into the same arrays, and returns a sum that depends on them.
#[unsafe(no_mangle)]
pub extern "C" fn play(rounds: u32) -> f32 {
    let ifs = Ifs::new(FERN.map(Affine2::from_row).to_vec()).expect("the fern");
    let mut game = ChaosGame::new(&ifs, 1);
    let (mut positions, mut pieces) = (vec![0.0; 1 << 17], vec![0; 1 << 16]);
    let mut sum = 0.0;
    for round in 0..rounds {
        game.fill(&mut positions, &mut pieces);
        let at = (round as usize * 7919) & 0xffff;
        sum += positions[2 * at] + f32::from(pieces[at]);
    }
    sum
}
