//! The chaos game beside that of the crate `barnsley`, in one run: points a second, each plotted into a picture of
//! 1000 x 1000, the same system, one thread. `cargo run --release --manifest-path tests/bench/peer/Cargo.toml`

use std::hint::black_box;
use std::time::Instant;

use barnsley::ifs::IFS;
use barnsley::image::Image;
use barnsley::transform::AffineTransform;
use barnsley::util::Color;
use frond_core::{Affine2, ChaosGame, Ifs};

const SIZE: usize = 1000;
const POINTS: usize = 8_000_000;
const GASKET: [[f64; 6]; 3] =
    [[0.5, 0.0, 0.0, 0.5, -0.5, -0.5], [0.5, 0.0, 0.0, 0.5, 0.5, -0.5], [0.5, 0.0, 0.0, 0.5, 0.0, 0.5]];

fn peer() -> f64 {
    let mut ifs = IFS::new();
    for row in GASKET {
        let [a, b, c, d, e, f] = row.map(|x| x as f32);
        let colour = Color { r: 1.0, g: 0.5, b: 0.2 };
        ifs.add_transform(AffineTransform::new(a, b, c, d, e, f, colour, 1.0).into());
    }
    let mut image = Image::new(SIZE, SIZE);
    let start = Instant::now();
    ifs.evaluate(&mut image, 8, POINTS / 8);
    black_box(&image);
    POINTS as f64 / start.elapsed().as_secs_f64()
}

fn frond() -> f64 {
    let ifs = Ifs::new(GASKET.map(Affine2::from_row).to_vec()).expect("the gasket");
    let mut game = ChaosGame::new(&ifs, 1);
    let mut image = vec![0_u32; SIZE * SIZE];
    let (mut positions, mut pieces) = (vec![0.0_f32; 1 << 14], vec![0_u8; 1 << 13]);
    let start = Instant::now();
    let mut left = POINTS;
    while left > 0 {
        let count = game.fill(&mut positions, &mut pieces).min(left);
        for (point, piece) in positions.chunks_exact(2).zip(&pieces).take(count) {
            let x = ((point[0] + 1.0) * (SIZE as f32 / 2.0)) as usize;
            let y = ((point[1] + 1.0) * (SIZE as f32 / 2.0)) as usize;
            if x < SIZE && y < SIZE {
                image[y * SIZE + x] += 1 + u32::from(*piece);
            }
        }
        left -= count;
    }
    black_box(&image);
    POINTS as f64 / start.elapsed().as_secs_f64()
}

fn main() {
    let best = |run: fn() -> f64| (0..5).map(|_| run()).fold(0.0, f64::max) / 1e6;
    let (peer, frond) = (best(peer), best(frond));
    println!("barnsley {peer:.1}, Frond {frond:.1} million points a second: {:.1} times", frond / peer);
}
